// SPDX-License-Identifier: MIT
// An adapter of Dawn for node: the system's, else that of the SwiftShader which comes with Chromium.
import {existsSync, realpathSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {pathToFileURL} from 'node:url';

import {need, require} from './packages.mjs';

const drivers = [process.env.CHROMIUM, '/usr/lib/chromium/chromium'].filter((path) => path && existsSync(path))
    .map((path) => join(dirname(realpathSync(path)), 'vk_swiftshader_icd.json')).filter(existsSync);

/** What Dawn made must outlive what was made of it. */
const kept = [];

/** Ends a test where there is none. */
export async function need_adapter() {
    need('webgpu');
    const {create, globals} = await import(pathToFileURL(require.resolve('webgpu')));
    Object.assign(globalThis, globals);
    for (const driver of ['', ...drivers]) {
        if (driver)
            process.env.VK_ICD_FILENAMES = driver; // for the processes of the test too
        const gpu = create([]), adapter = await gpu.requestAdapter();
        kept.push(gpu, adapter);
        if (adapter)
            return adapter;
    }
    console.log('skipped: Dawn finds no adapter');
    process.exit(77);
}
