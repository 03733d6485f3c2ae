// SPDX-License-Identifier: MIT
// Runs tests that need packages of npm's, and those that need a browser: in_browser.mjs TEST. Exit status 77 where these cannot be
// had; CHROMIUM is empty where a browser is needed and missing.
import {spawnSync} from 'node:child_process';
import {copyFileSync, mkdirSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

const {CHROMIUM, NPM, SCRATCH} = process.env;
const here = fileURLToPath(new URL('.', import.meta.url));

function skip(reason) {
    console.log(`skipped: ${reason}`);
    process.exit(77);
}

if (CHROMIUM === '')
    skip('chromium is not installed');
mkdirSync(SCRATCH, {recursive: true});
for (const file of ['package.json', 'package-lock.json'])
    copyFileSync(join(here, file), join(SCRATCH, file));
if (spawnSync(NPM, ['ci', '--ignore-scripts', '--no-audit', '--no-fund', '--prefer-offline'], {cwd: SCRATCH, stdio: 'inherit'}).status !== 0)
    skip('npm cannot install what tests/web/package-lock.json pins');
process.exit(spawnSync(process.execPath, ['--test', join(here, process.argv[2])], {stdio: 'inherit'}).status ?? 1);
