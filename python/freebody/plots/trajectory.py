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
from freebody.environment import FlatEarth
from freebody.simulation import StagedTrajectory, Trajectory, stages_of

from .panels import XYZ, at_least, energy_unit, length_unit, lines, wrapped
from .planet import draw_tracks, seen_from
from .signals import draw_signals
from .style import BLACK, BLUE, GREEN, GREY, RED, STYLE, blank

__all__ = ["figure"]

# Of positions and velocities, m and m/s: what is smaller is rounding.
_LEAST = 1e-9


def figure(
    run: Trajectory | StagedTrajectory, *, title: str = "", points: Mapping[str, ArrayLike] | None = None
) -> Figure:
    """Panels over time; a body whose mass centre rests shows the path of its first named point instead.

    Where the model has an environment, there are panels of what its planet sees. Dotted lines are changes of
    the chart, dashed ones separations of stages.
    """
    model = stages_of(run)[0].model
    planet = None if model.environment is None else model.environment.planet
    names: list[Any] = [["position", "velocity"], ["attitude", "rates"], ["energy", "drift"]]
    if isinstance(planet, FlatEarth):
        names = [["altitude", "speed"], ["position", "velocity"], ["pointing", "rates"], ["energy", "drift"]]
    elif planet is not None:
        names = [["altitude", "speed"], ["place", "pointing"], *names]
    with rc_context(STYLE):
        drawing = blank(11.0, 3.0 * len(names))
        axes = drawing.subplot_mosaic(names, sharex=True)
        scale, unit = _time_unit(run.t)
        time = run.t / scale
        if planet is not None:
            draw_tracks(axes, time, [seen_from(planet, stage) for stage in stages_of(run)])
        _position(axes["position"], axes["velocity"], time, run, points or {})
        if "attitude" in axes:
            _attitude(axes["attitude"], time, run)
        _rates(axes["rates"], time, run, scale, unit)
        _energy(axes["energy"], time, run)
        _last(axes["drift"], time, run)
        for name in names[-1]:
            axes[name].set_xlabel(f"time ({unit})")
        for change in run.chart_changes:
            at = axes.get("attitude", axes.get("pointing"))
            assert at is not None
            at.axvline(change.time / scale, color=GREY, linestyle=":", zorder=0)
        if isinstance(run, StagedTrajectory):
            for separation in run.separations:
                for panel in axes.values():
                    panel.axvline(separation.time / scale, color=GREY, linestyle="--", zorder=0)
        drawing.suptitle(title, fontsize=13, fontweight="bold", x=0.01, ha="left")
    return drawing


def _position(
    position: Axes,
    velocity: Axes,
    time: Array,
    run: Trajectory | StagedTrajectory | StagedTrajectory,
    points: Mapping[str, ArrayLike],
) -> None:
    path, speed, what = run.com_position_world, run.com_velocity_world, "the mass centre"
    if points and not np.any(np.ptp(path, axis=0)):
        name, at = next(iter(points.items()))
        what = f"the point {name}"
        path = run.point(at)
        speed = run.velocity_world + np.cross(run.angular_velocity_world, path - run.position_world)
    start = path[0]
    far = np.linalg.norm(start) > 10 * np.ptp(path, axis=0).max()
    seen = path - start if far else path
    least = _LEAST * max(1.0, float(np.linalg.norm(start)))
    factor, unit = length_unit(np.append(seen, least))
    lines(position, time, seen / factor, XYZ)
    at_least(position, least / factor)
    position.set(title=f"Position of {what}" + (" from its start" if far else ""), ylabel=unit)
    factor, unit = length_unit(np.append(speed, _LEAST))
    lines(velocity, time, speed / factor, XYZ)
    at_least(velocity, _LEAST / factor)
    velocity.set(title=f"Velocity of {what}", ylabel=f"{unit}/s")


def _attitude(axes: Axes, time: Array, run: Trajectory | StagedTrajectory) -> None:
    sequence = stages_of(run)[0].model.attitude
    if sequence == "quaternion":
        lines(axes, time, run.quaternion, {"w": BLACK, **XYZ})
        axes.set(title="Attitude quaternion")
        return
    colours = zip(sequence, XYZ.values(), strict=True)
    labels = {f"α{i} about {axis}": colour for i, (axis, colour) in enumerate(colours, 1)}
    lines(axes, time, wrapped(run.angles(sequence)), labels)
    axes.set(title=f"Attitude angles {sequence}", ylabel="deg")


def _rates(axes: Axes, time: Array, run: Trajectory | StagedTrajectory, scale: float, unit: str) -> None:
    per, name = (scale, unit) if unit in {"h", "day"} else (1.0, "s")
    lines(axes, time, np.rad2deg(run.angular_velocity_body) * per, XYZ)
    axes.set(title="Angular velocity, body axes", ylabel=f"deg/{name}")
    at_least(axes, 1e-6 * per)


def _energy(axes: Axes, time: Array, run: Trajectory | StagedTrajectory) -> None:
    if np.any(run.potential_energy):
        changes = np.column_stack([e - e[0] for e in (run.kinetic_energy, run.potential_energy, run.energy)])
        factor, unit = energy_unit(changes)
        lines(axes, time, changes / factor, {"kinetic": BLUE, "potential": GREEN, "sum": BLACK})
        axes.set(title="Energy gained since the start", ylabel=unit)
        return
    energy = run.kinetic_energy
    factor, unit = energy_unit(energy)
    axes.plot(time, energy / factor, color=BLUE)
    largest = energy.max() / factor
    if np.ptp(energy / factor) < 1e-6 * largest:  # a constant: its rounding is for the next panel
        axes.set_ylim(0, 1.25 * largest)
    axes.set(title="Kinetic energy", ylabel=unit)


def _last(axes: Axes, time: Array, run: Trajectory | StagedTrajectory) -> None:
    """The mass, if it changes; how well the run kept what it keeps; or what its forces read and remember."""
    if np.ptp(run.mass) > 0.0:
        axes.plot(time, run.mass, color=BLUE)
        axes.set(title="Mass", ylabel="kg", ylim=(0.0, None))
    elif isinstance(run, Trajectory):
        if run.conserved() or not draw_signals(axes, time, run):
            _drift(axes, time, run)
    else:
        axes.axis("off")


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


def _time_unit(t: Array) -> tuple[float, str]:
    span = float(t[-1] - t[0])
    for limit, scale, unit in ((600.0, 1.0, "s"), (7200.0, 60.0, "min"), (259200.0, 3600.0, "h")):
        if span <= limit:
            return scale, unit
    return 86400.0, "day"
