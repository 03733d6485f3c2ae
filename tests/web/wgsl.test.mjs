// SPDX-License-Identifier: MIT
// Effects in WGSL: naga makes it of the SPIR-V of the dialect webgpu, and Dawn accepts the modules and makes pipelines of them. No device
// is needed, as Dawn's null backend draws nothing.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';

import {need, require} from './packages.mjs';
import {webgpu_recipes} from './recipes.mjs';

const {EMIT, MODULES, PACKAGE} = process.env;
need('naga-wasm', 'webgpu');
const folder = mkdtempSync(join(tmpdir(), 'crease-wgsl-'));
let crease, webgpu, naga, gpu, device;

before(async () => {
    crease = await (await import(pathToFileURL(join(PACKAGE, 'crease.js')))).load();
    webgpu = await import(pathToFileURL(join(PACKAGE, 'webgpu.js')));
    naga = await import(pathToFileURL(require.resolve('naga-wasm')));
    const dawn = await import(pathToFileURL(require.resolve('webgpu')));
    Object.assign(globalThis, dawn.globals);
    gpu = dawn.create(['backend=null']); // which must outlive the device
    device = await (await gpu.requestAdapter()).requestDevice();
});

after(() => {
    device?.destroy();
    rmSync(folder, {recursive: true, force: true});
});

/** The manifest, with a translation in place of each file's name. */
function translated(recipe) {
    execFileSync(EMIT, [`${recipe}/webgpu`, '--format', 'spirv', '-o', folder], {stdio: 'pipe'});
    const manifest = JSON.parse(readFileSync(join(folder, 'crease_shaders.json')));
    for (const shader of manifest.passes.flatMap(({shaders}) => shaders)) {
        const source = new Uint32Array(Uint8Array.from(readFileSync(join(folder, shader.file))).buffer);
        Object.assign(shader, {format: 'wgsl', text: naga.translate({from: 'spirv', source, to: 'wgsl'})});
    }
    for (const resource of manifest.resources.filter(({texels}) => texels))
        resource.texels = new Uint32Array(Uint8Array.from(readFileSync(join(folder, resource.texels))).buffer);
    return manifest;
}

/** What Dawn says of the pipelines and images of a manifest, "" where it is content. */
async function complaint(manifest) {
    device.pushErrorScope('validation');
    const refused = await webgpu.WebGPUEffect.create(device, manifest, 64, 48).then((effect) => effect.dispose(), ({message}) => message);
    const otherwise = await device.popErrorScope();
    return refused ?? otherwise?.message ?? '';
}

test('naga translates every effect of a choice, and its GLSL too, and Dawn makes pipelines of both', async (context) => {
    const seen = new Set();
    const all = webgpu_recipes(crease);
    for (const recipe of all)
        for (const [from, manifest] of [['SPIR-V', translated(recipe)],
                                        ['GLSL', webgpu.with_wgsl(crease.compose(`${recipe}/webgpu`), naga.translate)]]) {
            const texts = manifest.passes.map(({shaders}) => shaders.map(({text}) => text).join(''));
            if (texts.every((text) => seen.has(text)))
                continue;
            texts.forEach((text) => seen.add(text));
            assert.equal(await complaint(manifest), '', `${recipe} by ${from}`);
        }
    context.diagnostic(`${all.length} recipes of ${seen.size} different passes`);
    assert.ok(seen.size > 120);
});

test('Dawn does complain of what is wrong', async () => {
    const wrong = (change) => {
        const manifest = translated('directions:4x4/single_layer/hbao');
        change(manifest.passes[0]);
        return complaint(manifest);
    };
    const replaced = (from, to) => ({shaders: [shader]}) => (shader.text = shader.text.replace(from, to));
    assert.match(await wrong(replaced('@workgroup_size(16, 16, 1)', '@workgroup_size(16, 32, 1)')), /workgroup|invocations/i);
    assert.match(await wrong(replaced('@binding(1)', '@binding(7)')), /binding/i);
});

test('crease emit --target wgsl writes the same', () => {
    const {passes} = translated('preset:medium');
    execFileSync(EMIT, ['preset:medium', '--target', 'wgsl', '-o', folder], {cwd: join(MODULES, '..'), stdio: 'pipe'});
    const manifest = JSON.parse(readFileSync(join(folder, 'crease_shaders.json')));
    manifest.passes.forEach(({shaders: [{format, file}], dialect}, i) => {
        assert.deepEqual([format, dialect], ['wgsl', 'webgpu']);
        const [origin, ...text] = readFileSync(join(folder, file), 'utf8').split('\n');
        assert.ok(origin.startsWith('// ') && origin.endsWith('SPDX-License-Identifier: MIT-0'), origin);
        assert.equal(text.join('\n'), passes[i].shaders[0].text);
    });
});

test('where naga is missing, and where WebGPU cannot, a sentence says so and nothing is written', () => {
    const refused = (recipe, cwd, sentence) => assert.throws(
        () => execFileSync(EMIT, [recipe, '--target', 'wgsl', '-o', join(folder, 'none')], {cwd, stdio: 'pipe', env: {...process.env, NODE_PATH: ''}}),
        ({stderr}) => sentence.test(String(stderr).trim()));
    refused('preset:medium', folder, /^crease_emit: WGSL needs node, and naga-wasm .*npm install naga-wasm/);
    refused('preset:ultra_layers', join(MODULES, '..'), /WebGPU have no way to capture layers/);
    refused('box_area/summed_area/unsharp_mask/subgroup_scan', join(MODULES, '..'), /WebGPU promise no operations of subgroups/);
});
