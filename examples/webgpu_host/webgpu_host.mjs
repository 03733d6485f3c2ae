// SPDX-License-Identifier: MIT
// Runs an effect by what `crease emit --target wgsl` wrote, on the G-buffer of `crease render`, in WebGPU by Dawn for node:
//     crease render built-in --recipe directions:8x4/single_layer/hbao/linear_depth -o gbuffer
//     crease emit directions:8x4/single_layer/hbao/linear_depth --target wgsl -o shaders
//     node webgpu_host.mjs shaders/crease_shaders.json camera.json gbuffer visibility.pfm
// The camera is that of the G-buffer, {"vfov_deg", "near", "far", "ao_radius"}. A browser's host differs in where the device comes from.
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';

import {load} from 'crease';
import {WebGPUEffect} from 'crease/webgpu';
import {create, globals} from 'webgpu';

import {read_pfm, write_pfm} from './pfm.mjs';

Object.assign(globalThis, globals);

/** A manifest with texts and texels in place of the files that it names. */
function read_manifest(path) {
    const manifest = JSON.parse(readFileSync(path));
    const beside = (file) => readFileSync(join(dirname(path), file));
    for (const {shaders} of manifest.passes)
        for (const shader of shaders)
            shader.text = beside(shader.file).toString();
    for (const resource of manifest.resources.filter(({texels}) => texels))
        resource.texels = new Uint32Array(Uint8Array.from(beside(resource.texels)).buffer);
    return manifest;
}

/** Column-major, for WebGPU's clip space; depth is reversed, as `crease render` has it. */
function projection_of({vfov_deg, near, far}, aspect) {
    const scale = 1 / Math.tan(vfov_deg * Math.PI / 360), range = near / (far - near);
    return [scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, range, -1, 0, 0, far * range, 0];
}

/** A texture of four floats where a texel has three, as WebGPU has none of these. */
function upload(device, {width, height, channels, texels}) {
    const [format, bytes] = channels === 1 ? ['r32float', 4] : ['rgba32float', 16];
    const all = channels === 1 ? texels
        : Float32Array.from({length: 4 * width * height}, (_, i) => (i % 4 < 3 ? texels[3 * Math.floor(i / 4) + i % 4] : 0));
    const texture = device.createTexture({size: [width, height], format, usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST});
    device.queue.writeTexture({texture}, all, {bytesPerRow: bytes * width}, [width, height]);
    return texture;
}

/** The first component of an image of bytes, from 0 to 1. */
async function download(device, texture) {
    const {width, height, format} = texture, bytes = format === 'r8unorm' ? 1 : 4;
    const bytesPerRow = Math.ceil(bytes * width / 256) * 256;
    const buffer = device.createBuffer({size: bytesPerRow * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({texture}, {buffer, bytesPerRow}, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const all = new Uint8Array(buffer.getMappedRange());
    return Float32Array.from({length: width * height}, (_, i) => all[Math.floor(i / width) * bytesPerRow + (i % width) * bytes] / 255);
}

async function main(manifest_path, camera_path, gbuffer, output, gpu) {
    const adapter = await gpu.requestAdapter();
    if (!adapter)
        throw new Error('there is no adapter for WebGPU');
    const device = await adapter.requestDevice();
    const manifest = read_manifest(manifest_path), camera = JSON.parse(readFileSync(camera_path));
    const depth = read_pfm(join(gbuffer, 'depth.pfm')), {width, height} = depth;

    const effect = await WebGPUEffect.create(device, manifest, width, height);
    const crease = await load();
    effect.setView(crease.view(projection_of(camera, width / height), width, height, {yUp: true}));
    effect.set('radius', camera.ao_radius);
    effect.bind('depth', upload(device, depth));
    if (manifest.resources.some(({name}) => name === 'normal'))
        effect.bind('normal', upload(device, read_pfm(join(gbuffer, 'normal.pfm'))));
    effect.run();

    write_pfm(output, width, height, await download(device, effect.texture('visibility')));
    device.destroy();
}

if (process.argv.length !== 6) {
    console.error('webgpu_host: MANIFEST CAMERA GBUFFER OUTPUT');
    process.exit(2);
}
const gpu = create([]); // which outlives the device
try {
    await main(...process.argv.slice(2), gpu);
} catch (error) {
    console.error(`webgpu_host: ${error.message}`);
    process.exitCode = 1;
}
