// SPDX-License-Identifier: MIT

/** An element with properties and children; `aria-...` and `for` are attributes. */
export function element(tag, properties = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(properties))
        if (name in made && name !== 'list')
            made[name] = value;
        else
            made.setAttribute(name, value);
    made.append(...children);
    return made;
}

export function by_id(id) {
    return document.getElementById(id);
}

let next_id = 0;

/** A slider and a field for one number, under one label, that say when it changes. */
export function number_control({label, title, least, most, step, value, curve = 1, on_input}) {
    const id = `number-${++next_id}`;
    const range = most - least;
    const to_place = (number) => ((number - least) / range) ** (1 / curve);
    const field = element('input', {type: 'number', min: least, max: most, step: step === 1 ? 1 : 'any', value, 'aria-label': label});
    const slider = element('input', {
        type: 'range', id, min: 0, max: 1, step: step === 1 ? 1 / Math.max(range, 1) : 0.001, value: to_place(value),
        'aria-valuetext': `${value}`,
    });
    const set = (number) => {
        field.value = number;
        slider.setAttribute('aria-valuetext', `${number}`);
        on_input(number);
    };
    slider.addEventListener('input', () => {
        const number = least + range * Number(slider.value) ** curve;
        set(step === 1 ? Math.round(number) : Number(number.toPrecision(3)));
    });
    field.addEventListener('change', () => {
        const number = Math.min(Math.max(Number(field.value), least), most);
        slider.value = to_place(number);
        set(step === 1 ? Math.round(number) : number);
    });
    return element('div', {className: 'number', title}, element('label', {htmlFor: id}, label), slider, field);
}
