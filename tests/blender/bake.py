"""Blender's side: bakes tangent-space normals of a sphere and says how long that took.

usage: blender --background --factory-startup --python-exit-code 1 --python bake.py --
           FOLDER NORMAL_MAP HEIGHT_MAP SIZE TIMES CASE...

Writes FOLDER/mesh.obj, with the normals that Blender has; FOLDER/CASE.pfm, as stored: (n + 1) / 2;
FOLDER/times.json, seconds of each of TIMES calls of the operator by case, everything loaded before.
A case, `normal_map`, `bump` or `both`, is a chain of nodes from images to a diffuse surface: that
is the least work for Blender, and its normal is read as it comes. One sample, at a texel's centre;
nothing beside islands.
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
    normal = None
    if case != "bump":
        mapped = tree.nodes.new("ShaderNodeNormalMap")
        link(image(NORMAL_MAP).outputs["Color"], mapped.inputs["Color"])
        normal = mapped.outputs["Normal"]
    if case != "normal_map":
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
    link(normal, surface.inputs["Normal"])
    goal = tree.nodes.new("ShaderNodeTexImage")
    goal.image = target
    tree.nodes.active = goal


def bake():
    start = time.perf_counter()
    bpy.ops.object.bake(type="NORMAL", margin=0, use_clear=True)
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
        times[case] = [bake() for _ in range(int(TIMES))]
        write_pfm(target, os.path.join(FOLDER, case + ".pfm"))
    with open(os.path.join(FOLDER, "times.json"), "w") as out:
        json.dump({"blender": bpy.app.version_string, "seconds": times}, out)


main()
