// SPDX-License-Identifier: MIT
// By what the page finds translations that were made beforehand.

/** The parts of an effect with their numbers: stage and dialect follow from the language, and of the rest only filters have an order. */
export function text_key(parts) {
    return parts.filter(({role}) => role !== 'stage' && role !== 'dialect')
        .sort((a, b) => (a.role < b.role ? -1 : a.role > b.role ? 1 : 0))
        .map(({name, numbers}) => [name, ...numbers].join(':')).join('/');
}
