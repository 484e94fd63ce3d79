"""What elements are told: signals by name, or numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.tracing.declaration import check_name

__all__ = ["Command", "command", "held", "unit_vector", "within"]


class Command(NamedTuple):
    """A number that a law is told: an input of this name, or a parameter of it.

    Attributes
    ----------
    inputs, parameters
        What the law declares for it.
    """

    name: str
    inputs: Mapping[str, str]
    parameters: Mapping[str, tuple[float, str]]

    def value(self, s: Any, p: Any) -> Any:
        return s.inputs[self.name] if self.inputs else p[self.name]


def command(where: str, value: str | float, unit: str, parameter: str) -> Command:
    """Check a command: a word is the input of that name, a number is the parameter `parameter`."""
    if isinstance(value, str):
        check_name(where, value)
        return Command(value, {value: unit}, {})
    return Command(parameter, {}, {parameter: (_check.number(where, value), unit)})


def unit_vector(name: str, value: ArrayLike) -> Array:
    """Check a direction (3,) in body axes; scaled to length one."""
    given = _check.vector(name, value, 3)
    largest = float(np.abs(given).max())
    if largest == 0.0:
        raise InputError(f"{name}: got the zero vector; give a direction")
    return given / largest / np.linalg.norm(given / largest)


def within(name: str, value: object) -> tuple[float, float] | None:
    """Check limits (low, high)."""
    if value is None:
        return None
    low, high = _check.vector(name, value, 2)  # pyright: ignore[reportArgumentType]
    if not low < high:
        raise InputError(f"{name}: got {_check.shown(value)}; give (low, high), low first")
    return float(low), float(high)


def held(rate: Any, value: Any, limits: tuple[Any, Any] | None, time: Any) -> Any:
    """A rate that keeps a value within its limits, approached over `time` at the soonest."""
    if limits is None:
        return rate
    low, high = limits
    return np.clip(rate, (low - value) / time, (high - value) / time)
