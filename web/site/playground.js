// SPDX-License-Identifier: MIT
// The page: state goes to the stage, and what is changed on the page goes to the state.
import {load, RecipeError} from './package/crease.js';

import {by_id, element} from './dom.js';
import {rmse, ssim} from './measures.js';
import {Menus} from './menus.js';
import {Recipes} from './recipe.js';
import {settings_of, show_settings} from './settings.js';
import {Stage} from './stage.js';
import {fragment_of, read_state} from './state.js';
import {Texts} from './texts.js';
import {list_of_views} from './views.js';
import {WebGL2Graphics} from './webgl2_graphics.js';
import {WebGPUGraphics} from './webgpu_graphics.js';

/** What the page decides of each recipe. */
const host_roles = ['depth encoding', 'stage', 'dialect'];

const devices = {webgl2: WebGL2Graphics, webgpu: WebGPUGraphics};

/** What the images of a view hold, in the words of manifests. */
const inputs = {depth: 'linear_depth', normal: 'view_normals'};

class Playground {
    #frame = 0; // that is requested; 0: none
    #runs = 0;
    #clock = 0;
    #stages = {}; // of each device that was chosen: stage, recipes, menus

    constructor(crease, views) {
        Object.assign(this, {crease, views});
        this.texts = new Texts(crease);
        by_id('version').textContent = crease.version;
        by_id('preset').append(...crease.presets.map(({name, summary}) => element('option', {value: `preset:${name}`, title: summary}, name)));
        by_id('view').append(...views.map(({name, title}) => element('option', {value: name}, title)));
        this.#listen();
    }

    /** Draws by the device of the state; where that cannot be, by WebGL 2, and says why. */
    async #choose_device() {
        const note = by_id('device-note');
        if (this.state.device === 'webgpu' && !this.#is_used('webgpu'))
            try {
                note.textContent = 'WebGPU is made ready…';
                await this.#use('webgpu');
                note.textContent = '';
            } catch (error) {
                note.textContent = error.message;
                this.state.device = 'webgl2';
            }
        if (this.state.device !== 'webgpu') {
            this.state.device = 'webgl2';
            await this.#use('webgl2');
        }
    }

    #is_used(device) {
        return this.stage !== undefined && this.stage === this.#stages[device]?.stage;
    }

    /** Shows the stage that a device draws, and the menus of what it can run. */
    async #use(device) {
        if (this.#is_used(device))
            return;
        this.#stages[device] ??= await this.#open(device);
        Object.assign(this, this.#stages[device]);
        by_id('picture').replaceWith(this.stage.canvas);
        by_id('lost').replaceChildren();
        by_id('menus').replaceChildren();
        for (const option of by_id('preset').querySelectorAll('option[title]'))
            option.disabled = this.#reason(option.value) !== '';
    }

    /** A canvas belongs to one device for good. */
    async #open(device) {
        const canvas = by_id('picture').cloneNode();
        const graphics = await devices[device].open(canvas);
        const recipes = new Recipes(this.crease, graphics.host);
        const menus = new Menus(recipes, by_id('menus'), (words, {keep_menus} = {}) => this.#change(words, keep_menus));
        const stage = new Stage(graphics, canvas, this.crease);
        this.#listen_to_moves(canvas);
        graphics.lost.then(() => this.#lose(stage));
        return {stage, recipes, menus};
    }

    /** Forgets the stage of a device that is gone, and offers to make it anew: by itself a page could lose it without end. */
    #lose(stage) {
        const {name} = stage.graphics;
        delete this.#stages[name];
        stage.effect = null;
        if (stage !== this.stage)
            return;
        ++this.#runs;
        clearTimeout(this.#clock);
        delete document.body.dataset.drawn;
        const again = element('button', {type: 'button'}, 'Draw again');
        again.addEventListener('click', () => this.restore().catch(({message}) => (by_id('refusal').textContent = message)));
        const {textContent} = by_id('device').querySelector(`[value=${name}]`);
        by_id('lost').replaceChildren(`The browser lost ${textContent}, and with it the picture: its driver may have restarted, or a frame taken too long. `, again);
    }

    /** Does what needs the device; what fails since that was lost is no error, and may come before the loss is told. */
    async #with_device(work) {
        const {lost} = this.stage.graphics;
        try {
            await work();
        } catch (error) {
            const late = new Promise((resolve) => setTimeout(resolve, 500, false));
            if (!await Promise.race([lost.then(() => true), late]))
                throw error;
        }
    }

    /** Offers WebGPU where there is a device for it, and says why where there is none. */
    async offer_webgpu() {
        const reason = await WebGPUGraphics.missing();
        by_id('device').querySelector('[value=webgpu]').disabled = reason !== '';
        if (reason)
            by_id('device-note').textContent = reason;
    }

    /** The words of a recipe without those that the page decides. Throws a RecipeError. */
    #words(recipe) {
        return this.crease.compose(recipe).recipe.split('/').filter((word) => !host_roles.includes(this.recipes.role_of(word)));
    }

    /** Why the page does not show a recipe; "" where it does. */
    #reason(recipe) {
        try {
            const refused = this.recipes.refusal(this.#words(recipe));
            if (refused)
                return refused;
        } catch (error) {
            if (error instanceof RecipeError)
                return error.message;
            throw error;
        }
        const {resources, parts} = this.crease.compose(this.recipes.hosted(this.#words(recipe)));
        const missing = resources.find(({name, kind, lifetime, content}) =>
            kind === 'image' && lifetime === 'input' && inputs[name] !== content);
        if (missing)
            return `this page has no input '${missing.name}' that holds ${missing.content || 'what it needs'}`;
        return parts.some(({name}) => name === 'orthographic') ? 'the cameras of this page are perspective' : '';
    }

    /** Shows what the address holds. */
    async restore() {
        this.state = read_state(location.hash);
        const view = this.views.find(({name}) => name === this.state.view) ?? this.views[0];
        this.state.view = view.name;
        await this.#choose_device();
        for (const id of ['view', 'truth', 'split', 'beside', 'device'])
            by_id(id).value = this.state[id];
        by_id('orbit').checked = this.state.orbit !== null;
        if (this.stage.view !== view)
            await this.stage.set_view(view);
        await this.stage.set_orbit(this.state.orbit);
        this.effect_recipe = null;
        await this.#compose();
    }

    #change(words, keep_menus) {
        this.state.recipe = words.join('/');
        this.#compose(keep_menus);
    }

    /** Shows the recipe of the state, or why it cannot be shown. */
    async #compose(keep_menus = false) {
        const {state} = this;
        by_id('recipe').value = state.recipe;
        const preset = by_id('preset');
        preset.value = [...preset.options].some(({value}) => value === state.recipe) ? state.recipe : '';
        const reason = this.#reason(state.recipe);
        by_id('refusal').textContent = reason;
        by_id('recipe').setAttribute('aria-invalid', `${reason !== ''}`);
        this.#remember();
        if (reason)
            return;
        const words = this.#words(state.recipe);
        const begin = performance.now();
        const effect = this.crease.compose(this.recipes.hosted(words));
        const composing = performance.now() - begin;
        try {
            if (!await this.stage.set_effect(effect))
                return;
        } catch (error) {
            by_id('refusal').textContent = error.message;
            return;
        }
        by_id('composing').textContent = composing.toFixed(1);
        const known = new Set(settings_of(effect).map(({name}) => name));
        state.settings = Object.fromEntries(Object.entries(state.settings).filter(([name]) => known.has(name)));
        if (!keep_menus) {
            this.menus.show(words, effect.parts);
            this.#show_settings(effect);
        }
        await Promise.all([this.#with_device(() => this.#run()), this.texts.show(state.recipe)]);
    }

    #show_settings(effect) {
        const {camera} = this.stage.view;
        show_settings(by_id('settings'), effect, {
            radius: this.radius,
            recommended_radius: camera.ao_radius,
            values: this.state.settings,
            on_radius: (value) => this.#set(() => (this.state.radius = value)),
            on_setting: (name, value) => this.#set(() => (this.state.settings[name] = value)),
        });
    }

    get radius() {
        return this.state.radius ?? this.stage.view.camera.ao_radius;
    }

    #set(change) {
        change();
        this.#remember();
        this.#next_frame();
    }

    /** At most one frame of the screen runs the effect once. */
    #next_frame() {
        this.#frame ||= requestAnimationFrame(() => {
            this.#frame = 0;
            this.#with_device(() => this.#run());
        });
    }

    /** Draws, and then measures what is still shown. */
    async #run() {
        const {stage, state} = this;
        if (!stage.effect)
            return;
        const run = ++this.#runs;
        stage.run({radius: this.radius, settings: state.settings});
        this.#draw();
        Object.assign(document.body.dataset, {drawn: state.recipe, device: stage.graphics.name});
        if (stage.orbit) {
            for (const id of ['rmse-hard', 'rmse-linear', 'ssim-hard', 'ssim-linear'])
                by_id(id).textContent = '–'; // the camera has no truth
        } else {
            const visibility = await stage.visibility();
            await Promise.all(['hard', 'linear'].map((kind) => stage.truth(kind)));
            if (run !== this.#runs)
                return;
            for (const kind of ['hard', 'linear'])
                this.#measure_errors(kind, visibility, stage.truths[kind]);
            this.#draw();
        }
        clearTimeout(this.#clock);
        this.#clock = setTimeout(() => this.#with_device(() => this.#measure_time()), 300);
    }

    #draw() {
        if (!this.stage.effect)
            return;
        this.stage.draw(this.state);
        const compared = !this.stage.orbit && this.state.beside !== 'nothing';
        by_id('beside-name').textContent = compared ? by_id('beside').selectedOptions[0]?.textContent ?? '' : '';
    }

    #measure_errors(kind, visibility, truth) {
        const {counts, width, height} = this.stage;
        by_id(`rmse-${kind}`).textContent = rmse(visibility, truth, counts).toFixed(4);
        by_id(`ssim-${kind}`).textContent = ssim(visibility, truth, counts, width, height).toFixed(4);
    }

    async #measure_time() {
        const {stage} = this;
        const {milliseconds, how} = await stage.measure();
        const shown = by_id('milliseconds');
        shown.textContent = milliseconds.toFixed(2);
        shown.title = how;
        shown.dataset.device = stage.graphics.name;
    }

    #remember() {
        history.replaceState(null, '', fragment_of(this.state));
    }

    #listen() {
        const redraw = () => {
            this.#remember();
            this.#draw();
        };
        by_id('split').addEventListener('input', ({target}) => {
            this.state.split = Number(target.value);
            redraw();
        });
        for (const id of ['beside', 'truth'])
            by_id(id).addEventListener('change', ({target}) => {
                this.state[id] = target.value;
                redraw();
            });
        by_id('preset').addEventListener('change', ({target}) => this.#change([target.value]));
        by_id('recipe-form').addEventListener('submit', (event) => {
            event.preventDefault();
            this.#change([by_id('recipe').value.trim()]);
        });
        by_id('view').addEventListener('change', async ({target}) => {
            Object.assign(this.state, {view: target.value, radius: null});
            this.#remember();
            await this.restore();
        });
        by_id('device').addEventListener('change', async ({target}) => {
            this.state.device = target.value;
            this.#remember();
            await this.restore();
        });
        by_id('orbit').addEventListener('change', async ({target}) => {
            this.state.orbit = target.checked ? [0, 0, 1] : null;
            this.#remember();
            await this.#with_device(() => this.stage.set_orbit(this.state.orbit));
            this.#next_frame();
        });
        by_id('link').addEventListener('click', async () => {
            const done = await navigator.clipboard.writeText(location.href).then(() => 'Copied', () => 'The address holds it');
            by_id('link-copied').textContent = done;
            setTimeout(() => (by_id('link-copied').textContent = ''), 3000);
        });
        addEventListener('hashchange', () => this.restore());
    }

    /** Dragging and keys turn the camera, the wheel moves it. */
    #listen_to_moves(canvas) {
        const turn = (across, up, distance) => {
            const {orbit} = this.stage;
            if (!orbit)
                return;
            const rounded = (number) => Math.round(number * 1000) / 1000;
            this.#set(() => {
                this.state.orbit = [orbit[0] + across, orbit[1] + up, Math.min(Math.max(orbit[2] * distance, 0.2), 4)].map(rounded);
                this.stage.orbit = this.state.orbit;
            });
        };
        canvas.addEventListener('pointerdown', ({pointerId}) => canvas.setPointerCapture(pointerId));
        canvas.addEventListener('pointermove', ({buttons, movementX, movementY}) => {
            if (buttons & 1)
                turn(-movementX * 0.005, movementY * 0.005, 1);
        });
        canvas.addEventListener('wheel', (event) => {
            if (!this.stage.orbit)
                return;
            event.preventDefault();
            turn(0, 0, Math.exp(event.deltaY * 0.001));
        }, {passive: false});
        const keys = {ArrowLeft: [-0.1, 0, 1], ArrowRight: [0.1, 0, 1], ArrowUp: [0, 0.1, 1], ArrowDown: [0, -0.1, 1], '+': [0, 0, 0.9], '-': [0, 0, 1.1]};
        canvas.addEventListener('keydown', (event) => {
            if (!this.stage.orbit || !(event.key in keys))
                return;
            event.preventDefault();
            turn(...keys[event.key]);
        });
    }
}

try {
    const [crease, views] = await Promise.all([load(), list_of_views()]);
    globalThis.playground = new Playground(crease, views); // for the console and the tests
    await globalThis.playground.restore();
    await globalThis.playground.offer_webgpu();
} catch (error) {
    by_id('refusal').textContent = error.message;
    throw error;
}
