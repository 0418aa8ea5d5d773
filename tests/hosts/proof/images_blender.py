"""Draws the mesh of the open file below an environment.

    blender -b FILE.blend -P images_blender.py -- ENVIRONMENT OUT SIDE FIELD_OF_VIEW EYE...
"""
import sys

import bpy
from mathutils import Vector

environment, out, side, field_of_view, *eye = sys.argv[sys.argv.index("--") + 1:]
scene = bpy.context.scene
for each in list(bpy.data.objects):
    if each.type == "LIGHT":
        bpy.data.objects.remove(each)
scene.world = bpy.data.worlds.new("Environment")
scene.world.use_nodes = True
tree = scene.world.node_tree
image = tree.nodes.new("ShaderNodeTexEnvironment")
image.image = bpy.data.images.load(environment)
tree.links.new(image.outputs["Color"], tree.nodes["Background"].inputs["Color"])
x, y, z = map(float, eye)
scene.camera.location = (x, -z, y)
scene.camera.rotation_euler = Vector((x, -z, y)).to_track_quat("Z", "Y").to_euler()
scene.camera.data.angle = float(field_of_view)
scene.render.engine = "CYCLES"
scene.cycles.samples = 64
scene.cycles.use_denoising = False
scene.render.resolution_x = scene.render.resolution_y = int(side)
scene.render.resolution_percentage = 100
scene.view_settings.view_transform = "Standard"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)
