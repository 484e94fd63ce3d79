"""Air that moves, and aerodynamics with every kind of coefficient."""

from __future__ import annotations

from typing import Any

import numpy as np

import freebody as fb
from freebody.elements import Aerodynamics, Lookup
from freebody.environment import Environment, Place, Wind, WindHere

ALPHA = np.deg2rad([-180.0, -40.0, -15.0, 5.0, 30.0, 70.0, 180.0])
BETA = np.deg2rad([-90.0, -20.0, 10.0, 90.0])
LIFT = fb.Table(ALPHA, np.sin(2.0 * ALPHA))
PITCH = fb.Table((ALPHA, BETA), np.cos(ALPHA)[:, None] * np.sin(BETA) - 0.3 * np.sin(ALPHA)[:, None])
DAMPING = fb.Table(ALPHA, 1.0 + 0.2 * np.cos(ALPHA))


class Sheared(Wind):
    """A wind that grows with height and turns the air."""

    def __init__(self) -> None:
        self.parameters = {"wind_north": (1.5, "m/s")}

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        north = 1.5 if p is None else p.wind_north
        turning = s.world_from_body.T @ np.array([0.01, -0.02, 0.03])
        return WindHere(np.stack([north + 0.1 * place.altitude, -0.7, 0.2]), turning)


WINDY = Environment(wind=Sheared())


def element(
    axes: Any = "wind", at: Any = (0.4, -0.1, 0.2), environment: Environment = WINDY, turn: Any = None
) -> Aerodynamics:
    """Derivatives, tables of one and of two variables, their products with rates, and a function."""
    x, z = ("CX", "CZ") if axes == "body" else ("CD", "CL")
    return Aerodynamics(
        environment,
        0.3,
        1.2,
        0.4,
        {
            x: {"0": 0.4, "alpha^2": 0.9, "beta^2": 0.5},
            "CY": {"beta": -0.6, "alpha rudder": 0.2},
            z: {"0": Lookup(LIFT, "alpha"), "q_hat": Lookup(DAMPING, "alpha")},
            "Cl": {"p_hat": Lookup(DAMPING, "alpha"), "0": [Lookup(PITCH, "alpha", "beta"), 0.01]},
            "Cm": {"0": lambda a: np.sin(a.alpha) * a.controls.rudder, "q_hat": -4.0},
            "Cn": {"beta": 0.1, "r_hat": -0.4, "mach": 0.2},
        },
        at,
        axes=axes,
        body_from_aero=turn,
        controls={"rudder": "rad"},
        name="hull",
    )
