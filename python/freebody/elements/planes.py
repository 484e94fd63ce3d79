"""Planes that bodies meet: in the world, or level on a planet."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.commands import unit_vector
from freebody.environment import Environment, checked_environment
from freebody.tracing.declaration import check_name

__all__ = ["Plane", "ground", "plane"]


class Plane(NamedTuple):
    """A plane, as laws ask for it.

    Attributes
    ----------
    at
        Of the situation, the parameters and a position, world axes: how deep the position lies, the direction
        out of the plane, the velocity of the plane there.
    parameters, inputs
        What a law declares for it.
    """

    at: Callable[[Any, Any, Any], tuple[Any, Any, Any]]
    parameters: Mapping[str, tuple[float, str]]
    inputs: Mapping[str, str]


def plane(through: ArrayLike, normal: ArrayLike, velocity: ArrayLike, moving: str | None) -> Plane:
    """A plane of the world that moves with a constant velocity, and along its normal as inputs say."""
    start, up = _check.vector("through", through, 3), unit_vector("normal", normal)
    drift = _check.vector("velocity", velocity, 3)
    inputs: dict[str, str] = {}
    if moving is not None:
        check_name("moving", moving)
        inputs = {f"{moving}_height": "m", f"{moving}_speed": "m/s"}

    def at(s: Any, p: Any, position: Any) -> tuple[Any, Any, Any]:
        depth = up @ start + (up @ drift) * s.time - position @ up
        if moving is None:
            return depth, up, drift
        height, speed = (s.inputs[n] for n in inputs)
        return depth + height, up, drift + speed * up

    return Plane(at, {}, inputs)


def ground(environment: Environment, altitude: float) -> Plane:
    """The ground of a planet at one altitude."""
    planet = checked_environment(environment).planet

    def at(s: Any, p: Any, position: Any) -> tuple[Any, Any, Any]:
        place = planet.place(position, s.time)
        return p.altitude - place.altitude, -place.world_from_ned[:, 2], planet.ground_velocity(position)

    return Plane(at, {"altitude": (_check.number("altitude", altitude), "m")}, {})
