"""How far a render is: a line on a terminal, a bar in a notebook, or what the caller wants."""
from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

#: None: shown where somebody looks; False: not at all; else called with the share that is done.
Progress = Callable[[float], object] | bool | None

_PATIENCE = 0.5  # seconds: what takes less shows nothing


class _Line:
    """A line on a terminal, which is wiped at the end."""

    def __init__(self) -> None:
        self._width = 0

    def show(self, share: float) -> None:
        filled = int(share * 30)
        text = f"[{'#' * filled}{'-' * (30 - filled)}] {share * 100:3.0f} %"
        self._width = len(text)
        sys.stderr.write("\r" + text)
        sys.stderr.flush()

    def end(self) -> None:
        if self._width:
            sys.stderr.write("\r" + " " * self._width + "\r")
            sys.stderr.flush()


class _Bar:
    """A bar below a notebook's cell, which goes when the work is done."""

    def __init__(self, display: Callable[..., Any]) -> None:
        self._display = display
        self._handle: Any = None

    def show(self, share: float) -> None:
        bar = {"text/html": f'<progress value="{share:.3f}"></progress> {share * 100:.0f} %'}
        if self._handle is None:
            self._handle = self._display(bar, raw=True, display_id=True)
        else:
            self._handle.update(bar, raw=True)

    def end(self) -> None:
        if self._handle is not None:
            self._handle.update({"text/html": ""}, raw=True)


def _shown() -> _Line | _Bar | None:
    """Where progress is seen; None: nowhere."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    if shell is not None and type(shell).__name__ == "ZMQInteractiveShell":
        return _Bar(import_module("IPython.display").display)
    return _Line() if sys.stderr is not None and sys.stderr.isatty() else None


@contextmanager
def watching(progress: Progress) -> Iterator[Callable[[float], object] | None]:
    """What the compiled part calls."""
    if callable(progress):
        yield progress
        return
    shown = None if progress is False else _shown()
    if shown is None:
        yield None
        return
    try:
        yield _patient(shown)
    finally:
        shown.end()


def _patient(shown: _Line | _Bar) -> Callable[[float], None]:
    begin = time.monotonic()

    def tell(share: float) -> None:
        if share < 1 and time.monotonic() - begin > _PATIENCE:  # at 1 it would go at once
            shown.show(share)

    return tell
