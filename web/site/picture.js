// SPDX-License-Identifier: MIT
// Shows visibility on the canvas, and right of the split what it is compared with.
import {program_of} from './gl.js';

const vertex = `#version 300 es
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1);
}`;

// Row 0 of the images is the top of the picture, and of the canvas the bottom.
const fragment = `#version 300 es
precision highp float;
uniform sampler2D visibility, truth;
uniform float split;
uniform int beside; // 0: nothing, 1: the truth, 2: the difference
out vec4 colour;
void main() {
    ivec2 size = textureSize(visibility, 0);
    ivec2 texel = ivec2(gl_FragCoord.x, float(size.y) - gl_FragCoord.y);
    float shown = texelFetch(visibility, texel, 0).r;
    float traced = texelFetch(truth, texel, 0).r;
    float difference = clamp((shown - traced) * 3.0, -1.0, 1.0);
    vec3 blue = vec3(0.13, 0.4, 0.67), red = vec3(0.7, 0.09, 0.17), pale = vec3(0.97);
    vec3 false_colour = mix(pale, difference < 0.0 ? blue : red, abs(difference));
    float past = beside == 0 ? -1.0 : gl_FragCoord.x - split * float(size.x);
    colour = vec4(past < 0.0 ? vec3(shown) : beside == 1 ? vec3(traced) : false_colour, 1);
    if (abs(past) < 1.0 && beside != 0)
        colour.rgb = vec3(0.12, 0.37, 0.66);
}`;

export class Picture {
    constructor(gl) {
        this.gl = gl;
        this.program = program_of(gl, vertex, fragment);
        this.triangle = gl.createVertexArray();
        gl.useProgram(this.program);
        gl.uniform1i(gl.getUniformLocation(this.program, 'visibility'), 0);
        gl.uniform1i(gl.getUniformLocation(this.program, 'truth'), 1);
    }

    /** @param truth  texture of the traced visibility, or null */
    draw(visibility, truth, {split, beside}) {
        const {gl, program} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, gl.canvas.width, gl.canvas.height);
        gl.useProgram(program);
        gl.bindVertexArray(this.triangle);
        gl.uniform1f(gl.getUniformLocation(program, 'split'), split);
        gl.uniform1i(gl.getUniformLocation(program, 'beside'), truth ? {truth: 1, difference: 2}[beside] ?? 0 : 0);
        [visibility, truth].forEach((texture, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, texture);
        });
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.bindVertexArray(null);
    }
}
