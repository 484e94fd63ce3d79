"""Inputs that change over time."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.tables import Interpolation, check_slopes, table_times

__all__ = ["InputTable", "checked_inputs", "core_table"]


class InputTable:
    """Inputs tabulated over time.

    Parameters
    ----------
    times
        (n,) s, rising; a time that stands twice makes a jump there.
    values
        (n, n_inputs), in the units of the model's inputs.
    interpolation
        "linear" between the rows, or "hold": each row until the next. The first and the last row hold
        outside.
    """

    def __init__(self, times: ArrayLike, values: ArrayLike, interpolation: Interpolation = "linear") -> None:
        self.times = table_times(times)
        self.values = _check.columns("values", values, len(self.times))
        _check.choice("interpolation", interpolation, ("linear", "hold"))
        self.interpolation: Interpolation = interpolation
        if interpolation == "linear":
            check_slopes("values", self.times, self.values)

    def at(self, t: ArrayLike) -> Array:
        """The inputs (m, n_inputs) at times (m,) s; at a jump the later row."""
        t = _check.series("t", t)
        later = np.searchsorted(self.times, t, side="right")
        before, after = np.maximum(later - 1, 0), np.minimum(later, len(self.times) - 1)
        if self.interpolation == "hold":
            return self.values[before]
        gap = self.times[after] - self.times[before]
        part = np.where(gap > 0.0, (t - self.times[before]) / np.where(gap > 0.0, gap, 1.0), 0.0)
        part = np.maximum(part, 0.0)[:, None]
        return self.values[before] + part * (self.values[after] - self.values[before])

    def check_width(self, n: int) -> None:
        """Check that a model with n inputs can read the table."""
        if self.values.shape[1] != n:
            raise InputError(f"inputs: the table has {self.values.shape[1]} columns; the model has {n}")


def checked_inputs(inputs: ArrayLike | InputTable | None, n: int) -> tuple[Array, InputTable | None]:
    """Constant inputs (n,), zero when none are given, and the table where one was."""
    if isinstance(inputs, InputTable):
        inputs.check_width(n)
        return np.zeros(n), inputs
    return np.zeros(n) if inputs is None else _check.vector("inputs", inputs, n), None


def core_table(table: InputTable) -> tuple[Array, Array, bool]:
    """The table as the core takes it: times, columns, whether rows are held."""
    return table.times, np.ascontiguousarray(table.values.T), table.interpolation == "hold"
