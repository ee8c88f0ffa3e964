"""pxm: ray tracing of linear fractals, and the Pixel Machine that they were first rendered on.

    import pxm
    picture = pxm.render("tetra")            # a scene that came with pxm, by its name
    picture.save("tetra.png")
    picture.depth, picture.normal, picture.word

docs/python.md says the rest.
"""
from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Concatenate, ParamSpec

import numpy as np
from numpy.typing import NDArray

from ._core import version as __version__
from ._errors import (
    FileError,
    MachineLimitError,
    Mistake,
    PxmError,
    PxmWarning,
    SceneError,
    SettingError,
)
from ._inspection import (
    Box,
    BoxScale,
    DimensionFacts,
    Inspection,
    MapFacts,
    MemoryUse,
    ObjectFacts,
    Sphere,
    SystemFacts,
)
from ._objects import Camera, Light, Object, Plane, System
from ._picture import NODE, PIXEL, Picture
from ._progress import Progress
from ._scene import Machine, Scene, Source, _render, models, scene_names, scene_of

__all__ = [
    "Box",
    "BoxScale",
    "Camera",
    "DimensionFacts",
    "FileError",
    "Inspection",
    "Light",
    "Machine",
    "MachineLimitError",
    "MapFacts",
    "MemoryUse",
    "Mistake",
    "NODE",
    "Object",
    "ObjectFacts",
    "PIXEL",
    "Picture",
    "Plane",
    "Progress",
    "PxmError",
    "PxmWarning",
    "Scene",
    "SceneError",
    "SettingError",
    "Source",
    "Sphere",
    "System",
    "SystemFacts",
    "__version__",
    "inspect",
    "models",
    "points",
    "render",
    "scene_names",
]

_P = ParamSpec("_P")


def _of_source(
    model: Callable[Concatenate[Scene, _P], Picture]
) -> Callable[Concatenate[Source, _P], Picture]:
    @wraps(model)
    def render(scene: Source, /, *args: _P.args, **options: _P.kwargs) -> Picture:
        return model(scene_of(scene), *args, **options)

    return render


render = _of_source(_render)


def inspect(scene: Source, *, progress: Progress = None) -> Inspection:
    """What is known of a scene before a ray is cast: Scene.inspect()."""
    return scene_of(scene).inspect(progress=progress)


def points(
    scene: Source, count: int, *, seed: int = 1, threads: int = 0, progress: Progress = None
) -> NDArray[np.float64]:
    """Points of a scene's attractors: Scene.points()."""
    return scene_of(scene).points(count, seed=seed, threads=threads, progress=progress)
