// SPDX-License-Identifier: MIT
// The views of the playground: G-buffers and ray-traced truths by the crease command, packed for the browser.
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {gzipSync} from 'node:zlib';

import {encode_depth} from '../site/depth_codec.js';
import {encode_bytes} from '../site/differences.js';
import {read_pfm} from './pfm.mjs';
import {scenes, views} from './scenes.mjs';

const recipe = 'directions:4x4/single_layer/hbao/linear_depth';

/** Writes the files of the scenes and their cameras; gives what the command calls each. */
function write_scenes(folder) {
    const paths = {};
    for (const [name, {text}] of Object.entries(scenes)) {
        paths[name] = text ? join(folder, `${name}.obj`) : name;
        if (text)
            writeFileSync(paths[name], text().toString());
        const cameras = views.filter(({scene}) => scene === name).map(({camera}) => camera);
        writeFileSync(join(folder, `${name}.cameras.json`), JSON.stringify(cameras));
    }
    return paths;
}

function write_packed(path, bytes) {
    const packed = gzipSync(Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength), {level: 9});
    writeFileSync(path, packed);
    return packed.length;
}

function truth_bytes(path) {
    return encode_bytes(Uint8Array.from(read_pfm(path).texels, (value) => Math.round(255 * value)));
}

/** Bakes the views of the given names to a folder, with so many rays a texel. */
export function bake_views({command, mesh, folder, scratch, names, rays}) {
    mkdirSync(folder, {recursive: true});
    mkdirSync(scratch, {recursive: true});
    const paths = write_scenes(scratch);
    const baked = [];
    for (const {title, scene, camera} of views.filter((view) => names.length === 0 || names.includes(view.camera.name))) {
        const {name} = camera;
        const view = [paths[scene], '--cameras', join(scratch, `${scene}.cameras.json`), '--camera', name];
        const run = (...words) => execFileSync(command, words, {stdio: ['ignore', 'inherit', 'ignore']});
        const made = join(scratch, name), traced = join(scratch, `${name}_truth`);
        run('render', ...view, '--recipe', recipe, '-o', made);
        run('reference', ...view, '--rays', `${rays}`, '-o', traced);
        const {texels, width, height} = read_pfm(join(made, 'depth.pfm'));
        write_packed(join(folder, `${name}.depth.bin`), encode_depth(texels, width));
        write_packed(join(folder, `${name}.normal.bin`), read_pfm(join(made, 'normal.pfm')).texels);
        for (const truth of ['hard', 'linear'])
            write_packed(join(folder, `${name}.${truth}.bin`), truth_bytes(join(traced, `ao_${truth}.pfm`)));
        baked.push({name, title, scene, width, height, rays, camera});
    }
    for (const name of new Set(baked.map(({scene}) => scene))) {
        execFileSync(mesh, [paths[name], join(scratch, `${name}.triangles`)]);
        write_packed(join(folder, `${name}.triangles.bin`), new Uint8Array(readFileSync(join(scratch, `${name}.triangles`))));
    }
    writeFileSync(join(folder, 'views.json'), JSON.stringify(baked));
    return baked;
}
