// SPDX-License-Identifier: MIT
// Draws triangles to a G-buffer by WebGPU, as Scene does by WebGL 2: linear depth, and the geometric normal in view space.
import {multiply} from './camera.js';
import {pipeline_of, texture_of} from './gpu.js';

const code = `
struct matrices { view: mat4x4f, projection: mat4x4f }
@group(0) @binding(0) var<uniform> given: matrices;

struct shaded { @builtin(position) place: vec4f, @location(0) position: vec3f }

@vertex fn corner(@location(0) corner: vec3f) -> shaded {
    let position = given.view * vec4f(corner, 1.0);
    return shaded(given.projection * position, position.xyz);
}

struct surface { @location(0) depth: f32, @location(1) normal: vec4f }

@fragment fn shade(in: shaded) -> surface {
    let across = normalize(cross(dpdx(in.position), dpdy(in.position)));
    return surface(-in.position.z, vec4f(select(-across, across, dot(across, in.position) < 0.0), 0.0));
}`;

/** From WebGL's clip space, whose depth begins at -1 and whose rows go up, to WebGPU's. */
const from_webgl = [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 1];

export class GPUScene {
    constructor(device, triangles, width, height) {
        Object.assign(this, {device, count: triangles.length / 3});
        this.corners = device.createBuffer({size: triangles.byteLength, usage: GPUBufferUsage.VERTEX | GPUBufferUsage.COPY_DST});
        device.queue.writeBuffer(this.corners, 0, triangles);
        this.matrices = device.createBuffer({size: 128, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
        const target = (format) => texture_of(device, format, width, height, GPUTextureUsage.RENDER_ATTACHMENT);
        Object.assign(this, {depth: target('r32float'), normal: target('rgba16float'), tested: target('depth24plus')});
        this.pipeline = pipeline_of(device, code, ['r32float', 'rgba16float'], {
            buffers: [{arrayStride: 12, attributes: [{shaderLocation: 0, offset: 0, format: 'float32x3'}]}],
            depth: {format: 'depth24plus', depthCompare: 'less', depthWriteEnabled: true},
        });
        this.group = device.createBindGroup({
            layout: this.pipeline.getBindGroupLayout(0), entries: [{binding: 0, resource: {buffer: this.matrices}}],
        });
    }

    draw(view, projection) {
        const {device} = this;
        device.queue.writeBuffer(this.matrices, 0, view);
        device.queue.writeBuffer(this.matrices, 64, multiply(from_webgl, projection));
        const encoder = device.createCommandEncoder();
        const cleared = (texture) => ({view: texture.createView(), loadOp: 'clear', storeOp: 'store'});
        const pass = encoder.beginRenderPass({
            colorAttachments: [cleared(this.depth), cleared(this.normal)],
            depthStencilAttachment: {view: this.tested.createView(), depthClearValue: 1, depthLoadOp: 'clear', depthStoreOp: 'discard'},
        });
        pass.setPipeline(this.pipeline);
        pass.setBindGroup(0, this.group);
        pass.setVertexBuffer(0, this.corners);
        pass.draw(this.count);
        pass.end();
        device.queue.submit([encoder.finish()]);
    }

    dispose() {
        [this.corners, this.matrices, this.depth, this.normal, this.tested].forEach((each) => each.destroy());
    }
}
