// SPDX-License-Identifier: MIT
// Bytes as differences from the byte before, which compress better where a picture is smooth.

export function encode_bytes(bytes) {
    return bytes.map((value, i) => value - (i > 0 ? bytes[i - 1] : 0));
}

export function decode_bytes(differences) {
    const bytes = new Uint8Array(differences.length);
    for (let i = 0, last = 0; i < bytes.length; ++i)
        last = bytes[i] = last + differences[i];
    return bytes;
}
