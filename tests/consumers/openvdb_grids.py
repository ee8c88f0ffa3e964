# What OpenVDB reads of level sets that pxm exports: known volumes, the box, and distances that are
# those to the surface: openvdb_grids.py PXM
import itertools
import math
import subprocess
import sys

import numpy as np
import pyopenvdb as vdb

program = sys.argv[1]


def exported(scene, *options):
    done = subprocess.run([program, "export", scene, "-o", "a.vdb", "--quiet", *options], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    grid = vdb.read("a.vdb", "surface")
    assert grid.gridClass == "level set" and isinstance(grid, vdb.FloatGrid), grid
    assert len(vdb.readAllGridMetadata("a.vdb")) == 1
    voxel = grid.transform.voxelSize()[0]
    assert grid.transform.voxelSize() == (voxel,) * 3 and math.isclose(grid.background, 3 * voxel, rel_tol=1e-6)
    low, high = grid.evalActiveVoxelBoundingBox()
    samples = np.empty([h - l + 3 for l, h in zip(low, high)], np.float32)
    first = tuple(l - 1 for l in low)
    grid.copyToArray(samples, first)
    return grid, samples, voxel, np.array(grid.transform.indexToWorld(first))


def places(samples, voxel, first):
    """Of the samples inside."""
    return np.argwhere(samples < 0) * voxel + first


def near(found, expected, error, what):
    assert abs(found / expected - 1) < error, (what, found, expected)
    print(f"{what}: {found:.6g}, should be {expected:.6g}")


# Menger's sponge in the cube [0,1]^3 or another: as many voxels as its cubes have.
for level, voxels in ((1, 27), (2, 54), (3, 81)):
    _, samples, voxel, first = exported("menger_exact", "--levels", str(level), "--voxels", str(voxels), "--shape", "box")
    side = voxels * voxel
    near((samples < 0).sum() * voxel**3 / side**3, (20 / 27) ** level, 1e-9, f"menger, level {level}")
    inside = places(samples, voxel, first)
    box = inside.max(0) - inside.min(0) + voxel
    assert np.allclose(box, side), box

with open("ball.pxm", "w") as file:
    file.write("object ball { sphere: (1,2,3) 2 }\n")
_, samples, voxel, first = exported("ball.pxm", "--voxels", "100")
near((samples < 0).sum() * voxel**3, 4 / 3 * math.pi * 8, 0.01, "a ball's volume")
middle = places(samples, voxel, first).mean(0)
assert np.allclose(middle, (1, 2, -3), atol=voxel / 10), middle  # z comes to the viewer
# The distance of every sample near the surface is right, and so its gradient.
index = np.argwhere(np.abs(samples) < 2.5 * voxel)
distances = np.linalg.norm(index * voxel + first - np.array((1, 2, -3)), axis=1) - 2
outside = distances > 0
found = samples[tuple(index.T)]
assert np.abs(found - distances)[outside].max() < voxel / 500, np.abs(found - distances)[outside].max()
assert np.abs(found - distances)[~outside].max() < voxel / 2

# Cubes that turn, mirror and overlap: a sample is inside if it is in one of them.
def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    a, b = {"x": (1, 2), "z": (0, 1)}[axis]
    matrix = np.eye(3)
    matrix[a, a] = matrix[b, b] = c
    matrix[b, a], matrix[a, b] = s, -s
    return matrix


maps = [
    (turn("z", 30) * 0.45, np.array((0.9, 0, 0))),
    (turn("x", 75) * 0.5, np.array((-0.8, 0.5, 0))),
    (np.diag((-0.4, 0.4, 0.4)), np.array((0, -0.5, 1))),
]
_, samples, voxel, first = exported("cubes.pxm", "--levels", "3", "--voxels", "150")
at = (np.indices(samples.shape).reshape(3, -1).T * voxel + first) * (1, 1, -1)
inside, doubtful = np.zeros(len(at), bool), np.zeros(len(at), bool)
for word in itertools.product(maps, repeat=3):
    matrix, move = np.eye(3), np.zeros(3)
    for linear, offset in word:  # the first is the outermost
        matrix, move = matrix @ linear, matrix @ offset + move
    out = np.abs((at - move) @ np.linalg.inv(matrix).T).max(1) - 2
    inside |= out < 0
    doubtful |= np.abs(out) < 0.01
found = samples.ravel() < 0
assert (found == inside)[~doubtful].all() and inside[~doubtful].sum() > 10000, (found != inside)[~doubtful].sum()
near(found.sum(), inside.sum(), 0.01, "voxels in 27 turned cubes")

# Where cubes touch, distances inside go on to the surface of them all.
halves = [f"newmap scale: 0.5 translate: {x},{y},{z}" for x, y, z in itertools.product((-0.5, 0.5), repeat=3)]
with open("eight.pxm", "w") as file:
    file.write("ifs a {\n" + "\n".join(halves) + "\n}\nobject a { ifs: a box: (-1,-1,-1)(1,1,1) }\n")
grid, samples, voxel, first = exported("eight.pxm", "--levels", "1", "--voxels", "20")
assert (samples < 0).sum() == 20**3
assert grid.getConstAccessor().getValue((10, 10, 10)) == -grid.background, "the middle lies deep inside"

once = open("a.vdb", "rb").read()
exported("eight.pxm", "--levels", "1", "--voxels", "20")
assert once == open("a.vdb", "rb").read(), "two runs make the same bytes"
print("openvdb: volumes, places and distances")
