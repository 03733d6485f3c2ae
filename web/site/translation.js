// SPDX-License-Identifier: MIT
// HLSL and Metal as naga makes them of GLSL for WebGPU.

/** naga numbers bindings by their slots in HLSL alone; the gaps that it leaves in Metal are filled alike. */
function numbered(text, bindings) {
    const slots = new Map(bindings.map(({name, access, slot}) => [access === 'uniform' ? 'crease_given' : `crease_${name}`, slot]));
    return text.replace(/(constant \w+&|metal::texture\S+ \S+) (\w+) \[\[user\(fake0\)\]\]/g, (_, type, name) =>
        `${type} ${name} [[${type.startsWith('constant') ? 'buffer' : 'texture'}(${slots.get(name)})]]`);
}

const targets = {
    hlsl: {title: 'HLSL 5.0', options: {shaderModel: '5_0'}, finish: (text) => text},
    msl: {title: 'MSL 2.1', options: {langVersion: [2, 1]}, finish: numbered},
};

/**
 * The passes of a manifest with texts in another language in place of their GLSL.
 * @param manifest   of a recipe with the part webgpu
 * @param translate  of the package naga-wasm
 * @param to         'hlsl' or 'msl'
 * @throws what `translate` throws
 */
export function translated_passes({passes}, translate, to) {
    const {title, options, finish} = targets[to];
    const made = (text, stage, bindings) => {
        const [origin] = text.match(/^\/\/.*\n/) ?? ['']; // the recipe and the licence: naga keeps no comment
        return origin.replace(';', `, as ${title} by naga;`) + finish(translate({from: 'glsl', source: text, parse: {stage}, to, options}), bindings);
    };
    return passes.map((pass) => ({...pass, shaders: pass.shaders.map(({stage, text}) => ({stage, text: made(text, stage, pass.bindings)}))}));
}
