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
    "StoreError",
    "TraceError",
    "TrimError",
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


class StoreError(FreebodyError):
    """A store of runs that cannot be begun, continued or written: which one, why, what to do."""


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


class TraceError(InputError):
    """A law that cannot be traced: which function, where, what happened, what to write instead.

    Attributes
    ----------
    function, file, line, text
        Name of the law, path, line counted from 1, and what stands there. `None` where unknown.
    """

    def __init__(
        self,
        message: str,
        *,
        function: str | None = None,
        file: str | None = None,
        line: int | None = None,
        text: str | None = None,
    ) -> None:
        super().__init__(message)
        self.function, self.file, self.line, self.text = function, file, line, text

    def __str__(self) -> str:
        place = None if self.file is None else f"{self.file}:{self.line}"
        head = ": ".join(part for part in (self.function, place, self.args[0]) if part)
        return f"{head}\n    {self.text}" if self.text else head


class TrimError(FreebodyError):
    """No steady flight was found; the message says which rates remain."""
