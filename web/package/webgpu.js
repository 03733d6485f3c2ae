// SPDX-License-Identifier: MIT
// Runs any effect of compute and fragment passes in WebGPU, by its manifest alone: it knows nothing of ambient occlusion.
import {Block, size_of} from './host.js';

export {size_of};

/** Of each format: that of WebGPU, and the 32-bit numbers in a texel. */
const formats = {
    r8_unorm: ['r8unorm'],
    rgba8_unorm: ['rgba8unorm'],
    r32_uint: ['r32uint', 1],
    rg32_uint: ['rg32uint', 2],
    rgba32_uint: ['rgba32uint', 4],
    r32_float: ['r32float', 1],
    rg32_float: ['rg32float', 2],
    rgba16_float: ['rgba16float'],
    rgba32_float: ['rgba32float', 4],
    d32_float: ['depth32float'],
};

const storage = {load: 'read-only', store: 'write-only', modify: 'read-write'};

/** WGSL of naga, whose barriers wait for all that there is, where GLSL's wait for shared memory; WebGPU has no such barrier of subgroups. */
function with_plain_barriers(text) {
    return text.replace(/^ *(?:subgroup|texture|storage)Barrier\(\);\n/gm, '');
}

/** The manifest with WGSL in place of its GLSL, by `translate` of the package naga-wasm. */
export function with_wgsl(manifest, translate) {
    const to_wgsl = ({stage, text}) => {
        const [origin] = text.match(/^\/\/.*\n/) ?? ['']; // the recipe and the licence: naga keeps no comment
        return {format: 'wgsl', stage, text: origin + with_plain_barriers(translate({from: 'glsl', source: text, parse: {stage}, to: 'wgsl'}))};
    };
    return {...manifest, passes: manifest.passes.map((pass) => ({...pass, shaders: pass.shaders.map(to_wgsl)}))};
}

/** Why this module cannot run an effect in WebGPU, in one sentence; "" where it can. */
export function unsupported(manifest) {
    for (const {name, stage, dialect, shaders} of manifest.passes) {
        if (dialect !== 'webgpu' || !['compute', 'fragment'].includes(stage))
            return `the pass '${name}' is ${stage} in the dialect ${dialect}: WebGPU runs compute and fragment passes in webgpu`;
        if (shaders.some(({format, text}) => format !== 'wgsl' || text === undefined))
            return `the pass '${name}' has no text in WGSL`;
    }
    const resource = manifest.resources.find(({kind, samples, lifetime}) => kind === 'buffer' || samples > 1 || lifetime === 'history');
    return resource ? `the resource '${resource.name}' is more than an image that passes of a frame write and read` : '';
}

function has_whole_numbers({format}) {
    return format.endsWith('_uint');
}

/** Of each device: what it said when it was lost, null while it is there. */
const losses = new WeakMap();

function watch(device) {
    if (losses.has(device))
        return;
    losses.set(device, null);
    device.lost.then((info) => losses.set(device, info));
}

function refuse_lost(device) {
    const loss = losses.get(device);
    if (loss)
        throw new Error(`crease: the device was lost, so make another, and the effect anew on it: ${loss.message || loss.reason}`);
}

/** How often an image of a size may be halved, itself included. */
function levels_of({levels = 1}, [width, height]) {
    return Math.min(levels, 1 + Math.floor(Math.log2(Math.max(width, height))));
}

/** The number that a component holds whose bits are given. */
function cleared_to({format, clear}) {
    if (has_whole_numbers({format}))
        return clear;
    return format.endsWith('_float') ? new Float32Array(Uint32Array.of(clear).buffer)[0] : clear / 255;
}

export class WebGPUEffect {
    #device;
    #block;
    #buffer;
    #inputs;
    #resources;
    #textures = new Map(); // and the views that a host binds
    #owned = [];
    #clears = [];
    #passes = [];

    /** Makes images and pipelines; rejects where that cannot be. */
    static async create(device, manifest, width, height, options) {
        const reason = unsupported(manifest);
        if (reason)
            throw new Error(`crease: ${reason}`);
        watch(device);
        await null; // by when a device that was lost before has said so
        refuse_lost(device);
        const effect = new WebGPUEffect(device, manifest, width, height, options);
        try {
            effect.#passes = await Promise.all(manifest.passes.filter((pass) => effect.#is_there(pass)).map((pass) => effect.#prepare(pass)));
            refuse_lost(device);
        } catch (error) {
            effect.dispose();
            throw error;
        }
        return effect;
    }

    constructor(device, manifest, width, height, {guard = 0} = {}) {
        Object.assign(this, {width, height, guard});
        this.#device = device;
        this.#block = new Block(manifest.uniform_block);
        this.#buffer = device.createBuffer({
            label: 'crease: parameters', size: manifest.uniform_block.size, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST,
        });
        this.#resources = new Map(manifest.resources.map((resource) => [resource.name, resource]));
        const images = manifest.resources.filter(({kind}) => kind === 'image');
        this.#inputs = images.filter(({lifetime}) => lifetime === 'input').map(({name}) => name);
        const bindings = manifest.passes.flatMap((pass) => pass.bindings);
        for (const image of images.filter(({lifetime}) => lifetime !== 'input'))
            this.#make(image, bindings.filter(({resource}) => resource === image.name).map(({access}) => access));
    }

    get lost() {
        return losses.get(this.#device) !== null;
    }

    set(name, value) {
        this.#block.set(name, value);
    }

    setView(view, index = 0) {
        this.#block.set_view(view, index);
    }

    bind(name, texture) {
        if (!this.#inputs.includes(name))
            throw new RangeError(`crease: the effect has no input '${name}'`);
        if (this.#textures.get(name) === texture)
            return;
        this.#textures.set(name, texture);
        for (const pass of this.#passes.filter(({bindings}) => bindings.some(({resource}) => resource === name)))
            pass.groups = null;
    }

    texture(name) {
        return this.#textures.get(name);
    }

    record(encoder, {timestamps} = {}) {
        refuse_lost(this.#device);
        const unbound = this.#inputs.find((name) => !this.#textures.has(name));
        if (unbound)
            throw new Error(`crease: nothing is bound to the input '${unbound}'`);
        this.#device.queue.writeBuffer(this.#buffer, 0, this.#block.bytes.buffer);
        for (const attachment of this.#clears)
            encoder.beginRenderPass({label: 'crease: clear', colorAttachments: [attachment]}).end();
        this.#passes.forEach((pass, i) => {
            const first = timestamps && i === 0, last = timestamps && i === this.#passes.length - 1;
            const timestampWrites = first || last ? {
                querySet: timestamps,
                beginningOfPassWriteIndex: first ? 0 : undefined,
                endOfPassWriteIndex: last ? 1 : undefined,
            } : undefined;
            this.#record_pass(encoder, pass, timestampWrites);
        });
    }

    run() {
        refuse_lost(this.#device);
        const encoder = this.#device.createCommandEncoder({label: 'crease'});
        this.record(encoder);
        this.#device.queue.submit([encoder.finish()]);
    }

    dispose() {
        this.#owned.forEach((texture) => texture.destroy());
        this.#buffer.destroy();
    }

    #size_of(size) {
        return size_of(size, this.width, this.height, this.guard);
    }

    /** Small images have fewer levels than passes may fill. */
    #is_there({bindings}) {
        return bindings.every(({resource, level = 0}) => {
            const image = this.#resources.get(resource);
            return image.kind !== 'image' || level < levels_of(image, this.#size_of(image.size));
        });
    }

    #make(image, accesses) {
        const {name, format, size, layers, texels, clear} = image;
        const [width, height] = this.#size_of(size);
        const [gpu_format, numbers] = formats[format];
        const stored = accesses.some((access) => access in storage), drawn = accesses.includes('attachment') || clear !== undefined;
        const texture = this.#device.createTexture({
            label: `crease: ${name}`,
            size: [width, height, layers],
            mipLevelCount: levels_of(image, [width, height]),
            format: gpu_format,
            usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_SRC | GPUTextureUsage.COPY_DST |
                (stored ? GPUTextureUsage.STORAGE_BINDING : 0) | (drawn ? GPUTextureUsage.RENDER_ATTACHMENT : 0),
        });
        this.#owned.push(texture);
        this.#textures.set(name, texture);
        if (texels)
            this.#device.queue.writeTexture({texture}, texels, {bytesPerRow: 4 * numbers * width, rowsPerImage: height}, [width, height, layers]);
        if (clear === undefined)
            return;
        const value = cleared_to(image);
        for (let level = 0; level < texture.mipLevelCount; ++level)
            for (let layer = 0; layer < layers; ++layer)
                this.#clears.push({
                    view: texture.createView({baseMipLevel: level, mipLevelCount: 1, baseArrayLayer: layer, arrayLayerCount: 1, dimension: '2d'}),
                    loadOp: 'clear', storeOp: 'store', clearValue: [value, value, value, value],
                });
    }

    #dimension_of(resource) {
        return this.#resources.get(resource).arrayed ? '2d-array' : '2d';
    }

    #layout_entry({resource, access, slot}, visibility) {
        if (access === 'uniform')
            return {binding: slot, visibility, buffer: {type: 'uniform'}};
        const image = this.#resources.get(resource), viewDimension = this.#dimension_of(resource);
        if (access === 'sample')
            return {binding: slot, visibility, texture: {sampleType: has_whole_numbers(image) ? 'uint' : 'unfilterable-float', viewDimension}};
        return {binding: slot, visibility, storageTexture: {access: storage[access], format: formats[image.format][0], viewDimension}};
    }

    async #prepare(pass) {
        const device = this.#device, {name, stage, shaders} = pass;
        const label = `crease: ${name}`, is_compute = stage === 'compute';
        const bindings = pass.bindings.filter(({access}) => access !== 'attachment');
        const attachments = pass.bindings.filter(({access}) => access === 'attachment');
        const visibility = is_compute ? GPUShaderStage.COMPUTE : GPUShaderStage.FRAGMENT;
        const layouts = Array.from({length: 1 + Math.max(-1, ...bindings.map(({set}) => set))}, (_, i) => device.createBindGroupLayout({
            label, entries: bindings.filter(({set}) => set === i).map((binding) => this.#layout_entry(binding, visibility)),
        }));
        device.pushErrorScope('validation');
        const modules = new Map(shaders.map(({stage: of, text}) => [of, device.createShaderModule({label, code: text})]));
        const refused = device.popErrorScope().catch(() => null); // of a lost device there is none
        const shared = {label, layout: device.createPipelineLayout({label, bindGroupLayouts: layouts})};
        const targets = attachments.map(({resource}) => ({format: formats[this.#resources.get(resource).format][0]}));
        const made = is_compute
            ? device.createComputePipelineAsync({...shared, compute: {module: modules.get('compute')}})
            : device.createRenderPipelineAsync({...shared, vertex: {module: modules.get('vertex')}, fragment: {module: modules.get('fragment'), targets}});
        const pipeline = await made.catch(async (error) => {
            throw new Error(`crease: WebGPU refuses the pass '${name}': ${(await refused)?.message ?? error.message}`);
        });
        return {...pass, label, pipeline, layouts, bindings, attachments, size: this.#size_of(pass.size), groups: null};
    }

    #view_of({resource, level, access}) {
        const bound = this.#textures.get(resource);
        if (!(bound instanceof GPUTexture))
            return bound;
        const is_depth = bound.format.startsWith('depth');
        const levels = level === undefined && access === 'sample' ? {} : {baseMipLevel: level ?? 0, mipLevelCount: 1};
        return bound.createView({dimension: this.#dimension_of(resource), aspect: is_depth ? 'depth-only' : 'all', ...levels});
    }

    #groups_of({label, layouts, bindings}) {
        return layouts.map((layout, i) => this.#device.createBindGroup({
            label, layout, entries: bindings.filter(({set}) => set === i).map((binding) => ({
                binding: binding.slot, resource: binding.access === 'uniform' ? {buffer: this.#buffer} : this.#view_of(binding),
            })),
        }));
    }

    #record_pass(encoder, pass, timestampWrites) {
        const {label, stage, pipeline, attachments, size: [width, height], dispatch, workgroup} = pass;
        pass.groups ??= this.#groups_of(pass);
        const recorded = stage === 'compute'
            ? encoder.beginComputePass({label, timestampWrites})
            : encoder.beginRenderPass({label, timestampWrites, colorAttachments: attachments.map((attachment) =>
                ({view: this.#view_of(attachment), loadOp: 'clear', storeOp: 'store'}))});
        recorded.setPipeline(pipeline);
        pass.groups.forEach((group, i) => recorded.setBindGroup(i, group));
        if (stage === 'compute')
            recorded.dispatchWorkgroups(dispatch === 'rows' ? 1 : Math.ceil(width / workgroup[0]),
                                        dispatch === 'columns' ? 1 : Math.ceil(height / workgroup[1]));
        else
            recorded.draw(3);
        recorded.end();
    }
}
