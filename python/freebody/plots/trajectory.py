"""One figure of a run: motion, attitude, rates, energy and what was conserved."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from freebody._check import Array
from freebody.simulation import Trajectory

from .style import BLACK, BLUE, GREEN, GREY, RED, STYLE, blank

__all__ = ["figure"]

XYZ = {"x": RED, "y": GREEN, "z": BLUE}


def figure(run: Trajectory, *, title: str = "", points: Mapping[str, ArrayLike] | None = None) -> Figure:
    """Panels over time; a body whose mass centre rests shows the path of its first named point instead."""
    with rc_context(STYLE):
        drawing = blank(11.0, 9.0)
        names: list[Any] = [["position", "velocity"], ["attitude", "rates"], ["energy", "drift"]]
        axes = drawing.subplot_mosaic(names, sharex=True)
        scale, unit = _time_unit(run.t)
        time = run.t / scale
        _position(axes["position"], axes["velocity"], time, run, points or {})
        _attitude(axes["attitude"], time, run)
        _rates(axes["rates"], time, run, scale, unit)
        _energy(axes["energy"], time, run)
        _drift(axes["drift"], time, run)
        for name in names[-1]:
            axes[name].set_xlabel(f"time ({unit})")
        for change in run.chart_changes:
            axes["attitude"].axvline(change.time / scale, color=GREY, linestyle=":", zorder=0)
        drawing.suptitle(title, fontsize=13, fontweight="bold", x=0.01, ha="left")
    return drawing


def _position(
    position: Axes, velocity: Axes, time: Array, run: Trajectory, points: Mapping[str, ArrayLike]
) -> None:
    path, speed, what = run.com_position_world, run.com_velocity_world, "the mass centre"
    if points and not np.any(np.ptp(path, axis=0)):
        name, at = next(iter(points.items()))
        what = f"the point {name}"
        path = run.point(at)
        speed = run.velocity_world + np.cross(run.angular_velocity_world, path - run.position_world)
    start = path[0]
    far = np.linalg.norm(start) > 100 * np.ptp(path, axis=0).max()
    factor, unit = _length_unit(path - start if far else path)
    _lines(position, time, (path - start if far else path) / factor, XYZ)
    position.set(title=f"Position of {what}" + (" from its start" if far else ""), ylabel=unit)
    factor, unit = _length_unit(speed)
    _lines(velocity, time, speed / factor, XYZ)
    velocity.set(title=f"Velocity of {what}", ylabel=f"{unit}/s")


def _attitude(axes: Axes, time: Array, run: Trajectory) -> None:
    if run.model.attitude == "quaternion":
        _lines(axes, time, run.quaternion, {"w": BLACK, **XYZ})
        axes.set(title="Attitude quaternion")
        return
    sequence = run.model.attitude
    colours = zip(sequence, XYZ.values(), strict=True)
    labels = {f"α{i} about {axis}": colour for i, (axis, colour) in enumerate(colours, 1)}
    angles = np.mod(np.rad2deg(run.angles(sequence)) + 180, 360) - 180
    # A turn past 180 deg is no jump of the body: the line breaks there.
    wraps = np.abs(np.diff(angles, axis=0, prepend=angles[:1])) > 180
    _lines(axes, time, np.where(wraps, np.nan, angles), labels)
    axes.set(title=f"Attitude angles {sequence}", ylabel="deg")


def _rates(axes: Axes, time: Array, run: Trajectory, scale: float, unit: str) -> None:
    per, name = (scale, unit) if unit in {"h", "day"} else (1.0, "s")
    _lines(axes, time, np.rad2deg(run.angular_velocity_body) * per, XYZ)
    axes.set(title="Angular velocity, body axes", ylabel=f"deg/{name}")


def _energy(axes: Axes, time: Array, run: Trajectory) -> None:
    if np.any(run.potential_energy):
        changes = [e - e[0] for e in (run.kinetic_energy, run.potential_energy, run.energy)]
        _lines(axes, time, np.column_stack(changes), {"kinetic": BLUE, "potential": GREEN, "sum": BLACK})
        axes.set(title="Energy gained since the start", ylabel="J")
        return
    axes.plot(time, run.kinetic_energy, color=BLUE)
    largest = run.kinetic_energy.max()
    if np.ptp(run.kinetic_energy) < 1e-6 * largest:  # a constant: its rounding is for the next panel
        axes.set_ylim(0, 1.25 * largest)
    axes.set(title="Kinetic energy", ylabel="J")


def _drift(axes: Axes, time: Array, run: Trajectory) -> None:
    axes.set(title="Largest relative drift so far", yscale="log", ylim=(1e-17, 1e-12))
    largest = 1e-12
    moving = [kept for kept in run.conserved() if kept.reference > 0.0]
    for kept, colour in zip(moving, (BLUE, RED, GREEN, BLACK, GREY), strict=False):
        drift = np.maximum(np.maximum.accumulate(kept.history), 1e-17)
        axes.plot(time, drift, color=colour, label=kept.name)
        largest = max(largest, 3 * drift[-1])
    axes.set_ylim(top=largest)
    if axes.lines:
        axes.legend(loc="best")
    else:
        axes.set(yscale="linear", yticks=[])
        axes.text(
            0.5,
            0.5,
            "the forces of this model keep nothing",
            transform=axes.transAxes,
            ha="center",
            color=GREY,
        )


def _lines(axes: Axes, time: Array, values: Array, labels: Mapping[str, str]) -> None:
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


def _time_unit(t: Array) -> tuple[float, str]:
    span = float(t[-1] - t[0])
    for limit, scale, unit in ((600.0, 1.0, "s"), (7200.0, 60.0, "min"), (259200.0, 3600.0, "h")):
        if span <= limit:
            return scale, unit
    return 86400.0, "day"


def _length_unit(values: Array) -> tuple[float, str]:
    largest = np.abs(values).max() or 1.0
    for least, factor, unit in ((1e4, 1e3, "km"), (0.1, 1.0, "m"), (1e-4, 1e-3, "mm")):
        if largest >= least:
            return factor, unit
    return 1e-6, "µm"
