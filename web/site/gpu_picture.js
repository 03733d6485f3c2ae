// SPDX-License-Identifier: MIT
// Shows visibility on the canvas by WebGPU, and right of the split what it is compared with, as Picture does by WebGL 2.
import {pipeline_of} from './gpu.js';

const code = `
struct choice {
    split: f32,  // texels
    beside: u32, // 0: nothing, 1: the truth, 2: the difference
}
@group(0) @binding(0) var<uniform> chosen: choice;
@group(0) @binding(1) var visibility: texture_2d<f32>;
@group(0) @binding(2) var truth: texture_2d<f32>;

@vertex fn corner(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(vec2u(index & 1, index >> 1)) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment fn shade(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let texel = vec2u(at.xy);
    let shown = textureLoad(visibility, texel, 0).r;
    let traced = textureLoad(truth, texel, 0).r;
    let difference = clamp((shown - traced) * 3.0, -1.0, 1.0);
    let far = select(vec3f(0.7, 0.09, 0.17), vec3f(0.13, 0.4, 0.67), difference < 0.0);
    let false_colour = mix(vec3f(0.97), far, abs(difference));
    let past = at.x - chosen.split;
    if (chosen.beside != 0 && abs(past) < 1.0) {
        return vec4f(0.12, 0.37, 0.66, 1.0);
    }
    if (chosen.beside == 0 || past < 0.0) {
        return vec4f(vec3f(shown), 1.0);
    }
    return vec4f(select(false_colour, vec3f(traced), chosen.beside == 1), 1.0);
}`;

export class GPUPicture {
    constructor(device, canvas) {
        Object.assign(this, {device, canvas, context: canvas.getContext('webgpu')});
        const format = navigator.gpu.getPreferredCanvasFormat();
        this.context.configure({device, format});
        this.pipeline = pipeline_of(device, code, [format]);
        this.choice = device.createBuffer({size: 8, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
    }

    /** @param truth  texture of the traced visibility, or null */
    draw(visibility, truth, {split, beside}) {
        const {device, pipeline, choice} = this;
        const chosen = new DataView(new ArrayBuffer(8));
        chosen.setFloat32(0, split * this.canvas.width, true);
        chosen.setUint32(4, truth ? {truth: 1, difference: 2}[beside] ?? 0 : 0, true);
        device.queue.writeBuffer(choice, 0, chosen.buffer);
        const encoder = device.createCommandEncoder();
        const pass = encoder.beginRenderPass({colorAttachments: [
            {view: this.context.getCurrentTexture().createView(), loadOp: 'clear', storeOp: 'store'},
        ]});
        pass.setPipeline(pipeline);
        const bound = [{buffer: choice}, visibility.createView(), (truth ?? visibility).createView()];
        pass.setBindGroup(0, device.createBindGroup({
            layout: pipeline.getBindGroupLayout(0), entries: bound.map((resource, binding) => ({binding, resource})),
        }));
        pass.draw(3);
        pass.end();
        device.queue.submit([encoder.finish()]);
    }
}
