// SPDX-License-Identifier: MIT
// Names of data are those of crease's manifests (docs/manifest.md) and of crease_c.h.

/** Why a recipe makes no effect, in one sentence. */
export class RecipeError extends Error {}

/** A whole number that a part takes. */
export interface PartNumber {
    name: string;
    meaning: string;
    least: number;
    most: number;
    fallback: number;
}

/** A real number that a host may change each frame, as its part describes it. */
export interface PartSetting {
    part: string;
    name: string;
    meaning: string;
    fallback: number;
    least: number;
    most: number;
    shared: boolean;
}

/** A part, of which recipes are made. */
export interface Part {
    name: string;
    /** In words, such as "depth source". */
    role: string;
    summary: string;
    /** Paper, chapter, algorithm; or "". */
    source: string;
    numbers: PartNumber[];
    settings: PartSetting[];
}

/** Parts that go well together: `preset:NAME` in recipes. */
export interface Preset {
    name: string;
    summary: string;
    recipe: string;
}

/** A part of an effect. */
export interface Choice {
    name: string;
    role: string;
    numbers: number[];
    /** Whether the recipe names it; else it is there by default. */
    named: boolean;
}

/** In texels, or relative to the picture's; halved `level` times. */
export type Size = ({width: number; height: number} | {divisor: number; guarded: boolean}) & {level?: number};

export type Stage = 'compute' | 'fragment' | 'functions' | 'geometry';
export type Access = 'uniform' | 'sample' | 'load' | 'store' | 'modify' | 'attachment' | 'result';
export type Format =
    'none' | 'r8_unorm' | 'rgba8_unorm' | 'r32_uint' | 'rg32_uint' | 'rgba32_uint' | 'r32_float' | 'rg32_float' |
    'rgba16_float' | 'rgba32_float' | 'd32_float';

export interface Shader {
    format: string;
    stage: Stage | 'vertex';
    /** Its source; manifests on disk name a `file` in its place. */
    text: string;
}

export interface Binding {
    /** In the shader without `crease_`. */
    name: string;
    resource: string;
    access: Access;
    set: number;
    slot: number;
    /** The mip level that is bound; absent: all. */
    level?: number;
}

export interface Constant {
    id: number;
    part: string;
    number: string;
    value: number;
}

export interface Pass {
    name: string;
    stage: Stage;
    dialect: string;
    view: number;
    size: Size;
    dispatch?: 'texels' | 'rows' | 'columns';
    workgroup?: [number, number];
    shaders: Shader[];
    bindings: Binding[];
    constants: Constant[];
}

export interface Resource {
    name: string;
    kind: 'image' | 'buffer' | 'block';
    lifetime: 'input' | 'constant' | 'transient' | 'history' | 'report' | 'output';
    format?: Format;
    element?: string;
    size?: Size;
    layers?: number;
    levels?: number;
    arrayed?: boolean;
    samples?: number;
    centred?: boolean;
    /** Of an input: what the host gives, such as "device_depth" or "packed_view_normals". */
    content?: string;
    meaning?: string;
    previous_of?: string;
    clear?: number;
    /** Of a constant: one 32-bit number each, row after row. */
    texels?: Uint32Array;
}

export interface BlockMember {
    name: string;
    type: 'float' | 'uint' | 'vec2' | 'vec4' | 'mat4';
    /** In bytes. */
    offset: number;
    default?: number;
    least?: number;
    most?: number;
    meaning?: string;
}

export interface UniformBlock {
    size: number;
    members: BlockMember[];
}

export interface Features {
    extended_storage_formats: boolean;
    fragment_stores_and_atomics: boolean;
    subgroup_arithmetic: boolean;
    depth_samples: number;
    centred_depth_samples: number;
}

/** All a renderer needs to run an effect. */
export interface Manifest {
    manifest: number;
    crease: string;
    recipe: string;
    passes: Pass[];
    resources: Resource[];
    uniform_block: UniformBlock;
    features: Features;
}

/** An effect that was composed here. */
export interface Effect extends Manifest {
    /** Of which it consists, those by default included. */
    parts: Choice[];
}

/** A camera: what a texel and its depth mean in view space. */
export interface View {
    from_texel: number[];
    depth_unpack: number[];
    far_depth: number;
    guard: number;
    resolution: number[];
    texel_size: number[];
}

/** How a host writes matrices and stores rows; all false is Vulkan's way. */
export interface Convention {
    /** NDC depth in [-1, 1], as in WebGL; else in [0, 1]. */
    depthFromMinusOne?: boolean;
    /** NDC y = -1 is the last row of the image, as in WebGPU; else row 0. */
    yUp?: boolean;
    /** View space looks along +Z; else along -Z. */
    leftHanded?: boolean;
    /** Rows one after the other, for column vectors; else columns. */
    rowMajor?: boolean;
    /** Texels of guard band on each side. */
    guard?: number;
}

export interface Crease {
    /** Such as "0.2.0". */
    readonly version: string;
    readonly parts: Part[];
    readonly presets: Preset[];
    /** Why the parts of a recipe do not fit, in one sentence; "" where they do. */
    check(recipe: string): string;
    /** The effect of a recipe, in a few milliseconds; throws a RecipeError where there is none. */
    compose(recipe: string): Effect;
    /** A camera of a projection matrix; throws a RangeError where it is none. */
    view(matrix: ArrayLike<number>, width: number, height: number, convention?: Convention): View;
}

/** Loads the library: the `crease.wasm` beside this module, or another, by its address, its bytes or as a module. */
export function load(source?: URL | string | BufferSource | WebAssembly.Module): Promise<Crease>;
