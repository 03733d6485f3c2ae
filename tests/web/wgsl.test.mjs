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

const {EMIT, MODULES, PACKAGE} = process.env;
need('naga-wasm', 'webgpu');
const folder = mkdtempSync(join(tmpdir(), 'crease-wgsl-'));
let crease, naga, gpu, device;

const formats = {r8_unorm: 'r8unorm', rgba8_unorm: 'rgba8unorm', r32_uint: 'r32uint', rg32_uint: 'rg32uint', rgba32_uint: 'rgba32uint',
                 r32_float: 'r32float', rgba16_float: 'rgba16float', rgba32_float: 'rgba32float'};

before(async () => {
    crease = await (await import(pathToFileURL(join(PACKAGE, 'crease.js')))).load();
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

const names_of = (role) => crease.parts.filter((part) => part.role === role).map(({name}) => name);

/** Every sampler and estimator over the sources of one layer, and every other part once. */
function recipes() {
    const fits = (recipe) => crease.check(`${recipe}/webgpu`) === '';
    const three = ['single_layer', 'depth_pyramid'].flatMap((source) =>
        names_of('sampler').flatMap((sampler) => names_of('estimator').map((estimator) => `${sampler}/${source}/${estimator}`)));
    const roles = ['projection', 'depth encoding', 'normals', 'noise', 'output', 'output format', 'filter', 'stage'];
    const base = 'directions:4x4/single_layer/hbao';
    return [
        ...three,
        ...roles.flatMap((role) => names_of(role).map((name) => `${base}/${name}`)),
        ...names_of('filter').map((name) => `${base}/${name}/fragment/bent_cone`),
        ...crease.presets.map(({name}) => `preset:${name}`),
    ].filter(fits).filter((recipe) => !recipe.includes('functions'));
}

/** The manifest, with a translation in place of each file's name. */
function translated(recipe) {
    execFileSync(EMIT, [`${recipe}/webgpu`, '--format', 'spirv', '-o', folder], {stdio: 'pipe'});
    const manifest = JSON.parse(readFileSync(join(folder, 'crease_shaders.json')));
    for (const shader of manifest.passes.flatMap(({shaders}) => shaders)) {
        const source = new Uint32Array(Uint8Array.from(readFileSync(join(folder, shader.file))).buffer);
        shader.code = naga.translate({from: 'spirv', source, to: 'wgsl'});
    }
    return manifest;
}

/** Makes the pipeline of a pass; what Dawn says of it, "" where it is content. */
async function complaint(pass, resources) {
    const stage_of = (wanted) => {
        const {code} = pass.shaders.find(({stage}) => stage === wanted);
        return {module: device.createShaderModule({code}), entryPoint: 'main'};
    };
    device.pushErrorScope('validation');
    if (pass.stage === 'compute') {
        device.createComputePipeline({layout: 'auto', compute: stage_of('compute')});
    } else {
        const targets = pass.bindings.filter(({access}) => access === 'attachment').map(({resource}) =>
            ({format: formats[resources.find(({name}) => name === resource).format]}));
        device.createRenderPipeline({layout: 'auto', vertex: stage_of('vertex'), fragment: {...stage_of('fragment'), targets}});
    }
    return (await device.popErrorScope())?.message ?? '';
}

test('naga translates every effect of a choice, and Dawn makes pipelines of it', async (context) => {
    const seen = new Set();
    const all = recipes();
    for (const recipe of all) {
        const {passes, resources} = translated(recipe);
        for (const pass of passes) {
            const text = pass.shaders.map(({code}) => code).join('');
            if (seen.has(text))
                continue;
            seen.add(text);
            assert.equal(await complaint(pass, resources), '', `${recipe}, pass ${pass.name}`);
        }
    }
    context.diagnostic(`${all.length} recipes of ${seen.size} different passes`);
    assert.ok(seen.size > 60);
});

test('Dawn does complain of what is wrong', async () => {
    const {passes, resources} = translated('directions:4x4/single_layer/hbao');
    passes[0].shaders[0].code = passes[0].shaders[0].code.replace('@workgroup_size(16, 16, 1)', '@workgroup_size(16, 32, 1)');
    assert.match(await complaint(passes[0], resources), /workgroup|invocations/i);
});

test('crease emit --target wgsl writes the same', () => {
    const {passes} = translated('preset:medium');
    execFileSync(EMIT, ['preset:medium', '--target', 'wgsl', '-o', folder], {cwd: join(MODULES, '..'), stdio: 'pipe'});
    const manifest = JSON.parse(readFileSync(join(folder, 'crease_shaders.json')));
    manifest.passes.forEach(({shaders: [{format, file}], dialect}, i) => {
        assert.deepEqual([format, dialect], ['wgsl', 'webgpu']);
        assert.equal(readFileSync(join(folder, file), 'utf8'), passes[i].shaders[0].code);
    });
});

test('where naga is missing, and where WebGPU cannot, a sentence says so and nothing is written', () => {
    const refused = (recipe, cwd, sentence) => assert.throws(
        () => execFileSync(EMIT, [recipe, '--target', 'wgsl', '-o', join(folder, 'none')], {cwd, stdio: 'pipe', env: {...process.env, NODE_PATH: ''}}),
        ({stderr}) => sentence.test(String(stderr).trim()));
    refused('preset:medium', folder, /^crease_emit: WGSL needs node, and naga-wasm .*npm install naga-wasm/);
    refused('preset:ultra_layers', join(MODULES, '..'), /WebGPU have no way to capture layers/);
    refused('box_area/n_buffer/unsharp_mask', join(MODULES, '..'), /WebGPU change no image of several numbers in place/);
});
