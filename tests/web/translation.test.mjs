// SPDX-License-Identifier: MIT
// HLSL and Metal as the page has naga make them: glslang's front end reads the HLSL; of Metal, which nothing here reads, the structure is compared.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {cpus, tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {promisify} from 'node:util';

import {translated_passes} from '../../web/site/translation.js';
import {need, require, skip_without} from './packages.mjs';
import {webgpu_recipes} from './recipes.mjs';

const {GLSLANG, PACKAGE} = process.env;
need('naga-wasm');
skip_without('glslangValidator', GLSLANG);
const folder = mkdtempSync(join(tmpdir(), 'crease-translation-'));
const suffixes = {compute: 'comp', fragment: 'frag', vertex: 'vert'};
let crease, naga;

before(async () => {
    crease = await (await import(pathToFileURL(join(PACKAGE, 'crease.js')))).load();
    naga = await import(pathToFileURL(require.resolve('naga-wasm')));
});

after(() => rmSync(folder, {recursive: true, force: true}));

function translated(recipe, to) {
    const manifest = crease.compose(`${recipe}/webgpu`);
    return {...manifest, passes: translated_passes(manifest, naga.translate, to)};
}

/** Every different shader of the recipes in a language: what it is of, its pass, its stage, its text. */
function shaders_in(to) {
    const made = new Map();
    for (const recipe of webgpu_recipes(crease)) {
        const {passes, uniform_block} = translated(recipe, to);
        for (const pass of passes)
            for (const {stage, text} of pass.shaders) {
                const [origin, ...lines] = text.split('\n');
                if (stage !== 'vertex') // which every effect shares
                    assert.match(origin, /^\/\/ .*, pass \w+, as (HLSL 5\.0|MSL 2\.1) by naga; crease .*SPDX-License-Identifier: MIT-0$/);
                made.set(lines.join('\n'), {what: `${recipe}, pass ${pass.name}`, pass, stage, text, uniform_block});
            }
    }
    assert.ok(made.size > 80, `${made.size} shaders`);
    return [...made.values()];
}

/** What glslang says of HLSL, "" where it is content. Its front end alone of all knows no zero of an array. */
async function complaint(text, stage, name) {
    const file = join(folder, `${name}.${suffixes[stage]}.hlsl`);
    writeFileSync(file, text.replace(/ = \(\w+(\[\d+\])+\)0;/g, ';'));
    const words = ['-D', '-e', 'main', '-V', '-Od', '-S', suffixes[stage], '--target-env', 'vulkan1.1', '-o', `${file}.spv`, file];
    return promisify(execFile)(GLSLANG, words).then(() => '', ({stdout}) => stdout);
}

test('every recipe is written in HLSL, which glslang reads, with its bindings', async (context) => {
    const left = shaders_in('hlsl');
    context.diagnostic(`${left.length} shaders`);
    const registers = {uniform: 'b', sample: 't', store: 'u'};
    const work = async (_, worker) => {
        for (let next = left.shift(); next; next = left.shift()) {
            const {what, pass, stage, text} = next;
            for (const {name, access, slot} of stage === 'vertex' ? [] : pass.bindings.filter(({access}) => access !== 'attachment'))
                assert.match(text, new RegExp(`crease_${access === 'uniform' ? 'given' : name} : register\\(${registers[access]}${slot}\\)`), what);
            assert.equal(await complaint(text, stage, `worker_${worker}`), '', what);
        }
    };
    await Promise.all(cpus().map(work));
});

test('glslang does complain of HLSL that is wrong', async () => {
    const {passes: [{shaders: [{text}]}]} = translated('directions:4x4/single_layer/hbao', 'hlsl');
    assert.match(await complaint(text.replace('float crease_linear_depth(', 'float nobody('), 'compute', 'wrong'), /crease_linear_depth/);
});

test('every recipe is written in Metal with an entry point, its bindings and all parameters', (context) => {
    const all = shaders_in('msl');
    context.diagnostic(`${all.length} shaders`);
    for (const {what, pass, stage, text, uniform_block} of all) {
        const [head, ...more] = text.split(/^(?=(?:\[\[.*\]\] kernel|vertex|fragment) )/m);
        assert.equal(more.length, 1, what);
        assert.match(more[0], {compute: /^\[\[.*\]\] kernel void main_\(/, fragment: /^fragment main_Output main_\(/, vertex: /^vertex main_Output main_\(/}[stage], what);
        assert.doesNotMatch(text, /user\(|undefined/, what);
        if (stage === 'vertex')
            continue;
        const [parameters] = more[0].split('\n) {');
        const found = [...parameters.matchAll(/(\w+) \[\[(buffer|texture)\((\d+)\)\]\]/g)].map(([, name, kind, number]) => `${name} ${kind} ${number}`);
        const expected = pass.bindings.filter(({access}) => access !== 'attachment').map(({name, access, slot}) =>
            access === 'uniform' ? `crease_given buffer ${slot}` : `crease_${name} texture ${slot}`);
        assert.deepEqual(found.sort(), expected.sort(), what);
        for (const {slot} of pass.bindings.filter(({access}) => access === 'attachment'))
            assert.ok(head.includes(`[[color(${slot})]]`), what);
        if (stage === 'compute')
            assert.ok(more[0].startsWith(`[[max_total_threads_per_threadgroup(${pass.workgroup[0] * pass.workgroup[1]})]]`), what);
        const [, block] = head.match(/struct crease_parameters \{(.*?)\};/s) ?? [];
        for (const {name} of pass.bindings.some(({access}) => access === 'uniform') ? uniform_block.members : [])
            assert.ok(block.includes(name.startsWith('views[') ? ' views;' : ` ${name.replace('.', '_')};`), `${what}: ${name}`);
    }
});
