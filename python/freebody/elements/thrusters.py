"""Thrusters: where they push, how strongly, and what flows out of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.elements.commands import Command, command, unit_vector
from freebody.elements.seats import at_least
from freebody.errors import InputError
from freebody.tracing.declaration import check_name

__all__ = ["Jet", "Thruster"]

STANDARD_GRAVITY = 9.80665


class Jet(NamedTuple):
    """What a thruster does at a moment: force (3,) N, body axes; mass flow, kg/s; rate of its level, 1/s."""

    force: Any
    flow: Any
    level_rate: Any


class Thruster:
    """One thruster of a `Propulsion`.

    Thrust is level (F - p A), the mass flow level F / (g0 Isp), with g0 = 9.80665 m/s^2. The level is the
    throttle between 0 and 1, late by the lag, and falls to zero with the propellant.

    Parameters
    ----------
    at
        Where it acts, and where the propellant leaves, body axes, (3,) m.
    direction
        Of the force on the body, body axes, (3,); scaled to length one.
    thrust
        F, N: in vacuum where there is an `exit_area`, at the place of use otherwise.
    specific_impulse
        Isp, s, of the thrust F. Without it nothing flows.
    tanks
        Name of the tank that it draws from, or {name: share} for several; shares are by mass.
    throttle
        Name of an input, or a number, 1 by default. Clipped to 0 ... 1.
    lag
        Time constant, s, of the first-order lag of the level; without it the level is the throttle.
    gimbal
        Pairs (angle, axis), the outer one first: the direction is turned by each angle, the name of an input
        or a number in rad, about its axis, body axes, (3,).
    exit_area
        A, m^2: on it the pressure p of the air takes thrust away, where the propulsion has an environment.
    exit_radius
        m: the propellant leaves over a disc of this radius and takes its share of the rotation along.
    name
        A word; parameters and states begin with it.

    Parameters of the law, behind `<name>_`: `thrust`, `specific_impulse`, `lag`, `exit_area`; `throttle`,
    `gimbal_1` ... where these are numbers.
    """

    def __init__(
        self,
        at: ArrayLike,
        direction: ArrayLike,
        thrust: float,
        *,
        specific_impulse: float | None = None,
        tanks: str | Mapping[str, float] | None = None,
        throttle: str | float = 1.0,
        lag: float | None = None,
        gimbal: Sequence[tuple[str | float, ArrayLike]] = (),
        exit_area: float | None = None,
        exit_radius: float = 0.0,
        name: str = "thruster",
    ) -> None:
        check_name("thruster: name", name)
        self.name = name
        self.at = _check.vector(f"{name}: at", at, 3)
        self.direction = unit_vector(f"{name}: direction", direction)
        self.exit_radius = at_least(f"{name}: exit_radius", exit_radius)
        self.shares = _shares(name, tanks)
        if (specific_impulse is None) != (not self.shares):
            raise InputError(
                f"{name}: specific_impulse, tanks: one came without the other; propellant that flows comes "
                "from a tank"
            )
        self._throttle = command(f"{name}: throttle", throttle, "1", f"{name}_throttle")
        if isinstance(gimbal, str) or not isinstance(gimbal, Sequence):
            raise InputError(f"{name}: gimbal: got {_check.shown(gimbal)}; give a list of (angle, axis)")
        self._gimbal = [_turning(name, i, pair) for i, pair in enumerate(gimbal)]
        self.parameters: dict[str, tuple[float, str]] = {
            f"{name}_thrust": (at_least(f"{name}: thrust", thrust), "N")
        }
        for key, value, unit in (
            ("specific_impulse", specific_impulse, "s"),
            ("lag", lag, "s"),
            ("exit_area", exit_area, "m^2"),
        ):
            if value is not None:
                number = _check.number(f"{name}: {key}", value, positive=True)
                self.parameters[f"{name}_{key}"] = (number, unit)
        self.inputs: dict[str, str] = {}
        for each in (self._throttle, *(angle for angle, _ in self._gimbal)):
            self.parameters |= each.parameters
            self.inputs |= each.inputs
        self.states = {} if lag is None else {f"{name}_level": (0.0, "1")}
        self.feels_pressure = exit_area is not None

    def jet(self, s: Any, p: Any, available: Any, pressure: Any) -> Jet:
        """In a law: what it does while the share `available` of the propellant it asks for comes."""
        name, level_rate = self.name, 0.0
        level = np.clip(self._throttle.value(s, p), 0.0, 1.0)
        if self.states:
            state = s.states[f"{name}_level"]
            level, level_rate = state, (level - state) / p[f"{name}_lag"]
        level, thrust = level * available, p[f"{name}_thrust"]
        flow = level * thrust / (STANDARD_GRAVITY * p[f"{name}_specific_impulse"]) if self.shares else 0.0
        if self.feels_pressure:
            thrust = thrust - pressure * p[f"{name}_exit_area"]
        direction: Any = self.direction
        for angle, axis in reversed(self._gimbal):
            direction = _turned(direction, axis, angle.value(s, p))
        return Jet(level * thrust * direction, flow, level_rate)

    def carried(self, omega: Any) -> Any:
        """The angular momentum about the origin that a kilogram takes along with the rotation, m^2/s."""
        disc = 0.25 * self.exit_radius**2
        axial = self.direction * (self.direction @ omega)
        return np.cross(self.at, np.cross(omega, self.at)) + disc * (omega + axial)


def _shares(name: str, tanks: str | Mapping[str, float] | None) -> dict[str, float]:
    if tanks is None:
        return {}
    given = {tanks: 1.0} if isinstance(tanks, str) else tanks
    if not isinstance(given, Mapping) or not given:
        raise InputError(
            f"{name}: tanks: got {_check.shown(tanks)}; give the name of a tank, or {{name: share}}"
        )
    shares = {key: _check.number(f"{name}: tanks[{key!r}]", given[key], positive=True) for key in given}
    return {key: share / sum(shares.values()) for key, share in shares.items()}


def _turning(name: str, i: int, pair: Any) -> tuple[Command, Array]:
    where = f"{name}: gimbal[{i}]"
    if not isinstance(pair, tuple | list) or len(pair) != 2:
        raise InputError(f"{where}: got {_check.shown(pair)}; give (angle, axis)")
    angle, axis = pair
    return command(where, angle, "rad", f"{name}_gimbal_{i + 1}"), unit_vector(f"{where}: axis", axis)


def _turned(vector: Any, axis: Array, angle: Any) -> Any:
    """A vector turned about an axis. Rodrigues' formula."""
    along = axis * (axis @ vector)
    return along + (vector - along) * np.cos(angle) + np.cross(axis, vector) * np.sin(angle)
