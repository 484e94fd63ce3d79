"""Where an element sits on the body: a point and axes of its own."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.environment import Flow
from freebody.errors import InputError
from freebody.tracing import wrench

__all__ = ["ORIGIN", "Seat", "at_least", "seat"]

ORIGIN = (0.0, 0.0, 0.0)


class Seat(NamedTuple):
    """A material point from o1 and axes that turn with the body.

    Attributes
    ----------
    at
        Body axes, (3,) m.
    axes
        Body axes from own axes, (3, 3): the own axes are the columns.
    """

    at: Array
    axes: Array

    def twist(self, flow: Flow) -> Any:
        """The velocity relative to the medium and the angular velocity, own axes, (6,)."""
        return np.concatenate([self.axes.T @ flow.velocity, self.axes.T @ flow.angular_velocity])

    def wrench(self, components: Any) -> Any:
        """The wrench that a law returns, of six components about this point in these axes."""
        return wrench(self.axes @ components[:3], self.axes @ components[3:], self.at)

    @property
    def transform(self) -> Array:
        """X of V_seat = X V_o1, (6, 6). Konoplev (1.2)"""
        x, y, z = self.at
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        turn = self.axes.T
        return np.block([[turn, -turn @ cross], [np.zeros((3, 3)), turn]])


def seat(at: ArrayLike, axes: ArrayLike | None) -> Seat:
    """Check a point and axes."""
    return Seat(_check.vector("at", at, 3), np.eye(3) if axes is None else _check.rotation("axes", axes))


def at_least(name: str, value: float, low: float = 0.0) -> float:
    """Check a number that is not below a bound."""
    checked = _check.number(name, value)
    if checked < low:
        raise InputError(f"{name}: got {checked:g}; give a number of at least {low:g}")
    return checked
