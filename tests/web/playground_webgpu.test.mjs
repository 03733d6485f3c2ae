// SPDX-License-Identifier: MIT
// The page with WebGPU, on Chromium's own SwiftShader: its pictures against those of the crease command, and the choice of the device.
import assert from 'node:assert/strict';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {need} from './packages.mjs';
import {apart, rendered} from './pictures.mjs';
import {open, page, use_playground, visibility} from './playground_page.mjs';

need('naga-wasm');
const folder = mkdtempSync(join(tmpdir(), 'crease-playground-webgpu-'));

// Without the latter three arguments a canvas of WebGPU ends the process that draws.
use_playground(/GPU stall due to ReadPixels/, // how a headless browser shows a canvas
               '--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader');
after(() => rmSync(folder, {recursive: true, force: true}));

function drawn(recipe, device) {
    return page.waitForFunction(([expected, by]) => document.body.dataset.drawn === expected && document.body.dataset.device === by, [recipe, device]);
}

for (const recipe of [
    'directions:4x4/single_layer/hbao/bilateral',
    'directions:4x4/depth_pyramid/hbao/reconstructed_normals/r32f',
])
    test(`WebGPU gives the picture of the command: ${recipe}`, async () => {
        await open(`recipe=${recipe}&device=webgpu`);
        await drawn(recipe, 'webgpu');
        const {mean, share} = apart(await visibility(), rendered(folder, recipe));
        assert.ok(mean <= 1e-4 && share <= 0.01, `mean ${mean}, share ${share}`);
    });

test('the device is chosen on the page, the link holds it, and the time is measured on it', async () => {
    const recipe = 'directions:4x4/single_layer/hbao';
    await open(`recipe=${recipe}`);
    await drawn(recipe, 'webgl2');
    const picture = await visibility();
    assert.doesNotMatch(page.url(), /device=/);
    await page.waitForFunction(() => document.getElementById('milliseconds').textContent !== '–');
    await page.getByLabel('Device').selectOption('webgpu');
    await drawn(recipe, 'webgpu');
    assert.match(page.url(), /device=webgpu/);
    const {mean, share} = apart(await visibility(), picture);
    assert.ok(mean <= 1e-4 && share <= 0.01, `mean ${mean}, share ${share}`);
    await page.waitForFunction(() => Number(document.getElementById('milliseconds').textContent) > 0 &&
                                     document.getElementById('milliseconds').dataset.device === 'webgpu');
    const pyramid = page.locator('#menu-depth-source option[value=depth_pyramid]');
    assert.equal(await pyramid.count(), 1); // which WebGL 2 does not run
    await page.getByLabel('Device').selectOption('webgl2');
    await drawn(recipe, 'webgl2');
    assert.equal(await pyramid.count(), 0);
    assert.deepEqual(await visibility(), picture);
});

test('the camera turns, and the picture is that of WebGL 2', async () => {
    const recipe = 'directions:4x4/single_layer/hbao', orbit = 'orbit=0.3,0.1,1';
    await open(`recipe=${recipe}&device=webgpu&${orbit}`);
    await drawn(recipe, 'webgpu');
    const picture = await visibility();
    await page.locator('#device').selectOption('webgl2');
    await drawn(recipe, 'webgl2');
    const {mean} = apart(await visibility(), picture);
    assert.ok(mean < 0.01, `mean ${mean}`);
    assert.ok(apart(picture, rendered(folder, recipe)).mean > 0.01);
});

test('of a lost device a sentence tells, and a button draws the same picture on another', async () => {
    const recipe = 'directions:4x4/single_layer/hbao';
    await open(`recipe=${recipe}&device=webgpu`);
    await drawn(recipe, 'webgpu');
    const picture = await visibility();
    await page.evaluate(() => globalThis.playground.stage.graphics.device.destroy());
    const again = page.getByRole('alert').getByRole('button', {name: 'Draw again'});
    await again.waitFor();
    assert.match(await page.locator('#lost').textContent(), /^The browser lost WebGPU, /);
    await again.click();
    await drawn(recipe, 'webgpu');
    assert.equal(await page.locator('#lost').textContent(), '');
    assert.deepEqual(await visibility(), picture);
});

test('where there is no device a sentence says so, and WebGL 2 draws', async () => {
    await page.addInitScript(() => Object.defineProperty(navigator, 'gpu', {value: {requestAdapter: async () => null}}));
    const recipe = 'directions:4x4/single_layer/hbao';
    await open(`recipe=${recipe}&device=webgpu`);
    await drawn(recipe, 'webgl2');
    await page.waitForFunction(() => document.querySelector('#device [value=webgpu]').disabled);
    assert.equal(await page.locator('#device-note').textContent(), 'This browser has WebGPU, and finds no device for it.');
    assert.equal(await page.locator('#device').inputValue(), 'webgl2');
    assert.doesNotMatch(page.url(), /device=/);
});
