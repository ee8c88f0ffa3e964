"""What is known of a scene before a ray is cast: what `pxm inspect` says (docs/inspect.md)."""
from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

Point = tuple[float, float, float]


@dataclass(frozen=True)
class Sphere:
    """A ball that holds the attractor."""

    center: Point
    radius: float


@dataclass(frozen=True)
class Box:
    """A box along the axes that holds the attractor."""

    low: Point
    high: Point


@dataclass(frozen=True)
class MapFacts:
    """One map of a system."""

    name: str
    matrix: tuple[float, ...]  # as the scene language writes it: rows, then the translation
    kind: str
    determinant: float
    singular_values: Point  # the largest first
    lipschitz: float
    lipschitz_determinant_bound: float
    condition: float | None
    fixed_point: Point | None
    follow: tuple[str, ...] | None  # None: of so many maps they are not listed
    follow_set: int


@dataclass(frozen=True)
class BoxScale:
    """Boxes of one size that the attractor meets."""

    side: float
    boxes: int


@dataclass(frozen=True)
class DimensionFacts:
    """The dimensions of an attractor, and what is known of them."""

    similarity: float | None
    similarity_error: float | None
    affinity: float | None
    affinity_upper: float | None
    affinity_exact: bool
    affinity_why: str
    box_counting: float | None
    box_counting_error: float | None
    box_counting_scales: tuple[BoxScale, ...]
    hull: int  # dimensions of the line, plane or space that it lies in
    upper: float | None  # no dimension is larger
    exact: float | None  # where it is known
    meaning: str


@dataclass(frozen=True)
class SystemFacts:
    """One system of the scene."""

    name: str
    maps: tuple[MapFacts, ...]
    contractivity: float
    contraction_proof: str
    start: tuple[str, ...]
    components: tuple[tuple[str, ...], ...]
    complete: bool
    strongly_connected: bool
    unreachable: tuple[str, ...]
    dead_ends: tuple[str, ...]
    bounding_sphere: Sphere
    bounding_box: Box
    dimension: DimensionFacts
    open_set_condition: str
    open_set_why: str
    totally_disconnected: bool | None
    totally_disconnected_why: str


@dataclass(frozen=True)
class ObjectFacts:
    """One object of the scene, and its bounding volume."""

    name: str
    ifs: str | None
    volume: str
    short_by: float
    sphere_slack: float | None


@dataclass(frozen=True)
class MemoryUse:
    """What a memory of a node holds, in bytes."""

    limit_bytes: int
    used_bytes: int


@dataclass(frozen=True)
class Inspection:
    """All of it; `json` has what `pxm inspect --json` writes."""

    scene: str
    systems: Mapping[str, SystemFacts]
    objects: tuple[ObjectFacts, ...]
    memory: Mapping[str, MemoryUse]  # of a node, by its name
    over_limit: bool  # a node of the machine has no room for the scene
    json: Mapping[str, Any]


def _point(values: list[float]) -> Point:
    return (values[0], values[1], values[2])


def _map(facts: dict[str, Any]) -> MapFacts:
    return MapFacts(
        name=facts["name"],
        matrix=tuple(facts["matrix"]),
        kind=facts["kind"],
        determinant=facts["determinant"],
        singular_values=_point(facts["singular_values"]),
        lipschitz=facts["lipschitz"],
        lipschitz_determinant_bound=facts["lipschitz_determinant_bound"],
        condition=facts["condition"],
        fixed_point=None if facts["fixed_point"] is None else _point(facts["fixed_point"]),
        follow=None if facts["follow"] is None else tuple(facts["follow"]),
        follow_set=facts["follow_set"],
    )


def _dimension(facts: dict[str, Any]) -> DimensionFacts:
    scales = tuple(BoxScale(one["side"], one["boxes"]) for one in facts["box_counting_scales"])
    names = [
        name for name in DimensionFacts.__dataclass_fields__ if name != "box_counting_scales"
    ]
    return DimensionFacts(
        box_counting_scales=scales, **{name: facts[name] for name in names}
    )


def _system(name: str, facts: dict[str, Any]) -> SystemFacts:
    sphere, box = facts["bounding_sphere"], facts["bounding_box"]
    return SystemFacts(
        name=name,
        maps=tuple(_map(one) for one in facts["maps"]),
        contractivity=facts["contractivity"],
        contraction_proof=facts["contraction_proof"],
        start=tuple(facts["start"]),
        components=tuple(tuple(one) for one in facts["components"]),
        complete=facts["complete"],
        strongly_connected=facts["strongly_connected"],
        unreachable=tuple(facts["unreachable"]),
        dead_ends=tuple(facts["dead_ends"]),
        bounding_sphere=Sphere(_point(sphere["center"]), sphere["radius"]),
        bounding_box=Box(_point(box["min"]), _point(box["max"])),
        dimension=_dimension(facts["dimension"]),
        open_set_condition=facts["open_set_condition"],
        open_set_why=facts["open_set_why"],
        totally_disconnected=facts["totally_disconnected"],
        totally_disconnected_why=facts["totally_disconnected_why"],
    )


def inspection_of(text: str) -> Inspection:
    """Of the JSON that the compiled part writes."""
    facts: dict[str, Any] = json.loads(text)
    memory = facts["memory"]
    return Inspection(
        scene=facts["scene"],
        systems={name: _system(name, one) for name, one in facts["ifs"].items()},
        objects=tuple(
            ObjectFacts(
                one["name"], one["ifs"], one["volume"], one["short_by"], one["sphere_slack"]
            )
            for one in facts["objects"]
        ),
        memory={
            name: MemoryUse(use["limit_bytes"], use["used_bytes"])
            for name, use in memory.items()
            if isinstance(use, dict)
        },
        over_limit=bool(memory["over_limit"]),
        json=facts,
    )
