// SPDX-License-Identifier: MIT
// What hosts of manifests share: sizes of images, and the block of parameters.

/** The sides of an image for a picture of a size, all in texels. */
export function size_of(size, width, height, guard = 0) {
    const band = size.guarded ? 2 * guard : 0;
    const sides = size.width ? [size.width, size.height] : [width, height].map((side) => Math.ceil(side / size.divisor) + band);
    return size.level ? sides.map((side) => Math.max(side >> size.level, 1)) : sides;
}

/** The uniform block, whose members are set by their names. */
export class Block {
    constructor({size, members}) {
        this.bytes = new DataView(new ArrayBuffer(size));
        this.members = new Map(members.map((member) => [member.name, member]));
        for (const {name, default: fallback} of members)
            if (fallback !== undefined)
                this.set(name, fallback);
    }

    set(name, value) {
        const member = this.members.get(name);
        if (!member)
            throw new RangeError(`crease: the effect has no parameter '${name}'`);
        if (member.least !== undefined && !(value >= member.least && value <= member.most))
            throw new RangeError(`crease: '${name}' must be from ${member.least} to ${member.most}, and is ${value}`);
        [value].flat().forEach((number, i) => {
            if (member.type === 'uint')
                this.bytes.setUint32(member.offset + 4 * i, number, true);
            else
                this.bytes.setFloat32(member.offset + 4 * i, number, true);
        });
    }

    /** Sets a camera, as `crease.view` makes it. */
    set_view(view, index) {
        for (const [name, value] of Object.entries(view))
            this.set(`views[${index}].${name}`, value);
    }
}
