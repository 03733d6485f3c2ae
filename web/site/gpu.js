// SPDX-License-Identifier: MIT
// What the drawing modules share of WebGPU.

export function texture_of(device, format, width, height, usage) {
    return device.createTexture({format, size: [width, height], usage: usage | GPUTextureUsage.TEXTURE_BINDING});
}

export function fill(device, texture, bytes, texels) {
    const {width, height} = texture;
    device.queue.writeTexture({texture}, texels, {bytesPerRow: bytes * width}, [width, height]);
}

/** WebGPU has no images of three floats. */
export function with_fourth(texels) {
    const made = new Float32Array(texels.length / 3 * 4);
    for (let from = 0, to = 0; from < texels.length; from += 3, to += 4)
        made.set(texels.subarray(from, from + 3), to);
    return made;
}

/** A pipeline that draws triangles to images of some formats by the functions `corner` and `shade` of a module. */
export function pipeline_of(device, code, formats, more = {}) {
    const module = device.createShaderModule({code});
    return device.createRenderPipeline({
        layout: 'auto', vertex: {module, entryPoint: 'corner', buffers: more.buffers},
        fragment: {module, entryPoint: 'shade', targets: formats.map((format) => ({format}))}, depthStencil: more.depth,
    });
}

/** The first component of each texel: of bytes from 0 to 1. */
export async function read(device, texture) {
    const {width, height, format} = texture;
    const [bytes, first] = {
        r8unorm: [1, (view, at) => view.getUint8(at) / 255],
        rgba8unorm: [4, (view, at) => view.getUint8(at) / 255],
        r32float: [4, (view, at) => view.getFloat32(at, true)],
    }[format];
    const bytesPerRow = Math.ceil(bytes * width / 256) * 256;
    const buffer = device.createBuffer({size: bytesPerRow * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({texture}, {buffer, bytesPerRow}, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const view = new DataView(buffer.getMappedRange());
    const texels = Float32Array.from({length: width * height}, (_, i) =>
        first(view, Math.floor(i / width) * bytesPerRow + (i % width) * bytes));
    buffer.destroy();
    return texels;
}
