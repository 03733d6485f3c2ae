// SPDX-License-Identifier: MIT
// Menus of parts and sliders of their numbers, that offer what fits and say of the rest why it does not.
import {element, number_control} from './dom.js';
import {name_of, replaced} from './recipe.js';

const main_roles = ['sampler', 'depth source', 'estimator'];
const further_roles = ['normals', 'noise', 'layer traversal', 'receivers', 'output', 'output format', 'image reads'];

function title_of(name) {
    return name.replaceAll('_', ' ');
}

function numbers_of(word) {
    const [, numbers] = word.split(':');
    return numbers ? numbers.split('x').map(Number) : [];
}

export class Menus {
    /**
     * @param recipes  Recipes
     * @param place    the element that holds them
     * @param change   called with the words of another recipe
     */
    constructor(recipes, place, change) {
        Object.assign(this, {recipes, place, change});
    }

    /** @param parts  of the effect, those by default included */
    show(words, parts) {
        const kept = document.activeElement?.dataset?.menu;
        const open = [...this.place.querySelectorAll('details[open]')].map(({id}) => id);
        this.words = words;
        this.place.replaceChildren(
            ...main_roles.map((role, i) => this.#main(role, i)), this.#filters(), this.#further(parts));
        open.forEach((id) => this.place.querySelector(`#${id}`)?.setAttribute('open', ''));
        this.place.querySelector(`[data-menu="${kept}"]`)?.focus();
    }

    #main(role, index) {
        const chosen = name_of(this.words[index]);
        const entries = this.recipes.main[index].map((name) => {
            const words = name === chosen ? this.words : this.recipes.with_main(this.words, index, name);
            const changes = words && words.some((word, i) => i !== index && word !== this.words[i]);
            return {name, words, note: changes ? ' *' : '', reason: words ? '' : this.recipes.refusal(replaced(this.words, index, name))};
        });
        return this.#group(role, chosen, entries, this.#numbers(index));
    }

    #further(parts) {
        const groups = further_roles.map((role) => {
            const used = parts.find((part) => part.role === role);
            const named = this.words.find((word) => this.recipes.role_of(word) === role);
            const entries = this.recipes.of_role(role).map((name) => {
                const words = name === used?.name ? this.words : this.recipes.with_role(this.words, role, name);
                return {name, words: this.recipes.fits(words) ? words : null, note: '', reason: this.recipes.refusal(words)};
            });
            return this.#group(role, used?.name, entries, named ? this.#numbers(this.words.indexOf(named)) : []);
        });
        return element('details', {id: 'further'}, element('summary', {}, 'More parts'), ...groups);
    }

    #group(role, chosen, entries, numbers) {
        const part = this.recipes.parts.get(chosen);
        const select = element('select', {id: `menu-${title_of(role).replaceAll(' ', '-')}`, 'data-menu': role},
            ...entries.filter(({words}) => words).map(({name, note}) =>
                element('option', {value: name, selected: name === chosen}, title_of(name) + note)));
        select.addEventListener('change', () => this.change(entries.find(({name}) => name === select.value).words));
        const refused = entries.filter(({words}) => !words);
        const group = element('div', {className: 'group'},
            element('label', {htmlFor: select.id}, role), select, element('p', {className: 'summary'}, part?.summary ?? ''));
        if (part?.source)
            group.append(element('p', {className: 'source'}, part.source));
        group.append(...numbers);
        if (refused.length > 0)
            group.append(element('details', {id: `refused-${select.id}`, className: 'refused'},
                element('summary', {}, `${refused.length} more ${refused.length === 1 ? 'does' : 'do'} not fit here`),
                element('dl', {}, ...refused.flatMap(({name, reason}) =>
                    [element('dt', {}, title_of(name)), element('dd', {}, reason.replace(/^crease::\w+: /, ''))]))));
        return group;
    }

    /** Sliders of the numbers of the part at a place in the recipe. */
    #numbers(index) {
        const word = this.words[index];
        const {name, numbers} = this.recipes.parts.get(name_of(word));
        const values = numbers.map(({fallback}, i) => numbers_of(word)[i] ?? fallback);
        return numbers.map((number, i) => number_control({
            label: number.name,
            title: number.meaning,
            least: number.least,
            most: number.most,
            step: 1,
            curve: number.most > 16 ? 2 : 1,
            value: values[i],
            on_input: (value) => {
                values[i] = value;
                this.words = replaced(this.words, index, `${name}:${values.join('x')}`);
                this.change(this.words, {keep_menus: true});
            },
        }));
    }

    #filters() {
        const {recipes, words} = this;
        const rows = words.flatMap((word, index) => {
            if (recipes.role_of(word) !== 'filter')
                return [];
            const remove = element('button', {type: 'button', 'aria-label': `remove ${title_of(name_of(word))}`}, '×');
            remove.addEventListener('click', () => this.change(words.filter((_, i) => i !== index)));
            return [element('div', {className: 'filter'}, element('span', {}, title_of(name_of(word))), remove), ...this.#numbers(index)];
        });
        const all = recipes.of_role('filter').map((name) => {
            const last = words.findLastIndex((word, i) => i < 3 || recipes.role_of(word) === 'filter');
            return {name, words: [...words.slice(0, last + 1), name, ...words.slice(last + 1)]};
        });
        const fitting = all.filter(({words: more}) => recipes.fits(more));
        const select = element('select', {id: 'menu-filter', 'data-menu': 'filter'},
            element('option', {value: ''}, 'add a filter…'),
            ...fitting.map(({name}) => element('option', {value: name}, title_of(name))));
        select.addEventListener('change', () => this.change(fitting.find(({name}) => name === select.value).words));
        return element('div', {className: 'group'}, element('label', {htmlFor: 'menu-filter'}, 'filters'), ...rows, select);
    }
}
