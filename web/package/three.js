// SPDX-License-Identifier: MIT
// Ambient occlusion as a pass of three.js's EffectComposer.
import {ExternalTexture, NoBlending, ShaderMaterial} from 'three';
import {FullScreenQuad, Pass} from 'three/addons/postprocessing/Pass.js';
import {WebGL2Effect} from './webgl2.js';

const axes = ['x', 'y', 'z'];

const vertexShader = `
varying vec2 at;
void main() {
    at = uv;
    gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const fragment_shaders = {
    multiply: `
uniform sampler2D colour, visibility;
varying vec2 at;
void main() {
    vec4 seen = texture2D(colour, at);
    gl_FragColor = vec4(seen.rgb * texture2D(visibility, at).r, seen.a);
}`,
    show: `
uniform sampler2D visibility;
varying vec2 at;
void main() { gl_FragColor = vec4(texture2D(visibility, at).rrr, 1.0); }`,
};

/** A recipe with the parts of the roles that it leaves open: what the camera and the textures of the host ask for. */
function completed(crease, recipe, wanted) {
    const named = new Set(crease.compose(recipe).parts.filter((part) => part.named).map(({role}) => role));
    return [recipe, ...Object.entries(wanted).filter(([role, part]) => part && !named.has(role)).map(([, part]) => part)].join('/');
}

/** Tells the renderer that its state was changed; that depth is reversed, and cleared so, it would forget. */
function reset_state(renderer) {
    const {depth} = renderer.state.buffers;
    const is_reversed = depth.getReversed();
    renderer.resetState();
    depth.setReversed(is_reversed);
    depth.setClear(1);
}

export class CreasePass extends Pass {
    #crease;
    #recipe;
    #manifest;
    #members;
    #effect = null;
    #gl = null;
    #quad;
    #texture = new ExternalTexture();

    constructor(camera, {crease, recipe, effect, radius = 1, depth = null, normals = null, blend = 'multiply'}) {
        super();
        if (!crease || !recipe === !effect)
            throw new TypeError('crease: CreasePass takes the loaded library as `crease`, and either a `recipe` or an `effect`');
        if (blend !== 'none' && !fragment_shaders[blend])
            throw new TypeError(`crease: blend is 'multiply', 'show' or 'none', and not '${blend}'`);
        Object.assign(this, {camera, radius, depth, normals, settings: {}, frame: 0});
        this.needsSwap = blend !== 'none';
        this.#crease = crease;
        this.#recipe = recipe;
        this.#manifest = effect;
        this.#quad = this.needsSwap && new FullScreenQuad(new ShaderMaterial({
            name: 'CreasePass',
            uniforms: {colour: {value: null}, visibility: {value: this.#texture}},
            vertexShader,
            fragmentShader: fragment_shaders[blend],
            depthTest: false,
            depthWrite: false,
            blending: NoBlending,
        }));
    }

    /** The visibility of the last frame, in red: 1 open, 0 closed. */
    get texture() {
        return this.#texture;
    }

    render(renderer, writeBuffer, readBuffer) {
        if (renderer.getContext().isContextLost())
            return; // three.js draws nothing either until it is restored
        const depth = this.depth ?? readBuffer.depthTexture;
        if (!depth)
            throw new Error('crease: CreasePass needs depth: give the composer a render target with a depthTexture, or the pass one as `depth`');
        this.#prepare(renderer, Math.floor(readBuffer.width), Math.floor(readBuffer.height));
        this.#describe();
        this.#bind(renderer, 'depth', depth);
        if (this.normals)
            this.#bind(renderer, 'normal', this.normals);
        this.#effect.run();
        reset_state(renderer);
        if (!this.#quad)
            return;
        this.#quad.material.uniforms.colour.value = readBuffer.texture;
        renderer.setRenderTarget(this.renderToScreen ? null : writeBuffer);
        this.#quad.render(renderer);
    }

    /** The pass follows the size of what it reads, so there is nothing to set beforehand. */
    setSize() {}

    dispose() {
        this.#effect?.dispose();
        this.#effect = null;
        this.#texture.sourceTexture = null;
        if (this.#quad) {
            this.#quad.material.dispose();
            this.#quad.dispose();
        }
    }

    #prepare(renderer, width, height) {
        const gl = renderer.getContext();
        if (this.#effect && !this.#effect.lost && this.#gl === gl && this.#effect.width === width && this.#effect.height === height)
            return;
        this.#manifest ??= this.#crease.compose(completed(this.#crease, this.#recipe, {
            projection: this.camera.isOrthographicCamera && 'orthographic',
            'depth encoding': renderer.capabilities.logarithmicDepthBuffer && !this.camera.isOrthographicCamera && 'logarithmic_depth',
            normals: this.normals ? 'packed_normals' : 'reconstructed_normals',
            stage: 'fragment',
            dialect: 'glsl_es:300',
        }));
        this.#members = new Set(this.#manifest.uniform_block.members.map(({name}) => name));
        this.#effect?.dispose();
        reset_state(renderer);
        this.#effect = new WebGL2Effect(gl, this.#manifest, width, height);
        this.#gl = gl;
        this.#texture.sourceTexture = this.#effect.texture('visibility');
    }

    #describe() {
        const {camera} = this;
        const effect = this.#effect;
        const set_where_there = (name, value) => this.#members.has(name) && effect.set(name, value);
        // Reversed depth comes with clip control, by which depth is in [0, 1] from the start.
        const convention = {depthFromMinusOne: !camera.reversedDepth};
        effect.setView(this.#crease.view(camera.projectionMatrix.elements, effect.width, effect.height, convention));
        effect.set('radius', this.radius);
        effect.set('frame', this.frame);
        set_where_there('logarithmic_depth.far', camera.far);
        axes.forEach((view, row) => axes.forEach((world, column) =>
            set_where_there(`world_${view}${world}`, camera.matrixWorldInverse.elements[4 * column + row])));
        for (const [name, value] of Object.entries(this.settings))
            effect.set(name, value);
    }

    #bind(renderer, name, texture) {
        const {__webglTexture: made} = renderer.properties.get(texture);
        if (!made)
            throw new Error(`crease: nothing was drawn to the texture that is given as ${name}`);
        this.#effect.bind(name, made);
    }
}
