"""Actuators: what is commanded comes late, and not beyond the stops."""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody import _check
from freebody.elements.commands import command, held, within
from freebody.errors import InputError
from freebody.tracing import ForceLaw, wrench
from freebody.tracing.declaration import check_name

__all__ = ["Actuator"]

# The stop of a servo of natural frequency w acts within this share of 1/w: stiff enough to look like a
# stop beside the motion of the servo, soft enough for explicit methods.
_STOP = 0.1


class Actuator(ForceLaw):
    """A servo or a valve: a state that follows its command and that other laws read as an input.

    It exerts nothing on the body. A law that reads the input `signal` gets the position of the actuator, and
    what was an input of the model under that name is now its command.

    First order: x' = (c - x) / T. Second order: x'' = w^2 (c - x) - 2 z w x'. The command c is clipped to the
    limits.

    Parameters
    ----------
    signal
        The name that others read: "elevator".
    time_constant
        T, s; for the first order. Or, for the second:
    natural_frequency, damping
        w, rad/s, and z, 1 by default.
    limits
        (low, high): stops. An actuator of the first order approaches a stop without touching it. One of
        the second order would swing beyond; its speed towards a stop is at most the distance over 0.1/w, so
        that it comes to rest there and never passes. From outside, where only a start can be, it comes back.
    rate_limit
        The largest speed, unit/s, in both directions. A second-order actuator reaches it in the
        same soft way.
    command
        Name of the input that commands it, `<signal>_command` by default, or a number: it goes there.
    unit
        Of the signal, SI.
    initial
        Where it starts.

    Parameters of the law: `time_constant`, or `natural_frequency` and `damping`; `rate_limit`, and the
    command where it is a number.
    """

    def __init__(
        self,
        signal: str,
        *,
        time_constant: float | None = None,
        natural_frequency: float | None = None,
        damping: float | None = None,
        limits: tuple[float, float] | None = None,
        rate_limit: float | None = None,
        command: str | float | None = None,
        unit: str = "rad",
        initial: float = 0.0,
        name: str | None = None,
    ) -> None:
        check_name("signal", signal)
        told = _command(signal, command, unit)
        stops = within("limits", limits)
        parameters = {**_dynamics(time_constant, natural_frequency, damping), **told.parameters}
        speed_unit = f"{unit}/s" if unit != "1" else "1/s"
        if rate_limit is not None:
            value = _check.number("rate_limit", rate_limit, positive=True)
            parameters["rate_limit"] = (value, speed_unit)
        speed_state = f"{signal}_rate"

        def goal(s: Any, p: Any) -> Any:
            c = told.value(s, p)
            return c if stops is None else np.clip(c, *stops)

        def fastest(p: Any) -> tuple[Any, Any] | None:
            return None if rate_limit is None else (-p.rate_limit, p.rate_limit)

        def first_order(s: Any, p: Any) -> Any:
            rate = (goal(s, p) - s.states[signal]) / p.time_constant
            speeds = fastest(p)
            return wrench(), {signal: rate if speeds is None else np.clip(rate, *speeds)}

        def second_order(s: Any, p: Any) -> Any:
            x, v, w = s.states[signal], s.states[speed_state], 1.0 * p.natural_frequency
            soft = _STOP / p.natural_frequency
            acceleration = w * w * (goal(s, p) - x) - 2.0 * p.damping * w * v
            return wrench(), {
                signal: held(v, x, stops, soft),
                speed_state: held(acceleration, v, fastest(p), soft),
            }

        states: dict[str, tuple[float | str, str]] = {signal: (_check.number("initial", initial), unit)}
        if time_constant is None:
            states[speed_state] = (0.0, speed_unit)
        super().__init__(
            second_order if time_constant is None else first_order,
            parameters,
            told.inputs,
            states,
            f"{signal}_actuator" if name is None else name,
        )
        self.publishes = (signal,)


def _command(signal: str, given: str | float | None, unit: str) -> Any:
    if given == signal:
        raise InputError(f"command: got {given!r}, the signal itself; give the command another name")
    return command("command", f"{signal}_command" if given is None else given, unit, "command")


def _dynamics(
    time_constant: float | None, natural_frequency: float | None, damping: float | None
) -> dict[str, tuple[float | str, str]]:
    if (time_constant is None) == (natural_frequency is None):
        raise InputError(
            "time_constant, natural_frequency: give one of the two, for an actuator of first or second order"
        )
    if time_constant is not None:
        if damping is not None:
            raise InputError("damping: an actuator of the first order has none; give natural_frequency")
        return {"time_constant": (_check.number("time_constant", time_constant, positive=True), "s")}
    assert natural_frequency is not None
    frequency = _check.number("natural_frequency", natural_frequency, positive=True)
    ratio = _check.number("damping", 1.0 if damping is None else damping)
    if ratio < 0.0:
        raise InputError(f"damping: got {ratio}; give a number that is not negative")
    return {"natural_frequency": (frequency, "rad/s"), "damping": (ratio, "1")}
