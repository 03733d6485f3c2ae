// SPDX-License-Identifier: MIT
// crease/three in headless Chromium: the pictures of three.js's composer against those of the command, for the same scene.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';

import {read_pfm} from '../../web/bake/pfm.mjs';
import {serve} from '../../web/serve.mjs';
import {need, need_browser, new_page} from './packages.mjs';

const {CREASE, MODULES, PACKAGE} = process.env;
need('three');
const launch = need_browser();
const here = fileURLToPath(new URL('.', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'crease-three-'));

/** Boxes on a floor, as three.js and as the command read them. */
function box(low, high, scene) {
    const first = scene.positions.length / 3;
    for (let i = 0; i < 8; ++i)
        scene.positions.push(...[0, 1, 2].map((axis) => (i >> axis & 1 ? high : low)[axis]));
    for (const corner of [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5])
        scene.indices.push(first + corner);
}
const scene = {positions: [], indices: []};
box([-6, -0.5, -6], [6, 0, 6], scene);
box([-1, 0, -1], [0.4, 1.2, 0.3], scene);
box([0.5, 0, -0.8], [1.3, 0.5, 0.9], scene);
box([-0.6, 1.2, -0.6], [0, 1.6, 0], scene);
const camera = {name: 'aside', eye: [2.1, 1.9, 3.2], target: [0, 0.4, 0], up: [0, 1, 0], vfov_deg: 45, near: 0.1, far: 40,
                width: 161, height: 103, ao_radius: 0.6};

/** Of the command: visibility from 0 to 255, row 0 at the top. */
function of_command(recipe, ...options) {
    const vertices = Array.from({length: scene.positions.length / 3}, (_, i) => `v ${scene.positions.slice(3 * i, 3 * i + 3).join(' ')}`);
    const faces = Array.from({length: scene.indices.length / 3}, (_, i) => `f ${scene.indices.slice(3 * i, 3 * i + 3).map((k) => k + 1).join(' ')}`);
    writeFileSync(join(folder, 'boxes.obj'), [...vertices, ...faces, ''].join('\n'));
    writeFileSync(join(folder, 'boxes.cameras.json'), JSON.stringify([camera]));
    execFileSync(CREASE, ['render', join(folder, 'boxes.obj'), '--recipe', recipe, '-o', folder, ...options], {stdio: 'pipe'});
    return Array.from(read_pfm(join(folder, 'ao.pfm')).texels, (value) => 255 * value);
}

/** The mean of how far two pictures are apart, in shares of 1. */
function apart(one, other) {
    assert.equal(one.length, other.length);
    return one.reduce((sum, value, i) => sum + Math.abs(value - other[i]), 0) / one.length / 255;
}

let address, browser, page, server;
const said = [];
const draw = (how) => page.evaluate((options) => window.draw(options), {scene, camera, radius: camera.ao_radius, ...how});

before(async () => {
    const site = join(folder, 'site');
    mkdirSync(site);
    for (const [name, place] of [['package', PACKAGE], ['three', join(MODULES, 'three')], ['three.html', join(here, 'three.html')],
                                 ['three_page.js', join(here, 'three_page.js')]])
        symlinkSync(place, join(site, name));
    ({server, address} = await serve(site));
    browser = await launch('--use-angle=swiftshader', '--enable-unsafe-swiftshader');
    page = await new_page(browser);
    page.on('console', (message) => said.push(message.text()));
    page.on('pageerror', (error) => said.push(String(error)));
    await page.goto(`${address}three.html`);
    await page.waitForFunction(() => window.ready).catch((error) => assert.fail(`${error}: ${said}`));
});

after(async () => {
    await browser?.close();
    server?.close();
    rmSync(folder, {recursive: true, force: true});
});

// So many directions that noise counts for little: WebGL has its rows from the bottom, and so other noise.
const recipe = 'directions:24x12/single_layer/hbao';
const most = 2e-3, most_of_samples = 5e-3;

for (const [name, how, parts = '/reconstructed_normals', options = [], allowed = most] of [
    ['standard depth', {}],
    ['reversed depth', {renderer: {reversedDepthBuffer: true}}],
    ['logarithmic depth', {renderer: {logarithmicDepthBuffer: true}}],
    ['an orthographic camera', {orthographic: true}, '/reconstructed_normals/orthographic', ['--orthographic']],
    ['an orthographic camera with logarithmic depth', {orthographic: true, renderer: {logarithmicDepthBuffer: true}},
     '/reconstructed_normals/orthographic', ['--orthographic']],
    ['normals that MeshNormalMaterial draws', {given: true}, ''],
    ['several samples', {samples: 4}, '/reconstructed_normals', [], most_of_samples],
])
    test(`${name}: the picture is the command's`, async (context) => {
        const made = await draw({recipe, ...how});
        assert.deepEqual([made.width, made.height, made.error], [camera.width, camera.height, 0]);
        assert.equal(made.reversed, how.renderer?.reversedDepthBuffer === true);
        const expected = of_command(recipe + parts, ...options);
        assert.ok(expected.some((value) => value < 128));
        const found = apart(made.visibility, expected);
        context.diagnostic(`mean difference ${found.toExponential(2)}`);
        assert.ok(found <= allowed, `${found} is more than ${allowed}`);
    });

test('a preset with filters runs, the canvas shows the picture times visibility, and settings count', async () => {
    const made = await draw({recipe: 'preset:low'});
    assert.equal(made.error, 0);
    assert.ok(Math.abs(made.shown - made.middle * made.grey) <= 1.5, `${made.shown} of ${made.middle}`);
    const shown = await draw({recipe: 'preset:low', blend: 'show'});
    assert.ok(Math.abs(shown.shown - shown.middle) <= 1.5);
    const mean = ({visibility}) => visibility.reduce((sum, value) => sum + value, 0);
    assert.ok(mean(await draw({recipe, settings: {strength: 0.2}})) > mean(await draw({recipe})));
});

test('pixel ratios and changes of size: visibility has the size of what the pass reads', async () => {
    const dense = await draw({recipe: 'preset:low', ratio: 1.5});
    assert.deepEqual([dense.width, dense.height, dense.error], [Math.floor(161 * 1.5), Math.floor(103 * 1.5), 0]);
    const changed = await draw({recipe: 'preset:low', resize: [160, 120]});
    assert.deepEqual([changed.width, changed.height, changed.error], [160, 120, 0]);
});

test('a context that was lost and restored gives the same picture', async () => {
    const before_loss = await draw({recipe: 'preset:low'}), after_it = await draw({recipe: 'preset:low', lose: true});
    assert.deepEqual([after_it.error, after_it.shown], [0, before_loss.shown]);
    assert.deepEqual(after_it.visibility, before_loss.visibility);
    const of_three = /delete\w*: object does not belong to this context/; // which disposes of what the lost context made
    assert.deepEqual(said.splice(0).filter((message) => !of_three.test(message)), ['THREE.WebGLRenderer: Context Lost.', 'THREE.WebGLRenderer: Context Restored.']);
});

test('what does not fit is said in a sentence', async () => {
    await assert.rejects(draw({recipe: 'directions/stochastic_layers/hbao'}), /GLSL ES/);
    await assert.rejects(draw({recipe: 'nobody'}), /crease::recipe/);
    await assert.rejects(draw({recipe, blend: 'screen'}), /blend is/);
    await assert.rejects(draw({recipe, settings: {nobody: 1}}), /no parameter 'nobody'/);
});

test('no message in the console', () => assert.deepEqual(said, []));
