// SPDX-License-Identifier: MIT
// Recipes in which each part stands that goes with WebGPU.

function names_of(crease, role) {
    return crease.parts.filter((part) => part.role === role).map(({name}) => name);
}

/** Every sampler and estimator over every source, and every other part once, without the part webgpu. */
export function webgpu_recipes(crease) {
    const of_role = (role) => names_of(crease, role);
    const fits = (recipe) => crease.check(`${recipe}/webgpu`) === '';
    const three = of_role('depth source').flatMap((source) =>
        of_role('sampler').flatMap((sampler) => of_role('estimator').map((estimator) => `${sampler}/${source}/${estimator}`)));
    const roles = ['projection', 'depth encoding', 'normals', 'noise', 'output', 'output format', 'filter', 'stage'];
    const base = 'directions:4x4/single_layer/hbao';
    return [
        ...three,
        ...roles.flatMap((role) => of_role(role).map((name) => `${base}/${name}`)),
        ...of_role('filter').map((name) => `${base}/${name}/fragment/bent_cone`),
        ...crease.presets.map(({name}) => `preset:${name}`),
    ].filter(fits).filter((recipe) => !recipe.includes('functions'));
}
