"""How a body starts, from what people say of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.environment.frames import lvlh
from freebody.environment.geodesy import ENU_FROM_NED
from freebody.errors import InputError

if TYPE_CHECKING:
    from freebody.environment.planet import Planet

__all__ = ["FRAMES", "Frame", "motion_of"]

Frame: TypeAlias = Literal["world", "earth", "ned", "enu", "lvlh"]
FRAMES: tuple[str, ...] = get_args(Frame)

Given: TypeAlias = Mapping[str, Any]


def motion_of(
    planet: Planet,
    position: Given,
    velocity: Given,
    turning: tuple[Attitude | None, Frame, ArrayLike, Frame],
    time: float,
    point: ArrayLike,
) -> dict[str, Any]:
    """See `Planet.motion`."""
    time, arm = _check.number("time", time), _check.vector("point", point, 3)
    attitude, relative_to, rate, rates_relative_to = turning
    _check.choice("relative_to", relative_to, FRAMES)
    _check.choice("rates_relative_to", rates_relative_to, FRAMES)
    attitude = Attitude.identity() if attitude is None else attitude
    if not isinstance(attitude, Attitude):
        raise InputError(f"attitude: got {_check.shown(attitude)}; make one with Attitude.angles(...)")
    r = _position(planet, position, time)
    world_from_ned = np.asarray(planet.place(r, time).world_from_ned)
    v = _velocity(planet, velocity, r, world_from_ned, time)
    if relative_to != "world":
        axes = _axes(planet, relative_to, r, v, world_from_ned, time)
        attitude = Attitude.rotation(axes @ attitude.as_rotation())
    world_from_body = attitude.as_rotation()
    frame_rate = _frame_rate(planet, rates_relative_to, r, v, time)
    omega = _check.vector("angular_velocity_body", rate, 3) + world_from_body.T @ frame_rate
    return {
        "position": r - world_from_body @ arm,
        "attitude": attitude,
        "velocity_world": v - world_from_body @ np.cross(omega, arm),
        "angular_velocity_body": omega,
    }


def _position(planet: Planet, given: Given, time: float) -> Array:
    came = {name: value for name, value in given.items() if value is not None}
    ways = [name for name in came if name.startswith("position")]
    if len(ways) + bool(came.keys() - set(ways)) > 1:
        raise InputError(
            f"{', '.join(came)}: say where the point is once: latitude, longitude and altitude, or a position"
        )
    if not ways:
        return planet.position_world(**came, time=time)
    vector = _check.vector(ways[0], came[ways[0]], 3)
    if ways[0] == "position_world":
        return vector
    return planet.center + planet.earth_from_world(time).T @ vector


def _velocity(planet: Planet, given: Given, r: Array, world_from_ned: Array, time: float) -> Array:
    came = {name: value for name, value in given.items() if value is not None}
    if len(came) > 1:
        raise InputError(f"{', '.join(came)}: give one velocity")
    if not came:
        return planet.ground_velocity(r)
    ((name, value),) = came.items()
    vector = _check.vector(name, value, 3)
    if name == "velocity_world":
        return vector
    world_from = {
        "velocity_ned": world_from_ned,
        "velocity_enu": world_from_ned @ ENU_FROM_NED,
        "velocity_earth": planet.earth_from_world(time).T,
    }
    return planet.ground_velocity(r) + world_from[name] @ vector


def _axes(planet: Planet, frame: Frame, r: Array, v: Array, world_from_ned: Array, time: float) -> Array:
    if frame == "lvlh":
        return lvlh(r - planet.center, v).world_from_lvlh
    if frame == "earth":
        return planet.earth_from_world(time).T
    return world_from_ned @ ENU_FROM_NED if frame == "enu" else world_from_ned


def _frame_rate(planet: Planet, frame: Frame, r: Array, v: Array, time: float) -> Array:
    """Angular velocity of a frame, world axes."""
    if frame == "world":
        return np.zeros(3)
    if frame == "earth":
        return np.asarray(planet.angular_velocity_world)
    if frame == "lvlh":
        return lvlh(r - planet.center, v).angular_velocity_world
    return np.asarray(planet.ned_rate(r, v, time))
