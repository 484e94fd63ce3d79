"""Where tables and models of the environment end, and how that is told."""

from __future__ import annotations

import keyword
from collections.abc import Callable
from typing import Any, NamedTuple

from freebody import _check
from freebody.environment.place import Place
from freebody.errors import InputError

__all__ = ["Limit", "altitude_limits", "checked_word"]


class Limit(NamedTuple):
    """Where something ends.

    Attributes
    ----------
    name
        What ends.
    message
        Where, and what holds beyond.
    inside
        A number of a place, negative beyond.
    """

    name: str
    message: str
    inside: Callable[[Place], Any]


def altitude_limits(name: str, low: float | None, high: float, holds: tuple[str, str]) -> tuple[Limit, ...]:
    """The limits of what is known between two altitudes, m; `holds` says what holds below and above."""
    ends = f"{name} ends at {high:.15g} m, {holds[1]}"
    above = Limit(name, ends, lambda place: (high + _SLACK) - place.altitude)
    if low is None:
        return (above,)
    begins = f"{name} begins at {low:.15g} m, {holds[0]}"
    return Limit(name, begins, lambda place: place.altitude - (low - _SLACK)), above


# A body that starts on the border is inside, whatever rounding did to its altitude, m.
_SLACK = 1e-3


def checked_word(what: str, word: object) -> str:
    """Check the word before the names of parameters."""
    if not isinstance(word, str) or not word.isidentifier() or keyword.iskeyword(word) or word[0] == "_":
        raise InputError(f"{what}: got {_check.shown(word)}; give a word of letters, digits and _")
    return word
