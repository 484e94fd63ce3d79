"""The element functions of NumPy that a law may call."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from freebody.tracing import analytic, arithmetic, comparison
from freebody.tracing.array import UFUNCS

__all__: list[str] = []

_ANALYTIC = (
    *(np.exp, np.exp2, np.expm1, np.log, np.log2, np.log10, np.log1p, np.radians, np.degrees),
    *(np.sin, np.cos, np.tan, np.arcsin, np.arccos, np.arctan, np.arctan2),
    *(np.sinh, np.cosh, np.tanh, np.arcsinh, np.arccosh, np.arctanh),
)
_ARITHMETIC = (
    *(np.add, np.subtract, np.multiply, np.divide, np.reciprocal, np.negative, np.positive, np.absolute),
    *(np.copysign, np.square, np.sqrt, np.cbrt, np.hypot, np.power),
    *(np.floor, np.ceil, np.trunc, np.floor_divide, np.remainder),
)
_COMPARISON = (
    *(np.less, np.less_equal, np.greater, np.greater_equal, np.maximum, np.minimum, np.sign, np.heaviside),
    *(np.logical_and, np.logical_or, np.logical_not, np.logical_xor),
)
_ALSO: dict[np.ufunc, Callable[..., Any]] = {
    np.deg2rad: analytic.radians,
    np.rad2deg: analytic.degrees,
    np.fabs: arithmetic.absolute,
    np.float_power: arithmetic.power,
    np.conjugate: arithmetic.positive,
    np.fmax: comparison.maximum,
    np.fmin: comparison.minimum,
    np.bitwise_and: comparison.logical_and,
    np.bitwise_or: comparison.logical_or,
    np.bitwise_xor: comparison.logical_xor,
    np.invert: comparison.logical_not,
}
# What a sum, a product ... over no elements is.
_IDENTITIES = {np.add: 0.0, np.multiply: 1.0, np.logical_and: True, np.logical_or: False}


def _elementwise(ufunc: np.ufunc, function: Callable[..., Any]) -> np.ufunc:
    return np.frompyfunc(function, ufunc.nin, 1, identity=_IDENTITIES.get(ufunc))


for _module, _ufuncs in ((analytic, _ANALYTIC), (arithmetic, _ARITHMETIC), (comparison, _COMPARISON)):
    UFUNCS.update({u: _elementwise(u, getattr(_module, u.__name__)) for u in _ufuncs})
UFUNCS.update({u: _elementwise(u, function) for u, function in _ALSO.items()})
