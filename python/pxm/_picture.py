"""A rendered picture: what is known of each pixel, as arrays that are the memory it was rendered to."""
from __future__ import annotations

import json
import os
import struct
import zlib
from collections.abc import Iterable
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core

_LAYOUT = _core.pixel_layout()

#: One pixel of Picture.pixels.
PIXEL = np.dtype(
    {
        "names": [name for name, _, _ in _LAYOUT],
        "formats": [form for _, form, _ in _LAYOUT],
        "offsets": [offset for _, _, offset in _LAYOUT],
        "itemsize": 64,
    }
)

#: One node of Picture.nodes: what a node of the simulated machine counted.
NODE = np.dtype(
    [("id", "i4"), ("column", "i4"), ("row", "i4")]
    + [
        (name, "u8")
        for name in (
            "instructions",
            "cycles",
            "pixels",
            "eye_rays",
            "light_rays",
            "reflect_rays",
            "hits",
            "volumes_tested",
            "heap_pushes",
            "heap_peak",
            "heap_overflows",
            "restarts",
            "capped_rays",
        )
    ]
)

#: Channels by their names on the command line (--aov), and the fields of a pixel that they are.
_CHANNELS = {"Z": "z", "N": "normal"} | {
    name: name
    for name in ("node", "cycles", "volumes", "level", "heap", "alpha", "object", "word")
}


def _png(pixels: NDArray[np.uint8]) -> bytes:
    """The bytes of a PNG of three channels of 8 bits."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    rows, columns, _ = pixels.shape
    lines = np.zeros((rows, 1 + 3 * columns), np.uint8)  # each line's filter, 0, stands before it
    lines[:, 1:] = pixels.reshape(rows, 3 * columns)
    head = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", head)
        + chunk(b"sRGB", b"\0")
        + chunk(b"IDAT", zlib.compress(lines.tobytes(), 1))
        + chunk(b"IEND", b"")
    )


class Picture:
    """What a render gives. Arrays have a row a row of the picture, from the top; they share memory
    with each other, and none is a copy."""

    def __init__(self, rendered: _core.Rendered) -> None:
        self._rendered = rendered
        flat = np.frombuffer(rendered, dtype=PIXEL)  # type: ignore[call-overload]
        #: Everything: a structured array of PIXEL.
        self.pixels: NDArray[Any] = flat.reshape(rendered.rows, rendered.columns)
        #: What is doubtful, for the user; also told as a PxmWarning.
        self.warnings: str = rendered.warnings

    @property
    def shape(self) -> tuple[int, int]:
        """Rows, columns."""
        return self._rendered.rows, self._rendered.columns

    @property
    def window(self) -> tuple[int, int, int, int]:
        """x0, y0, x1, y1 of the image: what was rendered of it."""
        return self._rendered.window

    @property
    def color(self) -> NDArray[np.float32]:
        """Linear red, green and blue: (rows, columns, 3)."""
        return self.pixels["color"]

    @property
    def depth(self) -> NDArray[np.float32]:
        """The distance along the ray, in world units; infinite where nothing was hit."""
        return self.pixels["z"]

    @property
    def normal(self) -> NDArray[np.float32]:
        """The total normal: (rows, columns, 3)."""
        return self.pixels["normal"]

    @property
    def word(self) -> NDArray[np.uint32]:
        """A hash of the terminal cell's word, of 24 bits; 0 where nothing was hit."""
        return self.pixels["word"]

    @property
    def hit(self) -> NDArray[np.bool_]:
        """Where something was hit."""
        return np.isfinite(self.depth)

    def aov(self, name: str) -> NDArray[Any]:
        """A channel by its name on the command line: Z, N, word, node, cycles, volumes, ..."""
        if name not in _CHANNELS:
            raise ValueError(f"aov: found {name!r}, expected one of {', '.join(_CHANNELS)}")
        return self.pixels[_CHANNELS[name]]

    @cached_property
    def statistics(self) -> dict[str, Any]:
        """What the render counted and measured: the JSON of `pxm render --stats`."""
        found: dict[str, Any] = json.loads(self._rendered.statistics())
        return found

    @cached_property
    def nodes(self) -> NDArray[Any]:
        """What each node of the machine counted: a structured array of NODE; empty of a native render."""
        return np.array(self._rendered.nodes(), dtype=NODE)

    def srgb(self) -> NDArray[np.uint8]:
        """The colours as a PNG has them: (rows, columns, 3) of 8 bits, a new array."""
        bytes_ = np.empty((*self.shape, 3), np.uint8)
        self._rendered.put_srgb(bytes_.reshape(-1))
        return bytes_

    def png(self) -> bytes:
        """The picture as a PNG file in memory."""
        return _png(self.srgb())

    def save(self, path: str | os.PathLike[str], aovs: Iterable[str] = ()) -> None:
        """Writes a file, whole or not at all: its format is that of the extension. An EXR has room
        for `aovs`."""
        self._rendered.save(os.fspath(path), ",".join(aovs))

    def _repr_png_(self) -> bytes:
        return self.png()

    def __repr__(self) -> str:
        rows, columns = self.shape
        return f"<pxm.Picture of {columns}x{rows} pixels, {int(self.hit.sum())} hit>"
