// SPDX-License-Identifier: MIT
// Runs any effect of fragment passes in WebGL 2, by its manifest alone: it knows nothing of ambient occlusion.
import {Block, size_of} from './host.js';

export {size_of};

/** Of each format: internal format, format and type of pixels, what holds these. */
function pixel_formats(gl) {
    return {
        r8_unorm: [gl.R8, gl.RED, gl.UNSIGNED_BYTE],
        rgba8_unorm: [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE],
        r32_uint: [gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT],
        rg32_uint: [gl.RG32UI, gl.RG_INTEGER, gl.UNSIGNED_INT],
        rgba32_uint: [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT],
        r32_float: [gl.R32F, gl.RED, gl.FLOAT],
        rg32_float: [gl.RG32F, gl.RG, gl.FLOAT],
        rgba16_float: [gl.RGBA16F, gl.RGBA, gl.HALF_FLOAT],
        rgba32_float: [gl.RGBA32F, gl.RGBA, gl.FLOAT],
    };
}

/** Why WebGL 2 cannot run an effect, in one sentence; "" where it can. */
export function unsupported(manifest) {
    const pass = manifest.passes.find(({stage, dialect}) => stage !== 'fragment' || dialect !== 'glsl_es');
    if (pass)
        return `the pass '${pass.name}' is ${pass.stage} in the dialect ${pass.dialect}: WebGL 2 runs fragment passes in glsl_es:300`;
    const resource = manifest.resources.find((each) => each.kind === 'buffer' || each.arrayed || each.samples > 1 ||
                                                       each.lifetime === 'history' || each.clear !== undefined);
    return resource ? `the resource '${resource.name}' is more than an image that a pass draws to and another reads` : '';
}

function compile(gl, type, text, name) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(`crease: the pass '${name}' does not compile: ${gl.getShaderInfoLog(shader)}`);
    return shader;
}

function link(gl, {name, shaders}) {
    const program = gl.createProgram();
    for (const {stage, text} of shaders) {
        const shader = compile(gl, stage === 'vertex' ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER, text, name);
        gl.attachShader(program, shader);
        gl.deleteShader(shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
        throw new Error(`crease: the pass '${name}' does not link: ${gl.getProgramInfoLog(program)}`);
    return program;
}

export class WebGL2Effect {
    #gl;
    #block;
    #inputs;
    #textures = new Map();
    #owned = [];
    #passes = [];
    #buffer;
    #sampler;
    #triangle;
    #lost = false;
    #note_loss = () => (this.#lost = true);

    constructor(gl, manifest, width, height, {guard = 0} = {}) {
        const reason = unsupported(manifest);
        if (reason)
            throw new Error(`crease: ${reason}`);
        if (gl.isContextLost())
            throw new Error('crease: the context of WebGL 2 is lost, so wait for it, or make another');
        if (!gl.getExtension('EXT_color_buffer_float'))
            throw new Error('crease: the device cannot draw to images of floats: EXT_color_buffer_float is missing');
        Object.assign(this, {width, height, guard});
        this.#gl = gl;
        gl.canvas.addEventListener('webglcontextlost', this.#note_loss);
        this.#block = new Block(manifest.uniform_block);
        this.#buffer = gl.createBuffer();
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.#buffer);
        gl.bufferData(gl.UNIFORM_BUFFER, manifest.uniform_block.size, gl.DYNAMIC_DRAW);
        this.#triangle = gl.createVertexArray();
        this.#sampler = gl.createSampler();
        for (const [name, value] of [
            [gl.TEXTURE_MIN_FILTER, gl.NEAREST], [gl.TEXTURE_MAG_FILTER, gl.NEAREST],
            [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE],
        ])
            gl.samplerParameteri(this.#sampler, name, value);
        const images = manifest.resources.filter(({kind}) => kind === 'image');
        this.#inputs = images.filter(({lifetime}) => lifetime === 'input').map(({name}) => name);
        try {
            for (const image of images.filter(({lifetime}) => lifetime !== 'input'))
                this.#make(image);
            this.#passes = manifest.passes.map((pass) => this.#prepare(pass));
        } catch (error) {
            this.dispose();
            throw error;
        }
    }

    /** What a context made is lost with it, and not restored with it. */
    get lost() {
        return this.#lost || this.#gl.isContextLost();
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
        this.#textures.set(name, texture);
    }

    texture(name) {
        return this.#textures.get(name);
    }

    run() {
        const gl = this.#gl;
        if (this.lost)
            throw new Error('crease: the context of WebGL 2 was lost, so make the effect anew once it is restored');
        const unbound = this.#inputs.find((name) => !this.#textures.has(name));
        if (unbound)
            throw new Error(`crease: nothing is bound to the input '${unbound}'`);
        gl.disable(gl.BLEND);
        gl.disable(gl.CULL_FACE);
        gl.disable(gl.DEPTH_TEST);
        gl.disable(gl.SCISSOR_TEST);
        gl.colorMask(true, true, true, true);
        gl.bindVertexArray(this.#triangle);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.#buffer);
        gl.bufferSubData(gl.UNIFORM_BUFFER, 0, this.#block.bytes);
        this.#passes.forEach((pass) => this.#draw(pass));
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.bindVertexArray(null);
    }

    dispose() {
        const gl = this.#gl;
        gl.canvas.removeEventListener('webglcontextlost', this.#note_loss);
        if (this.lost)
            return;
        this.#owned.forEach((texture) => gl.deleteTexture(texture));
        for (const {program, target} of this.#passes) {
            gl.deleteProgram(program);
            gl.deleteFramebuffer(target);
        }
        gl.deleteBuffer(this.#buffer);
        gl.deleteVertexArray(this.#triangle);
        gl.deleteSampler(this.#sampler);
    }

    #make({name, format, size, texels}) {
        const gl = this.#gl;
        const [internal, pixels, type] = pixel_formats(gl)[format];
        const [width, height] = size_of(size, this.width, this.height, this.guard);
        const texture = gl.createTexture();
        this.#owned.push(texture);
        this.#textures.set(name, texture);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        if (texels) {
            const held = type === gl.FLOAT ? new Float32Array(texels.buffer, texels.byteOffset, texels.length) : texels;
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, pixels, type, held);
        }
    }

    #prepare(pass) {
        const gl = this.#gl;
        const program = link(gl, pass);
        const block = gl.getUniformBlockIndex(program, 'crease_parameters');
        if (block !== gl.INVALID_INDEX)
            gl.uniformBlockBinding(program, block, 0);
        const read = pass.bindings.filter(({access}) => access === 'sample');
        gl.useProgram(program);
        read.forEach(({name}, unit) => gl.uniform1i(gl.getUniformLocation(program, `crease_${name}`), unit));
        const written = pass.bindings.filter(({access}) => access === 'attachment');
        const target = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, target);
        for (const {resource, slot} of written)
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + slot, gl.TEXTURE_2D, this.#textures.get(resource), 0);
        gl.drawBuffers(written.map(({slot}) => gl.COLOR_ATTACHMENT0 + slot));
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        return {program, target, read, size: size_of(pass.size, this.width, this.height, this.guard)};
    }

    #draw({program, target, read, size: [width, height]}) {
        const gl = this.#gl;
        gl.useProgram(program);
        gl.bindFramebuffer(gl.FRAMEBUFFER, target);
        gl.viewport(0, 0, width, height);
        read.forEach(({resource}, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, this.#textures.get(resource));
            gl.bindSampler(unit, this.#sampler);
        });
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        read.forEach((_, unit) => gl.bindSampler(unit, null));
    }
}
