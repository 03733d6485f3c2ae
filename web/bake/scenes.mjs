// SPDX-License-Identifier: MIT
// The views of the playground: the built-in scene of the crease command, and two scenes that are hard on screen space.

function camera(name, eye, target, ao_radius, vfov_deg = 45) {
    return {name, eye, target, up: [0, 1, 0], vfov_deg, near: 0.1, far: 40, width: 640, height: 360, ao_radius};
}

/** Vertices and faces as the text of an OBJ file. */
class Obj {
    #lines = [];
    #count = 0;

    face(corners) {
        corners.forEach(([x, y, z]) => this.#lines.push(`v ${x.toFixed(5)} ${y.toFixed(5)} ${z.toFixed(5)}`));
        this.#lines.push(`f ${corners.map((_, i) => this.#count + i + 1).join(' ')}`);
        this.#count += corners.length;
    }

    box(low, high) {
        for (let axis = 0; axis < 3; ++axis)
            for (const side of [low, high])
                this.face([[low, low], [high, low], [high, high], [low, high]].map(([u, v]) => {
                    const corner = [0, 0, 0];
                    corner[axis] = side[axis];
                    corner[(axis + 1) % 3] = u[(axis + 1) % 3];
                    corner[(axis + 2) % 3] = v[(axis + 2) % 3];
                    return corner;
                }));
    }

    toString() {
        return `${this.#lines.join('\n')}\n`;
    }
}

/** Before a wall three rows of rails, from a sixtieth of the radius thick. */
function rails() {
    const obj = new Obj();
    obj.box([-8, -0.1, -8], [8, 0, 8]);
    obj.box([-8, 0, -2.2], [8, 5, -2]);
    for (let row = 0; row < 3; ++row) {
        const thickness = 0.01 + 0.012 * row, z = -1.7 + 0.9 * row, step = 0.22 + 0.06 * row;
        for (let i = 0; -4 + i * step <= 4; ++i)
            obj.box([-4 + i * step, 0, z], [-4 + i * step + thickness, 1, z + thickness]);
        for (const y of [0.25, 0.625, 1])
            obj.box([-4, y, z], [4.1, y + thickness, z + thickness]);
    }
    return obj;
}

/** Numbers from 0 to 1 that look random and are the same each time. */
function random_numbers(seed) {
    let state = seed;
    return () => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return state / 2 ** 32;
    };
}

/** A trunk, and leaves at random in a ball. */
function foliage() {
    const obj = new Obj(), random = random_numbers(7);
    obj.face([[-8, 0, -8], [-8, 0, 8], [8, 0, 8], [8, 0, -8]]);
    obj.box([-0.1, 0, -0.1], [0.1, 1.6, 0.1]);
    for (let leaves = 0; leaves < 2500;) {
        const centre = [random(), random(), random()].map((r) => 2 * r - 1);
        if (Math.hypot(...centre) > 1)
            continue;
        ++leaves;
        const [a, b] = [0, 1].map(() => [random(), random(), random()].map((r) => 0.12 * (r - 0.5)));
        obj.face([[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => [
            centre[0] + u * a[0] + v * b[0], 1.8 + centre[1] + u * a[1] + v * b[1], centre[2] + u * a[2] + v * b[2],
        ]));
    }
    return obj;
}

export const scenes = {
    'built-in': {},
    rails: {text: rails},
    foliage: {text: foliage},
};

export const views = [
    {title: 'Courtyard', scene: 'built-in', camera: camera('courtyard', [6, 3.4, 9.4], [-0.7, 1.9, -2], 1.2, 40)},
    {title: 'Stairs', scene: 'built-in', camera: camera('stairs', [-0.9, 1.9, 1.2], [3, 1.75, -4.2], 0.8, 52)},
    {title: 'Arcade', scene: 'built-in', camera: camera('arcade', [-3.2, 1.7, 2.9], [-6.3, 2.1, -1.8], 1.2, 55)},
    {title: 'Fountain', scene: 'built-in', camera: camera('fountain', [0.9, 2.1, 3.6], [-1.9, 0.5, -0.4], 0.6, 42)},
    {title: 'Gallery', scene: 'built-in', camera: camera('gallery', [2.6, 0.9, 0.6], [4.9, 1.9, -4.4], 0.8, 50)},
    {title: 'Crates', scene: 'built-in', camera: camera('crates', [-2.6, 1.7, -1.6], [-4.9, 0.5, -4.6], 0.5, 48)},
    {title: 'Behind the arches', scene: 'built-in', camera: camera('walk', [-7.6, 1.5, 4.6], [-7.2, 1.5, -4], 1, 58)},
    {title: 'From above', scene: 'built-in', camera: camera('above', [2.6, 8.5, 7.5], [-0.6, 0.4, -1.4], 1.5, 42)},
    {title: 'Thin rails', scene: 'rails', camera: camera('rails', [0.5, 1.4, 3.4], [0, 0.5, -1], 0.6)},
    {title: 'Thin rails, near', scene: 'rails', camera: camera('rails_near', [2.6, 0.7, 1.9], [-1, 0.5, -1], 0.6)},
    {title: 'Foliage', scene: 'foliage', camera: camera('foliage', [0, 1.8, 3.6], [0, 1.5, 0], 0.6)},
    {title: 'Foliage, near', scene: 'foliage', camera: camera('foliage_near', [1.6, 2.2, 1.6], [0, 1.6, 0], 0.6)},
];
