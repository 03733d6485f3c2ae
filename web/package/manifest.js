// SPDX-License-Identifier: MIT
// An effect of the C library in the form of the manifests that `crease emit` writes: docs/manifest.md says what each word means.
// A shader has its `text` in place of a file, a constant its `texels`.

const all_levels = 0xffffffff;

const camera_members = [
    ['from_texel', 'vec4', 0], ['depth_unpack', 'vec2', 16], ['far_depth', 'float', 24],
    ['guard', 'float', 28], ['resolution', 'vec2', 32], ['texel_size', 'vec2', 40],
];

function size_of({divisor, guarded, fixed_width, fixed_height, level}) {
    const size = fixed_width ? {width: fixed_width, height: fixed_height} : {divisor, guarded};
    return level ? {...size, level} : size;
}

function shaders_of(pass) {
    const shaders = [{format: 'glsl', stage: pass.stage, text: pass.text}];
    if (pass.vertex_text)
        shaders.push({format: 'glsl', stage: 'vertex', text: pass.vertex_text});
    return shaders;
}

function binding_of({name, resource, access, set, slot, level}, resources) {
    const binding = {name, resource: resources[resource].name, access, set, slot};
    return level === all_levels ? binding : {...binding, level};
}

function pass_of(pass, resources) {
    const {name, stage, dialect, view} = pass;
    const described = {name, stage, dialect, view, size: size_of(pass.size)};
    if (stage === 'compute')
        Object.assign(described, {dispatch: pass.dispatch, workgroup: [pass.group_width, pass.group_height]});
    described.shaders = shaders_of(pass);
    described.bindings = pass.bindings.map((binding) => binding_of(binding, resources));
    described.constants = pass.constants.map(({id, part, number, value}) => ({id, part, number, value}));
    return described;
}

function resource_of(resource) {
    const {name, kind, lifetime} = resource;
    const described = {name, kind, lifetime};
    if (kind === 'block')
        return described;
    Object.assign(described, kind === 'image' ? {format: resource.format} : {element: resource.element});
    Object.assign(described, {size: size_of(resource.size), layers: resource.layers});
    if (kind === 'image')
        Object.assign(described, {arrayed: resource.arrayed, samples: resource.samples, centred: resource.centred});
    if (resource.levels > 1)
        described.levels = resource.levels;
    if (resource.content)
        described.content = resource.content;
    if (resource.meaning)
        described.meaning = resource.meaning;
    if (resource.previous_of)
        described.previous_of = resource.previous_of;
    if (resource.cleared)
        described.clear = resource.clear;
    if (resource.texels.length)
        described.texels = Uint32Array.from(resource.texels);
    return described;
}

function block_of(effect) {
    const members = [];
    for (let v = 0; v < effect.view_count; ++v)
        for (const [name, type, offset] of camera_members)
            members.push({name: `views[${v}].${name}`, type, offset: 48 * v + offset});
    for (let v = 1; v < effect.view_count; ++v)
        members.push({name: `from_first[${v - 1}]`, type: 'mat4', offset: effect.from_first_offset + 64 * (v - 1)});
    members.push({name: 'radius', type: 'float', offset: effect.radius_offset});
    members.push({name: 'frame', type: 'uint', offset: effect.frame_offset});
    for (const {part, name, shared, offset, fallback, least, most, meaning} of effect.settings)
        members.push({name: shared ? name : `${part}.${name}`, type: 'float', offset, default: fallback, least, most, meaning});
    return {size: effect.block_size, members};
}

export function manifest_of(effect, version) {
    return {
        manifest: 1,
        crease: version,
        recipe: effect.recipe,
        passes: effect.passes.map((pass) => pass_of(pass, effect.resources)),
        resources: effect.resources.map(resource_of),
        uniform_block: block_of(effect),
        features: effect.features,
    };
}
