// SPDX-License-Identifier: MIT
// naga, which translates GLSL in the page: 2 MB that are loaded once they are needed.

let loading = null;

async function load() {
    const naga = await import('./naga/index.js').catch(() => {
        throw new Error('This page was made without naga, which translates GLSL: npm had it not.');
    });
    await naga.init({module_or_path: new URL('naga/wasm/naga_bg.wasm', import.meta.url)});
    return naga.translate;
}

/** Its function `translate`. */
export function load_naga() {
    loading ??= load();
    return loading;
}
