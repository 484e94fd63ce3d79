"""What force laws return."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.tracing.array import Objects, plain
from freebody.tracing.scalar import Scalar, as_scalar
from freebody.tracing.trace import CURRENT, fault
from freebody.units import Dimension, dimension, text_of

__all__ = ["Wrench", "must_measure", "wrench"]

Vector: TypeAlias = ArrayLike | Sequence[Any]
"""Components; a list may mix numbers and traced values."""

ORIGIN = (0.0, 0.0, 0.0)
_FORCE, _MOMENT, _LENGTH = (dimension("unit", unit) for unit in ("N", "N m", "m"))


class Wrench:
    """A force and its moment about the body origin, body axes: (..., 3) N and N m each."""

    def __init__(self, force: Any, moment: Any) -> None:
        self.force, self.moment = force, moment

    def __repr__(self) -> str:
        return f"<Wrench of shape {(*np.shape(self.force)[:-1], 6)}>"

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.concatenate(np.broadcast_arrays(self.force, self.moment), axis=-1, dtype=dtype)


def wrench(force: Vector = ORIGIN, moment: Vector = ORIGIN, at: Vector = ORIGIN) -> Wrench:
    """The wrench that a force law returns.

    Parameters
    ----------
    force
        Body axes, (3,) N; in a callback (n, 3).
    moment
        About the body origin, or about `at`, body axes, (3,) N m.
    at
        Point of application of the force, from the body origin, body axes, (3,) m.
    """
    if CURRENT.get() is not None:
        f, m = _three("force", force, _FORCE), _three("moment", moment, _MOMENT)
        if at is not ORIGIN:
            turned = _three(
                "the moment of force about the origin", np.cross(_three("at", at, _LENGTH), f), _MOMENT
            )
            m = m + turned
        return Wrench(f, m)
    given = [_check.argument(n, v, 3).array for n, v in (("force", force), ("moment", moment), ("at", at))]
    try:
        f, m, r = np.broadcast_arrays(*given)
    except ValueError:
        shapes = ", ".join(str(a.shape) for a in given)
        raise InputError(f"force, moment, at: shapes {shapes} do not go together; give (n, 3) each") from None
    return Wrench(f, m + np.cross(r, f))


def _three(name: str, value: Any, unit: Dimension) -> Objects:
    array = np.asarray(plain(value), object)
    if array.shape != (3,):
        raise fault(f"fb.wrench came with {name} of shape {array.shape}", "give three components, (3,)")
    entries = np.empty(3, object)
    entries[:] = [must_measure(f"{name}[{i}]", as_scalar(item), unit) for i, item in enumerate(array)]
    return entries


def must_measure(what: str, value: Scalar, unit: Dimension) -> Scalar:
    """Refuse a number that is known to measure something else."""
    if value.unit not in (None, unit):
        raise fault(
            f"{what} is in {text_of(value.unit)} and must be in {text_of(unit)}",
            "a factor is missing, or a declared unit is wrong",
        )
    return value
