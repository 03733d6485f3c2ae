// SPDX-License-Identifier: MIT
// Recipes in HLSL and Metal, which the command translates to and the page cannot.
import {execFile} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {cpus} from 'node:os';
import {join} from 'node:path';
import {promisify} from 'node:util';
import {gzipSync} from 'node:zlib';

import {text_key} from '../site/text_key.js';
import {families} from './families.mjs';

const run = promisify(execFile);
const targets = ['hlsl', 'msl'];
const filters = ['', '/bilateral', '/separable_plane_filter'];

/** The presets, the gallery, and every sampler, source and estimator that browsers run, alone and with common filters. */
function recipes(crease) {
    const of_role = (role) => crease.parts.filter((part) => part.role === role).map(({name}) => name);
    const fits = (recipe) => crease.check(recipe) === '';
    const three = of_role('sampler').flatMap((a) => of_role('depth source').flatMap((b) => of_role('estimator').map((c) => `${a}/${b}/${c}`)))
        .filter((recipe) => fits(`${recipe}/webgpu`) || fits(`${recipe}/fragment/glsl_es:300`));
    return [...crease.presets.map(({name}) => `preset:${name}`), ...families.map(({recipe}) => recipe),
            ...filters.flatMap((filter) => three.map((recipe) => recipe + filter))].filter(fits);
}

/** The shaders of a recipe, or the sentence by which the command refuses it. */
async function shaders_of(command, recipe, target, folder) {
    try {
        await run(command, ['emit', recipe, '--target', target, '-o', folder]);
    } catch ({stderr}) {
        return stderr.trim();
    }
    const {passes} = JSON.parse(readFileSync(join(folder, 'crease_shaders.json'), 'utf8'));
    return passes.flatMap(({name, shaders}, i) => shaders.filter(({format}) => format === target)
        .map(({file}) => ({name: `${i} ${name}`, text: readFileSync(join(folder, file), 'utf8')})));
}

/**
 * Writes texts/<n>.bin for each recipe, and texts.json, which says by the parts of an effect which is whose.
 * @param count  of recipes at most
 */
export async function bake_texts({command, crease, folder, scratch, count}) {
    mkdirSync(join(folder, 'texts'), {recursive: true});
    const list = {};
    for (const recipe of recipes(crease).slice(0, count)) {
        const effect = crease.compose(recipe);
        list[text_key(effect.parts)] ??= {recipe: effect.recipe, file: `${Object.keys(list).length}.bin`};
    }
    const left = Object.values(list);
    const work = async () => {
        for (let next = left.shift(); next; next = left.shift()) {
            const texts = {};
            for (const target of targets)
                texts[target] = await shaders_of(command, next.recipe, target, join(scratch, `${next.file}_${target}`));
            writeFileSync(join(folder, 'texts', next.file), gzipSync(JSON.stringify(texts), {level: 9}));
        }
    };
    await Promise.all(cpus().map(work));
    writeFileSync(join(folder, 'texts.json'), JSON.stringify(list));
}
