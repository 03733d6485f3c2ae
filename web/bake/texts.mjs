// SPDX-License-Identifier: MIT
// Recipes in HLSL and Metal by SPIRV-Cross, which the command translates with and the page cannot.
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

/** Of what browsers run the presets, the gallery, and every sampler, source and estimator, alone and with common filters. */
function recipes(crease) {
    const of_role = (role) => crease.parts.filter((part) => part.role === role).map(({name}) => name);
    const runs = (recipe) => ['webgpu', 'fragment/glsl_es:300'].some((words) => crease.check(`${recipe}/${words}`) === '');
    const three = of_role('sampler').flatMap((a) => of_role('depth source').flatMap((b) => of_role('estimator').map((c) => `${a}/${b}/${c}`)));
    return [...crease.presets.map(({name}) => `preset:${name}`), ...families.map(({recipe}) => recipe),
            ...filters.flatMap((filter) => three.map((recipe) => recipe + filter))].filter(runs);
}

async function shaders_of(command, recipe, target, folder) {
    await run(command, ['emit', recipe, '--target', target, '-o', folder]);
    const {passes} = JSON.parse(readFileSync(join(folder, 'crease_shaders.json'), 'utf8'));
    return passes.flatMap(({name, shaders}, i) => shaders.filter(({format}) => format === target)
        .map(({file}) => ({name: `${i} ${name}`, text: readFileSync(join(folder, file), 'utf8')})));
}

/**
 * Writes texts/<n>.bin for each recipe, and texts.json, which says by text_key which is whose.
 * @param count  of recipes at most
 */
export async function bake_texts({command, crease, folder, scratch, count}) {
    mkdirSync(join(folder, 'texts'), {recursive: true});
    const list = {}, left = [];
    for (const recipe of recipes(crease).slice(0, count)) {
        const key = text_key(crease.compose(recipe).parts);
        if (key in list)
            continue;
        list[key] = `${left.length}.bin`;
        left.push({recipe, file: list[key]});
    }
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
