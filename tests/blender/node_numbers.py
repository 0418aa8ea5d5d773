#!/usr/bin/env python3
"""Writes tests/nodes/blender_numbers.h: color ramps, curves and blends as Blender computes them.

usage: blender --background --factory-startup --python-exit-code 1 \
           --python tests/blender/node_numbers.py -- tests/nodes/blender_numbers.h
"""
import os
import sys
import tempfile

import bpy

STOPS = [(0, (0, 0, 0)), (0.25, (0.8, 0.2, 0)), (0.6, (0.1, 0.4, 0.9)), (1, (1, 1, 1))]
POINTS = [(0, 0), (0.25, 0.1), (0.6, 0.8), (1, 1)]
RAMPS = {"LINEAR": "linear", "EASE": "ease", "CONSTANT": "constant"}
# Blender's modes with the formulas of the node `blend`; the others differ by design.
MODES = {"MIX": "normal", "ADD": "add", "SUBTRACT": "subtract", "MULTIPLY": "multiply",
         "SCREEN": "screen", "DIVIDE": "divide", "DIFFERENCE": "difference", "DARKEN": "darken",
         "LIGHTEN": "lighten", "OVERLAY": "overlay", "DODGE": "color_dodge", "BURN": "color_burn",
         "LINEAR_LIGHT": "linear_light"}
PAIRS = [((0.2, 0.5, 0.8), (0.6, 0.3, 0.9)), ((0.7, 0.05, 0.35), (0.15, 0.55, 0.25))]


def row(*parts):
    texts = ['"' + p + '"' if isinstance(p, str) else
             "{" + ", ".join(f"{x:.7g}" for x in p) + "}" if isinstance(p, (list, tuple)) else
             f"{p:.7g}" for p in parts]
    return "    {" + ", ".join(texts) + "},"


def ramps():
    tree = bpy.data.node_groups.new("ramp", "ShaderNodeTree")
    ramp = tree.nodes.new("ShaderNodeValToRGB").color_ramp
    for position, color in STOPS[1:-1]:
        ramp.elements.new(position).color = (*color, 1)
    for element, (_, color) in zip(ramp.elements, STOPS):
        element.color = (*color, 1)
    for theirs, ours in RAMPS.items():
        ramp.interpolation = theirs
        for k in range(-1, 22):
            x = k / 20 + 0.01
            yield row(ours, x, ramp.evaluate(x)[:3])


def curves():
    tree = bpy.data.node_groups.new("curve", "ShaderNodeTree")
    mapping = tree.nodes.new("ShaderNodeFloatCurve").mapping
    curve = mapping.curves[0]
    for point in POINTS[1:-1]:
        curve.points.new(*point)
    for at, point in zip(curve.points, POINTS):
        at.location = point
        at.handle_type = "VECTOR"
    mapping.update()
    for k in range(21):
        yield row("linear", k / 20, mapping.evaluate(curve, k / 20))


def blends(folder):
    scene = bpy.context.scene
    scene.render.resolution_x = scene.render.resolution_y = 4
    scene.use_nodes = True
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    nodes.clear()
    one, other, mix = (nodes.new("CompositorNode" + name) for name in ("RGB", "RGB", "MixRGB"))
    mix.inputs[0].default_value = 1
    links.new(one.outputs[0], mix.inputs[1])
    links.new(other.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], nodes.new("CompositorNodeComposite").inputs[0])
    settings = scene.render.image_settings
    settings.file_format, settings.color_depth = "OPEN_EXR", "32"
    for theirs, ours in MODES.items():
        mix.blend_type = theirs
        for base, top in PAIRS:
            one.outputs[0].default_value = (*base, 1)
            other.outputs[0].default_value = (*top, 1)
            scene.render.filepath = os.path.join(folder, theirs + str(base) + ".exr")
            bpy.ops.render.render(write_still=True)
            image = bpy.data.images.load(scene.render.filepath)
            yield row(ours, base, top, list(image.pixels)[:3])


def main():
    with tempfile.TemporaryDirectory() as folder:
        parts = [("BlenderRamp", "blender_ramps", "The ramp of 4 stops at a position.", ramps()),
                 ("BlenderCurve", "blender_curves", "Vector handles: straight parts.", curves()),
                 ("BlenderBlend", "blender_blends", "Base, foreground, result.", blends(folder))]
        text = [f"// Numbers of Blender {bpy.app.version_string}, written by tests/blender/node_numbers.py.",
                "#pragma once", "", "#include <array>", "", "namespace wrinkle::test {", "",
                "struct BlenderRamp {", "    const char* interpolation;", "    double at;",
                "    std::array<double, 3> color;", "};", "struct BlenderCurve {",
                "    const char* interpolation;", "    double at, value;", "};",
                "struct BlenderBlend {", "    const char* mode;",
                "    std::array<double, 3> base, top, color;", "};", "", "// clang-format off"]
        for kind, name, comment, rows in parts:
            text += ["// " + comment, f"inline constexpr {kind} {name}[] = {{", *rows, "};"]
    text += ["// clang-format on", "", "}  // namespace wrinkle::test", ""]
    with open(sys.argv[sys.argv.index("--") + 1], "w") as out:
        out.write("\n".join(text))


main()
