// Chains of normal maps as TSL nodes of three.js: what it takes to make the nodes and to write both
// stages as GLSL. The context stands for WebGL 2 and does nothing, as no driver is measured. The
// blend is whiteout, which is what a user writes; nothing is lit.
import * as THREE from "three/webgpu";
import { normalMap, texture, uv, vec3, vec4 } from "three/tsl";
import { layerScale, images, measure } from "./measure.mjs";

const nothing = () => {};
const stub = new Proxy({}, {
    get(_, name) {
        if (name === "getExtension" || name === "getContextAttributes") return () => ({});
        if (name === "getSupportedExtensions") return () => [];
        if (name === "getParameter") return () => 16;
        return typeof name === "string" && /^[A-Z0-9_]+$/.test(name) ? 0 : nothing;
    },
});
const canvas = { style: {}, addEventListener: nothing, removeEventListener: nothing };
globalThis.self ??= globalThis;
const renderer = new THREE.WebGPURenderer({ forceWebGL: true, context: stub, canvas });
await renderer.init();

const textures = Array.from({ length: images }, () => new THREE.Texture());
const geometry = new THREE.SphereGeometry();
geometry.setAttribute("tangent", new THREE.Float32BufferAttribute(
    new Float32Array(geometry.attributes.position.count * 4), 4));
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera();

function material(layers) {
    let sum = null;
    for (let i = 0; i < layers; ++i) {
        const map = texture(textures[i % images], uv().mul(layerScale(i))).xyz.mul(2).sub(1);
        sum = sum ? vec3(sum.xy.add(map.xy), sum.z.mul(map.z)) : map;
    }
    const made = new THREE.NodeMaterial();
    made.fragmentNode = vec4(normalMap(sum.normalize().mul(0.5).add(0.5)), 1);
    return made;
}

await measure("three.js", THREE.REVISION, (layers) => {
    const mesh = new THREE.Mesh(geometry, material(layers));
    const builder = renderer.backend.createNodeBuilder(mesh, renderer);
    builder.scene = scene;
    builder.camera = camera;
    builder.material = mesh.material;
    builder.context.material = mesh.material;
    builder.build();
    return builder.fragmentShader;
});
