"""Tabulated functions, and the checks that all tables share."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["Interpolation", "Table", "TableInterpolation", "check_slopes", "table_times"]

Interpolation = Literal["linear", "hold"]
TableInterpolation = Literal["linear", "cubic", "hold"]


class Table:
    """A function given by samples, of one variable or of two.

    It is called with numbers or arrays, which broadcast, or with values of a force law that is being traced.
    Outside the samples it holds its border values, with slope zero.

    Parameters
    ----------
    x
        (n,) where the samples stand, rising; or a pair of such, (nx,) and (ny,), for two variables.
    values
        (n,), or (nx, ny): one row for each of the first.
    interpolation
        "linear": straight lines, and their products in two variables; an abscissa that stands twice makes a
        jump there, with the later value from then on. "hold": each value until the next. "cubic": the spline
        with two continuous derivatives and "not-a-knot" ends, and the product of two such.
    """

    def __init__(
        self,
        x: ArrayLike | tuple[ArrayLike, ArrayLike],
        values: ArrayLike,
        interpolation: TableInterpolation = "linear",
    ) -> None:
        self.interpolation = _check.choice("interpolation", interpolation, ("linear", "cubic", "hold"))
        self.axes: tuple[Array, ...]
        if isinstance(x, tuple) and len(x) == 2 and all(_has_items(axis) for axis in x):
            rows, columns = self.axes = (self._axis("x[0]", x[0]), self._axis("x[1]", x[1]))
            self.values = _check.vector("values", values, len(rows), len(columns))
            self._core = _core.Grid(rows, columns, self.values, self.interpolation)
        else:
            (axis,) = self.axes = (self._axis("x", x),)
            self.values = _check.vector("values", values, len(axis))
            self._core = _core.Table(axis, self.values, self.interpolation)

    def _axis(self, name: str, value: object) -> Array:
        checked = _rising(name, value)  # pyright: ignore[reportArgumentType]
        if self.interpolation == "cubic":
            twice = np.flatnonzero(checked[1:] == checked[:-1]) + 1
            if twice.size:
                i = int(twice[0])
                raise InputError(
                    f"{name}: {checked[i]} stands twice at index {i}; a cubic table has no jumps: leave one "
                    'out, or use interpolation="linear"'
                )
        return checked

    def core(self) -> _core.Table | _core.Grid:
        """The table of the compiled part."""
        return self._core

    def __call__(self, *at: Any) -> Any:
        """The values at numbers or arrays, in the shape that these broadcast to."""
        n = len(self.axes)
        if len(at) != n:
            raise InputError(f"table: got {len(at)} arguments; it is a function of {n}")
        for argument in at:
            traced = _traced(argument)
            if traced is not None:
                return traced.__freebody_lookup__(self, at)
        arrays = [_numbers(f"argument {i + 1}", argument) for i, argument in enumerate(at)]
        try:
            arrays = np.broadcast_arrays(*arrays)
        except ValueError:
            shapes = " and ".join(str(array.shape) for array in arrays)
            raise InputError(
                f"table: shapes {shapes} do not broadcast; give arguments of one shape"
            ) from None
        values = self._core.value(*(np.ascontiguousarray(array).ravel() for array in arrays))
        return values.reshape(arrays[0].shape)[()]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and self._core == other._core

    def __hash__(self) -> int:
        return hash(self._core)

    def __reduce__(self) -> tuple[type[Table], tuple[object, Array, str]]:
        axes = self.axes if len(self.axes) == 2 else self.axes[0]
        return Table, (axes, self.values, self.interpolation)

    def __repr__(self) -> str:
        return f"Table({' x '.join(map(str, self.values.shape))} samples, {self.interpolation!r})"


def _traced(argument: Any) -> Any:
    """What of an argument is traced: itself, or an entry of an array of objects."""
    entries = argument.flat if isinstance(argument, np.ndarray) and argument.dtype == object else ()
    return next((a for a in (argument, *entries) if hasattr(a, "__freebody_lookup__")), None)


def _has_items(axis: object) -> bool:
    """Whether this is an axis of samples, and not one number of it."""
    try:
        return np.ndim(axis) > 0  # pyright: ignore[reportArgumentType]
    except Exception:  # what a foreign object raises is told when it is checked
        return False


def _numbers(name: str, value: ArrayLike) -> Array:
    """Check real numbers of any shape, finite or not."""
    try:
        shape = np.shape(value)
    except Exception:  # told by the check
        shape = ()
    return _check.numbers(name, value, *shape)


def _rising(name: str, value: ArrayLike) -> Array:
    """Check abscissae: rising, one at most twice (a jump)."""
    checked = _check.series(name, value)
    back = np.flatnonzero(np.diff(checked) < 0.0) + 1
    if back.size:
        i = int(back[0])
        raise InputError(f"{name}: {checked[i]} at index {i} is smaller than the one before; sort the {name}")
    thrice = np.flatnonzero(checked[2:] == checked[:-2]) + 2
    if thrice.size:
        i = int(thrice[0])
        raise InputError(f"{name}: {checked[i]} stands three times at index {i}; a jump takes two")
    return checked


def table_times(times: ArrayLike) -> Array:
    """Check the times of a table: rising, a time at most twice (a jump)."""
    return _rising("times", times)


def check_slopes(name: str, times: Array, rows: Array) -> None:
    """Refuse rows between which no straight line can be drawn in doubles."""
    gap = np.diff(times)[:, None]
    with np.errstate(over="ignore"):
        slopes = np.diff(rows, axis=0) / np.where(gap > 0.0, gap, np.inf)
    steep = np.flatnonzero(~np.isfinite(slopes).all(axis=1)) + 1
    if steep.size:
        i = int(steep[0])
        raise InputError(
            f"{name}: the line to row {i} is too steep for doubles; give that time twice to make a jump, or "
            'use interpolation="hold"'
        )
