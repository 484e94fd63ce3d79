"""The F-16 of Stevens and Lewis: a light fighter at low speed, longitudinally unstable, with engine lag.

Source: Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed., Wiley 2015, section 3.5 and
appendix A (2nd ed., 2003: the same figures), after Nguyen et al., NASA TP-1538, 1979.

The body frame has its origin at the aerodynamic reference point, 0.35 of the chord; x points forward, y to
the right, z down. The mass centre lies off it on the x axis.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.body import RigidBody, positive_integral_inertia
from freebody.elements import Aerodynamics, Lookup
from freebody.elements.air_data import Station
from freebody.environment import Air, Atmosphere, Environment
from freebody.environment.atmosphere import viscosity
from freebody.environment.limits import Limit, altitude_limits
from freebody.forces import UniformGravity
from freebody.model import Model
from freebody.tables import Table
from freebody.tracing import ForceLaw, wrench
from freebody.vehicles import f16_tables as tables

__all__ = ["LIMITS", "Engine", "StevensLewisAtmosphere", "aerodynamics", "body", "model"]

FOOT, POUND, SLUG = 0.3048, 4.4482216152605, 14.593902937206364
SPAN, CHORD, AREA = 30.0 * FOOT, 11.32 * FOOT, 300.0 * FOOT**2
GRAVITY = 32.17 * FOOT
# The program has 1/m = 1.57e-3, four digits of 32.17/20500; its printed results are those of this mass.
MASS = SLUG / 1.57e-3
INERTIA = {"Ixx": 9496.0, "Iyy": 55814.0, "Izz": 63100.0, "Pxz": 982.0}  # slug ft²
ENGINE_MOMENTUM = 160.0 * SLUG * FOOT**2
REFERENCE_CG = 0.35
# State equations of the moments with the coefficients that the program has, section 3.5: rounded.
_C = (-0.770, 0.02755, 1.055e-4, 1.642e-6, 0.9604, 1.759e-2, 1.792e-5, -0.7336, 1.587e-5)

CONTROLS = {"elevator": "rad", "aileron": "rad", "rudder": "rad"}
LIMITS = {
    "throttle": (0.0, 1.0),
    "elevator": (-np.deg2rad(25.0), np.deg2rad(25.0)),
    "aileron": (-np.deg2rad(21.5), np.deg2rad(21.5)),
    "rudder": (-np.deg2rad(30.0), np.deg2rad(30.0)),
}
"""Of the inputs (appendix A.4); the model itself takes what it is given."""


class StevensLewisAtmosphere(Atmosphere):
    """Density and speed of sound of the book's air data computer (appendix A.6)."""

    @property
    def limits(self) -> tuple[Limit, ...]:
        return altitude_limits(
            "Stevens and Lewis's atmosphere",
            None,
            142000.0 * FOOT,
            ("", "density and temperature are constant above"),
        )

    def at(self, altitude: Any, p: Any = None) -> Air:
        feet = altitude / FOOT
        factor = np.maximum(1.0 - 0.703e-5 * feet, 1e-3)
        rankine = np.where(feet >= 35000.0, 390.0, 519.0 * factor)
        density = 2.377e-3 * factor**4.14
        return Air(
            density=density * (SLUG / FOOT**3),
            pressure=1715.0 * density * rankine * (POUND / FOOT**2),
            temperature=rankine / 1.8,
            speed_of_sound=np.sqrt(1.4 * 1716.3 * rankine) * FOOT,
            dynamic_viscosity=viscosity(rankine / 1.8),
        )


def body(xcg: float = REFERENCE_CG, *, rounded: bool = False) -> RigidBody:
    """Mass properties, with the mass centre at `xcg` chords behind the leading edge; see `model`."""
    inertia = positive_integral_inertia(**INERTIA)
    if rounded:
        inertia = np.linalg.inv(_rounded_inverse())
    return RigidBody(MASS, _mass_centre(xcg), inertia_about_com=inertia * (SLUG * FOOT**2), name="F-16")


def aerodynamics(
    environment: Environment, xcg: float = REFERENCE_CG, *, name: str = "aerodynamics"
) -> Aerodynamics:
    """Its aerodynamics; the controls are elevator, aileron and rudder, rad, positive as in the book.

    Tables go on along their border cells, as the book's do; that they are left is noticed.
    """

    def damping(which: str) -> Lookup:
        return _lookup(tables.DAMPING[which], "alpha")

    def by_elevator(rows: ArrayLike) -> Lookup:
        return _lookup(rows, "alpha", elevator=tables.ELEVATOR)

    def by_sideslip(rows: ArrayLike) -> Lookup:
        right = np.array(rows)
        beta = np.concatenate([-tables.BETA_5[:0:-1], tables.BETA_5])
        return _lookup(np.concatenate([-right[:0:-1], right]), "alpha", beta=beta)

    def by_control(rows: ArrayLike, degrees: float) -> Lookup:
        return _lookup(np.array(rows) / np.deg2rad(degrees), "alpha", beta=tables.BETA_10)

    cz = np.array(tables.CZ)
    return Aerodynamics(
        environment,
        AREA,
        SPAN,
        CHORD,
        {
            "CX": {"0": by_elevator(tables.CX), "q_hat": damping("CXq")},
            "CY": {
                "beta": np.rad2deg(-0.02),
                "aileron": 0.021 / np.deg2rad(20.0),
                "rudder": 0.086 / np.deg2rad(30.0),
                "r_hat": damping("CYr"),
                "p_hat": damping("CYp"),
            },
            "CZ": {
                "0": _lookup(cz, "alpha"),
                "beta^2": _lookup(-cz * np.rad2deg(1.0 / 57.3) ** 2, "alpha"),
                "elevator": -0.19 / np.deg2rad(25.0),
                "q_hat": damping("CZq"),
            },
            "Cl": {
                "0": by_sideslip(tables.CL),
                "aileron": by_control(tables.DLDA, 20.0),
                "rudder": by_control(tables.DLDR, 30.0),
                "r_hat": damping("Clr"),
                "p_hat": damping("Clp"),
            },
            "Cm": {"0": by_elevator(tables.CM), "q_hat": damping("Cmq")},
            "Cn": {
                "0": by_sideslip(tables.CN),
                "aileron": by_control(tables.DNDA, 20.0),
                "rudder": by_control(tables.DNDR, 30.0),
                "r_hat": damping("Cnr"),
                "p_hat": damping("Cnp"),
            },
        },
        flow_point=_mass_centre(xcg),
        controls=CONTROLS,
        name=name,
    )


class Engine(ForceLaw):
    """Thrust along x by tables of altitude and Mach number, with the lag of its power and a spinning rotor.

    Input `throttle`, 0 to 1; state `power`, percent: 50 is military, 100 full afterburning power.
    """

    def __init__(self, environment: Environment, xcg: float = REFERENCE_CG, *, name: str = "engine") -> None:
        station = Station(environment, _mass_centre(xcg), SPAN, CHORD, {})
        idle, military, maximum = (
            Lookup(
                Table((tables.MACH, tables.ALTITUDE * FOOT), np.array(rows) * POUND),
                "mach",
                "altitude",
                extrapolate=True,
            )
            for rows in (tables.IDLE, tables.MILITARY, tables.MAXIMUM)
        )

        def engine(s: Any, p: Any) -> Any:
            _, a = station.meet(s, p)
            power, middle = s.states.power, military(a)
            low = idle(a) + (middle - idle(a)) * power / 50.0
            high = middle + (maximum(a) - middle) * (power - 50.0) / 50.0
            thrust = p.thrust_factor * np.where(power < 50.0, low, high)
            _, wy, wz = s.angular_velocity_body
            rotor = p.momentum * np.stack([0.0, -wz, wy])
            return (
                wrench(np.stack([thrust, 0.0, 0.0]), rotor),
                {"power": _power_rate(power, _gearing(s.inputs.throttle))},
            )

        super().__init__(
            engine,
            parameters={
                "thrust_factor": (1.0, "1"),
                "momentum": (ENGINE_MOMENTUM, "N m s"),
                **station.parameters,
            },
            inputs={"throttle": "1", **station.inputs},
            states={"power": (0.0, "1")},
            name=name,
        )
        self.notices = tuple(
            station.notice(variable, low, high, "thrust", idle.beyond)
            for variable, (low, high) in idle.ranges.items()
        )


def model(
    xcg: float = REFERENCE_CG,
    environment: Environment | None = None,
    *,
    rounded: bool = False,
    **options: Any,
) -> Model:
    """The aircraft in flight.

    Parameters
    ----------
    xcg
        Where the mass centre is, in chords behind the leading edge of the mean aerodynamic chord. The book
        has 0.35 (unstable), 0.30, 0.38 and 0.40.
    environment
        A flat Earth with the book's atmosphere when omitted; gravity is the book's 32.17 ft/s².
    rounded
        Whether the moments of inertia act as in the book's program, whose coefficients are rounded to three
        or four digits and belong to no body: its printed results are found again to their last digit only so.
        It changes each angular acceleration by some 2e-4 of it.
    options
        As of `freebody.Model`.

    Inputs are elevator, aileron and rudder in rad and throttle from 0 to 1; the state has `engine.power`.
    """
    _check.flag("rounded", rounded)
    around = Environment(atmosphere=StevensLewisAtmosphere()) if environment is None else environment
    forces = [UniformGravity(GRAVITY), aerodynamics(around, xcg), Engine(around, xcg)]
    if rounded:
        forces.append(_rounding())
    return Model(body(xcg, rounded=rounded), forces, environment=around, **{"name": "F-16", **options})


def _mass_centre(xcg: float) -> tuple[float, float, float]:
    return (REFERENCE_CG - _check.number("xcg", xcg)) * CHORD, 0.0, 0.0


def _lookup(rows: ArrayLike, of: str, **other: Any) -> Lookup:
    """A table whose rows are for the degrees of another variable."""
    values, alpha = np.array(rows), np.deg2rad(tables.ALPHA)
    if not other:
        return Lookup(Table(alpha, values), of, extrapolate=True)
    ((name, degrees),) = other.items()
    return Lookup(Table((alpha, np.deg2rad(degrees)), values.T), of, name, extrapolate=True)


def _gearing(throttle: Any) -> Any:
    """Commanded power, percent."""
    return np.where(throttle <= 0.77, 64.94 * throttle, 217.38 * throttle - 117.38)


def _power_rate(power: Any, commanded: Any) -> Any:
    """Percent per second: 5/s among powers of one kind above 50, slower below; the two meet at 50."""
    wanted = np.where(
        commanded >= 50.0,
        np.where(power >= 50.0, commanded, 60.0),
        np.where(power >= 50.0, 40.0, commanded),
    )
    slow = np.clip(1.9 - 0.036 * (wanted - power), 0.1, 1.0)
    return np.where(power >= 50.0, 5.0, slow) * (wanted - power)


def _rounded_inverse() -> Any:
    _, _, c3, c4, _, _, c7, _, c9 = _C
    return np.array([[c3, 0.0, c4], [0.0, c7, 0.0], [c4, 0.0, c9]])


def _rounding() -> ForceLaw:
    """The moment that makes the gyroscopic terms of a body those of the rounded coefficients."""
    c1, c2, _, _, c5, c6, _, c8, _ = _C
    inertia = np.linalg.inv(_rounded_inverse()) * (SLUG * FOOT**2)

    def rounding(s: Any) -> Any:
        p_, q, r = w = s.angular_velocity_body
        rates = np.stack(
            [(c2 * p_ + c1 * r) * q, c5 * p_ * r + c6 * (r * r - p_ * p_), (c8 * p_ - c2 * r) * q]
        )
        return wrench(moment=inertia @ rates + np.cross(w, inertia @ w))

    return ForceLaw(rounding, name="rounding")
