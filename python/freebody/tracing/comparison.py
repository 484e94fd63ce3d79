"""Comparisons of traced numbers, and choices by them.

The one primitive is `x where a <= b else y`; what a NaN chooses is therefore not always NumPy's.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody.tracing.scalar import Condition, Scalar, Unit, as_scalar, constant, unify, with_unit
from freebody.tracing.trace import current, fault
from freebody.units import DIMENSIONLESS

__all__ = [
    "choose",
    "clip",
    "greater",
    "greater_equal",
    "heaviside",
    "less",
    "less_equal",
    "logical_and",
    "logical_not",
    "logical_or",
    "logical_xor",
    "maximum",
    "minimum",
    "sign",
]


def choose(condition: Any, a: Any, b: Any, unit: Unit) -> Scalar:
    """The first where the condition holds, else the second."""
    a, b = as_scalar(a), as_scalar(b)
    if isinstance(condition, bool | np.bool_):
        return with_unit(a if condition else b, unit)
    if not isinstance(condition, Condition):
        raise fault("chooses by a number", "choose by a comparison: np.where(x > 0, a, b)")
    return Scalar(current(condition.trace), condition.choose(a.node, b.node), unit)


def less_equal(a: Any, b: Any) -> Condition:
    a, b = as_scalar(a), as_scalar(b)
    unify("compares", a, b)
    trace = current()
    return Condition(trace, lambda x, y: trace.select_le(a.node, b.node, x, y))


def less(a: Any, b: Any) -> Condition:
    return logical_not(less_equal(b, a))


def greater_equal(a: Any, b: Any) -> Condition:
    return less_equal(b, a)


def greater(a: Any, b: Any) -> Condition:
    return logical_not(less_equal(a, b))


def _condition(value: Any) -> Condition:
    if isinstance(value, Condition):
        current(value.trace)
        return value
    if isinstance(value, bool | np.bool_):
        return Condition(current(), lambda x, y: x if value else y)
    raise fault("joins conditions with a number", "join comparisons: np.logical_and(a > 0, b > 0)")


def logical_not(a: Any) -> Condition:
    a = _condition(a)
    return Condition(a.trace, lambda x, y: a.choose(y, x))


def logical_and(a: Any, b: Any) -> Condition:
    a, b = _condition(a), _condition(b)
    return Condition(a.trace, lambda x, y: a.choose(b.choose(x, y), y))


def logical_or(a: Any, b: Any) -> Condition:
    a, b = _condition(a), _condition(b)
    return Condition(a.trace, lambda x, y: a.choose(x, b.choose(x, y)))


def logical_xor(a: Any, b: Any) -> Condition:
    a, b = _condition(a), _condition(b)
    return Condition(a.trace, lambda x, y: a.choose(b.choose(y, x), b.choose(x, y)))


def maximum(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    return choose(less_equal(a, b), b, a, unify("takes the larger of", a, b))


def minimum(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    return choose(less_equal(a, b), a, b, unify("takes the smaller of", a, b))


def clip(a: Any, low: Any, high: Any) -> Scalar:
    a = as_scalar(a) if low is None else maximum(a, low)
    return a if high is None else minimum(a, high)


def sign(a: Any) -> Scalar:
    a = as_scalar(a)
    zero = constant(0.0, a.unit)
    below = choose(less_equal(zero, a), 0.0, -1.0, DIMENSIONLESS)
    return choose(less_equal(a, zero), below, 1.0, DIMENSIONLESS)


def heaviside(a: Any, at_zero: Any) -> Scalar:
    a = as_scalar(a)
    zero = constant(0.0, a.unit)
    below = choose(less_equal(zero, a), at_zero, 0.0, None)
    return choose(less_equal(a, zero), below, 1.0, as_scalar(at_zero).unit)
