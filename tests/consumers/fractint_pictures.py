# FRACTINT's points of .ifs files lie where pxm's do, and its drawings of L-systems show the limit that pxm imports:
# fractint_pictures.py PXM XFRACTINT FOLDER
# What is far from all of the other by more than a hundredth of the set's diameter is a mistake.
import os
import subprocess
import sys

import numpy as np
from point_sets import distance, points_of_ply

pxm, xfractint, folder = sys.argv[1:]
pixels, error = 300, 0.01

systems = {
    "gasket": ".5 0 0 .5 0 0 .33\n.5 0 0 .5 .5 0 .33\n.5 0 0 .5 0 .5 .34",
    "fern": "0 0 0 .16 0 0 .01\n.85 .04 -.04 .85 0 1.6 .85\n.2 -.26 .23 .22 0 1.6 .07\n-.15 .28 .26 .24 0 .44 .07",
    "dragon": ".5 .5 -.5 .5 .125 .625 .5\n.5 .5 -.5 .5 -.125 .375 .5",
    "koch": ".3333333 0 0 .3333333 0 0 .25\n.1666667 -.2886751 .2886751 .1666667 .3333333 0 .25\n"
    ".1666667 .2886751 -.2886751 .1666667 .5 .2886751 .25\n.3333333 0 0 .3333333 .6666667 0 .25",
    "leaf": ".6 0 0 .6 .18 .36 .3\n.6 0 0 .6 .18 .12 .3\n.4 .3 -.3 .4 .27 .36 .2\n.4 -.3 .3 .4 .27 .09 .2",
    "mirrored": "0 .6 .5 0 0 0 .4\n.5 0 0 -.6 .4 .3 .3\n.3 .1 -.1 .4 0 .8 .3",
    "solid": ".5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n.5 0 0 0 0 .5 0 -.5 0 1 0 0 .25\n"
    "0 .5 0 -.5 0 0 0 0 .5 0 1 0 .25\n.4 0 .3 0 .5 0 -.3 0 .4 0 0 1 .25",
}
# The order is one after which the drawing stands as the limit does: turns of the whole come round, or there are none.
# Of plants, points are too few on the long strokes for a comparison within a hundredth.
drawings = {
    "Koch": (6, "Angle 6\nAxiom F\nF=F+F--F+F"),
    "Dragon": (16, "Angle 4\nAxiom FX\nX=X+YF+\nY=-FX-Y"),
    "Levy": (14, "Angle 8\nAxiom F\nF=+F--F+"),
    "Arrowhead": (8, "Angle 6\nAxiom XF\nX=YF+XF+Y\nY=XF-YF-X"),
    "Snowflake": (6, "Angle 6\nAxiom F--F--F\nF=F+F--F+F"),
    "Hilbert": (7, "Angle 4\nAxiom X\nX=-YF+XFX+FY-\nY=+XF-YFY-FX+"),
    "Terdragon": (12, "Angle 3\nAxiom F\nF=F+F-F"),
}


def run(*arguments):
    done = subprocess.run(arguments, capture_output=True, text=True, cwd=folder, env={**os.environ, "HOME": folder})
    assert done.returncode == 0, (arguments, done.stderr[-2000:])


def fractint(*settings):
    run("xvfb-run", "-a", xfractint, "-disk", "batch=yes", "overwrite=yes", "savename=out.gif", *settings)


def our_points(name, count=400_000):
    run(pxm, "points", name + ".pxm", "-n", str(count), "-o", name + ".ply", "--precision", "float", "--quiet")
    points = points_of_ply(os.path.join(folder, name + ".ply"))
    return np.stack([points["x"], points["y"], points["z"]], axis=1).astype(float)


def grid(points, low, size):
    """The points as pixels of a square with that corner."""
    raster = np.zeros((pixels + 1, pixels + 1), bool)
    at = np.round((points - low) / size * pixels).astype(int)
    assert (at >= -pixels // 20).all() and (at <= pixels + pixels // 20).all(), "points far from the others"
    raster[tuple(np.clip(at, 0, pixels).T)] = True
    return raster


def their_points(name):
    orbits = os.path.join(folder, "orbits.raw")
    fractint("type=ifs" if name != "solid" else "type=ifs3d", f"ifsfile={name}.ifs", f"ifs={name}", "maxiter=400", "orbitsave=yes")
    points = np.loadtxt(orbits, skiprows=1, usecols=(0, 1, 2))
    os.remove(orbits)
    return points[100:]  # the first are on their way


for name, numbers in systems.items():
    kind = " (3D)" if name == "solid" else ""
    with open(os.path.join(folder, name + ".ifs"), "w") as file:
        file.write(f"{name}{kind} {{\n{numbers}\n}}\n")
    run(pxm, "import", name + ".ifs", "-o", name + ".pxm")
    ours, theirs = our_points(name), their_points(name)
    for axes in ((0, 1), (0, 2), (1, 2)) if name == "solid" else ((0, 1),):
        a, b = ours[:, axes], theirs[:, axes]
        low, size = a.min(0), np.ptp(a, axis=0).max()
        apart = distance(grid(a, low, size), grid(b, low, size))
        print(f"{name}, {'xyz'[axes[0]]} and {'xyz'[axes[1]]}: {len(b)} points, Hausdorff distance {100 * apart:.2f} %")
        assert apart < error, name


def their_pixels():
    gray = subprocess.run(["convert", "out.gif", "-depth", "8", "gray:-"], capture_output=True, cwd=folder, check=True)
    size = subprocess.run(["identify", "-format", "%h %w", "out.gif"], capture_output=True, cwd=folder, check=True).stdout
    return np.frombuffer(gray.stdout, dtype=np.uint8).reshape([int(n) for n in size.split()]) > 0


for name, (order, rules) in drawings.items():
    # Where file and entry had names of nine letters, its picture was empty.
    with open(os.path.join(folder, "one.l"), "w") as file:
        file.write(f"Drawing {{\n{rules}\n}}\n")
    run(pxm, "import", "one.l", "-o", name + ".pxm")
    fractint("type=lsystem", "lfile=one.l", "lname=Drawing", f"params={order}")
    theirs = their_pixels()
    rows, columns = np.argwhere(theirs).min(0), np.argwhere(theirs).max(0)
    # FRACTINT fits a drawing into its picture, so ours is moved and scaled alike along both axes; y points down there.
    ours = our_points(name)[:, 1::-1] * (-1, 1)
    low, size = ours.min(0), np.ptp(ours, axis=0)
    longer = size.argmax()
    scale = (columns - rows)[longer] / size[longer]
    at = np.round((ours - low - size / 2) * scale + (rows + columns) / 2).astype(int)
    shown = np.zeros_like(theirs)
    shown[tuple(np.clip(at, 0, np.array(theirs.shape) - 1).T)] = True
    apart = distance(theirs, shown)
    print(f"{name}, order {order}: {theirs.sum()} pixels, Hausdorff distance {100 * apart:.2f} %")
    assert apart < error, name
