# flam3's own pictures of linear flames show the set that pxm imports: flam3_pictures.py PXM FLAM3-RENDER FOLDER
# A pixel of one that is far from all of the other by more than a hundredth of the set's diameter is a mistake.
import math
import os
import re
import subprocess
import sys

import numpy as np
from point_sets import distance, points_of_ply

pxm, flam3_render, folder = sys.argv[1:]
columns, rows = 400, 300
few_points, error = 400_000, 0.01


def xform(coefs, more="", linear=1, weight=1):
    return f'<xform weight="{weight}" color="0.5" linear="{linear}" coefs="{coefs}" {more}/>\n'


corners = [xform("0.5 0 0 0.5 0 0"), xform("0.5 0 0 0.5 0.5 0"), xform("0.5 0 0 0.5 0 0.5")]
petals = xform("0.4 0.2 -0.2 0.4 0.9 0.1") + xform("0.3 0 0.1 0.4 0.1 0.7")
flames = {
    "gasket": ('center="0.5 0.5" scale="220"', "".join(corners)),
    "fern": (
        'center="0 -5" scale="28"',
        xform("0 0 0 0.16 0 0", weight=0.02)
        + xform("0.85 0.04 -0.04 0.85 0 -1.6", weight=0.8)
        + xform("0.2 -0.23 0.26 0.22 0 -1.6", weight=0.09)
        + xform("-0.15 -0.26 -0.28 0.24 0 -0.44", weight=0.09),
    ),
    "dragon": ('center="0.4 -0.2" scale="150"', xform("0.5 0.5 -0.5 0.5 0 0") + xform("-0.5 0.5 -0.5 -0.5 1 0")),
    "post": (
        'center="0.2 0.1" scale="130"',
        xform("0.5 0.1 -0.1 0.6 0.2 0", 'post="0.8 0.2 -0.2 0.8 0.3 -0.1"')
        + xform("0.4 0 0.2 0.5 -0.5 0.2", 'post="0 0.9 -0.9 0 0 0.4"')
        + xform("0.3 0.3 -0.3 0.3 0.4 0.6"),
    ),
    "xaos": (
        'center="0.4 0.4" scale="200"',
        xform("0.5 0 0 0.5 0 0", 'chaos="1 1 0"')
        + xform("0.5 0 0 0.5 0.5 0", 'chaos="0 1 1"')
        + xform("0.5 0 0 0.5 0 0.5", 'chaos="1 0 1"'),
    ),
    "one_way": (
        'center="0.4 0.4" scale="200"',
        xform("0.6 0.1 0 0.5 0 0", 'chaos="1 1 1"')
        + xform("0.5 0 0.2 0.5 0.5 0", 'chaos="1 0 1"')
        + xform("0.4 0 0 0.5 0 0.5", 'chaos="0 1 1"'),
    ),
    "opacity": (
        'center="0.4 0.4" scale="200"',
        xform("0.5 0.1 0 0.5 0 0", 'opacity="0"') + xform("0.5 0 0 0.5 0.5 0") + xform("0.5 0 0.1 0.5 0 0.5"),
    ),
    "final": (
        'center="0.4 0.6" scale="150"',
        "".join(corners) + '<finalxform color="0" color_speed="0" linear="1" coefs="0.9 0.5 -0.6 0.8 0.2 0.3"/>\n',
    ),
    "symmetry": ('center="0 0" scale="90"', petals + '<symmetry kind="3"/>\n'),
    "mirror": ('center="0 0" scale="90"', petals + '<symmetry kind="-2"/>\n'),
    "factor": (
        'center="0.5 0.3" scale="150" rotate="30"',
        xform("1 0 0 1 0 0", linear=0.5) + xform("1 0.2 0 1 1 0", linear=0.5) + xform("1 0 0.3 -0.7 0.2 1", linear=0.5),
    ),
    "zoom": (
        'center="0.3 0.2" scale="100" zoom="0.5" rotate="-50"',
        xform("0.6 0 0 0.5 0 0") + xform("0.3 0.2 0 0.5 0.5 0") + xform("0.5 0 0.2 0.4 0.1 0.5"),
    ),
}
white = "".join(f'<color index="{i}" rgb="255 255 255"/>' for i in range(256))
sharp = (
    'quality="100" oversample="1" filter="0.1" estimator_radius="0" estimator_minimum="0" brightness="20" gamma="1" '
    'background="0 0 0" passes="1" temporal_samples="1"'
)


def run(*arguments, **variables):
    done = subprocess.run(arguments, env={**os.environ, **variables}, capture_output=True, cwd=folder)
    assert done.returncode == 0, (arguments, done.stderr[-2000:])


def their_pixels(name):
    run(flam3_render, **{"in": name + ".flame"}, out=name + ".png", format="png", nthreads="1", isaac_seed="pxm")
    gray = subprocess.run(["convert", name + ".png", "-depth", "8", "gray:-"], capture_output=True, cwd=folder, check=True)
    return np.frombuffer(gray.stdout, dtype=np.uint8).reshape(rows, columns) > 0


def our_points(name):
    run(pxm, "points", name + ".pxm", "-n", str(few_points), "-o", name + ".ply", "--precision", "float", "--quiet")
    return points_of_ply(os.path.join(folder, name + ".ply"))


def our_pixels(name, view):
    """The points where flam3's picture has them: y down, turned about the centre."""
    numbers = {key: [float(n) for n in value.split()] for key, value in re.findall(r'(\w+)="([^"]*)"', view)}
    angle = math.radians(numbers.get("rotate", [0])[0])
    scale = numbers["scale"][0] * 2 ** numbers.get("zoom", [0])[0]
    points = our_points(name)
    x, y = points["x"] - numbers["center"][0], -points["y"] - numbers["center"][1]
    column = (math.cos(angle) * x - math.sin(angle) * y) * scale + columns / 2
    row = (math.sin(angle) * x + math.cos(angle) * y) * scale + rows / 2
    assert column.min() >= 0 and column.max() < columns and row.min() >= 0 and row.max() < rows, name
    pixels = np.zeros((rows, columns), bool)
    pixels[row.astype(int), column.astype(int)] = True
    return pixels


for name, (view, transforms) in flames.items():
    with open(os.path.join(folder, name + ".flame"), "w") as file:
        file.write(f'<flame name="{name}" size="{columns} {rows}" {sharp} {view}>\n{transforms}{white}\n</flame>\n')
    run(pxm, "import", name + ".flame", "-o", name + ".pxm")
    ours = our_pixels(name, view)
    apart = distance(ours, their_pixels(name))
    print(f"{name}: {ours.sum()} pixels, Hausdorff distance {100 * apart:.2f} % of the diameter")
    assert apart < error, name
    # And the way back: what pxm exports is the same set to flam3.
    if name in ("fern", "one_way", "opacity", "final"):
        run(pxm, "export", name + ".pxm", "-o", name + "_back.flame")
        text = open(os.path.join(folder, name + "_back.flame")).read()
        with open(os.path.join(folder, name + "_back.flame"), "w") as file:
            file.write(re.sub(r' brightness="4" gamma="4" background="0 0 0"', " " + sharp, text))
        apart = distance(ours, their_pixels(name + "_back"))
        print(f"{name}, exported: {100 * apart:.2f} %")
        assert apart < error, name
