"""Tanks: mass, mass centre and inertia of what they hold, by the mass that is left."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.tables import Table
from freebody.tracing.declaration import check_name

__all__ = ["Tank"]

_TAIL_OFF = 1e-3


class Tank:
    """Propellant of a `Propulsion`; the empty tank belongs to the body.

    Parameters
    ----------
    name
        A word. The mass is the state and the signal `<name>_mass`.
    mass
        kg, at the start.
    com
        Mass centre of the propellant, body axes, (3,) m; or, with `masses`, a row for each, (n, 3).
    inertia_about_com
        Of the propellant about its mass centre, kg m^2: (3, 3) for the full load, in proportion to the mass
        of a lesser one; or, with `masses`, (n, 3, 3). Zero when omitted.
    capacity
        The full load, kg; `mass` by default.
    masses
        (n,) kg, rising from 0 to the full load, at which mass centre and inertia are tabulated.
    interpolation
        Between them, "linear" or "cubic". Linear tables have corners, which cost steps.
    tail_off
        kg: when less is left, the flow falls with it, m' = -(1 - (1 - m/tail_off)^2) of what is asked for, so
        that the tank runs dry without a jolt and the rest goes exponentially. A thousandth of the full load
        by default.
    """

    def __init__(
        self,
        name: str,
        mass: float,
        com: ArrayLike,
        inertia_about_com: ArrayLike | None = None,
        *,
        capacity: float | None = None,
        masses: ArrayLike | None = None,
        interpolation: Literal["linear", "cubic"] = "linear",
        tail_off: float | None = None,
    ) -> None:
        check_name("tank: name", name)
        self.name, self.state = name, f"{name}_mass"
        self.mass = _check.number(f"{name}: mass", mass)
        full = self.mass if capacity is None else _check.number(f"{name}: capacity", capacity)
        self.tabulated = masses is not None
        if masses is not None:
            kind = _check.choice(f"{name}: interpolation", interpolation, ("linear", "cubic"))
            full = self._tabulated(com, inertia_about_com, masses, capacity, kind)
        if not 0.0 <= self.mass <= full or full == 0.0:
            raise InputError(f"{name}: mass: got {mass}; allowed is 0 ... {full} kg, the capacity")
        if masses is None:
            self._constant(com, inertia_about_com, full)
        self.capacity = full
        given = _TAIL_OFF * full if tail_off is None else tail_off
        self.tail_off = _check.number(f"{name}: tail_off", given, positive=True)

    def _constant(self, com: ArrayLike, inertia: ArrayLike | None, full: float) -> None:
        name = self.name
        point = _check.vector(f"{name}: com", com, 3)
        given = _inertia(f"{name}: inertia_about_com", inertia, 3, 3) / full
        self._com, self._com_slope = lambda m: point, lambda m: np.zeros(3)
        self._inertia, self._inertia_slope = lambda m: given * m, lambda m: given

    def _tabulated(
        self, com: ArrayLike, inertia: ArrayLike | None, masses: ArrayLike, capacity: float | None, kind: Any
    ) -> float:
        name = self.name
        rows = _check.series(f"{name}: masses", masses)
        n, full = len(rows), float(rows[-1])
        if n < 2 or rows[0] != 0.0 or not (np.diff(rows) > 0.0).all():
            raise InputError(f"{name}: masses: got {_check.shown(masses)}; give rising masses, 0 first")
        if capacity not in (None, full):
            raise InputError(f"{name}: capacity: got {capacity}; the last of the masses is {full} kg")
        points = _check.vector(f"{name}: com", com, n, 3)
        tensors = _inertia(f"{name}: inertia_about_com", inertia, n, 3, 3)
        self._com, self._com_slope = _interpolated(rows, points, kind)
        self._inertia, self._inertia_slope = _interpolated(rows, tensors, kind)
        return full

    def com(self, m: Any) -> Any:
        """The mass centre at a mass, (3,) m."""
        return self._com(m)

    def inertia_about_com(self, m: Any) -> Any:
        """The inertia about the mass centre at a mass, (3, 3) kg m^2."""
        return self._inertia(m)

    def source(self, m: Any) -> Any:
        """Where the propellant seems to come from, d(m r)/dm, (3,) m."""
        return self._com(m) + m * self._com_slope(m)

    def inertia_slope(self, m: Any) -> Any:
        """The derivative of the inertia about the body origin by the mass, (3, 3) m^2."""
        r, slope, one = self._com(m), self._com_slope(m), np.eye(3)
        mixed = np.outer(r, slope)
        steiner = (r @ r) * one - np.outer(r, r)
        moving = 2.0 * (r @ slope) * one - mixed - mixed.T
        return self._inertia_slope(m) + steiner + m * moving

    def available(self, m: Any) -> Any:
        """The share of the flow that comes when so much is left: one until the tail-off, zero when dry."""
        missing = 1.0 - np.clip(m / self.tail_off, 0.0, 1.0)
        return 1.0 - missing * missing


def _inertia(name: str, value: ArrayLike | None, *shape: int) -> Array:
    if value is None:
        return np.zeros(shape)
    tensor = _check.vector(name, value, *shape)
    if np.abs(tensor - np.swapaxes(tensor, -1, -2)).max() > 1e-9 * max(np.abs(tensor).max(), 1e-300):
        raise InputError(f"{name}: not symmetric")
    if np.linalg.eigvalsh(tensor).min() < -1e-9 * np.abs(tensor).max():
        raise InputError(f"{name}: a principal moment is negative")
    return tensor


def _interpolated(masses: Array, values: Array, kind: Any) -> tuple[Any, Any]:
    """A tabulated array as a function of the mass, and its slope."""
    tables = [Table(masses, column, kind) for column in values.reshape(len(masses), -1).T]
    slopes = [table.derivative() for table in tables]
    shape = values.shape[1:]
    # A tank starts full: there the slope is that below, and not the zero of what is held beyond.
    below = float(np.nextafter(masses[-1], 0.0))

    def at(functions: list[Table], m: Any) -> Any:
        return np.stack([function(m) for function in functions]).reshape(shape)

    return lambda m: at(tables, m), lambda m: at(slopes, np.minimum(m, below))
