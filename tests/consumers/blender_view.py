# Renders a file of shapes as the camera of cubes.pxm sees them, flat in the colours of the file:
# blender -b -P blender_view.py -- FILE OUT.png
import math
import sys

import bpy
import blender_files
from mathutils import Vector


def there(x, y, z):
    """A place of the scene where Blender has z up and y away from the viewer."""
    return Vector((x, z, y))


path, out = sys.argv[sys.argv.index("--") + 1 :]
blender_files.open_shapes(path)
scene = bpy.context.scene

camera = bpy.data.cameras.new("camera")
camera.sensor_fit = "HORIZONTAL"
camera.angle = math.radians(40)
eye = bpy.data.objects.new("eye", camera)
eye.location = there(1, 2, -6)
eye.rotation_euler = (there(0, 0, 0) - there(1, 2, -6)).to_track_quat("-Z", "Y").to_euler()
scene.collection.objects.link(eye)
scene.camera = eye

material = bpy.data.materials.new("flat")
material.use_nodes = True
tree = material.node_tree
tree.nodes.clear()
light = tree.nodes.new("ShaderNodeEmission")
tree.links.new(light.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs[0])
for thing in bpy.data.objects:
    if thing.type != "MESH":
        continue
    thing.data.materials.clear()
    thing.data.materials.append(material)
    if thing.data.color_attributes:
        color = tree.nodes.new("ShaderNodeAttribute")
        color.attribute_name = thing.data.color_attributes[0].name
        tree.links.new(color.outputs["Color"], light.inputs[0])

scene.render.engine = "CYCLES"
scene.cycles.samples = 16
scene.cycles.use_denoising = False
scene.render.resolution_x, scene.render.resolution_y = 320, 240
scene.render.resolution_percentage = 100
scene.render.film_transparent = True
scene.view_settings.view_transform = "Standard"
scene.render.image_settings.file_format = "PNG"
scene.render.image_settings.color_mode = "RGBA"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)
