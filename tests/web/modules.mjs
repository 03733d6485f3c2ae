// SPDX-License-Identifier: MIT
// Installs what web/package-lock.json pins into a folder. Where npm cannot be reached, what needs it is skipped: exit status 77.
import {execFileSync} from 'node:child_process';
import {copyFileSync, existsSync, mkdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';

const {LOCK, MODULES, NPM} = process.env;
const folder = join(MODULES, '..');
const [pinned, installed] = [join(LOCK, 'package-lock.json'), join(folder, 'package-lock.json')];
const is_there = existsSync(MODULES) && existsSync(installed) && readFileSync(pinned).equals(readFileSync(installed));
if (!is_there) {
    mkdirSync(folder, {recursive: true});
    try {
        copyFileSync(join(LOCK, 'package.json'), join(folder, 'package.json'));
        copyFileSync(pinned, installed);
        execFileSync(NPM, ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {cwd: folder, stdio: ['ignore', 'ignore', 'pipe']});
    } catch (error) {
        console.log(`skipped: npm cannot install what web/package-lock.json pins: ${error.stderr ?? error}`);
        process.exit(77);
    }
}
