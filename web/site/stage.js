// SPDX-License-Identifier: MIT
// One view on the device: its G-buffer, baked or drawn, the truth beside it, and the effect that runs on it.
import {orbited, projection_matrix, reversed_projection_matrix, view_matrix} from './camera.js';
import {load_inputs, load_triangles, load_truth} from './views.js';

export class Stage {
    effect = null;
    orbit = null; // angles and distance of a camera that was moved; null: the baked view
    #scene = null;
    #wanted = null; // the manifest that was set last

    /** @param graphics  WebGL2Graphics or WebGPUGraphics */
    constructor(graphics, canvas, crease) {
        Object.assign(this, {graphics, canvas, crease});
    }

    async set_view(view) {
        const {graphics} = this;
        const inputs = await load_inputs(view);
        const {width, height} = view;
        [...Object.values(this.baked ?? {}), ...Object.values(this.truth_textures ?? {})].forEach((texture) => graphics.free(texture));
        this.#scene?.dispose();
        this.#scene = null;
        Object.assign(this, {view, width, height, truths: {}, truth_textures: {}, orbit: null});
        Object.assign(this.canvas, {width, height});
        this.baked = Object.fromEntries(['depth', 'normal'].map((name) => [name, graphics.texture(name, width, height, inputs[name])]));
        const far = view.camera.far * (1 - 1e-6);
        this.counts = Uint8Array.from(inputs.depth, (depth) => (depth < far ? 1 : 0));
    }

    /** Ray-traced visibility of the view, from 0 to 1. */
    async truth(kind) {
        const {view} = this;
        if (!this.truths[kind]) {
            const bytes = await load_truth(view, kind);
            if (view !== this.view)
                return this.truth(kind);
            this.truths[kind] = Float32Array.from(bytes, (value) => value / 255);
            this.truth_textures[kind] = this.graphics.texture('truth', this.width, this.height, bytes);
        }
        return this.truths[kind];
    }

    /** Makes an effect anew, and says whether it is still wanted then; where that throws the one before stays. */
    async set_effect(manifest) {
        this.#wanted = manifest;
        const made = await this.graphics.effect(manifest, this.width, this.height);
        if (manifest !== this.#wanted) {
            made.dispose();
            return false;
        }
        this.effect?.dispose();
        this.effect = made;
        this.manifest = manifest;
        this.#bind(this.orbit ? this.#scene : this.baked);
        return true;
    }

    #bind(inputs) {
        for (const {name, kind, lifetime} of this.manifest.resources)
            if (kind === 'image' && lifetime === 'input')
                this.effect.bind(name, inputs[name]);
    }

    /** Draws the scene through a camera that moves, from its triangles. */
    async set_orbit(orbit) {
        if (orbit && !this.#scene) {
            const view = this.view;
            const triangles = await load_triangles(view);
            if (view === this.view && !this.#scene)
                this.#scene = this.graphics.scene(triangles, this.width, this.height);
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
        this.#bind(inputs);
        this.effect.run();
    }

    draw({split, beside, truth}) {
        this.graphics.draw(this.effect.texture('visibility'), this.orbit ? null : this.truth_textures[truth] ?? null, {split, beside});
    }

    /** How long the effect takes, or while that is measured the one that follows it. */
    measure() {
        return this.graphics.measure(() => this.effect);
    }

    /** The visibility that was drawn last, from 0 to 1, rows from the top. */
    visibility() {
        const resource = this.manifest.resources.find(({name}) => name === 'visibility');
        return this.graphics.read(this.effect.texture('visibility'), resource, this.width, this.height);
    }
}
