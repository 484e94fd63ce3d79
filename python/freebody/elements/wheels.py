"""Momentum inside the body: a constant one, and reaction wheels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.commands import command, unit_vector
from freebody.errors import InputError
from freebody.forces import Spin
from freebody.tracing import EventLaw, ForceLaw, wrench
from freebody.tracing.declaration import check_name

__all__ = ["GyroscopicMomentum", "ReactionWheels"]

# The torque of a motor falls to zero over this share of its largest speed.
_ROLL_OFF = 0.02


class GyroscopicMomentum(ForceLaw):
    """A gyrostat: a rotor inside the body whose momentum h relative to it is constant. Moment -omega x h.

    The rotor's mass and inertia belong to the body. Hughes, Spacecraft Attitude Dynamics (1986), chapter 6.

    Parameters
    ----------
    momentum
        h, body axes, (3,) N m s.

    Parameters of the law: `momentum_x`, `momentum_y`, `momentum_z`.
    """

    def __init__(self, momentum: ArrayLike, *, name: str | None = None) -> None:
        h = _check.vector("momentum", momentum, 3)

        def gyrostat(s: Any, p: Any) -> Any:
            h = np.stack([p.momentum_x, p.momentum_y, p.momentum_z])
            return wrench(moment=-np.cross(s.angular_velocity_body, h))

        parameters = {f"momentum_{axis}": (float(h[i]), "N m s") for i, axis in enumerate("xyz")}
        super().__init__(gyrostat, parameters, name="gyrostat" if name is None else name)


class ReactionWheels(ForceLaw):
    """Wheels that turn about axes fixed in the body, driven by motors that push the body back.

    Wheel i has the speed W_i relative to the body, a state, and the moment of inertia J_i about its axis a_i:
    J_i (W_i' + a_i . omega') = t_i, and the body gets -a_i t_i - omega x (a_i J_i W_i). The wheels' masses,
    and their inertia at rest, belong to the body. t_i is the motor's torque less the friction
    b W + c tanh(W / W_s). Markley and Crassidis, Fundamentals of Spacecraft Attitude Determination and
    Control (2014), section 3.3.3.

    Parameters
    ----------
    axes
        (n, 3), body axes, scaled to length one.
    inertias
        (n,), or one for all, kg m^2.
    torques
        For each the name of the input that commands its motor, N m, or a number; `wheel_1_torque` ... by
        default.
    max_torque
        N m: commands are clipped there.
    max_speed
        rad/s: the torque that speeds a wheel up falls to zero over the last 2 % before it. The outcome of a
        run says when a wheel gets there.
    viscous, coulomb, stiction_speed
        b, N m s; c, N m; W_s, rad/s: how slow a wheel is when its dry friction falls off.
    initial_speeds
        (n,) rad/s.
    prefix
        States and inputs are called `<prefix>_1_speed`, `<prefix>_1_torque` ...; the speeds are signals that
        others read.

    Parameters of the law: `max_torque`, `viscous`, `coulomb`, and torques given as numbers.
    """

    def __init__(
        self,
        axes: ArrayLike,
        inertias: ArrayLike,
        *,
        torques: Sequence[str | float] | None = None,
        max_torque: float | None = None,
        max_speed: float | None = None,
        viscous: float = 0.0,
        coulomb: float = 0.0,
        stiction_speed: float = 1.0,
        initial_speeds: ArrayLike | None = None,
        prefix: str = "wheel",
        name: str | None = None,
    ) -> None:
        check_name("prefix", prefix)
        given = _axes(axes)
        n = len(given)
        moments = _check.vector("inertias", [inertias] * n if np.ndim(inertias) == 0 else inertias, n)  # pyright: ignore[reportArgumentType]
        if not (moments > 0.0).all():
            raise InputError(f"inertias: got {_check.shown(inertias)}; every one must be positive")
        speeds = np.zeros(n) if initial_speeds is None else _check.vector("initial_speeds", initial_speeds, n)
        named = [f"{prefix}_{i + 1}" for i in range(n)]
        told = [
            command(f"torques[{i}]", value, "N m", f"{named[i]}_torque")
            for i, value in enumerate(_torques(torques, named))
        ]
        parameters: dict[str, tuple[float | str, str]] = {
            "viscous": (_not_negative("viscous", viscous), "N m s"),
            "coulomb": (_not_negative("coulomb", coulomb), "N m"),
        }
        if max_torque is not None:
            parameters["max_torque"] = (_check.number("max_torque", max_torque, positive=True), "N m")
        top = None if max_speed is None else _check.number("max_speed", max_speed, positive=True)
        slow = _check.number("stiction_speed", stiction_speed, positive=True)
        for each in told:
            parameters |= each.parameters
        states = [f"{label}_speed" for label in named]

        def motor(torque: Any, speed: Any, p: Any) -> Any:
            if max_torque is not None:
                torque = np.clip(torque, -p.max_torque, p.max_torque)
            if top is None:
                return torque
            forward = np.clip((top - speed) / (_ROLL_OFF * top), 0.0, 1.0)
            backward = np.clip((top + speed) / (_ROLL_OFF * top), 0.0, 1.0)
            return torque * np.where(torque > 0.0, forward, backward)

        def wheels(s: Any, p: Any) -> Any:
            omega, moment, rates = s.angular_velocity_body, np.zeros(3), {}
            for axis, inertia, state, each in zip(given, moments, states, told, strict=True):
                speed = s.states[state]
                friction = p.viscous * speed + p.coulomb * np.tanh(speed / slow)
                torque = motor(each.value(s, p), speed, p) - friction
                moment = moment - axis * torque - np.cross(omega, axis * (inertia * speed))
                rates[state] = torque / inertia
            return wrench(moment=moment), rates

        super().__init__(
            wheels,
            parameters,
            {key: unit for each in told for key, unit in each.inputs.items()},
            {state: (float(w), "rad/s") for state, w in zip(states, speeds, strict=True)},
            "reaction_wheels" if name is None else name,
        )
        self.publishes = tuple(states)
        self.spins = tuple(
            Spin((x, y, z), inertia, state)
            for (x, y, z), inertia, state in zip(given, moments.tolist(), states, strict=True)
        )
        if top is not None:
            self.notices = tuple(_at_limit(label, top) for label in named)


def _at_limit(label: str, limit: float) -> EventLaw:
    state = f"{label}_speed"

    def saturated(s: Any) -> Any:
        return (1.0 - _ROLL_OFF) * limit - np.abs(s.inputs[state])

    told = f"{label} is at its largest speed and takes up no more"
    return EventLaw(saturated, False, "falling", inputs={state: "rad/s"}, name=told)


def _axes(axes: ArrayLike) -> list[Any]:
    rows = np.asarray(axes)
    if rows.ndim != 2 or rows.shape[1] != 3 or not len(rows):
        raise InputError(f"axes: got shape {rows.shape}; give (n, 3), a row for each wheel")
    return [unit_vector(f"axes[{i}]", row) for i, row in enumerate(rows)]


def _torques(torques: Sequence[str | float] | None, named: list[str]) -> Sequence[str | float]:
    if torques is None:
        return [f"{label}_torque" for label in named]
    if isinstance(torques, str) or not isinstance(torques, Sequence) or len(torques) != len(named):
        raise InputError(
            f"torques: got {_check.shown(torques)}; give a name or a number for each of {len(named)} wheels"
        )
    return torques


def _not_negative(name: str, value: float) -> float:
    checked = _check.number(name, value)
    if checked < 0.0:
        raise InputError(f"{name}: got {value}; give a number that is not negative")
    return checked
