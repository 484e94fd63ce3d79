"""Checks that all tables over time share."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["Interpolation", "table_times"]

Interpolation = Literal["linear", "hold"]


def table_times(times: ArrayLike) -> Array:
    """Check the times of a table: rising, a time at most twice (a jump)."""
    shape = np.shape(times)
    if len(shape) != 1:
        raise InputError(f"times: got shape {shape}; allowed is (n,) with n of at least 1")
    checked = _check.vector("times", times, *shape)
    back = np.flatnonzero(np.diff(checked) < 0.0) + 1
    if back.size:
        i = int(back[0])
        raise InputError(f"times: {checked[i]} at index {i} is smaller than the one before; sort the times")
    thrice = np.flatnonzero(checked[2:] == checked[:-2]) + 2
    if thrice.size:
        i = int(thrice[0])
        raise InputError(f"times: {checked[i]} stands three times at index {i}; a jump takes two")
    return checked
