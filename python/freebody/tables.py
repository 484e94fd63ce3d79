"""Tabulated functions, and the checks that all tables share."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["CoreTable", "Interpolation", "Table", "TableInterpolation", "check_slopes", "table_times"]

Interpolation = Literal["linear", "hold"]
TableInterpolation = Literal["linear", "cubic", "hold"]
CoreTable: TypeAlias = _core.Table | _core.Grid | _core.Lattice


class Table:
    """A function given by samples, of one variable to four.

    It is called with numbers or arrays, which broadcast, or with values of a force law that is being traced.
    Outside the samples it holds its border values, with slope zero.

    Parameters
    ----------
    x
        (n,) where the samples stand, rising; or a tuple of two to four such, one for each variable.
    values
        (n,), (nx, ny), (nx, ny, nz) or (nx, ny, nz, nw): the last variable runs fastest.
    interpolation
        "linear": straight lines, and their products in several variables; an abscissa that stands twice makes
        a jump there, with the later value from then on. "hold": each value until the next. "cubic", of one
        variable or two: the spline with two continuous derivatives and "not-a-knot" ends, and the product of
        two such.

    Attributes
    ----------
    axes
        The abscissae along each variable.
    values
        The samples.
    """

    axes: tuple[Array, ...]
    values: Array
    # What this is a derivative of, and of which order; none for a table of its own.
    _derivative_of: tuple[Table, int] | None = None

    def __init__(
        self,
        x: ArrayLike | tuple[ArrayLike, ...],
        values: ArrayLike,
        interpolation: TableInterpolation = "linear",
    ) -> None:
        self.interpolation = _check.choice("interpolation", interpolation, ("linear", "cubic", "hold"))
        if isinstance(x, tuple) and len(x) > 1 and all(_has_items(axis) for axis in x):
            n = len(x)
            if n > 4:
                raise InputError(f"x: got {n} axes; a table is a function of one variable to four")
            if n > 2 and self.interpolation == "cubic":
                raise InputError(
                    f"interpolation: got 'cubic' with {n} axes; a cubic table has one or two: use \"linear\""
                )
            self.axes = tuple(self._axis(f"x[{i}]", axis) for i, axis in enumerate(x))
        else:
            self.axes = (self._axis("x", x),)
        self.values = _check.vector("values", values, *map(len, self.axes))
        self._core = _compiled(self.axes, self.values, self.interpolation)

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

    def core(self) -> CoreTable:
        """The table of the compiled part."""
        return self._core

    def __call__(self, *at: Any) -> Any:
        """The values at numbers or arrays, in the shape that these broadcast to."""
        traced = self._traced(at)
        if traced is not None:
            return traced.__freebody_lookup__(self, at)
        arrays = _broadcast(at)
        values = self._core.value(*(np.ascontiguousarray(array).ravel() for array in arrays))
        return values.reshape(arrays[0].shape)[()]

    def inside(self, *at: Any) -> Any:
        """How far inside the sampled range: ≥ 0 exactly where all arguments are within it.

        The smallest distance to a border, each in parts of the length of its axis; an axis of one sample has
        length one. Takes what the table is called with, traced values too.
        """
        arguments = at if self._traced(at) is not None else _broadcast(at)
        margins = []
        for axis, argument in zip(self.axes, arguments, strict=True):
            length = axis[-1] - axis[0] if axis[-1] > axis[0] else 1.0
            # Products with plain numbers have no unit, so that unlike variables can be compared.
            x = 1.0 * argument
            margins += [(x - axis[0]) / length, (axis[-1] - x) / length]
        return reduce(np.minimum, margins)

    def derivative(self) -> Table:
        """The slope of a table of one variable, zero outside the samples and across jumps.

        That of a linear table holds from sample to sample; that of a cubic table is its exact derivative. The
        `values` of the new table are its slopes at the samples, from there on.

        Raises
        ------
        InputError
            If it is a function of several variables.
        """
        if len(self.axes) > 1:
            raise InputError(f"table: a function of {len(self.axes)} variables; only one of one has a slope")
        source, order = self._derivative_of or (self, 0)
        return _derivative(source, order + 1)

    def _traced(self, at: tuple[Any, ...]) -> Any:
        """What of as many arguments as there are variables is traced; none if nothing is."""
        n = len(self.axes)
        if len(at) != n:
            raise InputError(f"table: got {len(at)} arguments; it is a function of {n}")
        return next((t for t in map(_traced, at) if t is not None), None)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and self._core == other._core

    def __hash__(self) -> int:
        return hash(self._core)

    def __reduce__(self) -> tuple[Callable[..., Table], tuple[object, ...]]:
        if self._derivative_of is not None:
            return _derivative, self._derivative_of
        axes = self.axes[0] if len(self.axes) == 1 else self.axes
        return Table, (axes, self.values, self.interpolation)

    def __repr__(self) -> str:
        samples = " x ".join(map(str, self.values.shape))
        order = "" if self._derivative_of is None else f", derivative of order {self._derivative_of[1]}"
        return f"Table({samples} samples, {self.interpolation!r}{order})"


def _compiled(axes: tuple[Array, ...], values: Array, interpolation: str) -> CoreTable:
    if len(axes) == 1:
        return _core.Table(*axes, values, interpolation)
    if len(axes) == 2:
        return _core.Grid(*axes, values, interpolation)
    return _core.Lattice(axes, values, interpolation)


def _derivative(source: Table, order: int) -> Table:
    """The derivative of a table of one variable."""
    derived = Table.__new__(Table)
    derived._derivative_of = (source, order)
    derived.axes = source.axes
    derived.interpolation = "cubic" if source.interpolation == "cubic" else "hold"
    (x,) = source.axes
    derived._core = _core.Table(x, source.values, source.interpolation, order)
    derived.values = derived._core.value(x)
    derived.values.flags.writeable = False
    return derived


def _broadcast(at: tuple[Any, ...]) -> tuple[Array, ...]:
    """Check arguments that are numbers or arrays of shapes that go together."""
    arrays = [_numbers(f"argument {i + 1}", argument) for i, argument in enumerate(at)]
    try:
        return tuple(np.broadcast_arrays(*arrays))
    except ValueError:
        shapes = " and ".join(str(array.shape) for array in arrays)
        raise InputError(f"table: shapes {shapes} do not broadcast; give arguments of one shape") from None


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
