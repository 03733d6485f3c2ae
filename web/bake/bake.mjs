// SPDX-License-Identifier: MIT
// Makes the playground: bake.mjs --crease COMMAND --mesh PROGRAM --package FOLDER --output FOLDER [--rays N] [--views A,B]
import {cpSync, mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {parseArgs} from 'node:util';

import {bake_views} from './views.mjs';

const {values: options} = parseArgs({
    options: {
        crease: {type: 'string'},
        mesh: {type: 'string'},
        package: {type: 'string'},
        output: {type: 'string'},
        rays: {type: 'string', default: '256'},
        views: {type: 'string', default: ''},
    },
});
const {crease, mesh, output} = options;
const scratch = mkdtempSync(join(tmpdir(), 'crease-bake-'));
try {
    cpSync(fileURLToPath(new URL('../site', import.meta.url)), output, {recursive: true});
    cpSync(options.package, join(output, 'package'), {recursive: true});
    bake_views({crease, mesh, folder: join(output, 'views'), scratch, names: options.views.split(',').filter(Boolean),
                rays: Number(options.rays)});
} finally {
    rmSync(scratch, {recursive: true, force: true});
}
