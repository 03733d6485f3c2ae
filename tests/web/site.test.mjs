// SPDX-License-Identifier: MIT
// What of the page needs no browser: its form for depth, recipes as menus change them, links, measures, the plot.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {test} from 'node:test';

import {plot} from '../../web/bake/plot.mjs';
import {decode_depth, encode_depth} from '../../web/site/depth_codec.js';
import {decode_bytes, encode_bytes} from '../../web/site/differences.js';
import {rmse, ssim} from '../../web/site/measures.js';
import {name_of, Recipes} from '../../web/site/recipe.js';
import {fragment_of, read_state} from '../../web/site/state.js';

const {load} = await import(pathToFileURL(join(process.env.PACKAGE, 'crease.js')));
const crease = await load();
const host = 'linear_depth/fragment/glsl_es:300';

test('depth comes back to the bit, whatever it is', () => {
    const width = 7;
    const odd = [0, -0, NaN, Infinity, -Infinity, 1e-45, 3.4e38, -1, 0.1, 40];
    const depth = Float32Array.from({length: 5 * width}, (_, i) => (i < 3 * width ? odd[(i * 7) % odd.length] : 1 / (0.2 + 0.01 * i)));
    const back = decode_depth(encode_depth(depth, width), width);
    assert.deepEqual(new Uint32Array(back.buffer), new Uint32Array(depth.buffer));
});

test('of a plane nothing is left beyond its first texels', () => {
    const width = 64, height = 48;
    const depth = Float32Array.from({length: width * height}, (_, i) => 1 / (0.1 + 0.002 * (i % width) + 0.003 * Math.floor(i / width)));
    const bytes = encode_depth(depth, width);
    let large = 0;
    for (let i = 0; i < depth.length; ++i)
        large += bytes[i] > 8 || bytes[depth.length + i] > 0 ? 1 : 0;
    assert.ok(large < 1.5 * (width + height), `${large} texels`);
});

test('bytes come back from their differences', () => {
    const bytes = Uint8Array.from([3, 255, 0, 0, 128, 127]);
    assert.deepEqual(decode_bytes(encode_bytes(bytes)), bytes);
});

test('a menu changes no more than it must, and what it makes fits', () => {
    const recipes = new Recipes(crease, host);
    const words = ['directions:4x4', 'single_layer', 'hbao', 'bilateral:3'];
    assert.deepEqual(recipes.with_main(words, 2, 'gtao').filter((_, i) => i !== 0 && i !== 2), ['single_layer', 'bilateral:3']);
    for (const [index, names] of recipes.main.entries())
        for (const name of names) {
            const made = recipes.with_main(words, index, name);
            if (!made) {
                assert.notEqual(recipes.refusal([...words.slice(0, index), name, ...words.slice(index + 1)]), '', name);
                continue;
            }
            assert.equal(name_of(made[index]), name);
            assert.equal(recipes.refusal(made), '');
        }
    assert.deepEqual(recipes.with_role([...words, 'blue_noise'], 'noise', 'tiled_noise'), [...words, 'tiled_noise']);
    assert.deepEqual(recipes.with_role([...words, 'blue_noise'], 'noise', ''), words);
});

test('a link holds the state, and what it cannot hold is passed over', () => {
    const state = {...read_state(''), recipe: 'directions:8x4/single_layer/hbao', view: 'stairs', split: 0.25, radius: 0.5,
                   orbit: [0.1, -0.2, 1.5], settings: {strength: 2, 'hbao.bias': 0.1}};
    assert.deepEqual(read_state(fragment_of(state)), state);
    assert.deepEqual(read_state('#split=wide&orbit=1,2&set.bias=x&settings=1&nobody=2'), read_state(''));
});

test('errors by hand', () => {
    const counts = Uint8Array.from([1, 1, 0, 1]);
    assert.equal(rmse([0, 1, 5, 0.5], [0, 0, 0, 0.5], counts), Math.sqrt(1 / 3));
    const side = 9, flat = new Float32Array(side * side).fill(0.5), all = new Uint8Array(side * side).fill(1);
    assert.equal(ssim(flat, flat, all, side, side), 1);
    const c1 = 0.01 ** 2; // of two constants only the means differ
    const expected = (2 * 0.5 * 0.25 + c1) / (0.5 ** 2 + 0.25 ** 2 + c1);
    assert.ok(Math.abs(ssim(flat, new Float32Array(side * side).fill(0.25), all, side, side) - expected) < 1e-9);
});

test('a plot has a point and a link for each figure', () => {
    const made = plot([{id: 'a', title: 'A & B', cost: 1, error: 0.1}, {id: 'c', title: 'C', cost: 100, error: 0.01}], {cost: 'ms', error: 'RMSE'});
    assert.equal(made.match(/<circle/g).length, 2);
    assert.match(made, /href="#a"><title>A &amp; B: 1\.00, 0\.1000</);
    assert.doesNotMatch(made, /NaN|undefined/);
});
