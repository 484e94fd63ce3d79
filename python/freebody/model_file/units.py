"""Numbers with units, as people type them, turned into SI.

A number is SI. A string is a number, or a bracketed array of numbers, followed by one unit: `"0.155 slug"`,
`"[10, 20, 30] deg/s"`. A list may mix both.
"""

from __future__ import annotations

import ast
import math
import re
from functools import cache
from typing import Any

import numpy as np
import pint
from numpy.typing import NDArray

__all__ = ["FieldError", "Shape", "to_si"]

Shape = tuple[int | None, ...]

_NUMBER_AND_UNIT = re.compile(r"\s*(\[.*\]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*", re.DOTALL)

_KINDS = {
    "kg": "a mass",
    "m": "a length",
    "s": "a time",
    "rad": "an angle",
    "m/s": "a velocity",
    "rad/s": "an angular velocity",
    "m/s^2": "an acceleration",
    "kg m^2": "a moment of inertia",
    "N": "a force",
    "N m": "a moment of force",
    "m^3/s^2": "a gravitational parameter",
}


class FieldError(ValueError):
    """What is wrong with a value, and at which keys or indices inside it."""

    def __init__(self, message: str, at: tuple[int | str, ...] = ()) -> None:
        super().__init__(message)
        self.at = at


def to_si(value: Any, unit: str, *shapes: Shape) -> NDArray[np.float64]:
    """Array of one of `shapes` in the SI unit `unit`; `None` in a shape allows any length from one up.

    Raises `FieldError` for another shape, a string without unit, an unknown unit, another dimension, or a
    number that is not finite. An empty `unit` means plain numbers only.
    """
    wanted = f"needs {' or '.join(map(_count, shapes))}, {_kind(unit)}"
    try:
        array = np.array(_convert(value, unit, ()), dtype=float)
    except FieldError:
        raise
    except ValueError:
        raise FieldError(f"{wanted}; the rows differ in length") from None
    if array.size == 0 or not any(_fits(array.shape, shape) for shape in shapes):
        raise FieldError(f"{wanted}; came {_count(array.shape)}")
    return array


def _fits(shape: tuple[int, ...], wanted: Shape) -> bool:
    return len(shape) == len(wanted) and all(n in (None, m) for n, m in zip(wanted, shape, strict=True))


def _convert(value: Any, unit: str, at: tuple[int, ...]) -> Any:
    if isinstance(value, list):
        return [_convert(item, unit, (*at, i)) for i, item in enumerate(value)]
    if isinstance(value, str):
        return _read(value, unit, at)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise FieldError(f"needs {_kind(unit)}; came {value!r}", at)
    if not math.isfinite(value):
        raise FieldError(f"needs a finite number; came {value}", at)
    return float(value)


def _read(text: str, unit: str, at: tuple[int, ...]) -> Any:
    match = _NUMBER_AND_UNIT.fullmatch(text)
    if not unit:
        raise FieldError(f"needs plain numbers, without quotes and units; came {text!r}", at)
    if match is None:
        raise FieldError(f"needs {_kind(unit)}; came {text!r}, which does not start with a number", at)
    number, given = match.groups()
    if not given:
        raise FieldError(f'{text!r} has no unit: write "{number} {unit}", or {number} without quotes', at)
    factor = _factor(given, unit, at)
    try:
        numbers = ast.literal_eval(number)
    except (SyntaxError, ValueError):
        raise FieldError(f"{number!r} is not an array of numbers", at) from None
    return _scaled(_convert(numbers, "", at), factor)


def _scaled(numbers: Any, factor: float) -> Any:
    return [_scaled(item, factor) for item in numbers] if isinstance(numbers, list) else numbers * factor


@cache
def _registry() -> pint.UnitRegistry:
    return pint.UnitRegistry()


def _factor(given: str, unit: str, at: tuple[int, ...]) -> float:
    registry = _registry()
    try:
        one = registry.Quantity(1.0, registry.parse_units(given)).to_base_units()
    except pint.UndefinedUnitError:
        raise FieldError(f"unknown unit {given!r}; needs {_kind(unit)}", at) from None
    except (
        Exception
    ):  # pint's parser raises what its tokenizer does: SyntaxError, TypeError, AttributeError ...
        raise FieldError(f"cannot read the unit {given!r}; needs {_kind(unit)}", at) from None
    # Base units rather than dimensions are compared: pint counts an angle as dimensionless, so Hz would pass.
    if one.units != registry.Quantity(1.0, registry.parse_units(unit)).to_base_units().units:
        raise FieldError(f"{given!r} is no unit of {_kind(unit)}", at)
    return one.magnitude


def _kind(unit: str) -> str:
    return f"{_KINDS.get(unit, 'a value')} ({unit})" if unit else "a plain number"


def _count(shape: Shape) -> str:
    if not shape:
        return "one number"
    sizes = ["n" if n is None else str(n) for n in shape]
    return f"{' x '.join(sizes)} numbers"
