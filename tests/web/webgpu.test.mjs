// SPDX-License-Identifier: MIT
// crease/webgpu on an adapter of Dawn for node: pictures against those of the command, and of naga's two ways to WGSL against each other.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {read_pfm} from '../../web/bake/pfm.mjs';
import {views} from '../../web/bake/scenes.mjs';
import {reversed_projection_matrix} from '../../web/site/camera.js';
import {fill, read, texture_of, with_fourth} from '../../web/site/gpu.js';
import {need_adapter} from './dawn.mjs';
import {need, require} from './packages.mjs';
import {apart, rendered} from './pictures.mjs';

const {EMIT, MODULES, PACKAGE} = process.env;
need('naga-wasm');
const adapter = await need_adapter();
const folder = mkdtempSync(join(tmpdir(), 'crease-webgpu-'));
const camera = {...views[0].camera, width: 161, height: 89};
const {width, height} = camera;
let crease, webgpu, naga, device, inputs;

before(async () => {
    crease = await (await import(pathToFileURL(join(PACKAGE, 'crease.js')))).load();
    webgpu = await import(pathToFileURL(join(PACKAGE, 'webgpu.js')));
    naga = await import(pathToFileURL(require.resolve('naga-wasm')));
    const timed = ['timestamp-query'].filter((feature) => adapter.features.has(feature));
    device = await adapter.requestDevice({requiredFeatures: timed});
    rendered(folder, 'directions:4x4/single_layer/hbao', camera);
    inputs = {
        depth: uploaded('r32float', 4, read_pfm(join(folder, 'depth.pfm')).texels),
        normal: uploaded('rgba32float', 16, with_fourth(read_pfm(join(folder, 'normal.pfm')).texels)),
    };
});

after(() => {
    device?.destroy();
    rmSync(folder, {recursive: true, force: true});
});

function uploaded(format, bytes, texels) {
    const texture = texture_of(device, format, width, height, GPUTextureUsage.COPY_DST);
    fill(device, texture, bytes, texels);
    return texture;
}

/** An effect that is ready to run. */
async function made(manifest) {
    const effect = await webgpu.WebGPUEffect.create(device, manifest, width, height);
    effect.setView(crease.view(reversed_projection_matrix(camera, width / height), width, height));
    effect.set('radius', camera.ao_radius);
    for (const {name, lifetime} of manifest.resources)
        if (name in inputs && lifetime === 'input')
            effect.bind(name, inputs[name]);
    return effect;
}

async function picture_of(manifest) {
    const effect = await made(manifest);
    effect.run();
    const picture = await read(device, effect.texture('visibility'));
    effect.dispose();
    return picture;
}

const composed = (recipe) => webgpu.with_wgsl(crease.compose(`${recipe}/linear_depth/webgpu`), naga.translate);

/** The manifest of `crease emit --target wgsl`, with texts and texels. */
function emitted(recipe) {
    execFileSync(EMIT, [`${recipe}/linear_depth`, '--target', 'wgsl', '-o', folder], {cwd: join(MODULES, '..'), stdio: 'pipe'});
    const manifest = JSON.parse(readFileSync(join(folder, 'crease_shaders.json')));
    for (const shader of manifest.passes.flatMap(({shaders}) => shaders))
        shader.text = readFileSync(join(folder, shader.file), 'utf8');
    for (const resource of manifest.resources.filter(({texels}) => texels))
        resource.texels = new Uint32Array(Uint8Array.from(readFileSync(join(folder, resource.texels))).buffer);
    return manifest;
}

for (const recipe of [
    'directions:4x4/single_layer/hbao/bilateral',
    'directions:4x4/depth_pyramid/gtao/upsample/blue_noise',
    'tap_grid/single_layer/hbao_plus/multi_resolution',
    'hemisphere_points/single_layer/ssao/reconstructed_normals/tiled_noise/fragment',
    'slices/single_layer/gtao/compute_columns/r32f',
    'sample_box/summed_area_adaptive:4x2/mean_height',
    'box_area/n_buffer/unsharp_mask',
])
    test(`WebGPU gives the picture of the command, by GLSL as by SPIR-V: ${recipe}`, async () => {
        const picture = await picture_of(composed(recipe));
        assert.deepEqual(picture, await picture_of(emitted(recipe)));
        const {mean, share} = apart(picture, rendered(folder, recipe, camera));
        assert.ok(mean <= 1e-4 && share <= 0.01, `mean ${mean}, share ${share}`);
    });

test('the example runs what the command emits, and gives its picture', () => {
    const host = join(folder, 'host'), recipe = 'directions:4x4/depth_pyramid/hbao/bilateral';
    cpSync(fileURLToPath(new URL('../../examples/webgpu_host', import.meta.url)), host, {recursive: true});
    mkdirSync(join(host, 'node_modules'));
    symlinkSync(PACKAGE, join(host, 'node_modules/crease'));
    symlinkSync(join(MODULES, 'webgpu'), join(host, 'node_modules/webgpu'));
    const expected = rendered(folder, recipe, camera), output = join(folder, 'visibility.pfm');
    emitted(recipe);
    writeFileSync(join(folder, 'camera.json'), JSON.stringify(camera));
    const run = (manifest) => execFileSync(process.execPath, [join(host, 'webgpu_host.mjs'), join(folder, manifest),
                                                              join(folder, 'camera.json'), folder, output], {stdio: 'pipe'});
    run('crease_shaders.json');
    const {mean, share} = apart(read_pfm(output).texels, expected);
    assert.ok(mean <= 1e-4 && share <= 0.01, `mean ${mean}, share ${share}`);
    assert.throws(() => run('none.json'), ({status, stderr}) => status === 1 && /webgpu_host: .*none\.json/.test(stderr));
});

test('the parameters of one frame are not those of the next, and timestamps tell how long it took', async () => {
    const effect = await made(composed('directions:4x4/single_layer/hbao/bilateral'));
    effect.run();
    const first = await read(device, effect.texture('visibility'));
    effect.set('strength', 0);
    effect.run();
    assert.ok((await read(device, effect.texture('visibility'))).every((value) => value === 1));
    effect.set('strength', 1.15);
    const timed = device.features.has('timestamp-query'), encoder = device.createCommandEncoder();
    const timestamps = timed ? device.createQuerySet({type: 'timestamp', count: 2}) : undefined;
    effect.record(encoder, {timestamps});
    const resolved = device.createBuffer({size: 16, usage: GPUBufferUsage.QUERY_RESOLVE | GPUBufferUsage.COPY_SRC});
    const times = device.createBuffer({size: 16, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
    if (timed) {
        encoder.resolveQuerySet(timestamps, 0, 2, resolved, 0);
        encoder.copyBufferToBuffer(resolved, 0, times, 0, 16);
    }
    device.queue.submit([encoder.finish()]);
    assert.deepEqual(await read(device, effect.texture('visibility')), first);
    await times.mapAsync(GPUMapMode.READ);
    const [begin, end] = new BigUint64Array(times.getMappedRange());
    assert.ok(!timed || end > begin, `${begin} to ${end}`);
});

test('what cannot be is refused in a sentence', async () => {
    const refused = (manifest, sentence) => assert.rejects(webgpu.WebGPUEffect.create(device, manifest, width, height), ({message}) => sentence.test(message));
    const recipe = 'directions:4x4/single_layer/hbao';
    await refused(crease.compose(recipe), /^crease: the pass 'visibility' is compute in the dialect vulkan: WebGPU runs /);
    await refused(crease.compose(`${recipe}/webgpu`), /^crease: the pass 'visibility' has no text in WGSL$/);
    const broken = composed(recipe);
    broken.passes[0].shaders[0].text = broken.passes[0].shaders[0].text.replace('fn crease_noise', 'fn nobody');
    await refused(broken, /^crease: WebGPU refuses the pass 'visibility': .*crease_noise/s);
    const effect = await webgpu.WebGPUEffect.create(device, composed(recipe), width, height);
    assert.throws(() => effect.run(), /^Error: crease: nothing is bound to the input 'depth'$/);
    assert.throws(() => effect.bind('nobody', inputs.depth), /^RangeError: crease: the effect has no input 'nobody'$/);
    assert.throws(() => effect.set('nobody', 1), /^RangeError: crease: the effect has no parameter 'nobody'$/);
    assert.throws(() => effect.set('strength', -1), /^RangeError: crease: 'strength' must be from 0 to /);
});

test('a device that was lost is told of, before an effect is made and after', async () => { // the last, as it leaves none
    const manifest = composed('directions:4x4/single_layer/hbao'), effect = await made(manifest);
    effect.run();
    const begun = webgpu.WebGPUEffect.create(device, manifest, width, height);
    assert.equal(effect.lost, false);
    device.destroy();
    await device.lost;
    const sentence = /^Error: crease: the device was lost, so make another, and the effect anew on it: ./;
    assert.equal(effect.lost, true);
    assert.throws(() => effect.run(), sentence);
    await assert.rejects(begun, sentence);
    await assert.rejects(webgpu.WebGPUEffect.create(device, manifest, width, height), sentence);
    effect.dispose();
});
