"""Arithmetic, powers and rounding of traced numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from freebody.tracing.comparison import choose, less_equal
from freebody.tracing.scalar import (
    Condition,
    Scalar,
    as_scalar,
    binary,
    constant,
    dimensionless,
    unary,
    unify,
    with_unit,
)
from freebody.tracing.trace import current
from freebody.units import DIMENSIONLESS, scaled, times

__all__ = [
    "absolute",
    "add",
    "cbrt",
    "ceil",
    "copysign",
    "divide",
    "floor",
    "floor_divide",
    "hypot",
    "multiply",
    "negative",
    "positive",
    "power",
    "reciprocal",
    "remainder",
    "root_of_squares",
    "sqrt",
    "square",
    "subtract",
    "trunc",
]


def add(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    return binary("add", a, b, unify("adds", a, b))


def subtract(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    return binary("sub", a, b, unify("subtracts", a, b))


def multiply(a: Any, b: Any) -> Scalar:
    # A truth is 1 or 0 here, as in NumPy: (x > 0) * x.
    a, b = (choose(v, 1.0, 0.0, DIMENSIONLESS) if isinstance(v, Condition) else as_scalar(v) for v in (a, b))
    return binary("mul", a, b, None if a.unit is None or b.unit is None else times(a.unit, b.unit))


def divide(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    return binary("div", a, b, None if a.unit is None or b.unit is None else times(a.unit, b.unit, -1))


def reciprocal(a: Any) -> Scalar:
    return divide(constant(1.0), a)


def negative(a: Any) -> Scalar:
    a = as_scalar(a)
    return unary("neg", a, a.unit)


def positive(a: Any) -> Scalar:
    return as_scalar(a)


def absolute(a: Any) -> Scalar:
    a = as_scalar(a)
    return unary("abs", a, a.unit)


def copysign(a: Any, b: Any) -> Scalar:
    size = absolute(a)
    return choose(less_equal(constant(0.0, as_scalar(b).unit), b), size, negative(size), size.unit)


def square(a: Any) -> Scalar:
    return multiply(a, a)


def sqrt(a: Any) -> Scalar:
    a = as_scalar(a)
    return unary("sqrt", a, None if a.unit is None else scaled(a.unit, Fraction(1, 2)))


def cbrt(a: Any) -> Scalar:
    a = as_scalar(a)
    third = binary("pow", unary("abs", a, None), as_scalar(1 / 3), None)
    unit = None if a.unit is None else scaled(a.unit, Fraction(1, 3))
    return choose(less_equal(constant(0.0, a.unit), a), third, negative(third), unit)


def root_of_squares(a: Scalar) -> Scalar:
    """A length from its square. At zero its derivative is taken as zero, where that of the root is none."""
    zero = constant(0.0, a.unit)
    unit = None if a.unit is None else scaled(a.unit, Fraction(1, 2))
    return choose(less_equal(a, zero), with_unit(a, unit), sqrt(a), unit)


def hypot(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    unify("np.hypot of", a, b)
    return root_of_squares(add(square(a), square(b)))


def power(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    exponent = current(b.trace).graph.value(b.node)
    if exponent is None:
        dimensionless("a power with a traced exponent", a)
        dimensionless("the exponent", b)
        return binary("pow", a, b, a.unit)
    unit = None if a.unit is None else scaled(a.unit, Fraction(exponent).limit_denominator(1000))
    twice = 2.0 * exponent
    # Products are faster than the function and right for negative numbers; their rounding grows with them.
    if not (twice.is_integer() and 0 < abs(twice) <= 16):
        return binary("pow", a, b, unit)
    bare = with_unit(a, None)
    whole = _whole_power(bare, int(abs(exponent)))
    result = whole
    if not exponent.is_integer():
        result = unary("sqrt", bare, None) if whole is None else multiply(whole, unary("sqrt", bare, None))
    assert result is not None
    return with_unit(result if exponent > 0 else divide(1.0, result), unit)


def _whole_power(a: Scalar, n: int) -> Scalar | None:
    result = None
    while n:
        if n % 2:
            result = a if result is None else multiply(result, a)
        n //= 2
        a = multiply(a, a) if n else a
    return result


def floor(a: Any) -> Scalar:
    a = as_scalar(a)
    return unary("floor", a, a.unit)


def ceil(a: Any) -> Scalar:
    return negative(floor(negative(a)))


def trunc(a: Any) -> Scalar:
    a = as_scalar(a)
    return choose(less_equal(constant(0.0, a.unit), a), floor(a), ceil(a), a.unit)


def floor_divide(a: Any, b: Any) -> Scalar:
    return floor(divide(a, b))


def remainder(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    unit = unify("takes the remainder of", a, b)
    whole = with_unit(floor_divide(a, b), DIMENSIONLESS)
    return with_unit(subtract(with_unit(a, None), with_unit(multiply(whole, b), None)), unit)
