// SPDX-License-Identifier: MIT
// A picture of three.js's composer with CreasePass, as the test three.test.mjs asks for it.
import * as THREE from 'three';
import {EffectComposer} from 'three/addons/postprocessing/EffectComposer.js';
import {RenderPass} from 'three/addons/postprocessing/RenderPass.js';
import {load} from 'crease';
import {CreasePass} from 'crease/three';

const crease = await load();

function mesh_of({positions, indices}) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
    geometry.setIndex(indices);
    const flat = geometry.toNonIndexed();
    flat.computeVertexNormals();
    return new THREE.Mesh(flat, new THREE.MeshBasicMaterial({color: 0x808080, side: THREE.DoubleSide}));
}

function camera_of({eye, target, vfov_deg, near, far, width, height}, orthographic) {
    const up = Math.tan(vfov_deg * Math.PI / 360) * Math.hypot(...eye.map((x, i) => x - target[i]));
    const across = up * width / height;
    const camera = orthographic ? new THREE.OrthographicCamera(-across, across, up, -up, near, far)
                                : new THREE.PerspectiveCamera(vfov_deg, width / height, near, far);
    camera.position.set(...eye);
    camera.lookAt(...target);
    return camera;
}

/** The first channel of a texture, 8 bits, row 0 at the top. */
function read(gl, texture, width, height) {
    const target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const texels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(target);
    return Array.from({length: width * height}, (_, i) => {
        const row = height - 1 - Math.floor(i / width);
        return texels[4 * (row * width + i % width)];
    });
}

/** Has the renderer lose its context, and get it back. */
async function lose_and_restore(renderer, composer) {
    const told = (name) => new Promise((resolve) => renderer.domElement.addEventListener(name, resolve, {once: true}));
    const lost = told('webglcontextlost');
    renderer.forceContextLoss();
    await lost;
    await new Promise((resolve) => setTimeout(resolve)); // only when all have heard of it may it be restored
    composer.render();
    const restored = told('webglcontextrestored');
    renderer.forceContextRestore();
    await restored;
}

/** Draws the scene, and gives the size and texels of visibility, and of the picture on the canvas. */
window.draw = async ({scene, camera: from, recipe, radius, renderer: how = {}, samples = 0, orthographic = false, given = false,
                      ratio = 1, blend = 'multiply', resize = null, lose = false, settings = {}}) => {
    const renderer = new THREE.WebGLRenderer({preserveDrawingBuffer: true, ...how});
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    renderer.setPixelRatio(ratio);
    renderer.setSize(from.width, from.height);
    const target = new THREE.WebGLRenderTarget(1, 1, {
        samples, type: THREE.HalfFloatType, depthTexture: new THREE.DepthTexture(1, 1, THREE.FloatType),
    });
    const normals = given ? new THREE.WebGLRenderTarget(from.width * ratio, from.height * ratio, {type: THREE.HalfFloatType}) : null;
    const world = new THREE.Scene();
    world.add(mesh_of(scene));
    const camera = camera_of(from, orthographic);
    const composer = new EffectComposer(renderer, target);
    composer.setSize(from.width, from.height);
    const pass = new CreasePass(camera, {crease, recipe, radius, normals: normals?.texture, blend});
    pass.settings = settings;
    composer.addPass(new RenderPass(world, camera));
    composer.addPass(pass);
    if (normals) {
        world.overrideMaterial = new THREE.MeshNormalMaterial({side: THREE.DoubleSide});
        renderer.setRenderTarget(normals);
        renderer.render(world, camera);
        renderer.setRenderTarget(null);
        world.overrideMaterial = null;
    }
    if (resize) {
        composer.render();
        renderer.setSize(...resize);
        composer.setSize(...resize);
    }
    composer.render();
    if (lose)
        await lose_and_restore(renderer, composer);
    composer.render();
    const gl = renderer.getContext();
    const width = Math.floor(composer.readBuffer.width), height = Math.floor(composer.readBuffer.height);
    const visibility = read(gl, pass.texture.sourceTexture, width, height);
    const canvas = new Uint8Array(4);
    gl.readPixels(width >> 1, height >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
    const middle = visibility[(height - 1 - (height >> 1)) * width + (width >> 1)];
    const error = gl.getError();
    const reversed = renderer.state.buffers.depth.getReversed();
    pass.dispose();
    composer.dispose();
    renderer.dispose();
    renderer.forceContextLoss();
    return {width, height, visibility, shown: canvas[0], middle, error, reversed, grey: world.children[0].material.color.r};
};
window.ready = true;
