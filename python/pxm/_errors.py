"""What can go wrong, as exceptions."""
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Mistake:
    """One thing that is wrong in a scene's text, and where it stands."""

    file: str
    line: int  # from 1
    column: int  # in bytes, from 1
    message: str


class PxmError(Exception):
    """Of everything that pxm throws. Its text is the whole message."""


class SettingError(PxmError, ValueError):
    """An argument has a value that it cannot have."""


class SceneError(PxmError, ValueError):
    """A scene is wrong. The text shows each mistake with its line and a caret below its place."""

    def __init__(self, message: str, mistakes: tuple[Mistake, ...] = ()) -> None:
        super().__init__(message)
        self.mistakes = mistakes

    def __reduce__(self) -> tuple[type[SceneError], tuple[str, tuple[Mistake, ...]]]:
        return type(self), (str(self), self.mistakes)

    @property
    def file(self) -> str | None:
        """Of the first mistake, as line and column; None if it has no place in a text."""
        return self.mistakes[0].file if self.mistakes else None

    @property
    def line(self) -> int | None:
        """The line of the first mistake, from 1."""
        return self.mistakes[0].line if self.mistakes else None

    @property
    def column(self) -> int | None:
        """The column of the first mistake, in bytes, from 1."""
        return self.mistakes[0].column if self.mistakes else None


class FileError(PxmError, OSError):
    """A file cannot be read or written."""


class MachineLimitError(PxmError):
    """A memory of the simulated machine is too small."""


class PxmWarning(UserWarning):
    """What a render or a cloud of points may be doubted for."""


_CLASSES: dict[str, type[PxmError]] = {
    "setting": SettingError,
    "file": FileError,
    "machine_limit": MachineLimitError,
}


def error_of(kind: str, message: str, mistakes: list[tuple[str, int, int, str]]) -> PxmError:
    """The exception of an error of the compiled part, which calls this."""
    if kind == "scene":
        return SceneError(message, tuple(Mistake(*mistake) for mistake in mistakes))
    if kind == "setting":
        message = message.removeprefix("--")  # options of the program are arguments here
    return _CLASSES.get(kind, PxmError)(message)
