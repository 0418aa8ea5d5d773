"""Draws files with Cycles and writes the values that it shades with.

    blender -b --factory-startup --python-exit-code 1 -P read_blender.py -- JOBS.json OUT.json

A job is [FILE, OBJECT]: a .blend with one mesh, or a .glb. OUT.json has a list of points for each:
u, v, front (1, back: -1), the normal in the space of the file, color, roughness.
"""
import json
import os
import sys

import bpy
import numpy
from mathutils import Euler, Matrix

numpy.bool = bool  # of Blender 3.4's importer of glTF, with numpy 1.24
SIDE, STEP = 256, 17  # of the image, and of the pixels that are returned
TURNED = Euler((0.5, 0.7, 0.2)).to_matrix().to_4x4()
Z_UP = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
OBJECTS = {"plain": TURNED, "mirrored": TURNED @ Matrix.Diagonal((-1, 1, 1, 1)),
           "scaled": TURNED @ Matrix.Diagonal((1, 0.6, 1.4, 1)), "back": TURNED}


def opened(file):
    """The mesh object of a file, the only object of the scene."""
    if file.endswith(".glb"):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.import_scene.gltf(filepath=file)
    else:
        bpy.ops.wm.open_mainfile(filepath=file)
    shapes = [each for each in bpy.data.objects if each.type == "MESH"]
    assert len(shapes) == 1, file
    for each in list(bpy.data.objects):
        if each != shapes[0]:
            bpy.data.objects.remove(each)
    return shapes[0]


def set_up(scene):
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.location = (0, 0, 4)
    camera.data.angle = 0.6
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 0.01
    scene.render.film_transparent = True
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = os.path.join(os.path.dirname(sys.argv[-1]), "drawn.exr")


class Drawing:
    """Shows values of the material of a file as emission."""

    def __init__(self, file):
        self.shape = opened(file)
        set_up(bpy.context.scene)
        self.imported = self.shape.matrix_world.copy()
        self.tree = self.shape.active_material.node_tree
        nodes = self.tree.nodes
        self.surface = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
        output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
        self.emission = nodes.new("ShaderNodeEmission")
        self.tree.links.new(self.emission.outputs[0], output.inputs["Surface"])
        self.geometry = nodes.new("ShaderNodeNewGeometry")
        self.encode = nodes.new("ShaderNodeVectorMath")
        self.encode.operation = "MULTIPLY_ADD"
        self.encode.inputs[1].default_value = self.encode.inputs[2].default_value = (0.5,) * 3
        self.uv = nodes.new("ShaderNodeUVMap")

    def drawn(self, source):
        """Pixels of an output of a node, bottom row first."""
        self.tree.links.new(source, self.emission.inputs["Color"])
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(bpy.context.scene.render.filepath)
        pixels = numpy.empty(SIDE * SIDE * 4, numpy.float32)
        image.pixels.foreach_get(pixels)
        bpy.data.images.remove(image)
        return pixels.reshape(-1, 4)[::STEP]

    def input_pixels(self, name, points):
        """Of the map of an input, or its value; of a color without the occlusion."""
        used = self.surface.inputs[name]
        if used.is_linked and used.links[0].from_node.label == "Occlusion":
            used = used.links[0].from_node.inputs[0]
        if used.is_linked:
            return self.drawn(used.links[0].from_socket)
        value = used.default_value
        value = (value,) * 4 if used.type == "VALUE" else (*value, 1)[:4]
        return numpy.tile(value, (points, 1))

    def normals(self):
        used = self.surface.inputs["Normal"]
        source = used.links[0].from_socket if used.is_linked else self.geometry.outputs["Normal"]
        self.tree.links.new(source, self.encode.inputs[0])
        return 2 * self.drawn(self.encode.outputs[0])[:, :3] - 1

    def points(self, object_name):
        self.shape.matrix_world = OBJECTS[object_name] @ self.imported
        camera = bpy.context.scene.camera
        camera.data.clip_start = 3.9 if object_name == "back" else 0.1
        uv = self.drawn(self.uv.outputs["UV"])
        back = self.drawn(self.geometry.outputs["Backfacing"])[:, 0]
        to_world = numpy.array((OBJECTS[object_name] @ Z_UP).to_3x3())
        normals = self.normals() @ to_world  # by the transposed matrix
        color = self.input_pixels("Base Color", len(uv))
        roughness = self.input_pixels("Roughness", len(uv))
        columns = (uv[:, :2], 1 - 2 * back, normals, color[:, :3], roughness[:, 0])
        return numpy.column_stack(columns)[uv[:, 3] > 0].tolist()


def main():
    with open(sys.argv[-2]) as file:
        jobs = json.load(file)
    results, current = [], None
    for file, object_name in jobs:
        if file != current:
            current, drawing = file, Drawing(file)
        results.append(drawing.points(object_name))
    with open(sys.argv[-1], "w") as out:
        json.dump(results, out)


main()
