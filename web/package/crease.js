// SPDX-License-Identifier: MIT
import {load_library} from './library.js';
import {manifest_of} from './manifest.js';
import * as structs from './structs.js';

const flags = {depthFromMinusOne: 1, yUp: 2, leftHanded: 4, rowMajor: 8};

/** Why a recipe makes no effect, in one sentence. */
export class RecipeError extends Error {
    name = 'RecipeError';
}

class Crease {
    #library;

    constructor(library) {
        this.#library = library;
        const {calls} = library;
        const listed = (count, at, layout) =>
            Array.from({length: count()}, (_, i) => layout.read(library, at(i)));
        this.version = library.text(calls.crease_c_version_text());
        this.parts = listed(calls.crease_part_count, calls.crease_part_at, structs.part);
        this.presets = listed(calls.crease_preset_count, calls.crease_preset_at, structs.preset);
    }

    check(recipe) {
        const {calls} = this.#library;
        return this.#library.with_text(recipe, (text) => {
            const length = calls.crease_check(text, 0, 0);
            const room = new Uint8Array(1 + length);
            return length === 0 ? '' : this.#library.with_bytes([room], (sentence) => {
                calls.crease_check(text, sentence, room.length);
                return this.#library.text(sentence);
            });
        });
    }

    compose(recipe) {
        const {calls} = this.#library;
        const composition = this.#library.with_text(recipe, (text) => calls.crease_compose(text));
        try {
            const error = this.#library.text(calls.crease_error(composition));
            if (error !== null)
                throw new RecipeError(error);
            const effect = structs.effect.read(this.#library, calls.crease_effect_of(composition));
            const parts = effect.parts.map(({part, numbers, named}) => ({name: part.name, role: part.role, numbers, named}));
            return {...manifest_of(effect, this.version), parts};
        } finally {
            calls.crease_destroy(composition);
        }
    }

    view(matrix, width, height, {guard = 0, ...convention} = {}) {
        const how = Object.entries(flags).reduce((all, [name, bit]) => all | (convention[name] ? bit : 0), 0);
        const room = new Uint8Array(structs.view.size);
        const given = new Uint8Array(Float32Array.from(matrix).buffer);
        if (given.length !== 64)
            throw new RangeError('crease: a projection matrix has 16 numbers');
        return this.#library.with_bytes([given, room], (from, to) => {
            const error = this.#library.calls.crease_set_projection(to, from, width, height, how, guard);
            if (error)
                throw new RangeError(this.#library.text(error));
            return structs.view.read(this.#library, to);
        });
    }
}

export async function load(source = new URL('crease.wasm', import.meta.url)) {
    return new Crease(await load_library(source));
}
