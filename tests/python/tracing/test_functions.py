"""Every element function of NumPy that a law may call gives NumPy's numbers."""

import numpy as np
import pytest

from python.tracing.expressions import MATRIX, Expression, check

EXPRESSIONS: dict[str, Expression] = {
    "operators": lambda x, y, v, w, m: 2 * x + y / 3 - x * y + (-x) - (+y) + abs(x) + 1 / (3 + y),
    "numbers of NumPy": lambda x, y, v, w, m: np.float64(2) * x + np.ones(3) * y + np.int64(3) - v,
    "lists": lambda x, y, v, w, m: v + [1.0, 2.0, 3.0],  # noqa: RUF005
    "python powers": lambda x, y, v, w, m: [x**2, x**3, x**-2, abs(x) ** 0.5, abs(x) ** 2.5, x**0, 2.0**y],
    "other powers": lambda x, y, v, w, m: [abs(x) ** 1.3, pow(abs(x), -0.5), x**17, abs(x) ** y, x**1],
    "remainders": lambda x, y, v, w, m: [x % 0.7, x // 0.7, np.mod(x, -0.3), np.remainder(y, 1.1)],
    "element arithmetic": lambda x, y, v, w, m: [
        np.add(x, y),
        np.subtract(x, y),
        np.multiply(x, y),
        np.divide(x, 3 + y),
        np.negative(x),
        np.positive(x),
        np.reciprocal(3 + x),
        np.square(x),
        np.absolute(x),
        np.abs(y),
        np.fabs(x),
        np.copysign(x, y),
        np.float_power(abs(x), 1.7),
        np.power(x, 4),
        np.conjugate(x),
        np.floor_divide(x, 0.3),
    ],
    "roots": lambda x, y, v, w, m: [np.sqrt(abs(x)), np.cbrt(x), np.hypot(x, y), np.hypot(x, 0.0)],
    "rounding": lambda x, y, v, w, m: [np.floor(x), np.ceil(x), np.trunc(x)],
    "circular functions": lambda x, y, v, w, m: [
        np.sin(x),
        np.cos(x),
        np.tan(x),
        np.arcsin(x / 2),
        np.arccos(x / 2),
        np.arctan(x),
        np.arctan2(x, y),
        np.deg2rad(x),
        np.radians(x),
        np.rad2deg(x),
        np.degrees(x),
    ],
    "hyperbolic functions": lambda x, y, v, w, m: [
        np.sinh(x),
        np.cosh(x),
        np.tanh(x),
        np.arcsinh(x),
        np.arccosh(1 + abs(x)),
        np.arctanh(x / 2.1),
    ],
    "exponentials": lambda x, y, v, w, m: [
        np.exp(x),
        np.exp2(x),
        np.expm1(x),
        np.log(abs(x)),
        np.log2(abs(x)),
        np.log10(abs(x)),
        np.log1p(abs(x)),
        np.log1p(-abs(x) / 2.1),
    ],
    "small arguments": lambda x, y, v, w, m: [
        np.expm1(1e-9 * x),
        np.log1p(1e-9 * x),
        np.arcsinh(1e-9 * x),
        np.arctanh(1e-9 * x),
        np.log1p(0.1 * x),
    ],
    "extremes": lambda x, y, v, w, m: [
        np.maximum(x, y),
        np.minimum(x, 0.5),
        np.fmax(x, y),
        np.fmin(x, y),
        np.clip(x, -0.5, 0.5),
        np.clip(y, None, 0.3),
        np.clip(y, 0.3, None),
        np.max(v),
        np.min(v),
        v.max(),
        v.min(),
        np.amax(v),
    ],
    "extremes of arrays": lambda x, y, v, w, m: [
        v.clip(-1, 1),
        np.clip(v, w - 3, w + 3),
        np.max(m, axis=0),
        m.min(axis=1),
        np.maximum(v, 0.0),
    ],
    "signs": lambda x, y, v, w, m: [
        np.sign(x),
        np.sign(0 * x),
        np.heaviside(x, 0.5),
        np.heaviside(0 * x, 0.5),
    ],
    "where": lambda x, y, v, w, m: [
        np.where(x > 0, x, y),
        np.where(x >= 0, 1, 0),
        np.where(x < y, 3.0, y),
        np.where(x <= y, x, 2),
        np.where((x > 0) & (y > 0), 1, 2),
        np.where((x > 0) | (y > 0), 1, 2),
        np.where(~(x > 0), 1, 2),
        np.where(np.logical_xor(x > 0, y > 0), 1, 2),
        np.where(np.logical_not(x > y), x, 2),
        (x > 0) * x,
        np.where((x > 0) ^ (y > 0), 1, 2),
        np.where((x > 0) & True, 1, 2),
    ],
    "where of arrays": lambda x, y, v, w, m: [
        np.where(v > 0, v, w),
        np.where(x > 0, v, 0.0),
        np.where([True, False, True], v, w),
        np.where(v > w, 1, v),
    ],
    "select": lambda x, y, v, w, m: [
        np.select([x > 1, x > 0], [y, 2.0], default=-1.0),
        np.select([v > 1, v > 0], [w, v])[1],
    ],
    "conditions of arrays": lambda x, y, v, w, m: [
        np.where(np.all(v > 0), 1, 2),
        np.where(np.any(v > 0), 1, 2),
        np.where((v > 0).all(), 1, 2),
        np.where((v > 0).any(), x, y),
    ],
    "polynomials": lambda x, y, v, w, m: [
        np.polyval([1.0, -2.0, 3.0], x),
        np.polyval(v, y),
        np.polyval(MATRIX[0], v)[1],
        np.polyval([2.0], x),
    ],
    "tables": lambda x, y, v, w, m: [
        np.interp(x, [-1.0, 0.0, 1.5], [3.0, 1.0, 2.0]),
        np.interp(v, [-1.0, 1.0], [0.0, 1.0])[2],
    ],
}


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_function_gives_the_numbers_of_numpy(name: str) -> None:
    check(EXPRESSIONS[name])
