// SPDX-License-Identifier: MIT
import type {Camera, DepthTexture, Texture, WebGLRenderTarget, WebGLRenderer} from 'three';
import {Pass} from 'three/addons/postprocessing/Pass.js';
import type {Crease, Manifest} from './crease.js';

export interface CreasePassOptions {
    /** What `load()` of `crease` gives. */
    crease: Crease;
    /** Of an effect of one layer, such as "preset:medium". Roles that it leaves open follow the camera and the textures. */
    recipe?: string;
    /** In place of a recipe: an effect of fragment passes in the dialect glsl_es:300, with texts. */
    effect?: Manifest;
    /** In view-space units, >= 0; else 1. */
    radius?: number;
    /** Else the depthTexture of the render target that the pass reads. */
    depth?: DepthTexture | null;
    /** What MeshNormalMaterial draws, at the size of the depth; else normals are reconstructed from depth. */
    normals?: Texture | null;
    /** What the pass draws: the picture times visibility, visibility alone, or nothing. Else "multiply". */
    blend?: 'multiply' | 'show' | 'none';
}

/**
 * Ambient occlusion for EffectComposer, before tone mapping. Depth may be standard, reversed or logarithmic, the camera of either
 * kind, and the target multisampled; the pass follows its size.
 */
export class CreasePass extends Pass {
    /** @throws TypeError where the options do not fit; the recipe is composed with the first frame. */
    constructor(camera: Camera, options: CreasePassOptions);
    camera: Camera;
    /** In view-space units, >= 0. */
    radius: number;
    depth: DepthTexture | null;
    normals: Texture | null;
    /** By name, such as `{strength: 1.2, 'hbao.bias': 0.1}`; what is left out has the effect's default. */
    settings: Record<string, number>;
    /** Changes the noise: count it up where frames are accumulated. */
    frame: number;
    /** The visibility of the last frame, in red: 1 open, 0 closed. */
    readonly texture: Texture;
    render(renderer: WebGLRenderer, writeBuffer: WebGLRenderTarget, readBuffer: WebGLRenderTarget): void;
    setSize(width: number, height: number): void;
    dispose(): void;
}
