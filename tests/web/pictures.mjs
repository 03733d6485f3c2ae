// SPDX-License-Identifier: MIT
// Pictures of the crease command, and how far others are from them.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {read_pfm} from '../../web/bake/pfm.mjs';
import {views} from '../../web/bake/scenes.mjs';

const {CREASE, VK_ICD_FILENAMES} = process.env;

/** What the command renders of the courtyard: ao.pfm, and the G-buffer beside it. Its driver is not Dawn's. */
export function rendered(folder, recipe, camera = views[0].camera) {
    const cameras = join(folder, 'cameras.json');
    writeFileSync(cameras, JSON.stringify([camera]));
    execFileSync(CREASE, ['render', 'built-in', '--cameras', cameras, '--recipe', `${recipe}/linear_depth`, '-o', folder],
                 {stdio: 'ignore', env: {...process.env, VK_ICD_FILENAMES}});
    return read_pfm(join(folder, 'ao.pfm')).texels;
}

/** The mean difference, and the share of the pixels that are off by 1/255 or more. */
export function apart(picture, expected) {
    assert.equal(picture.length, expected.length);
    let sum = 0, off = 0;
    picture.forEach((value, i) => {
        const difference = Math.abs(value - expected[i]);
        sum += difference;
        off += difference > 0.99 / 255 ? 1 : 0;
    });
    return {mean: sum / picture.length, share: off / picture.length};
}
