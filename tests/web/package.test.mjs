// SPDX-License-Identifier: MIT
// The npm package as a user has it: packed, installed from the file, and compared with what crease_emit writes.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {after, before, test} from 'node:test';
import {gzipSync} from 'node:zlib';

const {EMIT, NPM, PACKAGE} = process.env;
const folder = mkdtempSync(join(tmpdir(), 'crease-package-'));
const installed = join(folder, 'node_modules/crease');
let module, crease;

function npm(...words) {
    return execFileSync(NPM, [...words, '--offline', '--no-audit', '--no-fund'], {cwd: folder, encoding: 'utf8'});
}

before(async () => {
    const [{filename}] = JSON.parse(npm('pack', PACKAGE, '--json'));
    writeFileSync(join(folder, 'package.json'), '{"private": true}');
    npm('install', join(folder, filename));
    module = await import(pathToFileURL(join(installed, 'crease.js')));
    crease = await module.load();
});

after(() => rmSync(folder, {recursive: true, force: true}));

/** What crease_emit says of a recipe, the texts in place of the names of their files. */
function emitted(recipe) {
    execFileSync(EMIT, [recipe, '--format', 'glsl', '-o', join(folder, 'emitted')]);
    const read = (name) => readFileSync(join(folder, 'emitted', name));
    const manifest = JSON.parse(read('crease_shaders.json'));
    for (const shader of manifest.passes.flatMap(({shaders}) => shaders)) {
        shader.text = read(shader.file).toString();
        delete shader.file;
    }
    for (const resource of manifest.resources.filter(({texels}) => texels))
        resource.texels = new Uint32Array(Uint8Array.from(read(resource.texels)).buffer);
    delete manifest.files;
    return manifest;
}

test('an effect is what crease_emit writes, text by text and number by number', () => {
    const recipes = [
        'directions:8x4/single_layer/hbao/bilateral',
        'directions:8x4/single_layer/hbao/bilateral/fragment/opengl',
        'hemisphere_points/single_layer/ssao/upsample/blue_noise/reconstructed_normals',
        'hemisphere_points/stochastic_layers/ssao/second_view',
        'sample_box/summed_area_adaptive/mean_height',
        'directions/linked_lists/hbao',
        'directions/depth_pyramid/hbao',
        'directions/single_layer/hbao/functions:1x2x3',
        ...crease.presets.map(({name}) => `preset:${name}`),
    ];
    for (const recipe of recipes) {
        const {parts, ...effect} = crease.compose(recipe);
        assert.deepEqual(effect, emitted(recipe), recipe);
        assert.ok(parts.length >= 3);
    }
});

test('what does not fit is refused in the sentence of the command', () => {
    for (const recipe of ['', 'nobody', 'directions:8x4/single_layer/ssao', 'preset:nobody', 'directions:0/single_layer/hbao']) {
        const sentence = crease.check(recipe);
        assert.match(sentence, /^crease::(recipe|effect): /);
        assert.throws(() => crease.compose(recipe), {name: 'RecipeError', message: sentence});
        assert.throws(() => execFileSync(EMIT, [recipe, '-o', folder], {stdio: 'pipe'}),
                      ({stderr}) => stderr.toString().includes(sentence), recipe);
    }
});

test('the parts have names, roles and ranges, and the version is that of the package', () => {
    assert.equal(crease.version, JSON.parse(readFileSync(join(installed, 'package.json'))).version);
    const directions = crease.parts.find(({name}) => name === 'directions');
    assert.equal(directions.role, 'sampler');
    assert.deepEqual(directions.numbers.map(({name}) => name), ['count', 'steps', 'power']);
    for (const {numbers} of crease.parts)
        for (const {least, most, fallback} of numbers)
            assert.ok(least <= fallback && fallback <= most);
});

test('a camera of a projection matrix, or a sentence', () => {
    const view = crease.view([1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, -1, 0, 0, 0.5, 0], 64, 32);
    assert.deepEqual(view.from_texel, [2 / 64, -2 / 32, -1, 1]);
    assert.deepEqual(view.depth_unpack, [2, 0]);
    assert.deepEqual(view.resolution, [64, 32]);
    assert.throws(() => crease.view(new Float32Array(16), 64, 32), /the matrix is no projection/);
    assert.throws(() => crease.view([1, 2, 3], 64, 32), /16 numbers/);
});

test('composing takes milliseconds, and a thousand times leaks nothing', () => {
    const recipe = 'directions:8x4/single_layer/hbao/bilateral';
    crease.compose(recipe);
    const begin = process.cpuUsage();
    for (let i = 0; i < 1000; ++i)
        crease.compose(recipe);
    const {user, system} = process.cpuUsage(begin);
    assert.ok((user + system) / 1e6 < 10, `${(user + system) / 1e6} ms`);
});

test('the module is small', () => {
    const size = gzipSync(readFileSync(join(installed, 'crease.wasm')), {level: 9}).length;
    assert.ok(size < 128 * 1024, `${size} bytes zipped`);
});
