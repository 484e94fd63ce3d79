"""The one family of exceptions that freebody raises.

Every message names the argument (or the file, line and key), says what came and what is allowed.
"""

from __future__ import annotations

__all__ = [
    "BodyError",
    "FreebodyError",
    "InputError",
    "ModelFileError",
    "NonFiniteError",
    "SingularChartError",
]


class FreebodyError(Exception):
    """Base of every error that freebody raises on purpose."""


class InputError(FreebodyError, ValueError):
    """An argument that cannot be used: which one, what came, what is allowed, what to do."""


class BodyError(InputError):
    """A rigid body that cannot exist: its name, the rule it breaks, the numbers, the nearest fix."""


class SingularChartError(FreebodyError):
    """Orientation angles were asked for where they do not exist; the message says the angle."""


class NonFiniteError(FreebodyError):
    """A result that is not finite although its arguments are: where, and at which state."""


class ModelFileError(FreebodyError):
    """A model file that cannot be used.

    Attributes
    ----------
    file, line, key
        Where the fault stands: path, line counted from 1, dotted key. `None` where unknown.
    """

    def __init__(
        self, message: str, *, file: str | None = None, line: int | None = None, key: str | None = None
    ) -> None:
        super().__init__(message)
        self.file, self.line, self.key = file, line, key

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line) if part is not None)
        return ": ".join(part for part in (place, self.key, self.args[0]) if part)
