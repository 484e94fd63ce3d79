"""Force elements. Each gives a wrench about the body origin o1; linear part first, SI units.

`axes` says in which axes components are given, "body" or "world"; `at` is the point of application in body
axes from o1, (3,) m.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody.errors import InputError
from freebody.interfaces import Control, Force, Quantity, Spin, StateQuantity
from freebody.tables import Interpolation, check_slopes, table_times

__all__ = [
    "ConstantWrench",
    "Control",
    "Force",
    "InputWrench",
    "LinearDamping",
    "PointMassGravity",
    "QuadraticDamping",
    "Quantity",
    "Spin",
    "StateQuantity",
    "TabulatedWrench",
    "UniformGravity",
]

ORIGIN = (0.0, 0.0, 0.0)
Axes = Literal["body", "world"]


class UniformGravity(Force):
    """Gravity of one acceleration everywhere, acting at the mass centre. Konoplev (1.12).

    Parameters
    ----------
    acceleration
        m/s².
    direction
        Where things fall, world axes; scaled to length one. The default is the third axis: it points down.
    """

    def __init__(
        self,
        acceleration: float = 9.80665,
        direction: ArrayLike = (0.0, 0.0, 1.0),
        *,
        name: str | None = None,
    ) -> None:
        super().__init__(name)
        self.acceleration = _check.number("acceleration", acceleration)
        down = _check.vector("direction", direction, 3)
        largest = float(np.abs(down).max())
        if largest == 0.0:
            raise InputError("direction: got the zero vector; give the direction in which things fall")
        # Scaled first, so that no square overflows or vanishes.
        self.direction = down / largest / np.linalg.norm(down / largest)

    def core(self) -> _core.Force:
        return _core.Force.uniform_gravity(self.acceleration * self.direction)


class PointMassGravity(Force):
    """Attraction by a point mass or a sphere, at the mass centre, with the torque of its gradient.

    Parameters
    ----------
    mu
        Gravitational parameter GM, m³/s².
    center
        Position of the attracting centre, world axes, (3,) m.
    gradient_torque
        Whether the torque 3μ/r⁵ (r × J_c r) acts (Hughes, Spacecraft Attitude Dynamics, 1986, section 8.1).
    """

    def __init__(
        self, mu: float, center: ArrayLike = ORIGIN, gradient_torque: bool = True, *, name: str | None = None
    ) -> None:
        super().__init__(name)
        self.mu = _check.number("mu", mu, positive=True)
        self.center = _check.vector("center", center, 3)
        self.gradient_torque = _check.flag("gradient_torque", gradient_torque)

    def core(self) -> _core.Force:
        return _core.Force.point_mass_gravity(self.mu, self.center, self.gradient_torque)


class ConstantWrench(Force):
    """A force (3,) N and a moment (3,) N m, constant in body or world axes. Konoplev (1.1)."""

    def __init__(
        self,
        force: ArrayLike = ORIGIN,
        moment: ArrayLike = ORIGIN,
        axes: Axes = "body",
        at: ArrayLike = ORIGIN,
        *,
        name: str | None = None,
    ) -> None:
        super().__init__(name)
        self.force = _check.vector("force", force, 3)
        self.moment = _check.vector("moment", moment, 3)
        self.axes = _check.choice("axes", axes, ("body", "world"))
        self.at = _check.vector("at", at, 3)

    def core(self) -> _core.Force:
        return _core.Force.constant_wrench(self.force, self.moment, self.axes == "world", self.at)


class TabulatedWrench(Force):
    """A force and a moment tabulated over time.

    Parameters
    ----------
    times
        (n,) s, rising; a time that stands twice makes a jump there, with the later row from then on.
    force, moment
        (n, 3) N and N m; zero when omitted.
    interpolation
        "linear" between the rows, or "hold": each row until the next. The first and the last row hold
        outside. Integration steps onto every time of the table.
    """

    def __init__(
        self,
        times: ArrayLike,
        force: ArrayLike | None = None,
        moment: ArrayLike | None = None,
        axes: Axes = "body",
        at: ArrayLike = ORIGIN,
        interpolation: Interpolation = "linear",
        *,
        name: str | None = None,
    ) -> None:
        super().__init__(name)
        self.times = table_times(times)
        n = len(self.times)
        if force is None and moment is None:
            raise InputError("force, moment: neither came; give at least one table of shape (n, 3)")
        self.force = np.zeros((n, 3)) if force is None else _check.vector("force", force, n, 3)
        self.moment = np.zeros((n, 3)) if moment is None else _check.vector("moment", moment, n, 3)
        self.axes = _check.choice("axes", axes, ("body", "world"))
        self.at = _check.vector("at", at, 3)
        self.interpolation = _check.choice("interpolation", interpolation, ("linear", "hold"))
        if interpolation == "linear":
            check_slopes("force", self.times, self.force)
            check_slopes("moment", self.times, self.moment)

    def core(self) -> _core.Force:
        columns = np.ascontiguousarray(np.hstack([self.force, self.moment]).T)
        hold = self.interpolation == "hold"
        return _core.Force.tabulated_wrench(self.times, columns, hold, self.axes == "world", self.at)


class _Damping(Force):
    """What linear and quadratic damping share: their coefficients."""

    def __init__(self, coefficients: ArrayLike, *, name: str | None = None) -> None:
        super().__init__(name)
        self.coefficients = _check.diagonal_or_full("coefficients", coefficients, 6)


class LinearDamping(_Damping):
    """F = -D V, V the twist of o1 in body axes; D (6, 6), or (6,) for its diagonal, SI by blocks."""

    def core(self) -> _core.Force:
        return _core.Force.damping(self.coefficients.ravel(), False)


class QuadraticDamping(_Damping):
    """F = -D (|V| V), each component of the twist times its own size; D (6, 6) or (6,).

    Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2011), section 6.4.
    """

    def core(self) -> _core.Force:
        return _core.Force.damping(self.coefficients.ravel(), True)


class InputWrench(Force):
    """Six inputs of u: force_x, force_y, force_z (N), moment_x, moment_y, moment_z (N m). Konoplev (3.2)."""

    inputs = tuple(
        Quantity(f"{stem}_{axis}", unit)
        for stem, unit in (("force", "N"), ("moment", "N m"))
        for axis in "xyz"
    )

    def __init__(self, axes: Axes = "body", at: ArrayLike = ORIGIN, *, name: str | None = None) -> None:
        super().__init__(name)
        self.axes = _check.choice("axes", axes, ("body", "world"))
        self.at = _check.vector("at", at, 3)

    def core(self) -> _core.Force:
        return _core.Force.input_wrench(self.axes == "world", self.at)


def checked_forces(forces: Iterable[Force]) -> tuple[Force, ...]:
    """Check a list of force elements."""
    try:
        given = tuple(forces)
    except TypeError:
        raise InputError(f"forces: got {_check.shown(forces)}; give a list of force elements") from None
    for i, force in enumerate(given):
        if not isinstance(force, Force):
            raise InputError(f"forces[{i}]: got {_check.shown(force)}; give a force element")
        if isinstance(force, InputWrench) and any(
            isinstance(f, InputWrench) and f.name == force.name for f in given[:i]
        ):
            raise InputError(
                f"forces[{i}]: a second InputWrench called {force.name!r}; give each its own name=, which "
                "its inputs bear"
            )
    return given
