// SPDX-License-Identifier: MIT
/// <reference types="@webgpu/types" />
import type {Manifest, Size, View} from './crease.js';

/** The sides of an image for a picture of a size, all in texels. */
export function size_of(size: Size, width: number, height: number, guard?: number): [number, number];

/** What of `translate` of the package naga-wasm is needed here. */
export type Translate = (input: {
    from: 'glsl';
    source: string;
    parse: {stage: 'compute' | 'fragment' | 'vertex'};
    to: 'wgsl';
}) => string;

/**
 * An effect in the dialect webgpu with WGSL in place of its GLSL. `crease emit --target wgsl` does the same beforehand.
 * @throws what `translate` throws
 */
export function with_wgsl(manifest: Manifest, translate: Translate): Manifest;

/** Why this module cannot run an effect in WebGPU, in one sentence; "" where it can. */
export function unsupported(manifest: Manifest): string;

/** An effect of compute and fragment passes in the dialect webgpu, with texts in WGSL, made for one resolution. */
export class WebGPUEffect {
    private constructor();
    /**
     * Makes its images and pipelines.
     * @param width,height  of the picture, texels
     * @throws Error where WebGPU or the device cannot run it, or the device is lost, in one sentence
     */
    static create(device: GPUDevice, manifest: Manifest, width: number, height: number, options?: {guard?: number}): Promise<WebGPUEffect>;
    /** Whether its device was lost: then it runs no more, and is made anew on another device. */
    readonly lost: boolean;
    /** Sets a member of the uniform block by its name: "radius", "hbao.bias", "views[0].from_texel". */
    set(name: string, value: number | number[]): void;
    /** Sets a camera, that of the picture where no index is given. */
    setView(view: View, index?: number): void;
    /** Gives an input its texture, made for TEXTURE_BINDING, or a view of one; it stays the host's. */
    bind(name: string, texture: GPUTexture | GPUTextureView): void;
    /** The image of a resource, such as "visibility" once the effect has run. */
    texture(name: string): GPUTexture | undefined;
    /**
     * Records all passes, and hands the parameters to the queue: they hold for what is submitted from now on.
     * @param options.timestamps  two queries: when the first pass begins, and when the last ends
     * @throws Error where an input is not bound, or the device was lost
     */
    record(encoder: GPUCommandEncoder, options?: {timestamps?: GPUQuerySet}): void;
    /** Records all passes and submits them, and throws what `record` throws. */
    run(): void;
    /** Frees all but what was bound. */
    dispose(): void;
}
