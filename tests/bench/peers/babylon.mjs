// Chains of normal maps as blocks of Babylon.js' NodeMaterial, on its engine that draws nothing:
// what it takes to make the blocks and to write both stages as GLSL. Its preprocessor is not
// measured; nothing is lit.
import { NullEngine } from "@babylonjs/core/Engines/nullEngine.js";
import { Scene } from "@babylonjs/core/scene.js";
import { Texture } from "@babylonjs/core/Materials/Textures/texture.js";
import { Vector2 } from "@babylonjs/core/Maths/math.vector.js";
import { NodeMaterial } from "@babylonjs/core/Materials/Node/nodeMaterial.js";
import "@babylonjs/core/Materials/Node/Blocks/index.js";
import * as Blocks from "@babylonjs/core/Materials/Node/Blocks/index.js";
import { NodeMaterialSystemValues } from
    "@babylonjs/core/Materials/Node/Enums/nodeMaterialSystemValues.js";
import { layerScale, images, measure } from "./measure.mjs";

const scene = new Scene(new NullEngine());
const textures = Array.from({ length: images }, () => new Texture(null, scene));

function input(name, value) {
    const block = new Blocks.InputBlock(name);
    if (typeof value === "string") block.setAsAttribute(value);
    else if (typeof value === "number") block.setAsSystemValue(value);
    else block.value = value;
    return block;
}

function build(layers) {
    const material = new NodeMaterial("chain", scene);
    const position = input("position", "position"), normal = input("normal", "normal");
    const tangent = input("tangent", "tangent"), uv = input("uv", "uv");
    const world = input("world", NodeMaterialSystemValues.World);
    const clip = input("worldViewProjection", NodeMaterialSystemValues.WorldViewProjection);
    const vertex = new Blocks.TransformBlock("vertex");
    position.output.connectTo(vertex.vector);
    clip.output.connectTo(vertex.transform);
    const end = new Blocks.VertexOutputBlock("end");
    vertex.output.connectTo(end.vector);
    const inWorld = (name, from) => {
        const block = new Blocks.TransformBlock(name);
        from.output.connectTo(block.vector);
        world.output.connectTo(block.transform);
        return block;
    };
    let sum = null;
    for (let i = 0; i < layers; ++i) {
        const scaled = new Blocks.MultiplyBlock("scaled" + i);
        uv.output.connectTo(scaled.left);
        const [x, y] = [layerScale(i), layerScale(i)];
        input("scale" + i, new Vector2(x, y)).output.connectTo(scaled.right);
        const map = new Blocks.TextureBlock("map" + i);
        map.texture = textures[i % images];
        scaled.output.connectTo(map.uv);
        if (sum) {
            const blend = new Blocks.NormalBlendBlock("blend" + i);
            sum.connectTo(blend.normalMap0);
            map.rgb.connectTo(blend.normalMap1);
            sum = blend.output;
        } else {
            sum = map.rgb;
        }
    }
    const perturb = new Blocks.PerturbNormalBlock("perturb");
    sum.connectTo(perturb.normalMapColor);
    inWorld("worldPosition", position).output.connectTo(perturb.worldPosition);
    inWorld("worldNormal", normal).output.connectTo(perturb.worldNormal);
    inWorld("worldTangent", tangent).output.connectTo(perturb.worldTangent);
    uv.output.connectTo(perturb.uv);
    const color = new Blocks.FragmentOutputBlock("color");
    perturb.output.connectTo(color.rgba);
    material.addOutputNode(end);
    material.addOutputNode(color);
    return new Promise((resolve, reject) => {
        material.onBuildObservable.addOnce(() => resolve(material));
        material.onBuildErrorObservable.addOnce(reject);
        material.build();
    });
}

await measure("Babylon.js", NullEngine.Version, async (layers) => {
    const material = await build(layers);
    const text = material._fragmentCompilationState.compilationString;
    material.dispose();
    return text;
});
