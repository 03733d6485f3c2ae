// SPDX-License-Identifier: MIT
// What the tests take from npm, and Chromium. Where it is missing a test says so and ends with exit status 77: skipped.
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

const {CHROMIUM, MODULES} = process.env;

/** Finds npm's packages where the test web_modules has installed them. */
export const require = createRequire(join(MODULES, '..', 'package.json'));

/** Ends a test that needs a program or a folder which is not there. */
export function skip_without(what, path) {
    if (existsSync(path))
        return;
    console.log(`skipped: ${what} is missing`);
    process.exit(77);
}

/** Ends a test that needs packages which are not there. */
export function need(...packages) {
    for (const name of packages)
        skip_without(name, join(MODULES, name));
}

/** Ends a test that needs a browser where none is there; returns what starts it. */
export function need_browser() {
    skip_without('chromium', CHROMIUM);
    need('playwright-core');
    const {chromium} = require('playwright-core');
    return (...args) => chromium.launch({executablePath: CHROMIUM, args: ['--no-sandbox', ...args]});
}

/** A page that waits as long as a processor that draws in place of a GPU may take on a busy machine. */
export async function new_page(browser, options) {
    const page = await browser.newPage(options);
    page.setDefaultTimeout(120_000);
    return page;
}
