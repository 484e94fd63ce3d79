"""The surroundings of a body, as laws ask for them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any, NamedTuple, TypeVar

import numpy as np

from freebody import _check
from freebody.environment.atmosphere import Air, Atmosphere, UniformAtmosphere
from freebody.environment.limits import Limit
from freebody.environment.planet import FlatEarth, Place, Planet
from freebody.environment.wind import Calm, Wind, merged
from freebody.errors import InputError
from freebody.tracing import NoticeLaw, notice
from freebody.tracing.declaration import Shared

__all__ = ["Environment", "Flow", "checked_environment"]

K = TypeVar("K", Planet, Atmosphere, Wind)


class Flow(NamedTuple):
    """How the medium meets a material point of the body.

    Attributes
    ----------
    place
        Where the point is.
    air
        The state of the medium there.
    velocity, angular_velocity
        Of the body relative to the medium at that point, body axes, (3,) m/s and rad/s.
    """

    place: Place
    air: Air
    velocity: Any
    angular_velocity: Any


class Environment:
    """A planet, its medium and the wind. Forces and laws take it as an argument.

    What is omitted is a flat Earth with air of one density, and calm.

    Attributes
    ----------
    parameters, inputs
        What a law that asks for the flow declares. Its parameters are shared: to disperse
        "environment.wind_speed" sets it in all laws of a model at once.
    notices
        Say in the outcome of a run that its mass centre left the range of a table or of a model.
    steady
        The same without turbulence and gusts on the way through the air.
    """

    def __init__(
        self, planet: Planet | None = None, atmosphere: Atmosphere | None = None, wind: Wind | None = None
    ) -> None:
        self.planet = _checked("planet", planet, Planet, FlatEarth)
        self.atmosphere = _checked("atmosphere", atmosphere, Atmosphere, UniformAtmosphere)
        self.wind = _checked("wind", wind, Wind, Calm)
        both = merged("environment", self.atmosphere.parameters, self.wind.parameters)
        self._parameters = {name: Shared(*pair) for name, pair in both.items()}

    @property
    def parameters(self) -> Mapping[str, tuple[float, str]]:
        return self._parameters

    @property
    def inputs(self) -> Mapping[str, str]:
        return self.wind.inputs

    @property
    def steady(self) -> Environment:
        return Environment(self.planet, self.atmosphere, self.wind.steady)

    @cached_property
    def notices(self) -> tuple[NoticeLaw, ...]:
        limits = (*self.planet.limits, *self.atmosphere.limits, *self.wind.limits)
        return tuple(_notice(self.planet, limit) for limit in limits)

    def flow(self, s: Any, p: Any = None, at: Any = (0.0, 0.0, 0.0)) -> Flow:
        """The flow at the material point `at`, body axes from the origin, m; `s` and `p` of the law."""
        arm = s.world_from_body @ np.asarray(at)
        position = s.position_world + arm
        place = self.planet.place(position, s.time)
        wind = self.wind.here(place, s, p)
        medium = self.planet.ground_velocity(position) + place.world_from_ned @ wind.velocity_ned
        body_from_world = s.world_from_body.T
        velocity = (
            s.velocity_body + np.cross(s.angular_velocity_body, np.asarray(at)) - body_from_world @ medium
        )
        turning = body_from_world @ self.planet.angular_velocity_world + wind.rotation_body
        return Flow(place, self.atmosphere.at(place.altitude, p), velocity, s.angular_velocity_body - turning)


def _checked(name: str, given: K | None, kind: type[K], default: type[K]) -> K:
    if given is None:
        return default()
    if not isinstance(given, kind):
        raise InputError(f"{name}: got {_check.shown(given)}; give a {kind.__name__} of freebody.environment")
    return given


def _notice(planet: Planet, limit: Limit) -> NoticeLaw:
    def inside(s: Any) -> Any:
        return limit.inside(planet.place(s.position_world + s.world_from_body @ s.com, s.time))

    return notice(limit.message, inside, name=limit.name)


def checked_environment(value: object, whose: str = "") -> Environment:
    """Check an environment; `whose` is what messages begin with."""
    if not isinstance(value, Environment):
        raise InputError(f"{whose}environment: got {_check.shown(value)}; give an Environment")
    return value
