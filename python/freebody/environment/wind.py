"""Wind and current: how the medium moves relative to the ground."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from freebody import _check
from freebody.environment.limits import Limit, checked_word
from freebody.environment.planet import Place
from freebody.errors import InputError

__all__ = ["Calm", "NamedWind", "Wind", "WindHere", "Winds", "merged", "turned"]


class WindHere(NamedTuple):
    """The wind at a place: velocity in north, east, down axes, (3,) m/s, towards which it blows; and the
    rotation of gusts as the body feels it, body axes, (3,) rad/s.
    """

    velocity_ned: Any
    rotation_body: Any


class Wind(ABC):
    """What forces ask of the wind. Winds are added, `wind + gust`.

    Attributes
    ----------
    parameters
        Name: (value, unit), of what can be dispersed; every law that reads the wind has them.
    inputs
        Name: unit, of the signals that it reads.
    limits
        Where it ends, and what holds there.
    steady
        The same without what is met on the way through the air, that is, reads the input "air_path".
    """

    parameters: Mapping[str, tuple[float, str]] = {}
    inputs: Mapping[str, str] = {}

    @property
    def limits(self) -> tuple[Limit, ...]:
        return ()

    @property
    def steady(self) -> Wind:
        return Calm() if "air_path" in self.inputs else self

    @abstractmethod
    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        """The wind at a place, for the `s` and the `p` of a law (None: the nominal parameters)."""

    def __add__(self, other: Wind) -> Winds:
        return Winds(self, other)


class Calm(Wind):
    """The medium turns with the planet."""

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        return WindHere(np.zeros(3), np.zeros(3))


class NamedWind(Wind):
    """A wind with parameters of its own, each called by the name of the wind and its own."""

    def __init__(self, name: str, parameters: Mapping[str, tuple[float, str]]) -> None:
        self.name = checked_word("name", name)
        self.parameters = {f"{name}_{word}": pair for word, pair in parameters.items()}

    def _value(self, p: Any, word: str) -> Any:
        name = f"{self.name}_{word}"
        return self.parameters[name][0] if p is None else p[name]


class Winds(Wind):
    """Several winds at once: their velocities and rotations are added.

    Raises `InputError` where two of them have a parameter of one name: `name=` tells them apart.
    """

    def __init__(self, *winds: Wind) -> None:
        for wind in winds:
            if not isinstance(wind, Wind):
                raise InputError(f"winds: got {_check.shown(wind)}; give winds, such as ConstantWind(...)")
        self.winds = tuple(part for w in winds for part in (w.winds if isinstance(w, Winds) else (w,)))
        self.parameters = merged("winds", *(wind.parameters for wind in self.winds))
        self.inputs = {name: unit for wind in self.winds for name, unit in wind.inputs.items()}

    @property
    def limits(self) -> tuple[Limit, ...]:
        return tuple(limit for wind in self.winds for limit in wind.limits)

    @property
    def steady(self) -> Wind:
        return Winds(*(wind.steady for wind in self.winds))

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        velocity, rotation = np.zeros(3), np.zeros(3)
        for wind in self.winds:
            own = wind.here(place, s, p)
            velocity, rotation = velocity + own.velocity_ned, rotation + own.rotation_body
        return WindHere(velocity, rotation)


def merged(what: str, *parameters: Mapping[str, tuple[float, str]]) -> dict[str, tuple[float, str]]:
    """Parameters by name; a name that stands twice is refused."""
    found: dict[str, tuple[float, str]] = {}
    for group in parameters:
        for name, pair in group.items():
            if name in found:
                raise InputError(
                    f"{what}: two have the parameter {name!r}; give one of them another name=, such as "
                    '"current"'
                )
            found[name] = pair
    return found


def turned(velocity_ned: Any, angle: Any) -> Any:
    """A velocity turned about the vertical, clockwise seen from above, rad."""
    c, s = np.cos(angle), np.sin(angle)
    north, east, down = velocity_ned[0], velocity_ned[1], velocity_ned[2]
    return np.stack([c * north - s * east, s * north + c * east, down])
