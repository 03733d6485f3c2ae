// SPDX-License-Identifier: MIT
// The emitted text, in the language that is chosen: GLSL is composed here, the others were translated when the page was made.
import {by_id, element} from './dom.js';
import {name_of} from './recipe.js';

const composed = {
    vulkan: {title: 'GLSL for Vulkan', words: []},
    opengl: {title: 'GLSL for OpenGL', words: ['opengl']},
    es: {title: 'GLSL ES for WebGL 2', words: ['fragment', 'glsl_es:300']},
};
const translated = {hlsl: 'HLSL', msl: 'Metal', wgsl: 'WGSL'};

export class Texts {
    #presets = null;

    constructor(crease) {
        this.crease = crease;
        this.language = by_id('language');
        this.language.append(
            ...Object.entries(composed).map(([value, {title}]) => element('option', {value}, title)),
            ...Object.entries(translated).map(([value, title]) => element('option', {value}, title)));
        this.language.addEventListener('change', () => this.#update());
        by_id('pass').addEventListener('change', () => this.#print());
        by_id('copy').addEventListener('click', () => this.#copy());
    }

    show(recipe) {
        this.recipe = recipe;
        return this.#update();
    }

    async #update() {
        const language = this.language.value;
        this.shaders = language in composed ? this.#compose(language) : await this.#translation(language);
        const pass = by_id('pass'), before = pass.value;
        pass.replaceChildren(...this.shaders.map(({name}) => element('option', {value: name, selected: name === before}, name)));
        this.#print();
    }

    #compose(language) {
        const decided = new Set(['stage', 'dialect']);
        const roles = new Map(this.crease.parts.map(({name, role}) => [name, role]));
        const words = this.recipe.split('/').filter((word) => !decided.has(roles.get(name_of(word))));
        const recipe = [...words, ...composed[language].words].join('/');
        const reason = this.crease.check(recipe);
        this.note = reason || `crease emit ${recipe}`;
        if (reason)
            return [];
        return this.crease.compose(recipe).passes.map(({name, shaders}, i) => ({name: `${i} ${name}`, text: shaders[0].text}));
    }

    async #translation(language) {
        this.#presets ??= await (await fetch(new URL('texts.json', import.meta.url))).json();
        const shaders = this.#presets[this.recipe]?.[language] ?? [];
        const command = `crease emit ${this.recipe} --target ${language}`;
        this.note = shaders.length > 0 ? command
            : `${translated[language]} is translated by the command, and stands here for presets alone: ${command}`;
        return shaders;
    }

    #print() {
        const shown = this.shaders.find(({name}) => name === by_id('pass').value) ?? this.shaders[0];
        by_id('text').textContent = shown?.text ?? '';
        by_id('text-note').textContent = this.note;
        by_id('copy').disabled = !shown;
    }

    async #copy() {
        try {
            await navigator.clipboard.writeText(by_id('text').textContent);
            by_id('copied').textContent = 'Copied';
        } catch {
            by_id('copied').textContent = 'The browser does not let this page copy: select the text';
        }
        setTimeout(() => (by_id('copied').textContent = ''), 3000);
    }
}
