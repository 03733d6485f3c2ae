// SPDX-License-Identifier: MIT
// The presets in the languages that the command translates to, for the page that composes GLSL alone.
import {spawnSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

const targets = ['hlsl', 'msl', 'wgsl'];

/** The shaders of a recipe; none where the command refuses it, or knows no such target. */
function shaders_of(command, recipe, target, folder, cwd) {
    if (spawnSync(command, ['emit', recipe, '--target', target, '-o', folder], {stdio: 'ignore', cwd}).status !== 0)
        return [];
    const {passes} = JSON.parse(readFileSync(join(folder, 'crease_shaders.json'), 'utf8'));
    return passes.flatMap(({name, shaders}, i) => shaders.filter(({format}) => format === target)
        .map(({file}) => ({name: `${i} ${name}`, text: readFileSync(join(folder, file), 'utf8')})));
}

/** @param modules  a folder from which node finds naga-wasm, which makes WGSL; undefined: the current one */
export function bake_texts({command, crease, folder, scratch, modules}) {
    const texts = {};
    for (const {name} of crease.presets) {
        const recipe = `preset:${name}`;
        texts[recipe] = Object.fromEntries(targets.map((target) => [target, shaders_of(command, recipe, target, join(scratch, `${target}_${name}`), modules)]));
    }
    writeFileSync(join(folder, 'texts.json'), JSON.stringify(texts));
}
