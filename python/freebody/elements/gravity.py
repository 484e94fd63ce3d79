"""The attraction of a planet."""

from __future__ import annotations

from typing import Any

from freebody import _check
from freebody.environment import Ellipsoid, Environment, Planet
from freebody.errors import InputError
from freebody.tracing import ForceLaw, wrench

__all__ = ["Gravity"]


class Gravity(ForceLaw):
    """The attraction of the environment's planet, at the mass centre of the body as it is at the moment.

    What determines it can be dispersed: the parameters `mu` and `j2` of an ellipsoid (no `j2` where it is
    zero), `acceleration` of a flat earth.

    It has no torque. That of the gradient needs the inertia of all that the body is at the moment, which
    `PointMassGravity` has: `PointMassGravity(planet.mu, planet.center)` beside `Gravity(planet,
    point_mass=False)` is the attraction with that torque, right also for mass that changes. The torque of the
    J2 part, some thousandth of it at the Earth, is left out.

    Parameters
    ----------
    environment
        An environment or a planet.
    point_mass
        Whether the point mass attracts too, or only the rest, J2.
    """

    def __init__(
        self, environment: Environment | Planet, point_mass: bool = True, *, name: str | None = None
    ) -> None:
        planet = environment.planet if isinstance(environment, Environment) else environment
        if not isinstance(planet, Planet):
            raise InputError(f"environment: got {_check.shown(environment)}; give an Environment or a Planet")
        whole = _check.flag("point_mass", point_mass)
        if whole:
            attraction = planet.gravity
        elif isinstance(planet, Ellipsoid) and planet.j2:
            attraction = planet.oblateness
        else:
            raise InputError(
                "point_mass: got False, but the planet has no J2; nothing is left of its gravity"
            )

        def gravity(s: Any, p: Any) -> Any:
            position = s.position_world + s.world_from_body @ s.com
            pull = attraction(position, s.time, p)
            return wrench(force=s.mass * (s.world_from_body.T @ pull), at=s.com)

        super().__init__(gravity, parameters=planet.gravity_parameters, name=name)
