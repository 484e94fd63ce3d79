"""Checks that all tables over time share."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["Interpolation", "check_slopes", "table_times"]

Interpolation = Literal["linear", "hold"]


def table_times(times: ArrayLike) -> Array:
    """Check the times of a table: rising, a time at most twice (a jump)."""
    checked = _check.series("times", times)
    back = np.flatnonzero(np.diff(checked) < 0.0) + 1
    if back.size:
        i = int(back[0])
        raise InputError(f"times: {checked[i]} at index {i} is smaller than the one before; sort the times")
    thrice = np.flatnonzero(checked[2:] == checked[:-2]) + 2
    if thrice.size:
        i = int(thrice[0])
        raise InputError(f"times: {checked[i]} stands three times at index {i}; a jump takes two")
    return checked


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
