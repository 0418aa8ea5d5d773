"""Blender's side: bakes tangent-space normals of a sphere and says how long that took.

usage: blender --background --factory-startup --python-exit-code 1 --python bake.py --
           FOLDER NORMAL_MAP HEIGHT_MAP SIZE TIMES CASE...

Writes FOLDER/mesh.obj, with the normals that Blender has; FOLDER/CASE.pfm, as stored: (n + 1) / 2;
FOLDER/times.json, seconds of each of TIMES calls of the operator by case, everything loaded before.
A case, `normal_map`, `bump` or `both`, is a chain of nodes from images to a diffuse surface: that
is the least work for Blender, and its normal is read as it comes. `rust` and `rust_color` are the
noises and mixes of graphs/rusty_steel.json, without scratches, which Blender lacks. One sample, at
a texel's centre; nothing beside islands.
"""
import array
import json
import os
import sys
import time

import bpy

FOLDER, NORMAL_MAP, HEIGHT_MAP, SIZE, TIMES, *CASES = sys.argv[sys.argv.index("--") + 1:]
SIZE = int(SIZE)
TILES, DISTANCE = 4, 0.08  # of the height map; its white is this high in length units


def prepare():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 1
    # Debian's Blender cannot denoise, and then bakes nothing.
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False


def make_sphere():
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, calc_uvs=True)
    bpy.ops.object.shade_smooth()
    sphere = bpy.context.object
    sphere.modifiers.new("triangles", "TRIANGULATE")
    bpy.ops.object.modifier_apply(modifier="triangles")
    sphere.data.materials.append(bpy.data.materials.new("material"))
    return sphere


def write_obj(mesh, path):
    with open(path, "w") as out:
        for vertex in mesh.vertices:
            out.write("v %.9g %.9g %.9g\n" % tuple(vertex.co))
        for vertex in mesh.vertices:
            out.write("vn %.9g %.9g %.9g\n" % tuple(vertex.normal))
        for corner in mesh.uv_layers.active.data:
            out.write("vt %.9g %.9g\n" % tuple(corner.uv))
        for face in mesh.polygons:
            corners = zip(face.vertices, face.loop_indices)
            out.write("f " + " ".join(f"{v + 1}/{c + 1}/{v + 1}" for v, c in corners) + "\n")


class Rust:
    """rusty_steel.json without its scratches: the height and the color."""

    def __init__(self, tree):
        self.tree = tree
        self.place = tree.nodes.new("ShaderNodeTexCoord").outputs["Object"]
        bends, blisters, grain, pores, patches = (
            self.noise(scale, octaves)
            for scale, octaves in ((2, 8), (9, 4), (60, 2), (25, 3), (1.5, 3)))
        flakes = self.texture("Voronoi", "Distance", {"Scale": 14})
        product = lambda a, factor: self.math("MULTIPLY", a, factor)
        crust = self.math("ADD", product(blisters, 0.015), product(grain, 0.002))
        crusty = self.math("ADD", crust, product(flakes, 0.01))
        mottled = self.mix(flakes, crusty, product(pores, 0.004))
        rusty = self.ramp(self.math("ADD", patches, blisters), -0.2, 0.25)
        rusted = self.mix(rusty, product(product(bends, 0.03), 0.5), mottled)
        dust = product(self.ramp(flakes, 0.3, 0.9), 0.6)
        self.height = self.mix(dust, rusted, 0.004)
        steel = self.mix_color(bends, (0.45, 0.46, 0.48, 1), (0.6, 0.6, 0.62, 1))
        self.color = self.mix_color(
            rusty, steel, self.mix_color(grain, (0.28, 0.09, 0.03, 1), (0.45, 0.2, 0.07, 1)))

    def add(self, kind, values, output=0):
        node = self.tree.nodes.new("ShaderNode" + kind)
        for name, value in values.items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, node.inputs[name])
            else:
                node.inputs[name].default_value = value
        return node, node.outputs[output]

    def texture(self, kind, output, values):
        return self.add("Tex" + kind, {"Vector": self.place, **values}, output)[1]

    def noise(self, scale, octaves):
        value = self.texture("Noise", "Fac", {"Scale": scale, "Detail": octaves - 1})
        return self.math("SUBTRACT", value, 0.5)

    def math(self, operation, *values):
        node, output = self.add("Math", dict(enumerate(values)))
        node.operation = operation
        return output

    def mix(self, factor, a, b):
        part = self.math("MULTIPLY", factor, self.math("SUBTRACT", b, a))
        return self.math("ADD", a, part)

    def mix_color(self, factor, a, b):
        return self.add("MixRGB", {"Fac": factor, "Color1": a, "Color2": b})[1]

    def ramp(self, value, low, high):
        node, output = self.add("MapRange", {"Value": value, "From Min": low, "From Max": high})
        node.interpolation_type = "SMOOTHSTEP"
        return output


def make_rust(tree, case):
    rust = Rust(tree)
    if case == "rust_color":
        emission = rust.add("Emission", {"Color": rust.color})[1]
        tree.links.new(emission, tree.nodes["Material Output"].inputs["Surface"])
        return None
    bump = {"Height": rust.height, "Distance": 1}
    return rust.add("Bump", bump, "Normal")[1]


def make_nodes(tree, case, target):
    """Images to normals; `both` lays the bump over the map's normal, as in Blender."""
    tree.nodes.clear()
    link = tree.links.new

    def image(path):
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(path, check_existing=True)
        node.image.colorspace_settings.name = "Non-Color"
        return node

    surface = tree.nodes.new("ShaderNodeBsdfDiffuse")
    link(surface.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    normal = make_rust(tree, case) if case.startswith("rust") else None
    if case in ("normal_map", "both"):
        mapped = tree.nodes.new("ShaderNodeNormalMap")
        link(image(NORMAL_MAP).outputs["Color"], mapped.inputs["Color"])
        normal = mapped.outputs["Normal"]
    if case in ("bump", "both"):
        place, tile = (tree.nodes.new("ShaderNode" + name) for name in ("TexCoord", "Mapping"))
        tile.inputs["Scale"].default_value = (TILES, TILES, 1)
        height, bump = image(HEIGHT_MAP), tree.nodes.new("ShaderNodeBump")
        bump.inputs["Distance"].default_value = DISTANCE
        link(place.outputs["UV"], tile.inputs["Vector"])
        link(tile.outputs["Vector"], height.inputs["Vector"])
        link(height.outputs["Color"], bump.inputs["Height"])
        if normal:
            link(normal, bump.inputs["Normal"])
        normal = bump.outputs["Normal"]
    if normal:
        link(normal, surface.inputs["Normal"])
    goal = tree.nodes.new("ShaderNodeTexImage")
    goal.image = target
    tree.nodes.active = goal


def bake(kind):
    start = time.perf_counter()
    bpy.ops.object.bake(type=kind, margin=0, use_clear=True)
    return time.perf_counter() - start


def write_pfm(image, path):
    pixels = array.array("f", bytes(SIZE * SIZE * 16))
    image.pixels.foreach_get(pixels)
    colors = array.array("f", bytes(SIZE * SIZE * 12))
    for channel in range(3):
        colors[channel::3] = pixels[channel::4]
    with open(path, "wb") as out:
        out.write(b"PF\n%d %d\n-1.0\n" % (SIZE, SIZE))
        colors.tofile(out)


def main():
    prepare()
    sphere = make_sphere()
    write_obj(sphere.data, os.path.join(FOLDER, "mesh.obj"))
    material = sphere.data.materials[0]
    material.use_nodes = True
    target = bpy.data.images.new("target", SIZE, SIZE, float_buffer=True, is_data=True)
    times = {}
    for case in CASES:
        make_nodes(material.node_tree, case, target)
        kind = "EMIT" if case == "rust_color" else "NORMAL"
        times[case] = [bake(kind) for _ in range(int(TIMES))]
        write_pfm(target, os.path.join(FOLDER, case + ".pfm"))
    with open(os.path.join(FOLDER, "times.json"), "w") as out:
        json.dump({"blender": bpy.app.version_string, "seconds": times}, out)


main()
