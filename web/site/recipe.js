// SPDX-License-Identifier: MIT
// Recipes as lists of words, and what a change of one part asks of the others.

/** The part behind a word `NAME[:NxN...]`. */
export function name_of(word) {
    return word.split(':')[0];
}

/** The words with another in the place of one. */
export function replaced(words, index, word) {
    return words.map((each, i) => i === index ? word : each);
}

/** Recipes as menus change them: each part a word, the first three sampler, depth source and estimator. */
export class Recipes {
    /**
     * @param crease  the library
     * @param host    what the page adds to each recipe, such as "linear_depth/fragment/glsl_es:300"
     */
    constructor(crease, host) {
        Object.assign(this, {crease, host});
        this.parts = new Map(crease.parts.map((part) => [part.name, part]));
        this.main = ['sampler', 'depth source', 'estimator'].map((role) => this.of_role(role));
        const [samplers, sources, estimators] = this.main;
        this.triples = new Set(samplers.flatMap((a) => sources.flatMap((b) => estimators.map((c) => [a, b, c])))
            .filter((names) => this.fits(names)).map((names) => names.join('/')));
    }

    of_role(role) {
        return this.crease.parts.filter((part) => part.role === role).map(({name}) => name);
    }

    role_of(word) {
        return this.parts.get(name_of(word))?.role;
    }

    /** The recipe as the page runs it. */
    hosted(words) {
        return [...words, this.host].join('/');
    }

    /** Why the page cannot run it; "" where it can. */
    refusal(words) {
        return this.crease.check(this.hosted(words));
    }

    fits(words) {
        return this.refusal(words) === '';
    }

    /** The words with a part of one of the first three roles, the others changed as little as makes it fit; or null. */
    with_main(words, index, word) {
        const wanted = replaced(words, index, word);
        const rest = wanted.slice(3);
        const tails = [rest, rest.filter((each) => this.role_of(each) !== 'filter'), []];
        const others = [0, 1, 2].filter((i) => i !== index);
        for (const tail of tails) {
            const found = this.#nearest(wanted.slice(0, 3), others, tail);
            if (found)
                return found;
        }
        return null;
    }

    #nearest(three, others, tail) {
        const [first, second] = others;
        const near = (i) => [three[i], ...this.main[i].filter((name) => name !== name_of(three[i]))];
        const tries = [three];
        for (const i of others)
            tries.push(...near(i).slice(1).map((word) => replaced(three, i, word)));
        for (const a of near(first).slice(1))
            tries.push(...near(second).slice(1).map((b) => replaced(replaced(three, first, a), second, b)));
        const found = tries.find((words) =>
            this.triples.has(words.map(name_of).join('/')) && this.fits([...words, ...tail]));
        return found ? [...found, ...tail] : null;
    }

    /** The words with another part of a role that a recipe has at most once; none where the word is "". */
    with_role(words, role, word) {
        const others = words.filter((each) => this.role_of(each) !== role);
        return word ? [...others, word] : others;
    }
}
