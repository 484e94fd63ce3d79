"""Tables of traced numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody.tracing.array import FUNCTIONS, TABLES, Dispatches, each, plain, wrapped
from freebody.tracing.scalar import Scalar, as_scalar
from freebody.tracing.trace import current, fault

__all__ = ["is_traced", "look_up", "look_up_2"]


def is_traced(value: object) -> bool:
    """Whether a value, an array or an entry of it is traced."""
    if isinstance(value, np.ndarray) and value.dtype == object:
        return any(isinstance(item, Dispatches) for item in value.flat)
    return isinstance(value, Dispatches)


def look_up(table: _core.Table, x: Any) -> Any:
    """The value of a table at traced numbers of any shape; its unit is not known."""

    def one(x: Any) -> Scalar:
        a = as_scalar(x)
        trace = current()
        return Scalar(trace, trace.lookup(table, a.node), None)

    return wrapped(each(np.frompyfunc(one, 1, 1), x))


def look_up_2(grid: _core.Grid, x: Any, y: Any) -> Any:
    """The value of a table of two arguments at traced numbers of shapes that go together."""

    def one(x: Any, y: Any) -> Scalar:
        a, b = as_scalar(x), as_scalar(y)
        trace = current()
        return Scalar(trace, trace.lookup_2(grid, a.node, b.node), None)

    return wrapped(each(np.frompyfunc(one, 2, 1), x, y))


def _interp(x: Any, xp: ArrayLike, fp: ArrayLike) -> Any:
    if is_traced(xp) or is_traced(fp):
        raise fault("np.interp came with a table of traced values", "xp and fp must be plain numbers")
    at, values = _check.series("np.interp: xp", xp), _check.series("np.interp: fp", fp)
    if len(at) != len(values) or not (np.diff(at) > 0.0).all():
        raise fault("np.interp came with a table that is none", "xp must rise, and fp be as long")
    if len(at) == 1:
        return np.full(np.shape(plain(x)), values[0], object)
    return look_up(_core.Table(at, values, "linear"), x)


FUNCTIONS[np.interp] = _interp
TABLES.update({1: look_up, 2: look_up_2})
