// SPDX-License-Identifier: MIT
// Makes the playground, or steps of it: bake.mjs [site] [views] [gallery] [texts]
//     --crease COMMAND --mesh PROGRAM --package FOLDER --output FOLDER [--rays N] [--views A,B of them]
//     [--families N of them] [--texts N of them] [--modules FOLDER with naga-wasm]
import {cpSync, existsSync, mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {parseArgs} from 'node:util';

import {bake_gallery} from './gallery.mjs';
import {bake_texts} from './texts.mjs';
import {bake_views} from './views.mjs';

const {values: options, positionals: steps} = parseArgs({
    allowPositionals: true,
    options: {
        crease: {type: 'string'},
        mesh: {type: 'string'},
        package: {type: 'string'},
        output: {type: 'string'},
        rays: {type: 'string', default: '256'},
        views: {type: 'string', default: ''},
        families: {type: 'string', default: 'Infinity'},
        texts: {type: 'string', default: 'Infinity'},
        modules: {type: 'string'},
    },
});
const {crease: command, mesh, output: folder} = options;
const rays = Number(options.rays);
const beside = (name) => fileURLToPath(new URL(name, import.meta.url));
const wanted = (step) => steps.length === 0 || steps.includes(step);
const scratch = mkdtempSync(join(tmpdir(), 'crease-bake-'));
try {
    const {load} = await import(pathToFileURL(resolve(options.package, 'crease.js')));
    const crease = await load();
    if (wanted('site')) {
        cpSync(beside('../site'), folder, {recursive: true});
        cpSync(options.package, join(folder, 'package'), {recursive: true});
        const naga = options.modules && join(options.modules, 'node_modules/naga-wasm/dist');
        if (naga && existsSync(naga)) // by which the page makes WGSL
            cpSync(naga, join(folder, 'naga'), {recursive: true});
    }
    if (wanted('views'))
        bake_views({command, mesh, folder: join(folder, 'views'), scratch, names: options.views.split(',').filter(Boolean), rays});
    if (wanted('gallery'))
        bake_gallery({command, crease, folder, scratch, template: beside('gallery.html'), rays, count: Number(options.families)});
    if (wanted('texts'))
        await bake_texts({command, crease, folder, scratch, count: Number(options.texts)});
} finally {
    rmSync(scratch, {recursive: true, force: true});
}
