# How Blender opens what pxm exports.
import bpy
import numpy

# The glTF importer of Blender 3.4 uses a name that NumPy 1.24, the one of Debian 12, no longer has.
if not hasattr(numpy, "bool"):
    numpy.bool = bool


def open_shapes(path):
    """The shapes of one file, in an empty scene."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    kind = path.rsplit(".")[-1]
    if kind == "ply":
        bpy.ops.import_mesh.ply(filepath=path)
    elif kind == "stl":
        bpy.ops.import_mesh.stl(filepath=path)
    elif kind == "obj":
        bpy.ops.wm.obj_import(filepath=path)
    else:
        bpy.ops.import_scene.gltf(filepath=path)
