// SPDX-License-Identifier: MIT
// What the page draws by, in WebGPU.
import {WebGPUEffect, with_wgsl} from './package/webgpu.js';

import {fill, read, texture_of, with_fourth} from './gpu.js';
import {measure} from './gpu_clock.js';
import {GPUPicture} from './gpu_picture.js';
import {GPUScene} from './gpu_scene.js';
import {load_naga} from './naga.js';

function adapter() {
    return navigator.gpu?.requestAdapter() ?? null;
}

export class WebGPUGraphics {
    #picture;

    name = 'webgpu';

    /** What is added to each recipe: G-buffers hold linear depth. */
    host = 'linear_depth/webgpu';

    /** Why there is none here, in one sentence; "" where there is. */
    static async missing() {
        if (!navigator.gpu)
            return 'This browser has no WebGPU.';
        return await adapter() ? '' : 'This browser has WebGPU, and finds no device for it.';
    }

    static async open(canvas) {
        const found = await adapter();
        if (!found)
            throw new Error(await this.missing());
        const translate = await load_naga();
        const requiredFeatures = ['timestamp-query'].filter((feature) => found.features.has(feature));
        return new WebGPUGraphics(await found.requestDevice({requiredFeatures}), canvas, translate);
    }

    constructor(device, canvas, translate) {
        Object.assign(this, {device, translate, lost: device.lost});
        this.#picture = new GPUPicture(device, canvas);
    }

    /** An image of depths, of normals or of a truth, and its texels. */
    texture(content, width, height, texels) {
        const [format, bytes] = {depth: ['r32float', 4], normal: ['rgba32float', 16], truth: ['r8unorm', 1]}[content];
        const texture = texture_of(this.device, format, width, height, GPUTextureUsage.COPY_DST);
        fill(this.device, texture, bytes, content === 'normal' ? with_fourth(texels) : texels);
        return texture;
    }

    free(texture) {
        texture?.destroy();
    }

    effect(manifest, width, height) {
        return WebGPUEffect.create(this.device, with_wgsl(manifest, this.translate), width, height);
    }

    scene(triangles, width, height) {
        return new GPUScene(this.device, triangles, width, height);
    }

    draw(visibility, truth, how) {
        this.#picture.draw(visibility, truth, how);
    }

    /** The first component of each texel of an image of an effect. */
    read(texture) {
        return read(this.device, texture);
    }

    /** @param effect  gives the effect that is there at a time */
    measure(effect) {
        return measure(this.device, effect);
    }
}
