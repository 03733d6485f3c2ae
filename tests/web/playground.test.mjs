// SPDX-License-Identifier: MIT
// The page in headless Chromium: its pictures against those of the crease command, and what a visitor does.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {apart, rendered} from './pictures.mjs';
import {floats, open, page, use_playground, visibility} from './playground_page.mjs';

const {CREASE} = process.env;
const folder = mkdtempSync(join(tmpdir(), 'crease-playground-'));

// How a headless browser shows a canvas, finds no device for WebGPU, and loses a context.
use_playground(/GPU stall due to ReadPixels|No available adapters|CONTEXT_LOST_WEBGL/);
after(() => rmSync(folder, {recursive: true, force: true}));

function drawn(recipe) {
    return page.waitForFunction((expected) => document.body.dataset.drawn === expected, recipe);
}

function text_of(id) {
    return page.locator(`#${id}`).textContent();
}

for (const recipe of [
    'preset:medium/r32f',
    'directions:4x4/single_layer/hbao/bilateral',
    'directions:4x4/single_layer/hbao/reconstructed_normals/r32f',
    'hemisphere_points/single_layer/ssao/blue_noise',
    'slices/single_layer/gtao',
    'box_window:7/single_layer/unsharp_mask',
])
    test(`WebGL 2 gives the picture of the command: ${recipe}`, async () => {
        await open(`recipe=${recipe}`);
        await drawn(recipe);
        const {mean, share} = apart(await visibility(), rendered(folder, recipe));
        assert.ok(mean <= 1e-4 && share <= 0.01, `mean ${mean}, share ${share}`);
    });

/** Gives shaders sines to the last bits, where those of a device turn directions by up to 2e-4. */
function use_exact_sines() {
    const exact = `precision highp int;
float exact_sin(float x) {
    float turns = round(x * 0.636619772), r = (x - turns * 1.5703125) - turns * 4.83826795e-4, q = r * r;
    float sine = r * (1.0 + q * (-1.66666667e-1 + q * (8.33333333e-3 + q * (-1.98412698e-4 + q * 2.75573192e-6))));
    float cosine = 1.0 + q * (-0.5 + q * (4.16666667e-2 + q * (-1.38888889e-3 + q * (2.48015873e-5 - q * 2.75573192e-7))));
    float value = (int(turns) & 1) == 1 ? cosine : sine;
    return (int(turns) & 2) == 2 ? -value : value;
}
float exact_cos(float x) { return exact_sin(x + 1.57079633); }
#define sin(x) exact_sin(x)
#define cos(x) exact_cos(x)
`;
    const given = WebGL2RenderingContext.prototype.shaderSource;
    WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
        given.call(this, shader, text.replace('precision highp int;', exact));
    };
}

test('with sines as exact as the command has them nothing else is left', async () => {
    await page.addInitScript(use_exact_sines);
    for (const recipe of ['preset:medium/r32f', 'directions:4x4/single_layer/hbao/r32f']) {
        await page.goto('about:blank');
        await open(`recipe=${recipe}`);
        await drawn(recipe);
        const {mean, share} = apart(await visibility(), rendered(folder, recipe));
        assert.ok(mean <= 1e-6 && share <= 1e-3, `${recipe}: mean ${mean}, share ${share}`);
    }
});

test('the figures are those of crease compare', async () => {
    await open('recipe=directions:4x4/single_layer/hbao/bilateral');
    await page.waitForFunction(() => document.getElementById('ssim-linear').textContent !== '–');
    const shown = await Promise.all(['rmse-hard', 'ssim-hard', 'rmse-linear', 'ssim-linear'].map(async (id) => Number(await text_of(id))));
    const made = await visibility(), counts = await floats(() => globalThis.playground.stage.counts);
    const truths = {
        hard: await floats(() => globalThis.playground.stage.truths.hard),
        linear: await floats(() => globalThis.playground.stage.truths.linear),
    };
    const width = await page.evaluate(() => globalThis.playground.stage.width);
    const write = (name, texels) => {
        const height = texels.length / width, rows = new Float32Array(texels.length);
        for (let y = 0; y < height; ++y)
            rows.set(texels.slice((height - 1 - y) * width, (height - y) * width), y * width);
        writeFileSync(join(folder, name), Buffer.concat([Buffer.from(`Pf\n${width} ${height}\n-1\n`), Buffer.from(rows.buffer)]));
        return join(folder, name);
    };
    const measured = ['hard', 'linear'].flatMap((kind) => {
        const said = JSON.parse(execFileSync(CREASE, ['compare', write('test.pfm', made), write('truth.pfm', truths[kind]),
            '--depth', write('depth.pfm', counts.map((is) => (is ? 1 : 100))), '--far', '100', '--json'], {encoding: 'utf8'}));
        return [said.rmse, said.ssim];
    });
    measured.forEach((value, i) => assert.ok(Math.abs(value - shown[i]) < 1e-4, `${value} and ${shown[i]}`));
});

test('a slider changes the picture, the figures and the link, and the link brings it back', async () => {
    await open('recipe=directions:4x4/single_layer/hbao');
    await page.waitForFunction(() => document.getElementById('rmse-linear').textContent !== '–');
    const before_change = await text_of('rmse-linear');
    await page.locator('#settings .number', {hasText: 'strength'}).locator('input[type=number]').fill('2');
    await page.keyboard.press('Tab');
    await page.waitForFunction((old) => document.getElementById('rmse-linear').textContent !== old, before_change);
    await page.getByLabel('count', {exact: true}).first().focus();
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => document.body.dataset.drawn?.startsWith('directions:5x4'));
    await page.locator('#split').fill('0.25');
    const link = page.url();
    const picture = await visibility();
    assert.match(link, /recipe=directions:5x4x2\/single_layer\/hbao/);
    assert.match(link, /set\.strength=2/);
    assert.match(link, /split=0\.25/);
    await page.goto('about:blank');
    await page.goto(link);
    await drawn('directions:5x4x2/single_layer/hbao');
    assert.deepEqual(await visibility(), picture);
    assert.equal(await page.locator('#split').inputValue(), '0.25');
});

test('what does not fit is refused in the sentence of the command, and the picture stays', async () => {
    await open('recipe=directions:4x4/single_layer/hbao');
    await drawn('directions:4x4/single_layer/hbao');
    const picture = await visibility();
    for (const recipe of ['directions/single_layer/ssao', 'nobody', 'directions/depth_pyramid/hbao']) {
        await page.locator('#recipe').fill(recipe);
        await page.keyboard.press('Enter');
        const sentence = await text_of('refusal');
        const command = recipe.includes('pyramid') ? ['--stage', 'fragment', '--dialect', 'glsl_es:300'] : [];
        assert.throws(() => execFileSync(CREASE, ['emit', recipe, ...command, '-o', folder], {stdio: 'pipe'}),
                      ({stderr}) => stderr.toString().includes(sentence.replace(/^crease::\w+: /, '').replace(/ \(.*$/, '')), sentence);
        assert.notEqual(sentence, '');
    }
    assert.deepEqual(await visibility(), picture);
    await page.locator('#recipe').fill('directions:4x4/single_layer/hbao/bilateral');
    await page.keyboard.press('Enter');
    await drawn('directions:4x4/single_layer/hbao/bilateral');
    assert.equal(await text_of('refusal'), '');
});

test('each entry of the menus makes a recipe that is drawn, by the keyboard alone', async () => {
    await open('recipe=directions:4x4/single_layer/hbao');
    const estimators = await page.locator('#menu-estimator option').evaluateAll((all) => all.map(({value}) => value));
    assert.ok(estimators.length >= 8, estimators.join());
    for (const name of estimators) {
        await page.locator('#menu-estimator').selectOption(name);
        await page.waitForFunction((wanted) => document.body.dataset.drawn?.split('/')[2].startsWith(wanted), name);
        assert.equal(await text_of('refusal'), '');
    }
});

test('the text is that of the command, in the dialect that is chosen', async () => {
    await open('recipe=preset:medium');
    await drawn('preset:medium');
    execFileSync(CREASE, ['emit', 'preset:medium', '-o', folder], {stdio: 'ignore'});
    assert.equal(await text_of('text'), readFileSync(join(folder, '0_visibility.comp'), 'utf8'));
    await page.locator('#language').selectOption('es');
    await page.waitForFunction(() => document.getElementById('text').textContent.includes('#version 300 es'));
});

test('other languages are those of the command where the page holds them, else those of naga, and it says whose they are', async () => {
    await open('recipe=preset:medium');
    await drawn('preset:medium');
    const choose = async (language, recipe, noted) => {
        await page.locator('#language').selectOption(language);
        await page.waitForFunction(([command, sentence]) => document.getElementById('command').textContent === command &&
            document.getElementById('text-note').textContent.includes(sentence), [`crease emit ${recipe} --target ${language}`, noted]);
    };
    for (const [language, extension] of [['hlsl', 'hlsl'], ['msl', 'metal']]) {
        await choose(language, 'preset:medium', 'By SPIRV-Cross');
        execFileSync(CREASE, ['emit', 'preset:medium', '--target', language, '-o', folder], {stdio: 'ignore'});
        assert.equal(await text_of('text'), readFileSync(join(folder, `0_visibility.comp.${extension}`), 'utf8'));
    }
    const other = (await page.evaluate(() => globalThis.playground.crease.compose('preset:medium').recipe)).replace('1x8x2', '2x9x2');
    for (const recipe of [other, 'sphere_points/single_layer/ssao/blue_noise']) {
        await page.locator('#recipe').fill(recipe);
        await page.keyboard.press('Enter');
        for (const [language, says, entry] of [['msl', 'MSL 2.1', '] kernel void main_('], ['hlsl', 'HLSL 5.0', '\nvoid main(']]) {
            await choose(language, recipe, 'By naga in this page');
            const text = await text_of('text');
            assert.ok(text.startsWith(`// ${recipe.match(/^\w+/)[0]}:`) && text.split('\n')[0].includes(`, as ${says} by naga; crease`), text.slice(0, 200));
            assert.ok(text.includes(entry), recipe);
        }
    }
    await choose('wgsl', 'sphere_points/single_layer/ssao/blue_noise', 'By naga of GLSL');
    assert.match(await text_of('text'), /^\/\/ sphere_points.*SPDX-License-Identifier: MIT-0\n.*@compute @workgroup_size\(/s);
});

test('the camera turns', async () => {
    await open('recipe=directions:4x4/single_layer/hbao&orbit=0,0,1');
    await drawn('directions:4x4/single_layer/hbao');
    const picture = await visibility();
    const {mean} = apart(picture, rendered(folder, 'directions:4x4/single_layer/hbao'));
    assert.ok(mean < 0.01, `the scene as the page draws it: mean ${mean}`);
    await page.locator('#picture').focus();
    await page.keyboard.press('ArrowLeft');
    await page.waitForTimeout(300);
    const turned = await visibility();
    assert.ok(apart(turned, picture).mean > 0.01);
    assert.match(page.url(), /orbit=-0\.1,0,1/);
    assert.equal(await text_of('rmse-hard'), '–');
});

test('of a lost context a sentence tells, and a button draws the same picture on another', async () => {
    const recipe = 'directions:4x4/single_layer/hbao', other = `${recipe}/bilateral`;
    await open(`recipe=${recipe}`);
    await drawn(recipe);
    const picture = await visibility();
    await page.evaluate(() => {
        const {effect, graphics: {gl}} = globalThis.playground.stage;
        Object.assign(globalThis, {effect_before: effect, is_lost_before: effect.lost});
        gl.getExtension('WEBGL_lose_context').loseContext();
        try {
            effect.run();
        } catch ({message}) {
            globalThis.said_by_effect = message;
        }
    });
    assert.equal(await page.evaluate(() => globalThis.said_by_effect), 'crease: the context of WebGL 2 was lost, so make the effect anew once it is restored');
    const again = page.getByRole('alert').getByRole('button', {name: 'Draw again'});
    await again.waitFor();
    assert.match(await text_of('lost'), /^The browser lost WebGL 2, and with it the picture: .*\. Draw again$/);
    assert.deepEqual(await page.evaluate(() => [globalThis.is_lost_before, globalThis.effect_before.lost]), [false, true]);
    await page.locator('#recipe').fill(other);
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.getElementById('refusal').textContent.startsWith('crease: the context of WebGL 2 is lost'));
    await page.locator('#recipe').fill(recipe);
    await page.keyboard.press('Enter');
    await again.click();
    await drawn(recipe);
    assert.deepEqual([await text_of('lost'), await text_of('refusal')], ['', '']);
    assert.deepEqual(await visibility(), picture);
});

test('the first picture comes soon, of less than 3 MB', async () => {
    const begin = performance.now();
    await open();
    const seconds = (performance.now() - begin) / 1000;
    assert.equal(await text_of('refusal'), '');
    const bytes = await page.evaluate(() => performance.getEntries().reduce((sum, {encodedBodySize = 0}) => sum + encodedBodySize, 0));
    assert.ok(bytes > 1e5 && bytes < 3e6, `${bytes} bytes`);
    console.log(`# first picture after ${seconds.toFixed(2)} s, ${(bytes / 1e6).toFixed(2)} MB`);
});

test('every control has a name, and a phone needs no sideways scrolling', async () => {
    await page.setViewportSize({width: 360, height: 800});
    await open();
    const nameless = await page.locator('input, select, button').evaluateAll((all) =>
        all.filter((each) => !each.labels?.length && !each.getAttribute('aria-label') && !each.textContent.trim()).map(({outerHTML}) => outerHTML));
    assert.deepEqual(nameless, []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
});
