// SPDX-License-Identifier: MIT
// The types of the npm package as tsc sees them: in a user's file, and in what the pages show.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {need} from './packages.mjs';

const {MODULES, PACKAGE, SOURCE} = process.env;
need('typescript', 'three', '@types/three', 'naga-wasm');
const folder = mkdtempSync(join(MODULES, '..', 'types-')); // whose files find what is in MODULES

before(() => {
    cpSync(PACKAGE, join(folder, 'node_modules/crease'), {recursive: true});
    mkdirSync(join(folder, 'src'));
    writeFileSync(join(folder, 'package.json'), '{"type": "module"}');
    cpSync(join(SOURCE, 'tests/web/types/user.ts'), join(folder, 'src/user.ts'));
});

after(() => rmSync(folder, {recursive: true, force: true}));

/** What tsc says of files; "" where it is content. */
function complaints(...files) {
    const options = ['--noEmit', '--strict', '--exactOptionalPropertyTypes', '--target', 'es2022',
                     '--module', 'nodenext', '--lib', 'es2022,esnext.disposable,dom,dom.iterable'];
    const {stdout, error} = spawnSync(process.execPath, [join(MODULES, 'typescript/lib/tsc.js'), ...options, ...files],
                                      {cwd: folder, encoding: 'utf8'});
    if (error)
        throw error;
    return stdout;
}

// What the pages leave to the reader.
const host = `
declare const gl: WebGL2RenderingContext, depthTexture: WebGLTexture, width: number, height: number, projection: Float32Array;
declare const renderer: THREE.WebGLRenderer, scene: THREE.Scene, camera: THREE.PerspectiveCamera;
declare const device: GPUDevice, depth: GPUTexture;
declare function show(texture: GPUTexture | undefined): void;
declare function draw(texture: WebGLTexture | undefined): void;
import * as THREE from 'three';
import {EffectComposer} from 'three/addons/postprocessing/EffectComposer.js';
import {OutputPass} from 'three/addons/postprocessing/OutputPass.js';
import {RenderPass} from 'three/addons/postprocessing/RenderPass.js';
`;

/** The blocks of JavaScript of a page, each a module of its own. */
function blocks_of(page) {
    const blocks = [...readFileSync(join(SOURCE, page), 'utf8').matchAll(/^```js\n(.*?)^```$/gms)].map(([, text]) => text);
    assert.ok(blocks.length >= 2, page);
    return blocks.map((text, i) => {
        const name = `src/${page.replace(/\W/g, '_')}_${i}.ts`;
        const given = text.includes('load()') ? '' : "declare const crease: import('crease').Crease;\n";
        writeFileSync(join(folder, name), `${host}${given}${text}`);
        return name;
    });
}

test("a user's file and the pages compile strictly, and what is wrong does not", () => {
    assert.equal(complaints('src/user.ts', ...blocks_of('web/package/README.md'), ...blocks_of('docs/web.md')), '');
});
