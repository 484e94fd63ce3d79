"""Inputs that change over time."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.tables import Interpolation, check_slopes, table_times

__all__ = ["InputTable", "constant_inputs"]


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
        self.interpolation = _check.choice("interpolation", interpolation, ("linear", "hold"))
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


def constant_inputs(inputs: ArrayLike | None, n: int) -> Array:
    """Inputs that stay the same: zero when none are given."""
    if inputs is None:
        return np.zeros(n)
    if isinstance(inputs, InputTable):
        raise InputError("inputs: a table stands where constants are wanted")
    return _check.vector("inputs", inputs, n)
