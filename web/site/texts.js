// SPDX-License-Identifier: MIT
// The emitted text, in the language that is chosen: GLSL is composed here, of which naga makes WGSL; HLSL and Metal were translated
// when the page was made.
import {with_wgsl} from './package/webgpu.js';

import {by_id, element} from './dom.js';
import {load_naga} from './naga.js';
import {name_of} from './recipe.js';
import {text_key} from './text_key.js';

const composed = {
    vulkan: {title: 'GLSL for Vulkan', words: []},
    opengl: {title: 'GLSL for OpenGL', words: ['opengl']},
    es: {title: 'GLSL ES for WebGL 2', words: ['fragment', 'glsl_es:300']},
};
const translated = {hlsl: 'HLSL', msl: 'Metal'};
const titles = {...Object.fromEntries(Object.entries(composed).map(([value, {title}]) => [value, title])), ...translated, wgsl: 'WGSL'};

function shaders_of(passes) {
    return passes.map(({name, shaders: [{text}]}, i) => ({name: `${i} ${name}`, text}));
}

/** The shaders of a recipe in each language, or a sentence in their place. */
async function load_translation({file}) {
    const {body} = await fetch(new URL(`texts/${file}`, import.meta.url));
    return new Response(body.pipeThrough(new DecompressionStream('gzip'))).json();
}

export class Texts {
    #list = null; // of translations: by text_key the recipe and its file
    #updates = 0;

    constructor(crease) {
        this.crease = crease;
        this.language = by_id('language');
        this.language.append(...Object.entries(titles).map(([value, title]) => element('option', {value}, title)));
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
        const shown = language in composed ? this.#compose(language)
            : language === 'wgsl' ? await this.#wgsl() : await this.#translation(language);
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

    async #wgsl() {
        const recipe = this.#recipe_in(['webgpu']), command = `crease emit ${this.recipe} --target wgsl`;
        try {
            const {passes} = with_wgsl(this.crease.compose(recipe), await load_naga());
            return {note: 'By naga of GLSL. The command has naga make it of SPIR-V: other words, the same numbers.', command, shaders: shaders_of(passes)};
        } catch (error) {
            return {note: error.message, command, shaders: []};
        }
    }

    async #translation(language) {
        this.#list ??= await (await fetch(new URL('texts.json', import.meta.url))).json();
        const effect = this.crease.compose(this.recipe);
        const held = this.#list[text_key(effect.parts)];
        const made = held ? (await load_translation(held))[language] : [];
        const note = !held ? `${translated[language]} is translated outside of browsers. The page holds ${Object.keys(this.#list).length} recipes in it, and not this one.`
            : typeof made === 'string' ? made
            : held.recipe !== effect.recipe ? `The page holds these parts with other numbers: this is ${held.recipe}.` : '';
        return {note, command: `crease emit ${this.recipe} --target ${language}`, shaders: typeof made === 'string' ? [] : made};
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
