// SPDX-License-Identifier: MIT
// Matrices, column-major, and cameras as the crease command has them.

export function multiply(a, b) {
    const product = new Float32Array(16);
    for (let column = 0; column < 4; ++column)
        for (let row = 0; row < 4; ++row)
            for (let i = 0; i < 4; ++i)
                product[4 * column + row] += a[4 * i + row] * b[4 * column + i];
    return product;
}

function cross([ax, ay, az], [bx, by, bz]) {
    return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

function dot(a, b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function unit(v) {
    const length = Math.hypot(...v);
    return v.map((x) => x / length);
}

/** World space to view space, which looks down -Z. */
export function view_matrix({eye, target, up}) {
    const ahead = unit(target.map((x, i) => x - eye[i]));
    const right = unit(cross(ahead, up));
    const above = cross(right, ahead);
    return new Float32Array([
        right[0], above[0], -ahead[0], 0,
        right[1], above[1], -ahead[1], 0,
        right[2], above[2], -ahead[2], 0,
        -dot(right, eye), -dot(above, eye), dot(ahead, eye), 1,
    ]);
}

function perspective({vfov_deg}, aspect, depth_scale, depth_offset) {
    const scale = 1 / Math.tan(vfov_deg * Math.PI / 360);
    return new Float32Array([scale / aspect, 0, 0, 0, 0, -scale, 0, 0, 0, 0, depth_scale, -1, 0, 0, depth_offset, 0]);
}

/** View space to the clip space of WebGL, with row 0 of an image at the top of the picture. */
export function projection_matrix(camera, aspect) {
    const {near, far} = camera;
    return perspective(camera, aspect, (far + near) / (near - far), 2 * far * near / (near - far));
}

/** The same for effects: with the reversed depth of `crease render`, by whose rounding estimators judge linear depth too. */
export function reversed_projection_matrix(camera, aspect) {
    const {near, far} = camera;
    return perspective(camera, aspect, near / (far - near), far * near / (far - near));
}

/** The camera turned around its target by angles, and moved away from it by a factor. */
export function orbited(camera, across, up, distance) {
    const offset = camera.eye.map((x, i) => x - camera.target[i]);
    const length = Math.hypot(...offset) * distance;
    const turn = Math.atan2(offset[0], offset[2]) + across;
    const climb = Math.min(Math.max(Math.asin(offset[1] / Math.hypot(...offset)) + up, -1.5), 1.5);
    const eye = [
        camera.target[0] + length * Math.cos(climb) * Math.sin(turn),
        camera.target[1] + length * Math.sin(climb),
        camera.target[2] + length * Math.cos(climb) * Math.cos(turn),
    ];
    return {...camera, eye};
}
