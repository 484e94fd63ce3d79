"""The F-16 of `freebody.vehicles` against what Stevens and Lewis print of it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from freebody._check import Array
from freebody.attitude import Attitude
from freebody.model import Model
from freebody.model_file import load_model, shipped_model
from freebody.trimming import Trim, trim
from freebody.vehicles import f16

from . import f16_printed as book
from .printed import ROUNDED, digits, last_digits, off_by
from .residual import Residual

__all__ = ["book_rates", "cases", "linear"]

FOOT = 0.3048
AIRSPEED = 502.0 * FOOT
CONTROLS: tuple[str, ...] = ("throttle", "elevator", "aileron", "rudder")

# The book computed its rates in single precision: 3e-7 of a number, some units of a seventh digit.
SINGLE = 3e-7
# The book's search by a simplex stops near the minimum; half a last digit comes to that.
SEARCHED = 3e-5


@cache
def aircraft(xcg: float = f16.REFERENCE_CG, rounded: bool = True) -> Model:
    """The model with the coefficients that the book's program has."""
    return f16.model(xcg, rounded=rounded)


def cases() -> Iterator[Residual]:
    """Rates at the printed state, trimmed flight, and the linear model."""
    yield from _rates()
    yield from _level()
    yield from _conditions()
    yield from _linear()
    yield _file()


def _rates() -> Iterator[Residual]:
    got = iter(book_rates(aircraft(0.4)).tolist())
    for quantity, printed in book.RATES.items():
        figures = printed.split()
        numbers = [next(got) for _ in figures]
        single = max(SINGLE * np.abs(np.array(figures, dtype=float)) / last_digits(figures))
        yield digits("F-16", quantity, numbers, printed, 0.5 + single)


def book_rates(model: Model) -> Array:
    """The rates (13,) of the book's state at its test state, ft, rad, s, percent, from those of the model."""
    speed, alpha, beta, phi, theta, psi, p, q, r, north, east, altitude, power = book.STATE
    com, omega = np.asarray(model.body.com), np.array([p, q, r])
    attitude = Attitude.angles("zyx", [psi, theta, phi])
    rotation = attitude.as_rotation()
    v = speed * FOOT * np.array([np.cos(alpha) * np.cos(beta), np.sin(beta), np.sin(alpha) * np.cos(beta)])
    x = model.state(
        np.array([north, east, -altitude]) * FOOT - rotation @ com,
        attitude,
        velocity_body=v - np.cross(omega, com),
        angular_velocity_body=omega,
        states={"engine.power": power},
    )
    angles = np.deg2rad(book.CONTROLS[1:]).tolist()
    named: dict[str, float] = dict(zip(CONTROLS, [book.CONTROLS[0], *angles], strict=True))
    rate = model.derivative(0.0, x, [named[name] for name in model.input_names])
    at = model.state_names.index("velocity_x")
    turning = rate[at + 3 : at + 6]
    a = rate[at : at + 3] + np.cross(turning, com)
    faster = v @ a / np.linalg.norm(v)
    across = v[0] ** 2 + v[2] ** 2
    moved = rotation @ v / FOOT
    about_vertical = q * np.sin(phi) + r * np.cos(phi)
    return np.array(
        [
            faster / FOOT,
            (v[0] * a[2] - v[2] * a[0]) / across,
            (speed * FOOT * a[1] - v[1] * faster) * np.cos(beta) / across,
            p + np.tan(theta) * about_vertical,
            q * np.cos(phi) - r * np.sin(phi),
            about_vertical / np.cos(theta),
            *turning,
            moved[0],
            moved[1],
            -moved[2],
            rate[-1],
        ]
    )


def _level() -> Iterator[Residual]:
    """Straight and level at sea level."""
    found: list[Array] = []
    for row in book.LEVEL.splitlines():
        speed, printed = row.split(maxsplit=1)
        level = trim(aircraft(), airspeed=float(speed) * FOOT, bounds=f16.LIMITS)
        angles = np.rad2deg([level.alpha, level.inputs["elevator"]])
        found.append(off_by([level.inputs["throttle"], *angles], printed))
    largest = np.max(found, axis=0)
    for quantity, worst in zip(("throttle", "angle of attack", "elevator"), largest, strict=True):
        yield Residual("F-16", f"level from 130 to 800 ft/s: {quantity}", float(worst), ROUNDED, "last digit")


def _conditions() -> Iterator[Residual]:
    for name, (xcg, turn, pull, printed, loose) in book.CONDITIONS.items():
        got = in_book_units(trim(aircraft(xcg), airspeed=AIRSPEED, turn_rate=turn, pitch_rate=pull))
        numbers = [got[key] for key in printed]
        yield digits("F-16", f"trim, {name}", numbers, " ".join(printed.values()))
        if loose:
            worst = max(abs(got[key] - float(figure)) for key, figure in loose.items())
            yield Residual("F-16", f"trim, {name}: {' and '.join(loose)}", worst, SEARCHED, "deg")
    found = trim(aircraft(), airspeed=AIRSPEED, turn_rate=0.3)
    got = in_book_units(found) | {"power": found.states["engine.power"]}
    worst = max(abs(got[key] - figure) for key, figure in book.TURN.items())
    yield Residual("F-16", "turn of section 3.6, each of twelve figures", worst, SEARCHED, "as printed")


def in_book_units(found: Trim) -> dict[str, float]:
    """Deflections in degrees; angles and rates in rad and rad/s."""
    degrees = {name: float(np.rad2deg(found.inputs[name])) for name in CONTROLS[1:]}
    rates = dict(zip("pqr", found.angular_velocity_body.tolist(), strict=True))
    angles = {name: getattr(found, name) for name in ("alpha", "beta", "roll", "pitch")}
    return {"throttle": found.inputs["throttle"], **degrees, **rates, **angles}


def _file() -> Residual:
    """The shipped model file says the same aircraft as the module."""
    file, model = load_model(shipped_model("f16")), aircraft(0.30, False)
    x, inputs = file.x0, np.linspace(0.05, 0.2, 4)
    there = file.model.derivative(0.0, x, inputs)
    order = [file.model.input_names.index(name) for name in model.input_names]
    here = model.derivative(0.0, x, inputs[order])
    return Residual(
        "F-16", "rates, model file against module", float(np.abs(there - here).max()), 1e-12, "SI"
    )


@cache
def linear() -> tuple[Array, Array]:
    """A and B in the book's coordinates V, alpha, beta, phi, theta, psi, p, q, r and controls in degrees."""
    given = f16.model(rounded=True, attitude="zyx")
    found = trim(given, airspeed=AIRSPEED)
    a, b = given.jacobian(0.0, found.x, found.u)
    ca, sa = np.cos(found.alpha), np.sin(found.alpha)
    back = np.zeros((given.n_states, 9))
    back[6:9, :3] = np.column_stack(
        [[FOOT * ca, 0.0, FOOT * sa], [-AIRSPEED * sa, 0.0, AIRSPEED * ca], [0.0, AIRSPEED, 0.0]]
    )
    for i, place in enumerate((5, 4, 3, 9, 10, 11)):
        back[place, 3 + i] = 1.0
    into = np.linalg.pinv(back)
    order = [given.input_names.index(name) for name in CONTROLS]
    return into @ a @ back, into @ b[:, order] @ np.diag([1.0, *np.deg2rad([1.0, 1.0, 1.0])])


def _linear() -> Iterator[Residual]:
    a, b = linear()
    along, across = [0, 1, 4, 7], [2, 3, 6, 8]
    # Five digits; half a unit of the fourth is allowed: the book differentiates about its own minimum.
    for name, got, wanted in (("A", a[np.ix_(along, along)], book.LONG_A), ("B", b[along, 1:2], book.LONG_B)):
        yield Residual("F-16", f"longitudinal {name}", _relative(got, wanted), 5e-5)
    for name, got, wanted in (
        ("A", a[np.ix_(across, across)], book.SIDE_A),
        ("B", b[across, 2:], book.SIDE_B),
    ):
        off = float(np.abs(np.subtract(got, wanted)).max()) / 1e-4
        yield Residual("F-16", f"lateral {name}", off, 0.6, "last digit")
    modes = np.sort_complex(np.linalg.eigvals(a[np.ix_(along, along)]))
    real = [*modes.real[:2], modes.imag[2], modes.real[3]]
    yield digits("F-16", "longitudinal modes", real, "-1.912 -0.1507 0.1153 0.09755")


def _relative(got: Array, printed: ArrayLike) -> float:
    """The largest difference relative to the figure; where zero is printed, to one (1e-7 stands for zero)."""
    wanted = np.asarray(printed)
    scale = np.where(np.abs(wanted) > 1e-9, np.abs(wanted), 1.0)
    return float((np.abs(got - wanted) / scale).max())
