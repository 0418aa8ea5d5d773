"""Makes the material @NAME@ of Blender 3.4 or later from nodes and the maps beside this file.

In the Text editor: open this file, run it; the material goes to the active mesh object.
From a shell:

    blender --python @NAME@.py
    blender --background --python-exit-code 1 --python @NAME@.py -- --render preview.png
"""
import argparse
import math
import os
import sys

import bpy
from mathutils import Matrix, Vector

NAME = "@NAME@"
# The node group @NAME@. Inputs: name, type, default and range.
GROUP_INPUTS = [
@GROUP_INPUTS@]
# Nodes: type, operation or other setting, label, and inputs, which are numbers, vectors and links
# [NODE, OUTPUT]. Node 0 is the input of the group.
GROUP_NODES = [
@GROUP_NODES@]
# Outputs: name, type and link.
GROUP_OUTPUTS = [
@GROUP_OUTPUTS@]
# Inputs of the Principled BSDF: their names in Blender 3.4 and 4.x, and a number, a color, an image
# with its color space, or an output of the group.
INPUTS = [
@INPUTS@]
NORMALS = [
@NORMALS@]  # tangent space, green up
# Heights in units of the object; with them the normal map is not connected. None: no heights.
DISPLACEMENT = @DISPLACEMENT@
# Fraction of the light that crevices get, which the base color is multiplied by. None: all.
OCCLUSION = @OCCLUSION@
# Albedo of fuzz by 1 - cosine of the angle of view, for Blender before 4.0.
FUZZ = [@FUZZ@]
ALONG_U = @ALONG_U@  # highlights are stretched along u
OPACITY = @OPACITY@
CAMERA = @CAMERA@  # rows of a 4 x 4 matrix, z up
FIELD_OF_VIEW = @FIELD_OF_VIEW@  # radians


def folder():
    """The folder of this file, whether it is run from a shell or from the Text editor."""
    paths = [os.path.abspath(__file__)] if "__file__" in globals() else []
    paths += [bpy.path.abspath(text.filepath) for text in bpy.data.texts if text.filepath]
    folders = [os.path.dirname(path) for path in paths if os.path.basename(path) == NAME + ".py"]
    return next((each for each in folders if os.path.isdir(each)), os.getcwd())


def input_of(node, names):
    """The first input with one of the names; None: this version of Blender has none of them."""
    return next((node.inputs[name] for name in names if name in node.inputs.keys()), None)


def load_image(node, file, color_space):
    node.image = bpy.data.images.load(os.path.join(folder(), file), check_existing=True)
    node.image.colorspace_settings.name = color_space


def image_node(tree, file, color_space):
    node = tree.nodes.new("ShaderNodeTexImage")
    load_image(node, file, color_space)
    return node.outputs["Color"]


def add_socket(tree, direction, name, kind):
    """Of a node group; Blender 4.0 changed how."""
    if hasattr(tree, "interface"):
        return tree.interface.new_socket(name, in_out=direction, socket_type=kind)
    return (tree.inputs if direction == "INPUT" else tree.outputs).new(kind, name)


def set_up(node, setting):
    if node.type == "TEX_IMAGE":
        load_image(node, setting["image"], setting["space"])
        node.image.alpha_mode = "CHANNEL_PACKED"
        node.interpolation, node.extension = setting["interpolation"], setting["extension"]
    elif node.type == "MAP_RANGE":
        node.interpolation_type = setting
    elif setting:
        node.operation = setting


def connect(tree, made, target, value):
    if isinstance(value, list):
        tree.links.new(made[value[0]].outputs[value[1]], target)
    else:
        target.default_value = value


def make_group():
    old = bpy.data.node_groups.get(NAME)
    if old:
        bpy.data.node_groups.remove(old)
    tree = bpy.data.node_groups.new(NAME, "ShaderNodeTree")
    for name, kind, default, limits in GROUP_INPUTS:
        socket = add_socket(tree, "INPUT", name, kind)
        socket.default_value = default
        if limits:
            socket.min_value, socket.max_value = limits
    made, depths, rows = [tree.nodes.new("NodeGroupInput")], [0], {}
    for kind, setting, label, inputs in GROUP_NODES:
        node = tree.nodes.new(kind)
        node.label = label
        set_up(node, setting)
        for target, value in zip(node.inputs, inputs):
            connect(tree, made, target, value)
        depth = 1 + max((depths[each[0]] for each in inputs if isinstance(each, list)), default=0)
        rows[depth] = rows.get(depth, 0) + 1
        node.location = (200 * depth, -200 * rows[depth])
        made.append(node)
        depths.append(depth)
    for name, kind, _ in GROUP_OUTPUTS:
        add_socket(tree, "OUTPUT", name, kind)
    end = tree.nodes.new("NodeGroupOutput")
    end.location = (200 * (max(depths) + 1), 0)
    for (_, _, value), target in zip(GROUP_OUTPUTS, end.inputs):
        connect(tree, made, target, value)
    return tree


def add_group(tree):
    node = tree.nodes.new("ShaderNodeGroup")
    node.name, node.node_tree = NAME, make_group()
    node.location, node.width = (-350, 300), 240


def set_input(tree, target, value):
    if isinstance(value, dict) and "output" in value:
        tree.links.new(tree.nodes[NAME].outputs[value["output"]], target)
    elif isinstance(value, dict):
        tree.links.new(image_node(tree, value["image"], value["space"]), target)
    elif target.type == "RGBA":
        target.default_value = (*value, 1) if isinstance(value, tuple) else (value, value, value, 1)
    elif target.type == "VECTOR":
        target.default_value = value
    else:
        target.default_value = max(value) if isinstance(value, tuple) else value


def add_normals(tree, surface):
    for names, file in NORMALS:
        node = tree.nodes.new("ShaderNodeNormalMap")
        tree.links.new(image_node(tree, file, "Non-Color"), node.inputs["Color"])
        if names != ("Normal",) or not DISPLACEMENT:
            tree.links.new(node.outputs["Normal"], input_of(surface, names))


def add_fuzz(tree, surface):
    """As a diffuse color by the angle of view: Blender before 4.0 does not have this lobe."""
    given = {names[0]: value for names, value in INPUTS}
    facing = tree.nodes.new("ShaderNodeLayerWeight")
    facing.inputs["Blend"].default_value = 0.5
    if surface.inputs["Normal"].is_linked:
        tree.links.new(surface.inputs["Normal"].links[0].from_socket, facing.inputs["Normal"])
    albedo = tree.nodes.new("ShaderNodeValToRGB")
    for position, value in FUZZ[1:-1]:
        albedo.color_ramp.elements.new(position)
    for element, (position, value) in zip(albedo.color_ramp.elements, FUZZ):
        element.color = (value, value, value, 1)
    tree.links.new(facing.outputs["Facing"], albedo.inputs["Fac"])
    weight = tree.nodes.new("ShaderNodeMath")
    weight.operation = "MULTIPLY"
    tree.links.new(albedo.outputs["Color"], weight.inputs[0])
    set_input(tree, weight.inputs[1], given["Sheen Weight"])
    mix = tree.nodes.new("ShaderNodeMixRGB")
    tree.links.new(weight.outputs["Value"], mix.inputs["Fac"])
    copy_input(tree, surface.inputs["Base Color"], mix.inputs["Color1"])
    set_input(tree, mix.inputs["Color2"], given["Sheen Tint"])
    tree.links.new(mix.outputs["Color"], surface.inputs["Base Color"])


def copy_input(tree, source, target):
    if source.is_linked:
        tree.links.new(source.links[0].from_socket, target)
    elif target.type == "VECTOR":
        target.default_value = source.default_value[:3]
    else:
        target.default_value = source.default_value


def add_occlusion(tree, surface):
    color = surface.inputs["Base Color"]
    node = tree.nodes.new("ShaderNodeVectorMath")
    node.operation = "MULTIPLY"
    node.label = "Occlusion"
    copy_input(tree, color, node.inputs[0])
    tree.links.new(image_node(tree, OCCLUSION, "Non-Color"), node.inputs[1])
    tree.links.new(node.outputs["Vector"], color)


def restore_coat(tree, surface):
    """Blender before 4.0 draws a quarter of the coat."""
    coat = surface.inputs.get("Clearcoat")
    if coat is None or not (coat.is_linked or coat.default_value):
        return
    node = tree.nodes.new("ShaderNodeMath")
    node.operation = "MULTIPLY"
    node.inputs[1].default_value = 4
    copy_input(tree, coat, node.inputs[0])
    tree.links.new(node.outputs["Value"], coat)


def add_displacement(tree, material, output):
    node = tree.nodes.new("ShaderNodeDisplacement")
    node.inputs["Midlevel"].default_value = 0
    node.inputs["Scale"].default_value = 1
    tree.links.new(image_node(tree, DISPLACEMENT, "Non-Color"), node.inputs["Height"])
    tree.links.new(node.outputs["Displacement"], output.inputs["Displacement"])
    holder = material if hasattr(material, "displacement_method") else material.cycles
    holder.displacement_method = "BOTH"


def arrange(tree):
    """Images in a column, left of their users."""
    row = 0
    for node in tree.nodes:
        if node.type == "TEX_IMAGE":
            node.location = (-700, 300 - 280 * row)
            row += 1
        elif node.type in ("NORMAL_MAP", "DISPLACEMENT", "TANGENT", "MATH", "VECT_MATH", "MIX_RGB",
                            "VALTORGB", "LAYER_WEIGHT"):
            node.location = (-350, -280 * row)


def make_material():
    material = bpy.data.materials.get(NAME) or bpy.data.materials.new(NAME)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (400, 0)
    surface = tree.nodes.new("ShaderNodeBsdfPrincipled")
    tree.links.new(surface.outputs["BSDF"], output.inputs["Surface"])
    if GROUP_OUTPUTS:
        add_group(tree)
    for names, value in INPUTS:
        target = input_of(surface, names)
        if target is not None:
            set_input(tree, target, value)
    add_normals(tree, surface)
    if FUZZ and "Sheen Weight" not in surface.inputs.keys():
        add_fuzz(tree, surface)
    if OCCLUSION:
        add_occlusion(tree, surface)
    restore_coat(tree, surface)
    if ALONG_U:
        tangent = tree.nodes.new("ShaderNodeTangent")
        tangent.direction_type = "UV_MAP"
        tree.links.new(tangent.outputs["Tangent"], surface.inputs["Tangent"])
    if DISPLACEMENT:
        add_displacement(tree, material, output)
    if OPACITY and hasattr(material, "blend_method"):
        material.blend_method = "HASHED"
        if hasattr(material, "shadow_method"):
            material.shadow_method = "HASHED"
    arrange(tree)
    return material


def add_mesh(material):
    before = set(bpy.data.objects)
    bpy.ops.wm.obj_import(filepath=os.path.join(folder(), "mesh.obj"))
    for shape in set(bpy.data.objects) - before:
        shape.data.materials.clear()
        shape.data.materials.append(material)


def add_light(scene):
    sun = bpy.data.objects.new("Light", bpy.data.lights.new("Light", "SUN"))
    sun.data.energy, sun.data.angle = 3, 0.2
    sun.rotation_euler = Vector((-0.5, -0.6, 0.7)).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.5, 0.5, 0.5, 1)


def add_camera(scene):
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.matrix_world = Matrix(CAMERA)
    camera.data.angle = FIELD_OF_VIEW
    camera.data.clip_end = 1e6
    scene.collection.objects.link(camera)
    scene.camera = camera


def render(path, samples, size):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = os.path.abspath(path)
    bpy.ops.render.render(write_still=True)


def main():
    parser = argparse.ArgumentParser(prog=NAME + ".py")
    parser.add_argument("--render", metavar="OUT.png", help="renders the material on its mesh")
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--resolution", type=int, default=512)
    parser.add_argument("--save", metavar="OUT.blend", help="saves a file with the material")
    given = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    options = parser.parse_args(given)
    material = make_material()
    shape = bpy.context.active_object
    if options.render or options.save:
        for each in list(bpy.data.objects):
            bpy.data.objects.remove(each)
        add_mesh(material)
        add_light(bpy.context.scene)
        add_camera(bpy.context.scene)
    elif shape is not None and shape.type == "MESH":
        shape.active_material = material
    if options.save:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(options.save))
    if options.render:
        render(options.render, options.samples, options.resolution)


main()
