"""Panels of a run as its planet sees it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes

from freebody.environment import Planet, Track
from freebody.simulation import Trajectory

from .panels import at_least, length_unit, lines, wrapped
from .style import BLACK, BLUE, GREEN, RED

__all__ = ["draw_tracks", "seen_from"]


def seen_from(planet: Planet, run: Trajectory) -> Track:
    """The way of the body's mass centre over the planet."""
    return planet.track(run, run.model.body.com)


def draw_tracks(axes: Mapping[str, Axes], time: np.ndarray, stages: Sequence[Track]) -> None:
    """Draws the panels that `axes` has: altitude, speed, place, pointing; `stages` follow one another."""

    def joined(name: str) -> np.ndarray:
        return np.concatenate([getattr(track, name) for track in stages])

    altitude = joined("altitude")
    factor, unit = length_unit(np.append(altitude, 1.0))
    axes["altitude"].plot(time, altitude / factor, color=BLUE)
    axes["altitude"].set(title="Altitude", ylabel=unit)
    at_least(axes["altitude"], 0.01 / factor)
    ground, air = joined("speed"), np.concatenate([track.flow.airspeed for track in stages])
    factor, unit = length_unit(ground)
    if np.allclose(ground, air, rtol=1e-3, atol=1e-3 * ground.max()):
        axes["speed"].plot(time, ground / factor, color=BLACK)
        axes["speed"].set(title="Speed over the ground", ylabel=f"{unit}/s")
    else:
        speeds = np.column_stack([ground, air]) / factor
        lines(axes["speed"], time, speeds, {"over the ground": BLACK, "in the medium": BLUE})
        axes["speed"].set(title="Speed", ylabel=f"{unit}/s")
    at_least(axes["speed"], 1e-3 * max(float(ground.max()), 1e-3) / factor)
    if "place" in axes:
        _place(axes["place"], time, np.column_stack([joined("latitude"), joined("longitude")]))
    if "pointing" in axes:
        angles = np.concatenate([track.angles("zyx", "ned") for track in stages])
        lines(axes["pointing"], time, wrapped(angles), {"yaw": BLUE, "pitch": GREEN, "roll": RED})
        axes["pointing"].set(title="Attitude, local axes", ylabel="deg")


def _place(axes: Axes, time: np.ndarray, place: np.ndarray) -> None:
    """Where the way is short, from its start."""
    along = np.unwrap(place, axis=0)
    start = np.rad2deg(along[0])
    title = "Latitude and longitude"
    if np.ptp(along, axis=0).max() < np.deg2rad(10.0):
        along, title = along - along[0], f"Place from {start[0]:.4g}, {start[1]:.4g} deg"
        lines(axes, time, np.rad2deg(along), {"latitude": BLUE, "longitude": RED})
    else:
        lines(axes, time, wrapped(along), {"latitude": BLUE, "longitude": RED})
    axes.set(title=title, ylabel="deg")
    at_least(axes, 1e-5)  # a metre
