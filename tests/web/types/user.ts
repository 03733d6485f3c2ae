// SPDX-License-Identifier: MIT
// What a user of the npm package writes in TypeScript. The test web_types has tsc read it; each line below @ts-expect-error must not compile.
import {load, RecipeError} from 'crease';
import type {Effect, Manifest, View} from 'crease';
import {CreasePass} from 'crease/three';
import {size_of, unsupported, WebGL2Effect} from 'crease/webgl2';
import {unsupported as unsupported_by_webgpu, WebGPUEffect, with_wgsl} from 'crease/webgpu';
import {translate} from 'naga-wasm';
import {PerspectiveCamera, WebGLRenderer} from 'three';
import {EffectComposer} from 'three/addons/postprocessing/EffectComposer.js';

const crease = await load(new URL('https://example.org/crease.wasm'));

export function labels(): string[] {
    return crease.parts.flatMap(({name, role, numbers, settings}) =>
        [`${role}: ${name}`, ...numbers.map(({least, most}) => `${least} to ${most}`), ...settings.map(({meaning}) => meaning)]);
}

export function composed(recipe: string): Effect | string {
    try {
        return crease.compose(recipe);
    } catch (error) {
        if (error instanceof RecipeError)
            return error.message;
        throw error;
    }
}

/** A manifest of `crease emit` and one that was composed are run alike. */
export function run(gl: WebGL2RenderingContext, manifest: Manifest, depth: WebGLTexture): WebGLTexture | undefined {
    if (unsupported(manifest) !== '')
        return undefined;
    const effect = new WebGL2Effect(gl, manifest, 640, 360, {guard: 16});
    const view: View = crease.view(new PerspectiveCamera().projectionMatrix.elements, 640, 360, {depthFromMinusOne: true, guard: 16});
    effect.setView(view);
    effect.set('views[0].resolution', [640, 360]);
    effect.bind('depth', depth);
    if (effect.lost)
        return undefined;
    effect.run();
    return effect.texture('visibility');
}

export async function run_webgpu(device: GPUDevice, depth: GPUTextureView, encoder: GPUCommandEncoder): Promise<GPUTexture | undefined> {
    const manifest: Manifest = with_wgsl(crease.compose('preset:low/webgpu'), translate);
    if (unsupported_by_webgpu(manifest) !== '')
        return undefined;
    const effect = await WebGPUEffect.create(device, manifest, 640, 360, {guard: 16});
    effect.bind('depth', depth);
    if (!effect.lost)
        effect.record(encoder, {timestamps: device.createQuerySet({type: 'timestamp', count: 2})});
    return effect.texture('visibility');
}

// @ts-expect-error pipelines are made while others wait
new WebGPUEffect();

export function bytes({resources}: Manifest): number {
    return resources.reduce((sum, {size, levels = 1}) => {
        const [width, height] = size ? size_of(size, 640, 360) : [0, 0];
        return sum + 4 * width * height * levels;
    }, 0);
}

export function add(renderer: WebGLRenderer, camera: PerspectiveCamera): EffectComposer {
    const composer = new EffectComposer(renderer);
    const pass = new CreasePass(camera, {crease, effect: crease.compose('preset:low/fragment/glsl_es:300'), blend: 'show'});
    pass.settings = {strength: 1.2};
    ++pass.frame;
    composer.addPass(pass);
    return composer;
}

// @ts-expect-error blend has three values
new CreasePass(new PerspectiveCamera(), {crease, recipe: 'preset:low', blend: 'screen'});
// @ts-expect-error the library is loaded first
new CreasePass(new PerspectiveCamera(), {recipe: 'preset:low'});
// @ts-expect-error a recipe is text
crease.compose(7);
// @ts-expect-error the convention has no such flag
crease.view(new Float32Array(16), 1, 1, {upsideDown: true});
