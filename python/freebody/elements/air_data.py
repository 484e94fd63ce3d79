"""How the air meets a body: what aerodynamic coefficients are functions of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody._check import Array
from freebody.environment import Environment, Flow
from freebody.tracing import NoticeLaw
from freebody.tracing.situation import Names

__all__ = ["VARIABLES", "AirData", "Station"]

VARIABLES = {
    "alpha": "rad",
    "beta": "rad",
    "mach": "1",
    "altitude": "m",
    "airspeed": "m/s",
    "p_hat": "1",
    "q_hat": "1",
    "r_hat": "1",
}
"""What tables and derivatives may be of, besides controls, with their units."""

# Below this the flow is taken as from ahead: the forces there are of the order of its square.
_STILL = 1e-6  # m/s


@dataclass(frozen=True)
class AirData:
    """The flow at a point of the body; SI and radians, numbers without units.

    Attributes
    ----------
    alpha, beta
        Angle of attack atan2(w, u) and of sideslip atan2(v, √(u² + w²)), rad, of the velocity (u, v, w)
        relative to the air; zero where there is none.
    mach, altitude, airspeed, dynamic_pressure
        altitude in m above the ellipsoid, airspeed in m/s, dynamic_pressure in Pa.
    p_hat, q_hat, r_hat
        The angular velocity relative to the air, made dimensionless: p b/2V, q c/2V, r b/2V.
    controls
        By name.
    """

    alpha: Any
    beta: Any
    mach: Any
    altitude: Any
    airspeed: Any
    dynamic_pressure: Any
    p_hat: Any
    q_hat: Any
    r_hat: Any
    controls: Names

    def __getitem__(self, name: str) -> Any:
        return getattr(self, name) if name in VARIABLES else self.controls[name]


@dataclass(frozen=True)
class Station:
    """Where the air is met, and what makes it dimensionless.

    Attributes
    ----------
    at
        The material point, body axes from the origin, (3,) m.
    span, chord
        m.
    controls
        Name: unit, of the inputs that coefficients depend on.
    body_from_aero
        Forward, right and down in body axes, the columns of (3, 3); None where they are the body axes.
    """

    environment: Environment
    at: tuple[float, float, float]
    span: float
    chord: float
    controls: Mapping[str, str]
    body_from_aero: Array | None = None

    @property
    def parameters(self) -> dict[str, tuple[float, str]]:
        return {**self.environment.parameters}

    @property
    def inputs(self) -> dict[str, str]:
        return {**self.environment.inputs, **self.controls}

    def meet(self, s: Any, p: Any, at: Any = None) -> tuple[Flow, AirData]:
        """The flow, here or `at`, and what coefficients are functions of, in a law with its `s` and `p`."""
        flow = self.environment.flow(s, p, at=self.at if at is None else at)
        u, v, w = self._from_body_axes(1.0 * flow.velocity)
        ahead = u * u + w * w
        square = ahead + v * v
        speed = np.linalg.norm(np.stack([u, v, w]))
        # Both sides of a choice are computed, and the derivative of atan2 is none where both are zero.
        alpha = np.arctan2(w, np.where(ahead > _STILL**2, u, 1.0))
        beta = np.arctan2(v, np.where(square > _STILL**2, np.hypot(u, w), 1.0))
        per = 0.5 / np.maximum(speed, 1e3 * _STILL)
        wx, wy, wz = self._from_body_axes(1.0 * flow.angular_velocity)
        return flow, AirData(
            alpha=alpha,
            beta=beta,
            mach=speed / (1.0 * flow.air.speed_of_sound),
            altitude=1.0 * flow.place.altitude,
            airspeed=speed,
            dynamic_pressure=0.5 * flow.air.density * square,
            p_hat=wx * self.span * per,
            q_hat=wy * self.chord * per,
            r_hat=wz * self.span * per,
            controls=Names("control", {name: 1.0 * s.inputs[name] for name in self.controls}),
        )

    def in_body_axes(self, vector: Any) -> Any:
        """A vector (3,) told in forward, right and down."""
        return vector if self.body_from_aero is None else self.body_from_aero @ vector

    def _from_body_axes(self, vector: Any) -> Any:
        return vector if self.body_from_aero is None else self.body_from_aero.T @ vector

    def notice(self, variable: str, low: float, high: float, of: str, beyond: str) -> NoticeLaw:
        """Says that a variable left the range of the tables of something, and what holds beyond."""

        def inside(s: Any, p: Any) -> Any:
            _, a = self.meet(s, p)
            return np.minimum(a[variable] - low, high - a[variable])

        unit = {**VARIABLES, **self.controls}[variable]
        span = f"{low:.6g} to {high:.6g}" + ("" if unit == "1" else f" {unit}")
        message = f"{variable} leaves {span} of the tables of {of}, {beyond}"
        return NoticeLaw(message, inside, self.parameters, self.inputs)
