// SPDX-License-Identifier: MIT
// Baked views: G-buffers and truths as arrays.
import {decode_depth} from './depth_codec.js';
import {decode_bytes} from './differences.js';

async function fetched(name) {
    const answer = await fetch(new URL(`views/${name}`, import.meta.url));
    if (!answer.ok)
        throw new Error(`views/${name} cannot be read: ${answer.status} ${answer.statusText}`);
    return answer;
}

async function unpacked(name) {
    const {body} = await fetched(`${name}.bin`);
    return new Response(body.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

export async function list_of_views() {
    return (await fetched('views.json')).json();
}

/** Linear depth and normals, row after row from the top. */
export async function load_inputs({name, width}) {
    const [depth, normal] = await Promise.all([unpacked(`${name}.depth`), unpacked(`${name}.normal`)]);
    return {depth: decode_depth(new Uint8Array(depth), width), normal: new Float32Array(normal)};
}

/** Ray-traced visibility, a byte a texel. */
export async function load_truth({name}, kind) {
    return decode_bytes(new Uint8Array(await unpacked(`${name}.${kind}`)));
}

/** Corners of triangles in world space. */
export async function load_triangles({scene}) {
    return new Float32Array(await unpacked(`${scene}.triangles`));
}
