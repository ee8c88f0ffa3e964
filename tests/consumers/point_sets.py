# Sets of pixels, of pictures and of `pxm points`, and how far they are apart.
import math
import re

import numpy as np


def points_of_ply(path):
    """Of the binary PLY that `pxm points` writes: an array with fields x, y, z."""
    data = open(path, "rb").read()
    head = data[: data.index(b"end_header\n") + 11]
    fields = [(n, {"float": "<f4", "uchar": "u1"}[t]) for t, n in re.findall(r"property (\w+) (\w+)", head.decode())]
    return np.frombuffer(data, dtype=fields, offset=len(head))


def farthest(some, others, reach=40):
    """The largest distance of a pixel of one to the nearest of the other; infinite beyond `reach` pixels."""
    left = some & ~others
    around = np.pad(others, reach)
    steps = [(math.hypot(x, y), x, y) for x in range(-reach, reach + 1) for y in range(-reach, reach + 1)]
    away = 0.0
    for step, x, y in sorted(steps):
        if not left.any():
            return away
        away = step
        left &= ~around[reach + x : reach + x + left.shape[0], reach + y : reach + y + left.shape[1]]
    return math.inf


def distance(a, b):
    """Hausdorff's, as a share of the diameter of the first."""
    return max(farthest(a, b), farthest(b, a)) / math.hypot(*np.ptp(np.argwhere(a), axis=0))
