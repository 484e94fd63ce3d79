"""What the panels of a run share."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes

from freebody._check import Array

from .style import BLUE, GREEN, RED

__all__ = ["XYZ", "at_least", "energy_unit", "length_unit", "lines", "wrapped"]

XYZ = {"x": RED, "y": GREEN, "z": BLUE}


def lines(axes: Axes, time: Array, values: Array, labels: Mapping[str, str]) -> None:
    for column, (label, colour) in zip(values.T, labels.items(), strict=True):
        axes.plot(time, column, color=colour, label=label)
    _legend(axes)


def _legend(axes: Axes) -> None:
    """In the title's line, where no curve can run through it."""
    axes.legend(
        loc="lower right",
        bbox_to_anchor=(1.0, 0.98),
        ncols=5,
        handlelength=1.2,
        columnspacing=1.0,
        borderpad=0.2,
    )


def at_least(axes: Axes, span: float) -> None:
    """Widens the range of the values to `span`: what changes less is rounding, or nothing to see."""
    low, high = axes.get_ylim()
    if high - low < span:
        middle = 0.5 * (low + high)
        axes.set_ylim(middle - 0.5 * span, middle + 0.5 * span)


def wrapped(angles: Array) -> Array:
    """Angles (n, k) in rad as degrees within a turn."""
    degrees = np.mod(np.rad2deg(angles) + 180, 360) - 180
    # A turn past 180 deg is no jump of the body: the line breaks there.
    wraps = np.abs(np.diff(degrees, axis=0, prepend=degrees[:1])) > 180
    return np.where(wraps, np.nan, degrees)


def length_unit(values: Array) -> tuple[float, str]:
    """A unit in SI, and its name, in which values in m are numbers of a handy size."""
    return _unit(values, ((1e4, 1e3, "km"), (0.1, 1.0, "m"), (1e-4, 1e-3, "mm")), (1e-6, "µm"))


def energy_unit(values: Array) -> tuple[float, str]:
    """Likewise of values in J."""
    return _unit(values, ((1e10, 1e9, "GJ"), (1e7, 1e6, "MJ"), (1e4, 1e3, "kJ")), (1.0, "J"))


def _unit(
    values: Array, units: tuple[tuple[float, float, str], ...], smallest: tuple[float, str]
) -> tuple[float, str]:
    largest = np.abs(values).max() or 1.0
    return next(((factor, unit) for least, factor, unit in units if largest >= least), smallest)
