"""Winds that depend on the altitude alone."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.environment.limits import Limit, altitude_limits
from freebody.environment.planet import Place
from freebody.environment.wind import NamedWind, WindHere, turned
from freebody.errors import InputError
from freebody.tables import Table

__all__ = ["ConstantWind", "LogWind", "PowerLawWind", "WindShear", "WindTable"]


class ConstantWind(NamedWind):
    """One velocity everywhere, of air or of water.

    Parameters
    ----------
    velocity
        Towards which it blows or flows, north, east, down, (3,) m/s.
    name
        The word before the names of its parameters: "wind_speed", horizontal, m/s; "wind_direction", towards
        which, clockwise from north, rad; "wind_down", m/s.
    """

    def __init__(self, velocity: ArrayLike, *, name: str = "wind") -> None:
        north, east, down = (float(v) for v in _check.vector("velocity", velocity, 3))
        speed, direction = float(np.hypot(north, east)), float(np.arctan2(east, north))
        super().__init__(
            name, {"speed": (speed, "m/s"), "direction": (direction, "rad"), "down": (down, "m/s")}
        )

    @classmethod
    def blowing_from(cls, direction: float, speed: float, *, name: str = "wind") -> ConstantWind:
        """As meteorologists say it: from where, clockwise from north, rad; how fast, m/s."""
        return cls(_towards(direction, speed), name=name)

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        speed, direction = self._value(p, "speed"), self._value(p, "direction")
        north, east = speed * np.cos(direction), speed * np.sin(direction)
        return WindHere(np.stack([north, east, self._value(p, "down")]), np.zeros(3))


class _Profile(NamedWind):
    """A velocity by altitude, that can be scaled and turned."""

    def __init__(self, name: str) -> None:
        super().__init__(name, {"factor": (1.0, "1"), "turn": (0.0, "rad")})

    @abstractmethod
    def velocity(self, altitude: Any) -> Any:
        """North, east, down, (3,) m/s, at an altitude, m."""

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        velocity = self._value(p, "factor") * self.velocity(place.altitude)
        return WindHere(turned(velocity, self._value(p, "turn")), np.zeros(3))


class WindTable(_Profile):
    """A wind by altitude, straight lines between the rows.

    Below the first and above the last row these hold; a run in which the body is there says so.

    Parameters
    ----------
    altitude
        Rising, (n,) m.
    velocity
        Towards which it blows, north, east, down, (n, 3) m/s.
    name
        The word before the names of its parameters: "wind_factor" multiplies it, "wind_turn" turns it
        clockwise seen from above, rad.
    """

    def __init__(self, altitude: ArrayLike, velocity: ArrayLike, *, name: str = "wind") -> None:
        super().__init__(name)
        self.altitude = _check.series("altitude", altitude)
        self.velocities = _check.vector("velocity", velocity, len(self.altitude), 3)
        self._tables = [Table(self.altitude, column) for column in self.velocities.T]

    @classmethod
    def blowing_from(
        cls, altitude: ArrayLike, direction: ArrayLike, speed: ArrayLike, *, name: str = "wind"
    ) -> WindTable:
        """As a sounding has it: from where, clockwise from north, (n,) rad; how fast, (n,) m/s.

        It is the velocities, not the angles, between which straight lines are drawn.
        """
        n = len(_check.series("altitude", altitude))
        from_where, how_fast = _check.vector("direction", direction, n), _check.vector("speed", speed, n)
        rows = [_towards(d, v) for d, v in zip(from_where, how_fast, strict=True)]
        return cls(altitude, np.array(rows), name=name)

    @property
    def limits(self) -> tuple[Limit, ...]:
        low, high = float(self.altitude[0]), float(self.altitude[-1])
        held = ("its first row holds below", "its last row holds")
        return altitude_limits(f"{self.name} table", low, high, held)

    def velocity(self, altitude: Any) -> Any:
        return np.stack([table(altitude) for table in self._tables])


class WindShear(_Profile):
    """A wind that grows linearly with the altitude, without end.

    Parameters
    ----------
    gradient
        Of the velocity towards which it blows, north, east, down, (3,) 1/s.
    velocity, altitude
        The velocity (3,) m/s at one altitude, m.
    name
        As of `WindTable`.
    """

    def __init__(
        self,
        gradient: ArrayLike,
        velocity: ArrayLike = (0.0, 0.0, 0.0),
        altitude: float = 0.0,
        *,
        name: str = "wind",
    ) -> None:
        super().__init__(name)
        self.gradient = _check.vector("gradient", gradient, 3)
        self.base = _check.vector("velocity", velocity, 3)
        self.altitude = _check.number("altitude", altitude)

    def velocity(self, altitude: Any) -> Any:
        return self.base + self.gradient * (1.0 * (altitude - self.altitude))


class _BoundaryLayer(NamedWind):
    """A wind near the ground, of one direction: its speed at a height says how fast it is at all others."""

    def __init__(
        self, speed: float, direction: float, height: float, ground: float, top: float | None, name: str
    ) -> None:
        towards = {"speed": (_check.number("speed", speed), "m/s")}
        super().__init__(name, towards | {"direction": (_check.number("direction", direction), "rad")})
        self.height = _check.number("height", height, positive=True)
        self.ground = _check.number("ground", ground)
        self.top = None if top is None else _check.number("top", top, positive=True)

    @abstractmethod
    def share(self, height: Any) -> Any:
        """Of the speed, at a height above ground, m."""

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        height = 1.0 * (place.altitude - self.ground)
        height = height if self.top is None else np.minimum(height, self.top)
        speed, direction = self.share(height) * self._value(p, "speed"), self._value(p, "direction")
        return WindHere(np.stack([speed * np.cos(direction), speed * np.sin(direction), 0.0]), np.zeros(3))


class LogWind(_BoundaryLayer):
    """The logarithmic wind profile near the ground, V(h) = V(h₁) ln(h/z₀)/ln(h₁/z₀); calm below z₀.

    MIL-F-8785C, 3.7.3.4 takes h₁ = 20 ft, z₀ = 0.15 ft in terminal flight phases and 2.0 ft otherwise, from 3
    to 1000 ft.

    Parameters
    ----------
    speed, height
        How fast, m/s, at which height above ground, m.
    direction
        Towards which it blows, clockwise from north, rad.
    roughness
        z₀, m.
    ground
        Its altitude, m.
    top
        Height above ground from which on the wind is the same, m; none when omitted.
    name
        The word before the names of its parameters, "wind_speed" and "wind_direction".
    """

    def __init__(
        self,
        speed: float,
        direction: float,
        *,
        height: float = 6.096,
        roughness: float = 0.04572,
        ground: float = 0.0,
        top: float | None = None,
        name: str = "wind",
    ) -> None:
        super().__init__(speed, direction, height, ground, top, name)
        self.roughness = _check.number("roughness", roughness, positive=True)
        if self.roughness >= self.height:
            raise InputError(f"roughness: got {roughness:g} m; allowed is less than the height, {height:g} m")

    def share(self, height: Any) -> Any:
        scale = float(np.log(self.height / self.roughness))
        return np.log(np.maximum(height, self.roughness) / self.roughness) / scale


class PowerLawWind(_BoundaryLayer):
    """The power law of the wind near the ground, V(h) = V(h₁) (h/h₁)^a; linear below a hundredth of h₁.

    a = 1/7 over open land, neutral (IEC 61400-1 takes 0.2).

    Parameters
    ----------
    speed, height
        How fast, m/s, at which height above ground, m.
    direction
        Towards which it blows, clockwise from north, rad.
    exponent
        a.
    ground, top, name
        As of `LogWind`.
    """

    def __init__(
        self,
        speed: float,
        direction: float,
        *,
        height: float = 10.0,
        exponent: float = 1.0 / 7.0,
        ground: float = 0.0,
        top: float | None = None,
        name: str = "wind",
    ) -> None:
        super().__init__(speed, direction, height, ground, top, name)
        self.exponent = _check.number("exponent", exponent, positive=True)

    def share(self, height: Any) -> Any:
        ratio = height / self.height
        above = np.maximum(ratio, _LINEAR)
        return above**self.exponent * np.clip(ratio / _LINEAR, 0.0, 1.0)


# A power of less than one is infinitely steep at the ground.
_LINEAR = 0.01


def _towards(direction: float, speed: float) -> tuple[float, float, float]:
    """The velocity of a wind that blows from a direction."""
    from_where, how_fast = _check.number("direction", direction), _check.number("speed", speed)
    return -how_fast * float(np.cos(from_where)), -how_fast * float(np.sin(from_where)), 0.0
