"""Scenes by code: what each object says in the scene language (docs/scene-language.md)."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector = Sequence[float]


def number(value: float) -> str:
    """The shortest text that reads back the same."""
    if not np.isfinite(value):
        raise ValueError(f"found {value}, expected a finite number")
    return repr(float(value))


def numbers(values: Iterable[float]) -> str:
    return ",".join(number(value) for value in values)


def vector(name: str, values: Vector, count: int = 3) -> str:
    """`name: x,y,z`."""
    if len(values) != count:
        raise ValueError(f"{name}: found {len(values)} numbers, expected {count}")
    return f"    {name}: {numbers(values)}\n"


def _finite(name: str, values: ArrayLike) -> NDArray[np.float64]:
    array = np.asarray(values, dtype=np.float64)
    if not np.isfinite(array).all():
        where = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
        raise ValueError(f"{name}: found {array[where]} at {where}, expected finite numbers")
    return array


def _matrix(matrix: NDArray[np.float64]) -> str:
    """Of a matrix for columns: the language multiplies rows from the left."""
    linear = ", ".join(numbers(row) for row in matrix[:, :3].T)
    return f"matrix: {linear}, {numbers(matrix[:, 3])}"


class System:
    """An iterated function system, a recurrent one with `follow`.

    maps      (n, 3, 4): [A | t] of x' = A x + t
    names     of the maps; without, they have numbers
    follow    which maps may stand inside which: an (n, n) array of truth values, row i what may
              follow map i, or a mapping from a map to maps, each by its number from 0 or its name.
              Without, all may
    start     the maps that may be outermost
    weights   (n,): how likely each map is in points()
    colors    (n, 4): red, green, blue and how much of it, which a map paints over what is inside it
    """

    def __init__(
        self,
        maps: ArrayLike,
        *,
        name: str = "system",
        names: Sequence[str] | None = None,
        follow: ArrayLike | Mapping[int | str, Iterable[int | str]] | None = None,
        start: Iterable[int | str] | None = None,
        weights: ArrayLike | None = None,
        colors: ArrayLike | None = None,
    ) -> None:
        self.maps = _finite("maps", maps)
        if self.maps.ndim != 3 or self.maps.shape[0] == 0 or self.maps.shape[1:] != (3, 4):
            raise ValueError(f"maps: found the shape {self.maps.shape}, expected (n, 3, 4)")
        self.name = name
        self.names = tuple(names) if names is not None else None
        if self.names is not None and len(self.names) != len(self.maps):
            raise ValueError(
                f"names: found {len(self.names)} names, expected one of each of the {len(self.maps)} maps"
            )
        self.follow = None if follow is None else self._rules(follow)
        self.start = None if start is None else tuple(self._number(one) for one in start)
        self.weights = self._per_map("weights", weights, ())
        self.colors = self._per_map("colors", colors, (4,))

    def __len__(self) -> int:
        return len(self.maps)

    def __repr__(self) -> str:
        return f"<pxm.System {self.name!r} of {len(self)} maps>"

    def text(self) -> str:
        """The block `ifs` of the scene language."""
        lines = [f"ifs {self.name} {{\n"]
        for i, matrix in enumerate(self.maps):
            called = f" {self.names[i]}" if self.names is not None else ""
            lines.append(f"    newmap{called} {_matrix(matrix)}\n")
            if self.colors is not None:
                lines.append("    " + vector("color", list(self.colors[i]), 4))
            if self.weights is not None:
                lines.append(f"        weight: {number(self.weights[i])}\n")
        if self.follow is not None:
            for i in range(len(self)):
                followers = ", ".join(str(j + 1) for j in np.flatnonzero(self.follow[i]))
                lines.append(f"    follow: {i + 1} -> {followers}\n")
        if self.start is not None:
            lines.append(f"    start: {', '.join(str(i + 1) for i in self.start)}\n")
        return "".join([*lines, "}\n"])

    def _number(self, one: int | str) -> int:
        if isinstance(one, str):
            if self.names is None or one not in self.names:
                raise ValueError(f"found the map {one!r}, expected one of {self.names or 'none'}")
            return self.names.index(one)
        if not 0 <= int(one) < len(self.maps):
            raise ValueError(f"found the map {one}, expected 0 to {len(self.maps) - 1}")
        return int(one)

    def _rules(
        self, follow: ArrayLike | Mapping[int | str, Iterable[int | str]]
    ) -> NDArray[np.bool_]:
        n = len(self.maps)
        if isinstance(follow, Mapping):
            rules = np.zeros((n, n), np.bool_)
            for one, followers in follow.items():
                for other in followers:
                    rules[self._number(one), self._number(other)] = True
        else:
            rules = np.asarray(follow, dtype=np.bool_)
        if rules.shape != (n, n):
            raise ValueError(f"follow: found the shape {rules.shape}, expected ({n}, {n})")
        for i in np.flatnonzero(~rules.any(axis=1)):
            raise ValueError(f"follow: nothing may follow map {i}, which must go on for ever")
        return rules

    def _per_map(
        self, name: str, values: ArrayLike | None, shape: tuple[int, ...]
    ) -> NDArray[np.float64] | None:
        if values is None:
            return None
        array = _finite(name, values)
        expected = (len(self.maps), *shape)
        if array.shape != expected:
            raise ValueError(f"{name}: found the shape {array.shape}, expected {expected}")
        return array

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{self.names[i] if self.names is not None else i}</td><td>"
            + "<br>".join(" ".join(f"{x:.4g}" for x in row) for row in matrix)
            + "</td></tr>"
            for i, matrix in enumerate(self.maps[:20])
        )
        more = f"<tr><td colspan=2>and {len(self) - 20} more</td></tr>" if len(self) > 20 else ""
        return f"<table><caption>{self.name}</caption>{rows}{more}</table>"


@dataclass
class Object:
    """A system that is shown, and where: `matrix` is (3, 4), as a map's."""

    system: System
    name: str | None = None
    matrix: ArrayLike | None = None
    color: Vector | None = None  # red, green, blue and how much of it
    opacity: float | None = None
    diffuse: float | None = None
    reflect: float | None = None
    levels: int | None = None

    def text(self) -> str:
        lines = [f"object {self.name or self.system.name} {{\n    ifs: {self.system.name}\n"]
        if self.matrix is not None:
            matrix = _finite("matrix", self.matrix)
            if matrix.shape != (3, 4):
                raise ValueError(f"matrix: found the shape {matrix.shape}, expected (3, 4)")
            lines.append(f"    {_matrix(matrix)}\n")
        if self.color is not None:
            lines.append(vector("color", self.color, 4))
        for name in ("opacity", "diffuse", "reflect"):
            value = getattr(self, name)
            if value is not None:
                lines.append(f"    {name}: {number(value)}\n")
        if self.levels is not None:
            lines.append(f"    levels: {int(self.levels)}\n")
        return "".join([*lines, "}\n"])


@dataclass
class Camera:
    """Where the picture is taken from; what is None has the default of the scene language."""

    eye: Vector | None = None
    look: Vector | None = None
    up: Vector | None = None
    fov: float | None = None  # degrees, horizontal
    orthographic: float | None = None  # width of the picture in the world
    zoom: float | None = None

    def text(self) -> str:
        lines = ["camera {\n"]
        for name in ("eye", "look", "up"):
            value = getattr(self, name)
            if value is not None:
                lines.append(vector(name, value))
        for name in ("fov", "orthographic", "zoom"):
            value = getattr(self, name)
            if value is not None:
                lines.append(f"    {name}: {number(value)}\n")
        return "".join([*lines, "}\n"])


@dataclass
class Light:
    """A light with either a direction, from the surface to it, or a position."""

    direction: Vector | None = None
    position: Vector | None = None
    color: Vector = (1.0, 1.0, 1.0)
    shadow: bool = False

    def text(self) -> str:
        if (self.direction is None) == (self.position is None):
            raise ValueError("a light has either a direction or a position")
        if self.direction is not None:
            place = vector("direction", self.direction)
        else:
            assert self.position is not None
            place = vector("position", self.position)
        shadow = "on" if self.shadow else "off"
        return f"light {{\n{place}{vector('color', self.color)}    shadow: {shadow}\n}}\n"


@dataclass
class Plane:
    """An endless floor or wall."""

    normal: Vector = (0.0, 1.0, 0.0)
    point: Vector = (0.0, 0.0, 0.0)
    color: Vector = (0.9, 0.9, 0.9)
    reflect: float = 0.0

    def text(self) -> str:
        return (
            f"plane {{\n{vector('point', self.point)}{vector('normal', self.normal)}"
            f"{vector('color', self.color)}    reflect: {number(self.reflect)}\n}}\n"
        )


def scene_text(
    shown: Sequence[System | Object],
    camera: Camera | None,
    lights: Iterable[Light],
    planes: Iterable[Plane],
    render: Mapping[str, Any],
) -> str:
    """The whole scene, each system once."""
    systems: dict[str, System] = {}
    for one in shown:
        system = one.system if isinstance(one, Object) else one
        if systems.setdefault(system.name, system) is not system:
            raise ValueError(f"two systems have the name {system.name!r}")
    blocks = [system.text() for system in systems.values()]
    objects = [one if isinstance(one, Object) else Object(one) for one in shown]
    names: set[str] = set()
    for thing in objects:
        name = thing.name or thing.system.name
        if name in names:
            raise ValueError(f"two objects have the name {name!r}: give them names")
        names.add(name)
        blocks.append(thing.text())
    blocks += [light.text() for light in lights]
    blocks += [plane.text() for plane in planes]
    if camera is not None:
        blocks.append(camera.text())
    if render:
        lines = "".join(f"    {key}: {setting_text(value)}\n" for key, value in render.items())
        blocks.append(f"render {{\n{lines}}}\n")
    return "".join(blocks)


def setting_text(value: Any) -> str:
    """What stands behind a directive's colon."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return number(float(value))
    return ",".join(setting_text(one) for one in value)
