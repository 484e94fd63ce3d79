"""NASA's check cases of six-degree-of-freedom simulation, atmospheric: cases 1, 2, 3, 4, 6, 8 and 9."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.resources import files

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.model_file import load_model, shipped_model

from .residual import Residual

__all__ = ["MODELS", "run"]

MODELS = {
    1: "nesc_01_dropped_sphere",
    2: "nesc_02_tumbling_brick",
    3: "nesc_03_damped_brick",
    4: "nesc_04_sphere_round_earth",
    6: "nesc_06_sphere_with_drag",
    8: "nesc_08_sphere_in_wind_shear",
    9: "nesc_09_sphere_fired_east",
}

FOOT = 0.3048

# The program that printed them rounds the constants of the air: an independent integration of order 8 agrees
# with its drag cases to 8e-4 ft, with its rotation to 3e-10 deg/s and 3e-8 deg.
ALTITUDE, VELOCITY = 2e-3, 2e-3
ROTATION = {2: (1e-6, 1e-8), 3: (5e-3, 5e-3)}


def run(number: int) -> Iterator[Residual]:
    """The largest differences of a case from what was printed, over 30 s."""
    printed = _printed(number)
    loaded = load_model(shipped_model(MODELS[number]))
    options = {**loaded.options, "save_every": None, "save_at": printed[:, 1]}
    trajectory = loaded.model.simulate(loaded.x0, loaded.t_span, **options)
    track = loaded.tracks(trajectory)["com"]
    case = f"NESC {number}"

    def residual(quantity: str, got: Array, columns: slice, allowed: float, unit: str) -> Residual:
        difference = got - printed[:, columns]
        if unit == "deg":
            difference = (difference + 180.0) % 360.0 - 180.0
        return Residual(case, quantity, float(np.abs(difference).max()), allowed, unit)

    yield residual("altitude", track.altitude[:, None] / FOOT, slice(2, 3), ALTITUDE, "ft")
    yield residual("velocity", track.velocity_ned / FOOT, slice(3, 6), VELOCITY, "ft/s")
    if number in ROTATION:
        angles, rates = ROTATION[number]
        yield residual("Euler angles", np.rad2deg(track.angles()), slice(6, 9), angles, "deg")
        body_rates = np.rad2deg(trajectory.angular_velocity_body)
        yield residual("inertial body rates", body_rates, slice(9, 12), rates, "deg/s")


def _printed(number: int) -> Array:
    """The rows of a case: number, time, altitude, velocity, angles, rates, as nesc.csv says."""
    with (files("freebody.verify") / "nesc.csv").open(encoding="utf-8") as stream:
        rows = np.loadtxt(stream, delimiter=",", skiprows=3)
    return _check.vector("nesc.csv", rows[rows[:, 0] == number], len(rows) // len(MODELS), 12)
