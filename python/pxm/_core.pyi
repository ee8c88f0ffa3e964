"""What the compiled part of pxm offers to the rest of it."""
from collections.abc import Callable
from typing import Any

version: str

Progress = Callable[[float], object] | None

class ReadScene:
    def __init__(
        self, path: str, text: str | None, allowed: list[str], settings: list[str]
    ) -> None: ...
    @property
    def path(self) -> str: ...
    @property
    def allowed(self) -> list[str]: ...
    def frames(self) -> int: ...
    def text(self) -> str: ...
    def systems(
        self,
    ) -> list[
        tuple[
            str,
            list[
                tuple[
                    str,
                    tuple[float, ...],
                    tuple[float, float, float, float] | None,
                    float | None,
                ]
            ],
            list[tuple[int | str, list[int | str]]],
            list[int | str],
        ]
    ]: ...
    def inspect(self, progress: Progress = None) -> str: ...

class Options:
    size: str
    crop: str
    shading: str
    covers: str
    intersect: str
    numeric: str
    lipschitz: str
    volume: str
    machine: str
    cost_model: str
    levels: int | None
    samples: int | None
    heap: int | None
    detail: float | None
    zoom: float
    frame: float
    threads: int
    def __init__(self) -> None: ...

class Rendered:
    @property
    def columns(self) -> int: ...
    @property
    def rows(self) -> int: ...
    @property
    def window(self) -> tuple[int, int, int, int]: ...
    @property
    def warnings(self) -> str: ...
    @property
    def pixel_at_eye(self) -> float: ...
    @property
    def pixel_growth(self) -> float: ...
    def statistics(self) -> str: ...
    def nodes(self) -> list[tuple[int, ...]]: ...
    def put_srgb(self, to: Any) -> None: ...
    def save(self, path: str, aovs: str) -> None: ...

def scene_names() -> list[str]: ...
def render(scene: ReadScene, options: Options, progress: Progress) -> Rendered: ...
def pixel_layout() -> list[tuple[str, str, int]]: ...
def models() -> list[tuple[str, int, int]]: ...
def points(
    scene: ReadScene, places: Any, colors: Any, seed: int, threads: int, progress: Progress
) -> str: ...
