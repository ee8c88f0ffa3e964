# What Blender makes of pictures of cubes.pxm: sizes, passes, pixels and mattes.
#   blender -b -P blender_pictures.py -- FOLDER
import os
import sys

import bpy

folder = sys.argv[sys.argv.index("--") + 1]
scene = bpy.context.scene
scene.use_nodes = True
tree = scene.node_tree
columns, rows = 320, 240


def load(name):
    picture = bpy.data.images.load(os.path.join(folder, name), check_existing=False)
    picture.colorspace_settings.name = "Non-Color"
    return picture


def passes_of(picture):
    tree.nodes.clear()
    node = tree.nodes.new("CompositorNodeImage")
    node.image = picture
    return [output.name for output in node.outputs if output.enabled]


plain = load("plain.exr")
assert tuple(plain.size) == (columns, rows) and plain.is_float
assert load("half.exr").pixels[:] and passes_of(load("half.exr")) == ["Image", "Alpha", "Depth"]
pixels = plain.pixels[:]
assert set(pixels[3::4]) == {1.0}
seen = sum(any(pixels[4 * i : 4 * i + 3]) for i in range(columns * rows))
assert seen > 1000
half = load("half.exr").pixels[:]
assert max(abs(a - b) for a, b in zip(pixels, half)) < 1e-3

aov = passes_of(load("aov.exr"))
assert aov == ["Combined", "Alpha", "Depth", "N", "alpha", "object"], aov
crop = load("crop.exr")
assert tuple(crop.size) == (120, 80), tuple(crop.size)

scene.render.resolution_x, scene.render.resolution_y = columns, rows
scene.render.resolution_percentage = 100
scene.render.engine = "CYCLES"
scene.cycles.samples = 1
camera = bpy.data.objects.new("c", bpy.data.cameras.new("c"))
scene.collection.objects.link(camera)
scene.camera = camera
settings = scene.render.image_settings
settings.file_format, settings.color_depth, settings.color_mode = "OPEN_EXR", "32", "RGB"
scene.render.filepath = os.path.join(folder, "matte.exr")


def covered(layer, names):
    """How many pixels the matte of these names covers in Blender's own node."""
    tree.nodes.clear()
    node = tree.nodes.new("CompositorNodeCryptomatteV2")
    node.source, node.image = "IMAGE", load("crypto.exr")
    node.layer_name, node.matte_id = layer, names
    tree.links.new(node.outputs["Matte"], tree.nodes.new("CompositorNodeComposite").inputs[0])
    bpy.ops.render.render(write_still=True)
    return sum(load("matte.exr").pixels[:][0::4])


assert covered("CryptoObject", "a") == seen
first = covered("CryptoMap", "a/1")
assert 0 < first < seen and first + covered("CryptoMap", "a/2,a/3") == seen
print("blender_pictures: sizes, passes, pixels and mattes")
