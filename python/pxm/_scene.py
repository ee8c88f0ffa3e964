"""Scenes, and what is done with them."""
from __future__ import annotations

import base64
import html
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from typing import Any, Concatenate, ParamSpec, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import PxmWarning
from ._inspection import Inspection, inspection_of
from ._objects import Camera, Light, Object, Plane, System, scene_text, setting_text
from ._picture import Picture
from ._progress import Progress, watching

P = ParamSpec("P")


def _warn(text: str) -> None:
    if text.strip():
        warnings.warn(text.strip(), PxmWarning, stacklevel=4)


def _render(
    scene: Scene,
    *,
    size: tuple[int, int] | None = None,
    crop: tuple[int, int, int, int] | None = None,
    levels: int | None = None,
    zoom: float = 1,
    samples: int | None = None,
    covers: str | tuple[float, float] | None = None,
    shading: str | None = None,
    intersect: str | None = None,
    numeric: str | None = None,
    lipschitz: str | None = None,
    volume: str | None = None,
    detail: float | None = None,
    heap: int | None = None,
    frame: float = 0,
    threads: int = 0,
    machine: str | None = None,
    cost_model: str | os.PathLike[str] | None = None,
    progress: Progress = None,
) -> Picture:
    """Renders a scene: the options are those of `pxm render`, and what is not given is the scene's.

    size, crop   (columns, rows), and the window (x0, y0, x1, y1) of it
    frame        of a film, from 0
    threads      0: as many as the system grants
    machine      a model of the Pixel Machine to render on, with the costs of `cost_model`, a file
    progress     a function that is called with the share done; False: nothing is shown
    """
    options = _core.Options()
    if size is not None:
        options.size = "x".join(str(int(side)) for side in size)
    if crop is not None:
        options.crop = ",".join(str(int(edge)) for edge in crop)
    options.levels, options.samples, options.heap = levels, samples, heap
    options.zoom, options.detail, options.frame = zoom, detail, frame
    options.covers = "" if covers is None else setting_text(covers)
    options.shading, options.intersect = shading or "", intersect or ""
    options.numeric, options.lipschitz = numeric or "", lipschitz or ""
    options.volume, options.machine = volume or "", machine or ""
    options.cost_model = "" if cost_model is None else os.fspath(cost_model)
    options.threads = threads
    with watching(progress) as told:
        picture = Picture(_core.render(scene._read, options, told))
    _warn(picture.warnings)
    return picture


class Scene:
    """A scene that was read and found right.

    source    text in the scene language, or systems and objects; with the latter, `camera`,
              `lights`, `planes` and `render` say the rest
    name      what messages call it; what a text includes is looked for beside a file of that name
    allow     further folders for files that the scene names
    set       values over those of the text: {"camera.fov": 50}
    """

    def __init__(
        self,
        source: str | System | Object | Iterable[System | Object],
        *,
        camera: Camera | None = None,
        lights: Sequence[Light] = (),
        planes: Sequence[Plane] = (),
        render: Mapping[str, Any] | None = None,
        name: str = "scene",
        allow: Iterable[str | os.PathLike[str]] = (),
        set: Mapping[str, Any] | None = None,
    ) -> None:
        if isinstance(source, str):
            if camera is not None or lights or planes or render is not None:
                raise ValueError("a scene of text has its camera, lights, planes and render there")
            text = source
        else:
            shown = [source] if isinstance(source, (System, Object)) else list(source)
            text = scene_text(shown, camera, lights, planes, render or {})
        self._read = _read(name, text, allow, set)

    @classmethod
    def read(
        cls,
        path: str | os.PathLike[str],
        *,
        allow: Iterable[str | os.PathLike[str]] = (),
        set: Mapping[str, Any] | None = None,
    ) -> Scene:
        """Of a file, or of a scene that came with pxm, by its name."""
        scene = cls.__new__(cls)
        scene._read = _read(os.fspath(path), None, allow, set)
        return scene

    @property
    def path(self) -> str:
        """The file, or the name that messages call it."""
        return self._read.path

    @property
    def text(self) -> str:
        """The scene in the scene language, everything that it includes with it."""
        return self._read.text()

    @property
    def frames(self) -> int:
        """Of its animation; 1 without."""
        return self._read.frames()

    @property
    def systems(self) -> tuple[System, ...]:
        """Its systems as they are with all that the text says of them."""
        return tuple(_system(*system) for system in self._read.systems())

    def inspect(self, *, progress: Progress = None) -> Inspection:
        """What is known of it before a ray is cast."""
        with watching(progress) as told:
            return inspection_of(self._read.inspect(told))

    def points(
        self, count: int, *, seed: int = 1, threads: int = 0, progress: Progress = None
    ) -> NDArray[np.float64]:
        """Points of its attractors by the chaos game: (count, 3). The same as those of `pxm points`."""
        places = _rows(count)
        self._draw(places, None, seed, threads, progress)
        return places

    def colored_points(
        self, count: int, *, seed: int = 1, threads: int = 0, progress: Progress = None
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The same, and the colour of each: (count, 3), linear."""
        places, colors = _rows(count), _rows(count)
        self._draw(places, colors, seed, threads, progress)
        return places, colors

    def _draw(
        self,
        places: NDArray[np.float64],
        colors: NDArray[np.float64] | None,
        seed: int,
        threads: int,
        progress: Progress,
    ) -> None:
        with watching(progress) as told:
            _warn(_core.points(self._read, places, colors, seed, threads, told))

    #: Renders it, with the options of `pxm render` as keywords.
    render = _render

    def _repr_html_(self) -> str:
        """A small picture of it, and its text."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", PxmWarning)
            png = base64.b64encode(_render(self, size=(240, 180), progress=False).png()).decode()
        return (
            f'<img src="data:image/png;base64,{png}" width="240" height="180">'
            f"<details><summary>{html.escape(self.path)}</summary>"
            f"<pre>{html.escape(self.text[:20000])}</pre></details>"
        )

    def __repr__(self) -> str:
        return f"<pxm.Scene {self.path!r}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.path, self.text, self._read.allowed)


def _again(path: str, text: str, allowed: list[str]) -> Scene:
    """A scene that came from another process."""
    return Scene(text, name=path, allow=allowed)


#: What may be rendered: a scene, its name or path, or objects.
Source = Union[Scene, str, "os.PathLike[str]", System, Object]


def scene_of(source: Source) -> Scene:
    """The scene that is meant; text in the scene language is Scene(text)."""
    if isinstance(source, Scene):
        return source
    if isinstance(source, (System, Object)):
        return Scene(source)
    return Scene.read(source)


def _read(
    path: str,
    text: str | None,
    allow: Iterable[str | os.PathLike[str]],
    settings: Mapping[str, Any] | None,
) -> _core.ReadScene:
    return _core.ReadScene(
        path,
        text,
        [os.fspath(folder) for folder in allow],
        [f"{key}={setting_text(value)}" for key, value in (settings or {}).items()],
    )


def _rows(count: int) -> NDArray[np.float64]:
    if count < 1:
        raise ValueError(f"count: found {count}, expected 1 or more")
    return np.empty((count, 3))


def _system(
    name: str,
    maps: list[
        tuple[str, tuple[float, ...], tuple[float, float, float, float] | None, float | None]
    ],
    follow: list[tuple[int | str, list[int | str]]],
    start: list[int | str],
) -> System:
    names = [called or f"map{i + 1}" for i, (called, _, _, _) in enumerate(maps)]
    weights = [weight for _, _, _, weight in maps]
    colors = [color for _, _, color, _ in maps]
    return System(
        np.array([matrix for _, matrix, _, _ in maps]).reshape(-1, 3, 4),
        name=name,
        names=names,
        follow=dict(follow) if follow else None,
        start=start or None,
        weights=None if None in weights else np.array(weights, dtype=np.float64),
        colors=None
        if all(color is None for color in colors)
        else [color or (0.0, 0.0, 0.0, 0.0) for color in colors],
    )


def _on_machine(
    model: Callable[Concatenate[Scene, P], Picture]
) -> Callable[Concatenate[Machine, Source, P], Picture]:
    @wraps(model)
    def render(self: Machine, scene: Source, /, *args: P.args, **options: P.kwargs) -> Picture:
        options["machine"], options["cost_model"] = self.model, self.cost_model
        return model(scene_of(scene), *args, **options)

    return render


class Machine:
    """A simulated Pixel Machine of a model: `pxm models` says which there are."""

    def __init__(
        self, model: str = "964", *, cost_model: str | os.PathLike[str] | None = None
    ) -> None:
        known = {name: (columns, rows) for name, columns, rows in _core.models()}
        if model not in known:
            raise ValueError(f"model: found {model!r}, expected one of {', '.join(known)}")
        self.model = model
        self.columns, self.rows = known[model]
        self.cost_model = cost_model

    #: Renders a scene on it, with the options of Scene.render(); Picture.nodes has what each node
    #: counted.
    render = _on_machine(_render)

    def __repr__(self) -> str:
        return f"<pxm.Machine {self.model!r}, {self.columns}x{self.rows} nodes>"


def models() -> tuple[str, ...]:
    """The names of all models of the machine."""
    return tuple(name for name, _, _ in _core.models())


def scene_names() -> tuple[str, ...]:
    """The scenes that Scene.read() finds by name."""
    return tuple(_core.scene_names())
