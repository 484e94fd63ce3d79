"""Standard variables that flight gives a model, and what models give: names of ANSI/AIAA S-119-2011.

Names compare without regard to case: files write altitudeMSL and altitudeMsl.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from freebody.environment import Flow

__all__ = ["QUANTITIES", "RESULTS", "AirData", "Standard", "air_data"]

_SLOWEST = 1e-9  # m/s: at rest there is no direction; this keeps angles and their derivatives finite
_SEA_LEVEL_DENSITY = 1.225  # kg/m³, US Standard Atmosphere 1976; defines the equivalent airspeed


class AirData(NamedTuple):
    """The flow in the axes of the model, forward, right and down; SI."""

    flow: Flow
    velocity: Any
    angular_velocity: Any
    airspeed: Any
    angle_of_attack: Any
    angle_of_sideslip: Any

    @property
    def dynamic_pressure(self) -> Any:
        """ρ V²/2, Pa."""
        return 0.5 * self.flow.air.density * self.airspeed**2


def air_data(flow: Flow, body_from_model: Any) -> AirData:
    """Airspeed and angles of a flow."""
    velocity, rate = body_from_model.T @ flow.velocity, body_from_model.T @ flow.angular_velocity
    u, v, w = velocity
    in_plane = np.hypot(u, w)
    still = in_plane < _SLOWEST
    alpha = np.arctan2(w, np.where(still, _SLOWEST, u))
    beta = np.arctan2(v, np.where(still, _SLOWEST, in_plane))
    return AirData(flow, velocity, rate, np.linalg.norm(velocity), alpha, beta)


class Standard(NamedTuple):
    """A standard variable: its name, its unit of SI, and how flight gives it."""

    name: str
    unit: str
    value: Callable[[AirData], Any]


class Result(NamedTuple):
    """A standard result, its unit of SI, and other names that files have for it."""

    name: str
    unit: str
    aliases: tuple[str, ...] = ()


def _table(*entries: Standard) -> dict[str, Standard]:
    return {entry.name.casefold(): entry for entry in entries}


QUANTITIES = _table(
    Standard("trueAirspeed", "m/s", lambda a: a.airspeed),
    Standard(
        "equivalentAirspeed", "m/s", lambda a: a.airspeed * np.sqrt(a.flow.air.density / _SEA_LEVEL_DENSITY)
    ),
    Standard("mach", "1", lambda a: a.airspeed / a.flow.air.speed_of_sound),
    Standard("dynamicPressure", "Pa", lambda a: a.dynamic_pressure),
    Standard("angleOfAttack", "rad", lambda a: a.angle_of_attack),
    Standard("angleOfSideslip", "rad", lambda a: a.angle_of_sideslip),
    Standard("bodyAngularRate_Roll", "rad/s", lambda a: a.angular_velocity[0]),
    Standard("bodyAngularRate_Pitch", "rad/s", lambda a: a.angular_velocity[1]),
    Standard("bodyAngularRate_Yaw", "rad/s", lambda a: a.angular_velocity[2]),
    Standard("altitudeMSL", "m", lambda a: a.flow.place.altitude),
    Standard("airDensity", "kg/m^3", lambda a: a.flow.air.density),
    Standard("ambientPressure", "Pa", lambda a: a.flow.air.pressure),
    Standard("ambientTemperature", "K", lambda a: a.flow.air.temperature),
    Standard("speedOfSound", "m/s", lambda a: a.flow.air.speed_of_sound),
)
"""What flight gives, by folded name; rates are relative to the medium."""

RESULTS = (
    *(Result(f"aeroBodyForceCoefficient_{x}", "1") for x in "XZ"),
    Result("aeroBodyForceCoefficient_Y", "1", ("sideforceCoefficient",)),
    Result("totalCoefficientOfLift", "1", ("liftCoefficient",)),
    Result("totalCoefficientOfDrag", "1", ("dragCoefficient",)),
    Result("aeroBodyMomentCoefficient_Roll", "1", ("rollingMomentCoefficient",)),
    Result("aeroBodyMomentCoefficient_Pitch", "1", ("pitchingMomentCoefficient",)),
    Result("aeroBodyMomentCoefficient_Yaw", "1", ("yawingMomentCoefficient",)),
    *(Result(f"aeroBodyForce_{x}", "N") for x in "XYZ"),
    *(Result(f"aeroBodyMoment_{x}", "N m") for x in ("Roll", "Pitch", "Yaw")),
    *(Result(f"thrustBodyForce_{x}", "N", (f"bodyThrustForce_{x}",)) for x in "XYZ"),
    *(Result(f"thrustBodyMoment_{x}", "N m", (f"bodyThrustMoment_{x}",)) for x in ("Roll", "Pitch", "Yaw")),
    Result("referenceWingArea", "m^2", ("referenceArea",)),
    Result("referenceWingSpan", "m", ("lateralReferenceLength",)),
    Result("referenceWingChord", "m", ("longitudinalReferenceLength",)),
)
"""What a model gives to the force."""
