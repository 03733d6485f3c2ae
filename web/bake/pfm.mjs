// SPDX-License-Identifier: MIT
import {readFileSync} from 'node:fs';

/** A PFM file of the crease command, its rows from the top to the bottom. */
export function read_pfm(path) {
    const bytes = readFileSync(path);
    let at = 0;
    const line = () => {
        const begin = at;
        at = bytes.indexOf(10, begin) + 1;
        return bytes.toString('latin1', begin, at - 1);
    };
    const channels = line() === 'PF' ? 3 : 1;
    const [width, height] = line().split(' ').map(Number);
    line(); // little-endian
    const stride = width * channels;
    const upward = new Float32Array(Uint8Array.from(bytes.subarray(at)).buffer);
    const texels = new Float32Array(upward.length);
    for (let y = 0; y < height; ++y)
        texels.set(upward.subarray((height - 1 - y) * stride, (height - y) * stride), y * stride);
    return {width, height, channels, texels};
}
