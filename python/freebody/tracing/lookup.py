"""Tables of traced numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody.tables import CoreTable, Table
from freebody.tracing.array import FUNCTIONS, TABLES, Dispatches, each, plain, wrapped
from freebody.tracing.scalar import Scalar, as_scalar
from freebody.tracing.trace import current, fault

__all__ = ["is_traced", "look_up"]


def is_traced(value: object) -> bool:
    """Whether a value, an array or an entry of it is traced."""
    if isinstance(value, np.ndarray) and value.dtype == object:
        return any(isinstance(item, Dispatches) for item in value.flat)
    return isinstance(value, Dispatches)


def look_up(table: CoreTable, *at: Any) -> Any:
    """The value of a table at traced numbers of shapes that go together; its unit is not known."""

    def one(*at: Any) -> Scalar:
        nodes = [as_scalar(x).node for x in at]
        trace = current()
        return Scalar(trace, trace.lookup(table, nodes), None)

    return wrapped(each(np.frompyfunc(one, len(at), 1), *at))


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
TABLES[Table] = look_up
