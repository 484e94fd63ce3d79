"""Functions of traced numbers, from those that the graph has."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from freebody.tracing.arithmetic import absolute, add, divide, multiply, sqrt, square, subtract
from freebody.tracing.comparison import choose, less_equal
from freebody.tracing.scalar import Scalar, as_scalar, binary, constant, dimensionless, unary, unify
from freebody.units import DIMENSIONLESS

__all__ = [
    "arccos",
    "arccosh",
    "arcsin",
    "arcsinh",
    "arctan",
    "arctan2",
    "arctanh",
    "cos",
    "cosh",
    "degrees",
    "exp",
    "exp2",
    "expm1",
    "log",
    "log1p",
    "log2",
    "log10",
    "radians",
    "sin",
    "sinh",
    "tan",
    "tanh",
]


def _function(op: str, name: str) -> Callable[[Any], Scalar]:
    def call(a: Any) -> Scalar:
        a = as_scalar(a)
        return unary(op, a, dimensionless(f"np.{name}", a))

    return call


def _scaled_log(scale: float, name: str) -> Callable[[Any], Scalar]:
    def call(a: Any) -> Scalar:
        a = as_scalar(a)
        dimensionless(f"np.{name}", a)
        return divide(log(a), constant(scale))

    return call


exp, log = _function("exp", "exp"), _function("ln", "log")
sin, cos, tan = _function("sin", "sin"), _function("cos", "cos"), _function("tan", "tan")
arcsin, arccos, arctan = _function("asin", "arcsin"), _function("acos", "arccos"), _function("atan", "arctan")
sinh, cosh, tanh = _function("sinh", "sinh"), _function("cosh", "cosh"), _function("tanh", "tanh")
log2, log10 = _scaled_log(math.log(2.0), "log2"), _scaled_log(math.log(10.0), "log10")


def exp2(a: Any) -> Scalar:
    a = as_scalar(a)
    return binary("pow", as_scalar(2.0), a, dimensionless("np.exp2", a))


def expm1(a: Any) -> Scalar:
    # e^x - 1 = tanh(x/2) (e^x + 1), without cancellation.
    a = as_scalar(a)
    return multiply(tanh(multiply(constant(0.5), a)), add(exp(a), 1.0))


def log1p(a: Any) -> Scalar:
    # Near zero 2 artanh(x/(2 + x)) by its series, which ends below the rounding; elsewhere nothing cancels.
    a = as_scalar(a)
    dimensionless("np.log1p", a)
    z = divide(a, add(constant(2.0), a))
    zz = multiply(z, z)
    series = constant(1 / 13)
    for n in (11, 9, 7, 5, 3, 1):
        series = add(multiply(series, zz), constant(1 / n))
    near = multiply(multiply(constant(2.0), z), series)
    return choose(less_equal(absolute(a), 0.125), near, log(add(1.0, a)), DIMENSIONLESS)


def _odd(f: Callable[[Scalar], Scalar], name: str) -> Callable[[Any], Scalar]:
    """An odd function from its right half."""

    def call(a: Any) -> Scalar:
        a = as_scalar(a)
        dimensionless(f"np.{name}", a)
        sign = choose(less_equal(0.0, a), 1.0, -1.0, DIMENSIONLESS)
        return multiply(sign, f(multiply(sign, a)))

    return call


def _arcsinh(a: Scalar) -> Scalar:
    aa = square(a)
    return log1p(add(a, divide(aa, add(1.0, sqrt(add(1.0, aa))))))


def _arctanh(a: Scalar) -> Scalar:
    return multiply(constant(0.5), log1p(divide(multiply(constant(2.0), a), subtract(1.0, a))))


def arccosh(a: Any) -> Scalar:
    a = as_scalar(a)
    dimensionless("np.arccosh", a)
    above = subtract(a, 1.0)
    return log1p(add(above, sqrt(multiply(above, add(a, 1.0)))))


def arctan2(a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    unify("np.arctan2 of", a, b)
    return binary("atan2", a, b, DIMENSIONLESS)


def _turned(factor: float) -> Callable[[Any], Scalar]:
    def call(a: Any) -> Scalar:
        a = as_scalar(a)
        return multiply(a, constant(factor))

    return call


arcsinh, arctanh = _odd(_arcsinh, "arcsinh"), _odd(_arctanh, "arctanh")
radians, degrees = _turned(math.pi / 180.0), _turned(180.0 / math.pi)
