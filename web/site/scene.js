// SPDX-License-Identifier: MIT
// Draws triangles to a G-buffer: linear depth, and the geometric normal in view space.
import {program_of, texture_of} from './gl.js';

const vertex = `#version 300 es
uniform mat4 view, projection;
in vec3 corner;
out vec3 position;
void main() {
    position = (view * vec4(corner, 1)).xyz;
    gl_Position = projection * vec4(position, 1);
}`;

const fragment = `#version 300 es
precision highp float;
in vec3 position;
layout(location = 0) out float depth;
layout(location = 1) out vec4 normal;
void main() {
    vec3 across = normalize(cross(dFdx(position), dFdy(position)));
    depth = -position.z;
    normal = vec4(dot(across, position) < 0.0 ? across : -across, 0);
}`;

export class Scene {
    constructor(gl, triangles, width, height) {
        Object.assign(this, {gl, width, height, count: triangles.length / 3});
        this.program = program_of(gl, vertex, fragment);
        this.corners = gl.createVertexArray();
        this.buffer = gl.createBuffer();
        gl.bindVertexArray(this.corners);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
        gl.bufferData(gl.ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
        const place = gl.getAttribLocation(this.program, 'corner');
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
        gl.bindVertexArray(null);
        this.depth = texture_of(gl, gl.R32F, width, height);
        this.normal = texture_of(gl, gl.RGBA16F, width, height);
        this.tested = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, this.tested);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
        this.target = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.depth, 0);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT1, gl.TEXTURE_2D, this.normal, 0);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, this.tested);
        gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }

    draw(view, projection) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
        gl.viewport(0, 0, this.width, this.height);
        gl.enable(gl.DEPTH_TEST);
        gl.disable(gl.CULL_FACE);
        gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
        gl.clearBufferfv(gl.COLOR, 1, [0, 0, 0, 0]);
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        gl.useProgram(this.program);
        gl.uniformMatrix4fv(gl.getUniformLocation(this.program, 'view'), false, view);
        gl.uniformMatrix4fv(gl.getUniformLocation(this.program, 'projection'), false, projection);
        gl.bindVertexArray(this.corners);
        gl.drawArrays(gl.TRIANGLES, 0, this.count);
        gl.bindVertexArray(null);
        gl.disable(gl.DEPTH_TEST);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }

    dispose() {
        const {gl} = this;
        gl.deleteProgram(this.program);
        gl.deleteVertexArray(this.corners);
        gl.deleteBuffer(this.buffer);
        gl.deleteTexture(this.depth);
        gl.deleteTexture(this.normal);
        gl.deleteRenderbuffer(this.tested);
        gl.deleteFramebuffer(this.target);
    }
}
