// SPDX-License-Identifier: MIT
// The emitted text, in the language that is chosen: GLSL is composed here, and naga makes the others of it; HLSL and Metal of many
// recipes were made by SPIRV-Cross when the page was, and read better.
import {with_wgsl} from './package/webgpu.js';

import {by_id, element} from './dom.js';
import {load_naga} from './naga.js';
import {name_of} from './recipe.js';
import {text_key} from './text_key.js';
import {translated_passes} from './translation.js';

const composed = {
    vulkan: {title: 'GLSL for Vulkan', words: []},
    opengl: {title: 'GLSL for OpenGL', words: ['opengl']},
    es: {title: 'GLSL ES for WebGL 2', words: ['fragment', 'glsl_es:300']},
};
const translated = {hlsl: {title: 'HLSL'}, msl: {title: 'Metal'}, wgsl: {title: 'WGSL'}};
const notes = {
    held: 'By SPIRV-Cross: what the command writes, beside a manifest that says by which numbers a host binds.',
    naga: 'By naga in this page, with fixed numbers: the command has SPIRV-Cross write half as much, with numbers left to the host and bindings counted by kind.',
    wgsl: 'By naga of GLSL. The command has naga make it of SPIR-V: other words, the same numbers.',
};

function shaders_of(passes) {
    return passes.map(({name, shaders: [{text}]}, i) => ({name: `${i} ${name}`, text}));
}

/** What was made when the page was: by text_key the file of a recipe. */
async function load_list() {
    return (await fetch(new URL('texts.json', import.meta.url))).json();
}

/** The shaders of a recipe in each language. */
async function load_translations(file) {
    const {body} = await fetch(new URL(`texts/${file}`, import.meta.url));
    return new Response(body.pipeThrough(new DecompressionStream('gzip'))).json();
}

export class Texts {
    #list = null;
    #updates = 0;

    constructor(crease) {
        this.crease = crease;
        this.language = by_id('language');
        this.language.append(...Object.entries({...composed, ...translated}).map(([value, {title}]) => element('option', {value}, title)));
        this.language.addEventListener('change', () => this.#update());
        by_id('pass').addEventListener('change', () => this.#print());
        by_id('copy').addEventListener('click', () => this.#copy('text'));
        by_id('copy-command').addEventListener('click', () => this.#copy('command'));
    }

    show(recipe) {
        this.recipe = recipe;
        return this.#update();
    }

    async #update() {
        const language = this.language.value, update = ++this.#updates;
        const shown = language in composed ? this.#compose(language) : await this.#translate(language);
        if (update !== this.#updates)
            return;
        Object.assign(this, shown);
        const pass = by_id('pass'), before = pass.value;
        pass.replaceChildren(...this.shaders.map(({name}) => element('option', {value: name, selected: name === before}, name)));
        this.#print();
    }

    /** The recipe with the stage and the dialect of a language. */
    #recipe_in(words) {
        const decided = new Set(['stage', 'dialect']);
        const roles = new Map(this.crease.parts.map(({name, role}) => [name, role]));
        return [...this.recipe.split('/').filter((word) => !decided.has(roles.get(name_of(word)))), ...words].join('/');
    }

    #compose(language) {
        const recipe = this.#recipe_in(composed[language].words);
        const note = this.crease.check(recipe);
        return {note, command: `crease emit ${recipe}`, shaders: note ? [] : shaders_of(this.crease.compose(recipe).passes)};
    }

    async #translate(language) {
        const command = `crease emit ${this.recipe} --target ${language}`;
        try {
            const held = language === 'wgsl' ? null : await this.#held(language);
            if (held)
                return {note: notes.held, command, shaders: held};
            const manifest = this.crease.compose(this.#recipe_in(['webgpu'])), naga = await load_naga();
            const passes = language === 'wgsl' ? with_wgsl(manifest, naga).passes : translated_passes(manifest, naga, language);
            return {note: notes[language] ?? notes.naga, command, shaders: shaders_of(passes)};
        } catch (error) {
            return {note: error.message, command, shaders: []};
        }
    }

    /** The shaders of SPIRV-Cross, where the page holds them. */
    async #held(language) {
        this.#list ??= await load_list();
        const file = this.#list[text_key(this.crease.compose(this.recipe).parts)];
        return file && (await load_translations(file))[language];
    }

    #print() {
        const shown = this.shaders.find(({name}) => name === by_id('pass').value) ?? this.shaders[0];
        by_id('text').textContent = shown?.text ?? '';
        by_id('text-note').textContent = this.note;
        by_id('command').textContent = this.command;
        by_id('copy').disabled = !shown;
    }

    async #copy(id) {
        try {
            await navigator.clipboard.writeText(by_id(id).textContent);
            by_id('copied').textContent = 'Copied';
        } catch {
            by_id('copied').textContent = 'The browser does not let this page copy: select the text';
        }
        setTimeout(() => (by_id('copied').textContent = ''), 3000);
    }
}
