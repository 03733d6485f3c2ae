// SPDX-License-Identifier: MIT
// PFM files: little-endian floats, their rows from the bottom to the top.
import {readFileSync, writeFileSync} from 'node:fs';

function flipped(texels, stride) {
    const rows = new Float32Array(texels.length);
    for (let from = 0, to = texels.length - stride; to >= 0; from += stride, to -= stride)
        rows.set(texels.subarray(from, from + stride), to);
    return rows;
}

/** Texels row after row from the top. */
export function read_pfm(path) {
    const bytes = readFileSync(path);
    const [head, type, width, height] = bytes.toString('latin1', 0, 64).match(/^(P[Ff])\s(\d+) (\d+)\s\S+\s/);
    const channels = type === 'PF' ? 3 : 1;
    const texels = new Float32Array(Uint8Array.from(bytes.subarray(head.length)).buffer);
    return {width: Number(width), height: Number(height), channels, texels: flipped(texels, channels * width)};
}

/** @param texels  one float each, row after row from the top */
export function write_pfm(path, width, height, texels) {
    writeFileSync(path, Buffer.concat([Buffer.from(`Pf\n${width} ${height}\n-1\n`), Buffer.from(flipped(texels, width).buffer)]));
}
