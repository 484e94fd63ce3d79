"""Tables in named variables, and what a run says when it leaves them."""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.tables import Table

__all__ = ["Lookup", "extended"]

# How far an extrapolated table goes on, in lengths of its axis.
_REACH = 20.0


class Lookup:
    """A table of named variables, for the coefficients of `Aerodynamics`.

    Parameters
    ----------
    table
        Of as many variables as are named; angles in rad.
    of
        Names of variables: "alpha", "beta", "mach", ..., or of controls.
    extrapolate
        Whether it goes on along its border cells; it holds its border values otherwise. Linear tables only.

    Attributes
    ----------
    ranges
        From where to where each variable has samples, {"alpha": (low, high)}.
    beyond
        What holds outside, in words.
    """

    def __init__(self, table: Table, *of: str, extrapolate: bool = False) -> None:
        if not isinstance(table, Table):
            raise InputError(f"table: got {_check.shown(table)}; give a freebody.Table")
        if len(of) != len(table.axes):
            raise InputError(
                f"of: got {len(of)} names, {', '.join(map(repr, of)) or 'none'}; the table is a function of "
                f"{len(table.axes)}"
            )
        if len(set(of)) != len(of):
            raise InputError(f"of: got {', '.join(map(repr, of))}; name each variable once")
        self.of = tuple(_check.label("of", name) for name in of)
        self.extrapolate = _check.flag("extrapolate", extrapolate)
        self.table = extended(table) if extrapolate else table
        self.ranges = {
            name: (float(axis[0]), float(axis[-1])) for name, axis in zip(of, table.axes, strict=True)
        }

    @property
    def beyond(self) -> str:
        return (
            "which go on along their border cells" if self.extrapolate else "which hold their border values"
        )

    def __call__(self, values: Any) -> Any:
        """The value where `values[name]` are the variables."""
        return self.table(*(values[name] for name in self.of))

    def __repr__(self) -> str:
        return f"Lookup({self.table!r}, {', '.join(map(repr, self.of))})"


def extended(table: Table) -> Table:
    """The same linear table, which goes on along its border cells beyond its borders."""
    if table.interpolation != "linear":
        raise InputError(
            f"extrapolate: the table is {table.interpolation!r}; only linear tables go on beyond their border"
        )
    axes, values = [], np.asarray(table.values)
    for i, axis in enumerate(table.axes):
        if len(axis) < 2:
            raise InputError(f"extrapolate: axis {i + 1} of the table has one sample; two make a line")
        reach = _REACH * (axis[-1] - axis[0])
        far = np.concatenate([[axis[0] - reach], axis, [axis[-1] + reach]])
        rows = np.moveaxis(values, i, 0)
        low = _line(axis[:2], rows[:2], far[0])
        high = _line(axis[-2:], rows[-2:], far[-1])
        values = np.moveaxis(np.concatenate([low[None], rows, high[None]]), 0, i)
        axes.append(far)
    return Table(tuple(axes) if len(axes) > 1 else axes[0], values)


def _line(x: Array, y: Array, at: float) -> Array:
    return y[0] + (y[1] - y[0]) * ((at - x[0]) / (x[1] - x[0]))
