"""4179 Toutatis: radar observations against a rotation without torques.

Another program, Principia (mockingbirdnest/Principia, physics/euler_solver_test.cpp), solves the same
rotation analytically and states its difference from every observation. A run from the same start must
differ by the same.
"""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime
from typing import NamedTuple

import numpy as np

from freebody import forms
from freebody._check import Array
from freebody.model_file import load_model, shipped_model

from .printed import off_by
from .residual import Residual

__all__ = ["cases", "differences"]

# Principia states each difference to one unit of its last printed digit.
ALLOWED = 1.0

QUANTITIES = (
    "rate, relative difference",
    "rate, angle in body axes",
    "direction of the third axis",
    "direction of the first axis",
    "direction of the second axis",
)

START = datetime.fromisoformat("1992-11-09T17:49:47")


class Observation(NamedTuple):
    """When (UTC), 3-1-3 angles in deg, body rates in deg/day, and Principia's differences as printed."""

    utc: str
    angles: tuple[float, float, float]
    rates: tuple[float, float, float]
    differences: str

    @property
    def seconds(self) -> float:
        """Time since the start, without the six leap seconds before 2008, in which it turns by 0.007 deg."""
        return (datetime.fromisoformat(self.utc) - START).total_seconds()


# Takahashi, Busch and Scheeres (2013), The Astronomical Journal 146:95, Table 3; the third rate of 1992-12-12
# as Principia has it.
OBSERVATIONS = tuple(
    Observation(*row)
    for row in (
        ("1992-12-02T21:40", (122.2, 86.5, 107.0), (-35.6, 7.2, -97.0), "0.011 4.5 7.9 5.4 5.9"),
        ("1992-12-03T19:30", (86.3, 81.8, 24.5), (-16.4, -29.1, -91.9), "0.076 0.5 6.6 7.7 4.7"),
        ("1992-12-04T18:10", (47.8, 60.7, 284.0), (29.1, -23.2, -97.8), "0.005 5.0 13 15 9.4"),
        ("1992-12-05T18:50", (14.6, 39.4, 207.1), (33.3, 8.2, -92.2), "0.064 1.1 9.4 4.3 8.4"),
        ("1992-12-06T17:30", (331.3, 23.7, 151.6), (6.6, 34.5, -95.8), "0.032 0.8 2.0 0.6 2.1"),
        ("1992-12-07T17:20", (222.5, 25.4, 143.9), (12.8, 25.4, -104.1), "0.028 24 5.7 15 15"),
        ("1992-12-08T16:40", (169.8, 45.5, 106.9), (-31.1, -21.9, -97.7), "0.0001 2.7 3.0 2.6 2.6"),
        ("1992-12-09T17:50", (137.3, 71.3, 22.3), (11.8, -36.9, -94.9), "0.028 3.4 3.4 3.4 1.1"),
        ("1992-12-10T17:20", (103.1, 85.2, 292.6), (35.8, -8.9, -97.9), "0.0009 0.8 3.1 1.4 3.4"),
        ("1992-12-11T09:40", (77.0, 85.7, 225.5), (31.0, 17.0, -96.3), "0.022 1.0 2.8 1.6 2.7"),
        ("1992-12-12T09:20", (42.8, 70.2, 133.2), (-1.3, 37.0, -95.9), "0.025 2.2 2.0 3.2 2.6"),
        ("1992-12-13T08:10", (13.7, 44.4, 51.9), (-38.3, 17.9, -97.3), "0.013 3.4 2.5 5.3 5.3"),
        ("1992-12-14T07:50", (323.7, 14.0, 0.0), (-70.5, -30.6, -91.1), "0.119 22 4.1 3.8 4.5"),
        ("1992-12-15T07:50", (193.2, 24.4, 21.4), (22.1, -26.6, -96.6), "0.026 4.9 3.2 8.2 8.0"),
        ("1992-12-16T07:10", (165.1, 46.4, 310.6), (33.4, -3.4, -93.7), "0.052 2.6 7.3 5.8 8.0"),
        ("1992-12-17T06:49", (130.6, 76.1, 234.9), (12.6, 33.9, -94.0), "0.045 2.1 0.8 1.1 1.2"),
        ("1992-12-18T07:09", (91.6, 81.6, 142.4), (-24.3, 29.6, -102.0), "0.036 2.1 5.6 6.3 4.1"),
        ("2008-11-23T10:45", (86.2, 85.0, 0.3), (-0.4, -36.2, -98.9), "0.0005 40 29 122 131"),
    )
)


def cases() -> Iterator[Residual]:
    """For each kind of difference, the largest deviation from Principia's, in its last printed digits."""
    deviations = []
    for observation, computed in zip(OBSERVATIONS, differences(), strict=True):
        deviations.append(off_by(computed, observation.differences))
    for quantity, worst in zip(QUANTITIES, np.max(deviations, axis=0), strict=True):
        yield Residual("Toutatis", quantity, float(worst), ALLOWED, "last digit")


def differences() -> Array:
    """Computed against observed, (18, 5): |ω| relative; in degrees ω in body axes, axes 3, 1, 2 in space."""
    loaded = load_model(shipped_model("toutatis"))
    times = np.array([observation.seconds for observation in OBSERVATIONS])
    options = {**loaded.options, "save_every": None, "save_at": times}
    run = loaded.model.simulate(loaded.x0, (0.0, times[-1]), **options)
    observed = np.array([observation.rates for observation in OBSERVATIONS])
    rates = np.rad2deg(run.angular_velocity_body) * 86400.0
    sizes = np.linalg.norm(rates, axis=1), np.linalg.norm(observed, axis=1)
    angles = np.deg2rad([observation.angles for observation in OBSERVATIONS])
    axes = _angle(run.world_from_body, forms.rotation(angles, "zxz"), axis=1)
    return np.column_stack(
        [
            np.abs(sizes[0] / sizes[1] - 1.0),
            _angle(rates, observed, axis=1),
            axes[:, 2],
            axes[:, 0],
            axes[:, 1],
        ]
    )


def _angle(a: Array, b: Array, axis: int) -> Array:
    """The angle in degrees between vectors along `axis`."""
    sine = np.linalg.norm(np.cross(a, b, axis=axis), axis=axis)
    return np.rad2deg(np.arctan2(sine, np.sum(a * b, axis=axis)))
