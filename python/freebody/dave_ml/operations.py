"""The operators of MathML content markup, on numbers, arrays or traced values."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import reduce
from itertools import pairwise
from typing import Any, Literal, NamedTuple

import numpy as np

__all__ = ["CONSTANTS", "OPERATIONS", "Operation"]

CONSTANTS = {"pi": math.pi, "exponentiale": math.e, "true": 1.0, "false": 0.0}
_MANY = 10**6


class Operation(NamedTuple):
    """An operator: its function, how many arguments it takes, and of which kind these and its value are."""

    function: Callable[..., Any]
    least: int = 1
    most: int = 1
    takes: Literal["number", "truth"] = "number"
    gives: Literal["number", "truth"] = "number"
    qualifier: str | None = None


def _folded(function: Callable[[Any, Any], Any]) -> Callable[..., Any]:
    return lambda *arguments: reduce(function, arguments)


def _chained(function: Callable[[Any, Any], Any]) -> Callable[..., Any]:
    """A relation that holds between each argument and the next."""
    return lambda *arguments: reduce(np.logical_and, (function(a, b) for a, b in pairwise(arguments)))


def _minus(a: Any, *b: Any) -> Any:
    return np.subtract(a, *b) if b else np.negative(a)


def _root(a: Any, degree: Any = None) -> Any:
    """The square root has slope zero at zero: it is mostly that of a sum of squares, a length."""
    if degree is None:
        return np.where(np.absolute(a) <= 0.0, 0.0, np.sqrt(a))
    return np.power(a, 1.0 / degree)


def _log(a: Any, base: Any = None) -> Any:
    return np.log10(a) if base is None else np.log(a) / np.log(base)


def _different(a: Any, b: Any) -> Any:
    return np.logical_or(a < b, a > b)


def _equal(a: Any, b: Any) -> Any:
    return np.logical_and(a <= b, a >= b)


def _of_reciprocal(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    return lambda a: function(1.0 / a)


def _reciprocal(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    return lambda a: 1.0 / function(a)


_THREE: dict[str, tuple[Callable[[Any], Any], str]] = {
    "sin": (np.sin, "csc"),
    "cos": (np.cos, "sec"),
    "tan": (np.tan, "cot"),
    "sinh": (np.sinh, "csch"),
    "cosh": (np.cosh, "sech"),
    "tanh": (np.tanh, "coth"),
    "arcsin": (np.arcsin, "arccsc"),
    "arccos": (np.arccos, "arcsec"),
    "arctan": (np.arctan, "arccot"),
    "arcsinh": (np.arcsinh, "arccsch"),
    "arccosh": (np.arccosh, "arcsech"),
    "arctanh": (np.arctanh, "arccoth"),
}

OPERATIONS: dict[str, Operation] = {
    "plus": Operation(_folded(np.add), 1, _MANY),
    "minus": Operation(_minus, 1, 2),
    "times": Operation(_folded(np.multiply), 1, _MANY),
    "divide": Operation(np.divide, 2, 2),
    "power": Operation(np.power, 2, 2),
    "root": Operation(_root, qualifier="degree"),
    "exp": Operation(np.exp),
    "ln": Operation(np.log),
    "log": Operation(_log, qualifier="logbase"),
    "abs": Operation(np.absolute),
    "floor": Operation(np.floor),
    "ceiling": Operation(np.ceil),
    "quotient": Operation(
        np.divide, 2, 2
    ),  # so it is in DAVE-ML: basic_functions.dml of its authors has 6/5 = 1.2
    "rem": Operation(lambda a, b: a - b * np.trunc(a / b), 2, 2),
    "min": Operation(_folded(np.minimum), 1, _MANY),
    "max": Operation(_folded(np.maximum), 1, _MANY),
    "atan2": Operation(np.arctan2, 2, 2),
    "eq": Operation(_chained(_equal), 2, _MANY, gives="truth"),
    "neq": Operation(_different, 2, 2, gives="truth"),
    "lt": Operation(_chained(np.less), 2, _MANY, gives="truth"),
    "gt": Operation(_chained(np.greater), 2, _MANY, gives="truth"),
    "leq": Operation(_chained(np.less_equal), 2, _MANY, gives="truth"),
    "geq": Operation(_chained(np.greater_equal), 2, _MANY, gives="truth"),
    "and": Operation(_folded(np.logical_and), 1, _MANY, "truth", "truth"),
    "or": Operation(_folded(np.logical_or), 1, _MANY, "truth", "truth"),
    "xor": Operation(_folded(np.logical_xor), 1, _MANY, "truth", "truth"),
    "not": Operation(np.logical_not, 1, 1, "truth", "truth"),
    "implies": Operation(lambda a, b: np.logical_or(np.logical_not(a), b), 2, 2, "truth", "truth"),
    "as number": Operation(lambda a: np.where(a, 1.0, 0.0), 1, 1, "truth", "number"),
    "as truth": Operation(lambda a: _different(a, 0.0), 1, 1, "number", "truth"),
}
for _name, (_function, _other) in _THREE.items():
    OPERATIONS[_name] = Operation(_function)
    OPERATIONS[_other] = Operation((_of_reciprocal if _name.startswith("arc") else _reciprocal)(_function))
