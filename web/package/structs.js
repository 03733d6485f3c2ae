// SPDX-License-Identifier: MIT
// The structs of crease_c.h as they lie in wasm's memory: each field is 4 bytes, or a struct of such.

const u32 = {size: 4, read: (memory, at) => memory.view.getUint32(at, true)};
const i32 = {size: 4, read: (memory, at) => memory.view.getInt32(at, true)};
const f32 = {size: 4, read: (memory, at) => shortest(memory.view.getFloat32(at, true))};
const flag = {size: 4, read: (memory, at) => u32.read(memory, at) !== 0};
const text = {size: 4, read: (memory, at) => memory.text(u32.read(memory, at))};

/** The number with the fewest digits that is the same float. */
function shortest(value) {
    for (let digits = 6; digits < 9; ++digits) {
        const near = Number(value.toPrecision(digits));
        if (Math.fround(near) === value)
            return near;
    }
    return value;
}

function one_of(...names) {
    return {size: 4, read: (memory, at) => names[u32.read(memory, at)]};
}

/** A struct behind a pointer. */
function pointer(layout) {
    return {size: 4, read: (memory, at) => layout.read(memory, u32.read(memory, at))};
}

/** A list, and the field of the same struct with its length; a function gives that of what is read otherwise. */
function list(count, item) {
    return {...u32, count, item};
}

function struct(fields) {
    const entries = Object.entries(fields);
    const read = (memory, from) => {
        const made = {};
        let at = from;
        for (const [name, field] of entries) {
            made[name] = field.read(memory, at);
            at += field.size;
        }
        for (const [name, {count, item}] of entries.filter(([, {item}]) => item)) {
            const length = typeof count === 'function' ? count(made) : made[count];
            made[name] = Array.from({length}, (_, i) => item.read(memory, made[name] + item.size * i));
            delete made[count];
        }
        return made;
    };
    return {size: entries.reduce((sum, [, field]) => sum + field.size, 0), read};
}

const extent = struct({divisor: u32, guarded: flag, fixed_width: u32, fixed_height: u32, level: u32});

const binding = struct({
    name: text,
    resource: u32,
    access: one_of('uniform', 'sample', 'load', 'store', 'modify', 'attachment', 'result'),
    set: u32,
    slot: u32,
    level: u32,
});

const constant = struct({part: text, number: text, id: u32, value: i32});

const pass = struct({
    name: text,
    stage: one_of('compute', 'fragment', 'functions', 'geometry'),
    dialect: one_of('vulkan', 'opengl', 'glsl_es', 'webgpu'),
    text,
    vertex_text: text,
    bindings: list('binding_count', pointer(binding)),
    constants: list('constant_count', pointer(constant)),
    binding_count: u32,
    constant_count: u32,
    size: extent,
    dispatch: one_of('texels', 'rows', 'columns'),
    group_width: u32,
    group_height: u32,
    view: u32,
});

const resource = struct({
    name: text,
    kind: one_of('image', 'buffer', 'block'),
    format: one_of('none', 'r8_unorm', 'rgba8_unorm', 'r32_uint', 'rg32_uint', 'rgba32_uint', 'r32_float', 'rg32_float',
                   'rgba16_float', 'rgba32_float', 'd32_float'),
    element: text,
    lifetime: one_of('input', 'constant', 'transient', 'handed_on', 'history', 'report', 'output'),
    size: extent,
    meaning: text,
    layers: u32,
    levels: u32,
    samples: u32,
    arrayed: flag,
    centred: flag,
    previous_of: text,
    cleared: flag,
    clear: u32,
    texels: list('texel_count', u32),
    texel_count: u32,
    content: text,
});

const setting = struct({
    part: text,
    name: text,
    meaning: text,
    fallback: f32,
    least: f32,
    most: f32,
    shared: flag,
    offset: u32,
});

const number = struct({name: text, meaning: text, least: i32, most: i32, fallback: i32});

const features = struct({
    extended_storage_formats: flag,
    fragment_stores_and_atomics: flag,
    subgroup_arithmetic: flag,
    depth_samples: u32,
    centred_depth_samples: u32,
});

export const part = struct({
    name: text,
    role: text,
    summary: text,
    source: text,
    numbers: list('number_count', pointer(number)),
    settings: list('setting_count', pointer(setting)),
    number_count: u32,
    setting_count: u32,
});

export const preset = struct({name: text, summary: text, recipe: text});

const choice = struct({part: pointer(part), numbers: list((made) => made.part.numbers.length, i32), named: flag});

export const effect = struct({
    recipe: text,
    parts: list('part_count', pointer(choice)),
    passes: list('pass_count', pointer(pass)),
    resources: list('resource_count', pointer(resource)),
    settings: list('setting_count', pointer(setting)),
    part_count: u32,
    pass_count: u32,
    resource_count: u32,
    setting_count: u32,
    view_count: u32,
    block_size: u32,
    from_first_offset: u32,
    radius_offset: u32,
    frame_offset: u32,
    features,
});

const exact = {size: 4, read: (memory, at) => memory.view.getFloat32(at, true)};
const floats = (count) => ({
    size: 4 * count,
    read: (memory, at) => Array.from({length: count}, (_, i) => exact.read(memory, at + 4 * i)),
});

export const view = struct({
    from_texel: floats(4),
    depth_unpack: floats(2),
    far_depth: exact,
    guard: exact,
    resolution: floats(2),
    texel_size: floats(2),
});
