// SPDX-License-Identifier: MIT
// Effects of fragment shaders in GLSL ES 3.00 as Chromium's WebGL 2 reads them, which refuses what glslang does not, such as ?: on structs.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';

import {need_browser, new_page} from './packages.mjs';

const {PACKAGE} = process.env;
const launch = need_browser();
let crease, browser, page;

before(async () => {
    crease = await (await import(pathToFileURL(join(PACKAGE, 'crease.js')))).load();
    browser = await launch();
    page = await new_page(browser);
});

after(() => browser?.close());

/** What WebGL 2 says of texts of fragment shaders: "" where it is content. */
const complaints = (texts) => page.evaluate((all) => {
    const gl = document.createElement('canvas').getContext('webgl2');
    return all.map((text) => {
        const shader = gl.createShader(gl.FRAGMENT_SHADER);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        const said = gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? '' : gl.getShaderInfoLog(shader);
        gl.deleteShader(shader);
        return said;
    });
}, texts);

const names_of = (role) => crease.parts.filter((part) => part.role === role).map(({name}) => name);

/** Every sampler and estimator, and every other part with one of these. */
function recipes() {
    const roles = ['projection', 'depth encoding', 'normals', 'noise', 'output', 'output format', 'filter', 'receivers'];
    const outputs = names_of('output').flatMap((output) => names_of('filter').map((filter) => `${output}/${filter}`));
    return [
        ...names_of('sampler').flatMap((sampler) => names_of('estimator').map((estimator) => `${sampler}/single_layer/${estimator}`)),
        ...roles.flatMap(names_of).concat(outputs).map((parts) => `directions:4x4/single_layer/hbao/${parts}`),
        ...crease.presets.map(({name}) => `preset:${name}`),
    ].map((recipe) => `${recipe}/fragment/glsl_es:300`).filter((recipe) => crease.check(recipe) === '');
}

test('WebGL 2 compiles every effect of a choice', async (context) => {
    const names = new Map();
    const all = recipes();
    for (const recipe of all)
        for (const pass of crease.compose(recipe).passes)
            names.set(pass.shaders.find(({stage}) => stage === 'fragment').text, `${recipe}, pass ${pass.name}`);
    const texts = [...names.keys()];
    (await complaints(texts)).forEach((said, i) => assert.equal(said, '', names.get(texts[i])));
    context.diagnostic(`${all.length} recipes of ${texts.length} passes`);
    assert.ok(all.length > 40);
});

test('WebGL 2 does complain of ?: on structs', async () => {
    const text = `#version 300 es
precision highp float;
struct pair { float one, other; };
uniform float chosen;
out vec4 colour;
void main() {
    pair first = pair(chosen, 0.0), second = pair(0.0, chosen), taken = chosen > 0.5 ? first : second;
    colour = vec4(taken.one, taken.other, 0.0, 1.0);
}`;
    assert.match((await complaints([text]))[0], /ternary|structure/i);
});
