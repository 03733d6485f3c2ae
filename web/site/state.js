// SPDX-License-Identifier: MIT
// All that the page shows, as the fragment of its address: a link holds it whole.

export const defaults = {
    recipe: 'preset:medium',
    device: 'webgl2',
    view: 'courtyard',
    truth: 'linear',
    beside: 'truth',
    split: 0.5,
    radius: null,
    orbit: null,
    settings: {},
};

const numbers = ['split', 'radius'];
const prefix = 'set.';

/** Angles across and up and a distance; null of anything else. */
function angles_of(text) {
    const numbers = text.split(',').map(Number);
    return numbers.length === 3 && numbers.every(Number.isFinite) && numbers[2] > 0 ? numbers : null;
}

export function read_state(fragment) {
    const state = {...defaults, settings: {}};
    for (const [name, value] of new URLSearchParams(fragment.replace(/^#/, '')))
        if (name.startsWith(prefix) && Number.isFinite(Number(value)))
            state.settings[name.slice(prefix.length)] = Number(value);
        else if (numbers.includes(name) && Number.isFinite(Number(value)))
            state[name] = Number(value);
        else if (name === 'orbit')
            state.orbit = angles_of(value);
        else if (name in defaults && !numbers.includes(name) && name !== 'settings')
            state[name] = value;
    return state;
}

export function fragment_of(state) {
    const words = new URLSearchParams();
    for (const [name, value] of Object.entries(state))
        if (name === 'settings')
            Object.entries(value).forEach(([setting, number]) => words.set(prefix + setting, number));
        else if (value !== defaults[name])
            words.set(name, value);
    return `#${words.toString().replaceAll('%3A', ':').replaceAll('%2F', '/').replaceAll('%2C', ',')}`;
}
