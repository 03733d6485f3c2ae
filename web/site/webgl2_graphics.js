// SPDX-License-Identifier: MIT
// What the page draws by, in WebGL 2.
import {WebGL2Effect} from './package/webgl2.js';

import {measure} from './clock.js';
import {fill, read, texture_of} from './gl.js';
import {Picture} from './picture.js';
import {Scene} from './scene.js';

export class WebGL2Graphics {
    #picture;

    name = 'webgl2';

    /** What is added to each recipe: G-buffers hold linear depth, and WebGL 2 runs fragment shaders. */
    host = 'linear_depth/fragment/glsl_es:300';

    static async open(canvas) {
        const gl = canvas.getContext('webgl2', {antialias: false});
        if (!gl)
            throw new Error('This browser has no WebGL 2.');
        if (!gl.getExtension('EXT_color_buffer_float'))
            throw new Error('This device cannot draw to images of floats (EXT_color_buffer_float).');
        return new WebGL2Graphics(gl);
    }

    constructor(gl) {
        this.gl = gl;
        this.lost = new Promise((resolve) => gl.canvas.addEventListener('webglcontextlost', resolve, {once: true}));
        this.#picture = new Picture(gl);
    }

    /** An image of depths, of normals or of a truth, and its texels. */
    texture(content, width, height, texels) {
        const {gl} = this;
        const [internal, format, type] = {
            depth: [gl.R32F, gl.RED, gl.FLOAT],
            normal: [gl.RGB32F, gl.RGB, gl.FLOAT],
            truth: [gl.R8, gl.RED, gl.UNSIGNED_BYTE],
        }[content];
        const texture = texture_of(gl, internal, width, height);
        fill(gl, texture, width, height, format, type, texels);
        return texture;
    }

    free(texture) {
        this.gl.deleteTexture(texture);
    }

    async effect(manifest, width, height) {
        return new WebGL2Effect(this.gl, manifest, width, height);
    }

    scene(triangles, width, height) {
        return new Scene(this.gl, triangles, width, height);
    }

    draw(visibility, truth, how) {
        this.#picture.draw(visibility, truth, how);
    }

    /** The first component of each texel of an image of an effect. */
    read(texture, {format}, width, height) {
        return read(this.gl, texture, width, height, format === 'r32_float');
    }

    /** @param effect  gives the effect that is there at a time */
    measure(effect) {
        return measure(this.gl, () => effect().run());
    }
}
