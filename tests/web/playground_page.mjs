// SPDX-License-Identifier: MIT
// The page of the playground as its tests open it: served from a folder, anew for each test, and no message of it passed over.
import assert from 'node:assert/strict';
import {after, afterEach, before, beforeEach} from 'node:test';

import {serve} from '../../web/serve.mjs';
import {need_browser, new_page} from './packages.mjs';

const {SITE} = process.env;

/** That of the test at work. */
export let page;

let address;

/** Ends a test where no browser is there. `expected`: the messages that a headless browser writes by itself. */
export function use_playground(expected, ...browser_arguments) {
    const launch = need_browser();
    let server, browser, messages;

    before(async () => {
        ({server, address} = await serve(SITE));
        browser = await launch(...browser_arguments);
    });

    after(async () => {
        await browser?.close();
        server?.close();
    });

    beforeEach(async () => {
        messages = [];
        page = await new_page(browser, {viewport: {width: 1280, height: 1400}});
        page.on('pageerror', (error) => messages.push(error.message));
        page.on('console', (message) => {
            if (!expected.test(message.text()))
                messages.push(message.text());
        });
    });

    afterEach(async () => {
        await page.close();
        assert.deepEqual(messages, []);
    });
}

/** @param fragment  of the link, which holds the state of the page */
export async function open(fragment = '') {
    await page.goto(`${address}index.html${fragment && `#${fragment}`}`);
    await page.waitForFunction(() => document.body.dataset.drawn || document.getElementById('refusal').textContent);
}

/** An array of numbers that the page has, as text, which goes much faster than numbers do. */
export async function floats(of_page) {
    const numbers = await page.evaluateHandle(of_page);
    const text = await numbers.evaluate((all) => {
        const bytes = new Uint8Array(Float32Array.from(all).buffer);
        let made = '';
        for (let i = 0; i < bytes.length; i += 4096)
            made += String.fromCharCode(...bytes.subarray(i, i + 4096));
        return btoa(made);
    });
    return new Float32Array(Uint8Array.from(Buffer.from(text, 'base64')).buffer);
}

/** What the page draws. */
export function visibility() {
    return floats(() => globalThis.playground.stage.visibility());
}
