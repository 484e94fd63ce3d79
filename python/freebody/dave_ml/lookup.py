"""The tables of functions, any number of arguments, each with its own rule between and beyond the samples."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from freebody._check import Array
from freebody.tables import Table, TableInterpolation

__all__ = ["INTERPOLATIONS", "Axis", "GriddedFunction"]

INTERPOLATIONS: dict[str, TableInterpolation] = {
    "linear": "linear",
    "cubicSpline": "cubic",
    "discrete": "hold",
    "floor": "hold",
    "ceiling": "hold",
}
_MOST_AXES = 4  # of one table
_FAR = 1000.0  # where a border is continued, it is so for this many of its intervals


class Axis(NamedTuple):
    """One argument of a function: where its samples stand, and what holds between and beyond them."""

    breakpoints: Array
    interpolate: str = "linear"
    extrapolate: str = "neither"
    minimum: float = -np.inf
    maximum: float = np.inf

    def held(self) -> tuple[float, float]:
        """From where to where the argument acts; infinite where it always does, as it does not in steps."""
        if INTERPOLATIONS[self.interpolate] == "hold":
            return -np.inf, np.inf
        low, high = float(self.breakpoints[0]), float(self.breakpoints[-1])
        return (
            self.minimum if self.extrapolate in ("min", "both") else max(low, self.minimum),
            self.maximum if self.extrapolate in ("max", "both") else min(high, self.maximum),
        )


class GriddedFunction:
    """A function given by samples at all combinations of breakpoints, (n1, n2, ...)."""

    def __init__(self, axes: Sequence[Axis], values: Array) -> None:
        self.axes = tuple(axes)
        places = []
        for i, axis in enumerate(self.axes):
            place, values = _placed(axis, np.moveaxis(values, i, 0))
            places.append(place)
            values = np.moveaxis(values, 0, i)
        self._table = _table(places, [INTERPOLATIONS[axis.interpolate] for axis in self.axes], values)

    def __call__(self, *arguments: Any) -> Any:
        return self._table(*(_limited(axis, x) for axis, x in zip(self.axes, arguments, strict=True)))


class _Blend:
    """The sum of functions of the later arguments, each times its weight, a function of the first.

    Linear and cubic interpolation, and holding, are linear in the samples. So the weight of a sample is the
    interpolation of 1 there and 0 elsewhere.
    """

    def __init__(self, first: Array, kind: TableInterpolation, slices: Sequence[Any]) -> None:
        self._weights = [Table(first, row, kind) for row in np.eye(len(first))]
        self._slices = slices

    def __call__(self, first: Any, *others: Any) -> Any:
        return sum(w(first) * f(*others) for w, f in zip(self._weights, self._slices, strict=True))


def _table(places: list[Array], kinds: list[TableInterpolation], values: Array) -> Any:
    if len(places) <= _MOST_AXES and len(set(kinds)) == 1:
        return Table(places[0] if len(places) == 1 else tuple(places), values, kinds[0])
    return _Blend(places[0], kinds[0], [_table(places[1:], kinds[1:], part) for part in values])


def _placed(axis: Axis, values: Array) -> tuple[Array, Array]:
    """Where the samples of a table stand that gives the rule of the axis, first axis of `values`."""
    at = axis.breakpoints
    if axis.interpolate == "discrete":  # the nearest; half way is rounded up
        return np.concatenate([at[:1], 0.5 * (at[1:] + at[:-1])]), values
    if axis.interpolate == "ceiling":  # the next one above: the last one below, seen from the other side
        return -at[::-1], values[::-1]
    if axis.interpolate == "linear":
        if axis.extrapolate in ("max", "both") and axis.maximum > at[-1]:
            at, values = _continued(at, values)
        if axis.extrapolate in ("min", "both") and axis.minimum < at[0]:
            mirrored, values = _continued(-at[::-1], values[::-1])
            at, values = -mirrored[::-1], values[::-1]
    return at, values


def _continued(at: Array, values: Array) -> tuple[Array, Array]:
    """One sample more, far behind the last, in line with the last two."""
    step = _FAR * (at[-1] - at[-2])
    last = values[-1] + _FAR * (values[-1] - values[-2])
    return np.append(at, at[-1] + step), np.concatenate([values, last[None]])


def _limited(axis: Axis, x: Any) -> Any:
    """The argument within the limits of the file; tables hold their borders by themselves."""
    if axis.minimum > axis.breakpoints[0] or (
        axis.extrapolate in ("min", "both") and np.isfinite(axis.minimum)
    ):
        x = np.maximum(x, axis.minimum)
    if axis.maximum < axis.breakpoints[-1] or (
        axis.extrapolate in ("max", "both") and np.isfinite(axis.maximum)
    ):
        x = np.minimum(x, axis.maximum)
    return -x if axis.interpolate == "ceiling" else x
