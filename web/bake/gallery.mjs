// SPDX-License-Identifier: MIT
// The gallery: a picture of each family by `crease render`, its figures by `crease bench`, its paper.
import {execFileSync} from 'node:child_process';
import {copyFileSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {families as all_families} from './families.mjs';
import {plot} from './plot.mjs';

/** By which the page may run a recipe. */
const devices = [
    {words: 'fragment/glsl_es:300', link: '', note: ''},
    {words: 'webgpu', link: '&amp;device=webgpu', note: ', by WebGPU'},
];

function escaped(text) {
    return `${text}`.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
}

/** The rows of `crease bench` for the recipes of the families, over the first view of the built-in scene. */
function measured(command, families, {rays, truths}) {
    const view = ['built-in', '--cameras', 'overview', '--width', '640', '--height', '360', '--rays', `${rays}`, '--truths', truths];
    const recipes = families.flatMap(({recipe}) => ['--recipes', recipe]);
    return JSON.parse(execFileSync(command, ['bench', ...view, '--repeats', '3', '--json', ...recipes],
                                   {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']}));
}

function entry(family, row, {crease, name}) {
    const part = crease.parts.find((each) => each.name === family.part);
    const device = devices.find(({words}) => crease.check(`${family.recipe}/linear_depth/${words}`) === '');
    const recipe = escaped(family.recipe);
    return `<article id="${name}">
    <h3>${escaped(family.title)}</h3>
    <img src="gallery/${name}.png" width="640" height="360" loading="lazy" alt="Ambient occlusion of the built-in scene by ${recipe}">
    <p>${escaped(part.summary)}.${part.source ? ` <cite>${escaped(part.source)}</cite>` : ''}</p>
    <p><code>${recipe}</code></p>
    <dl class="figures">
        <div><dt>RMSE linear</dt><dd>${row.rmse_linear.toFixed(4)}</dd></div>
        <div><dt>RMSE hard</dt><dd>${row.rmse_hard.toFixed(4)}</dd></div>
        <div><dt>SSIM linear</dt><dd>${row.ssim.toFixed(3)}</dd></div>
        <div><dt>ms</dt><dd>${(row.milliseconds + row.capture_milliseconds).toFixed(1)}</dd></div>
    </dl>
    <p>${device ? `<a href="index.html#recipe=${recipe}${device.link}">Open in the playground</a>${device.note}` : 'Its passes need more than WebGL 2 and WebGPU have.'}</p>
</article>`;
}

/** Writes gallery.html and its pictures, and the benchmark that it tells of as JSON. */
export function bake_gallery({command, crease, folder, scratch, template, rays, count}) {
    mkdirSync(join(folder, 'gallery'), {recursive: true});
    const families = all_families.slice(0, count);
    const bench = measured(command, families, {rays, truths: join(scratch, 'truths')});
    writeFileSync(join(folder, 'gallery/bench.json'), JSON.stringify(bench, null, 2));
    const entries = families.map((family, i) => ({...family, name: family.title.toLowerCase().replace(/\W+/g, '_'), row: bench.recipes[i]}));
    for (const {name, recipe} of entries) {
        execFileSync(command, ['render', 'built-in', '--recipe', recipe, '--width', '640', '--height', '360', '-o', join(scratch, name)],
                     {stdio: 'ignore'});
        copyFileSync(join(scratch, name, 'ao.png'), join(folder, 'gallery', `${name}.png`));
    }
    const points = (error) => entries.map(({name, title, row}) =>
        ({id: name, title, cost: row.milliseconds + row.capture_milliseconds, error: row[error]}));
    const cost = `milliseconds of a frame, ${bench.width} x ${bench.height}, on ${bench.device.replace(/ \(.*/, '')}`;
    const page = readFileSync(template, 'utf8')
        .replace('<!-- plots -->', `${plot(points('rmse_linear'), {cost, error: 'RMSE to the linear truth'})}\n${plot(points('rmse_hard'), {cost, error: 'RMSE to the hard truth'})}`)
        .replace('<!-- families -->', entries.map((each) => entry(each, each.row, {crease, name: each.name})).join('\n'))
        .replace('<!-- conditions -->', escaped(`The built-in scene from 'overview', ${bench.width} x ${bench.height}, against ${rays} rays a texel; times are of ${bench.device}.`));
    writeFileSync(join(folder, 'gallery.html'), page);
}
