// SPDX-License-Identifier: MIT
// One view on the device: its G-buffer, baked or drawn, the truth beside it, and the effect that runs on it.
import {WebGL2Effect} from './package/webgl2.js';

import {orbited, projection_matrix, reversed_projection_matrix, view_matrix} from './camera.js';
import {fill, read, texture_of} from './gl.js';
import {Picture} from './picture.js';
import {Scene} from './scene.js';
import {load_inputs, load_triangles, load_truth} from './views.js';

export class Stage {
    effect = null;
    orbit = null; // angles and distance of a camera that was moved; null: the baked view
    #scene = null;

    constructor(canvas, crease) {
        this.crease = crease;
        this.gl = canvas.getContext('webgl2', {antialias: false});
        if (!this.gl)
            throw new Error('This browser has no WebGL 2, by which the page draws.');
        if (!this.gl.getExtension('EXT_color_buffer_float'))
            throw new Error('This device cannot draw to images of floats (EXT_color_buffer_float).');
        this.picture = new Picture(this.gl);
    }

    async set_view(view) {
        const {gl} = this;
        const inputs = await load_inputs(view);
        const {width, height} = view;
        [this.baked?.depth, this.baked?.normal, ...Object.values(this.truth_textures ?? {})].forEach((texture) => gl.deleteTexture(texture));
        this.#scene?.dispose();
        this.#scene = null;
        Object.assign(this, {view, width, height, truths: {}, truth_textures: {}, orbit: null});
        gl.canvas.width = width;
        gl.canvas.height = height;
        this.baked = {depth: texture_of(gl, gl.R32F, width, height), normal: texture_of(gl, gl.RGB32F, width, height)};
        fill(gl, this.baked.depth, width, height, gl.RED, gl.FLOAT, inputs.depth);
        fill(gl, this.baked.normal, width, height, gl.RGB, gl.FLOAT, inputs.normal);
        const far = view.camera.far * (1 - 1e-6);
        this.counts = Uint8Array.from(inputs.depth, (depth) => (depth < far ? 1 : 0));
    }

    /** Ray-traced visibility of the view, from 0 to 1. */
    async truth(kind) {
        const {gl, view} = this;
        if (!this.truths[kind]) {
            const bytes = await load_truth(view, kind);
            if (view !== this.view)
                return this.truth(kind);
            this.truths[kind] = Float32Array.from(bytes, (value) => value / 255);
            this.truth_textures[kind] = texture_of(gl, gl.R8, this.width, this.height);
            fill(gl, this.truth_textures[kind], this.width, this.height, gl.RED, gl.UNSIGNED_BYTE, bytes);
        }
        return this.truths[kind];
    }

    /** Makes an effect anew; where that throws the one before stays. */
    set_effect(manifest) {
        const made = new WebGL2Effect(this.gl, manifest, this.width, this.height);
        this.effect?.dispose();
        this.effect = made;
        this.manifest = manifest;
    }

    /** Draws the scene through a camera that moves, from its triangles. */
    async set_orbit(orbit) {
        if (orbit && !this.#scene) {
            const view = this.view;
            const triangles = await load_triangles(view);
            if (view === this.view && !this.#scene)
                this.#scene = new Scene(this.gl, triangles, this.width, this.height);
        }
        this.orbit = orbit;
    }

    /** Runs the effect with a radius and settings. */
    run({radius, settings}) {
        const aspect = this.width / this.height;
        const {camera} = this.view;
        const inputs = this.orbit ? this.#scene : this.baked;
        if (this.orbit)
            this.#scene.draw(view_matrix(orbited(camera, ...this.orbit)), projection_matrix(camera, aspect));
        this.effect.setView(this.crease.view(reversed_projection_matrix(camera, aspect), this.width, this.height));
        this.effect.set('radius', radius);
        for (const {name, default: fallback} of this.manifest.uniform_block.members)
            if (fallback !== undefined)
                this.effect.set(name, settings[name] ?? fallback);
        for (const {name, kind, lifetime} of this.manifest.resources)
            if (kind === 'image' && lifetime === 'input')
                this.effect.bind(name, inputs[name]);
        this.effect.run();
    }

    draw({split, beside, truth}) {
        this.picture.draw(this.effect.texture('visibility'), this.orbit ? null : this.truth_textures[truth] ?? null, {split, beside});
    }

    /** The visibility that was drawn last, from 0 to 1, rows from the top. */
    visibility() {
        const {format} = this.manifest.resources.find(({name}) => name === 'visibility');
        return read(this.gl, this.effect.texture('visibility'), this.width, this.height, format === 'r32_float');
    }
}
