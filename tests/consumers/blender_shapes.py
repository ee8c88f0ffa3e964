# What Blender finds in exports of cubes.pxm at level 3: as many faces, the box, the volume and the
# colours that the maps give, counted here from the numbers of that file and nothing else.
#   blender -b -P blender_shapes.py -- FOLDER
import math
import os
import sys
from itertools import product

import blender_files
import bpy
from mathutils import Matrix, Vector

turn_z = Matrix.Rotation(math.radians(30), 3, "Z")
turn_x = Matrix.Rotation(math.radians(75), 3, "X")
maps = [
    (0.45 * turn_z, Vector((0.9, 0, 0)), (0.8, 0.1, 0.2)),
    (0.5 * turn_x, Vector((-0.8, 0.5, 0)), (0.1, 0.6, 0.3)),
    (Matrix(((-0.4, 0, 0), (0, 0.4, 0), (0, 0, 0.4))), Vector((0, -0.5, 1)), (0.1, 0.2, 0.7)),
]
levels = 3
corners = [Vector(c) for c in product((-2, 2), repeat=3)]


def cells():
    """The corners of every cell in the scene, the cell's volume, and its colour."""
    for word in product(maps, repeat=levels):
        points, volume = corners, 64.0
        for linear, offset, color in reversed(word):
            points = [linear @ p + offset for p in points]
            volume *= abs(linear.determinant())
        yield points, volume, word[-1][2]


def box_of(points):
    points = list(points)
    return [min(p[k] for p in points) for k in range(3)], [max(p[k] for p in points) for k in range(3)]


def near(a, b, error):
    return all(abs(x - y) <= error for x, y in zip(a, b))


def found():
    """Faces, corners, volume and colours of what is shown, instances included."""
    faces, points, volume, colors = 0, [], 0.0, set()
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        if instance.object.type != "MESH":
            continue
        mesh, place = instance.object.data, instance.matrix_world
        faces += len(mesh.polygons)
        points += [place @ v.co for v in mesh.vertices]
        mesh.calc_loop_triangles()
        for triangle in mesh.loop_triangles:
            a, b, c = (place @ mesh.vertices[i].co for i in triangle.vertices)
            volume += a.dot(b.cross(c)) / 6
        for attribute in mesh.color_attributes:
            colors |= {tuple(round(c, 2) for c in value.color[:3]) for value in attribute.data}
    return faces, points, volume, colors


folder = sys.argv[sys.argv.index("--") + 1]
expected = list(cells())
low, high = box_of(p for points, _, _ in expected for p in points)
volume = sum(v for _, v, _ in expected)
colors = {color for _, _, color in expected}
for name, faces in (("a.ply", 6), ("a.obj", 6), ("a.stl", 12), ("a.glb", 12), ("a.gltf", 12)):
    blender_files.open_shapes(os.path.join(folder, name))
    their_faces, points, their_volume, their_colors = found()
    assert their_faces == faces * len(expected), (name, their_faces)
    # x to the right, z up, y away; a PLY has the numbers of the scene.
    order = (0, 1, 2) if name == "a.ply" else (0, 2, 1)
    their_low, their_high = box_of(points)
    assert near(their_low, [low[k] for k in order], 1e-5), (name, their_low, low)
    assert near(their_high, [high[k] for k in order], 1e-5), (name, their_high, high)
    assert abs(their_volume - volume) < 1e-4 * volume, (name, their_volume, volume)
    if name != "a.stl":  # it has no colours
        assert len(their_colors) == len(colors), (name, their_colors)
        assert all(any(near(a, b, 0.011) for b in colors) for a in their_colors), (name, their_colors)
print("blender_shapes: as many faces, the same box, volume and colours")
