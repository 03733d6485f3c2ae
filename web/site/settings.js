// SPDX-License-Identifier: MIT
// Sliders of the settings of an effect and of the radius.
import {element, number_control} from './dom.js';

/** The members of the uniform block that a visitor may change. */
export function settings_of(effect) {
    return effect.uniform_block.members.filter((member) => member.default !== undefined);
}

export function show_settings(place, effect, {radius, recommended_radius, values, on_radius, on_setting}) {
    const controls = settings_of(effect).map((member) => number_control({
        label: member.name.replace(/^.*\./, '').replaceAll('_', ' '),
        title: `${member.name}: ${member.meaning}`,
        least: member.least,
        most: member.most,
        curve: member.most - member.least > 4 ? 3 : 1,
        value: values[member.name] ?? member.default,
        on_input: (value) => on_setting(member.name, value),
    }));
    place.replaceChildren(
        number_control({
            label: 'radius', title: 'how far occluders reach, metres', least: 0, most: 4 * recommended_radius, curve: 2,
            value: radius, on_input: on_radius,
        }),
        ...controls,
        element('p', {className: 'summary'}, 'Point at a slider to read what it means.'));
}
