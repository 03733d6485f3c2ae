// SPDX-License-Identifier: MIT
import type {Manifest, Size, View} from './crease.js';

/** The sides of an image for a picture of a size, all in texels. */
export function size_of(size: Size, width: number, height: number, guard?: number): [number, number];

/** Why WebGL 2 cannot run an effect, in one sentence; "" where it can. */
export function unsupported(manifest: Manifest): string;

/** An effect of fragment passes in the dialect glsl_es:300, made for one resolution. */
export class WebGL2Effect {
    /**
     * Makes its images and programs.
     * @param width,height  of the picture, texels
     * @throws Error where WebGL 2 or the device cannot run it, or the context is lost, in one sentence
     */
    constructor(gl: WebGL2RenderingContext, manifest: Manifest, width: number, height: number, options?: {guard?: number});
    /** Whether its context was lost since it was made: then it runs no more, and is made anew once the context is restored. */
    readonly lost: boolean;
    /** Sets a member of the uniform block by its name: "radius", "hbao.bias", "views[0].from_texel". */
    set(name: string, value: number | number[]): void;
    /** Sets a camera, that of the picture where no index is given. */
    setView(view: View, index?: number): void;
    /** Gives an input its texture, which stays the host's. Row 0 is the first of the convention of the camera. */
    bind(name: string, texture: WebGLTexture): void;
    /** The image of a resource, such as "visibility" once the effect has run. */
    texture(name: string): WebGLTexture | undefined;
    /**
     * Runs all passes. Afterwards no framebuffer, vertex array or sampler is bound; other state is as it was needed.
     * @throws Error where an input is not bound, or the context was lost
     */
    run(): void;
    /** Frees all but what was bound. */
    dispose(): void;
}
