"""Steady flight: the state and the inputs that hold it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.environment import Calm, FlatEarth
from freebody.errors import InputError, TrimError
from freebody.model import Model
from freebody.trimming.equations import SteadyFlight, named

__all__ = ["Trim", "trim"]

# A steady state is found to rounding; what stays above this is none.
_STEADY = 1e-8


@dataclass(frozen=True)
class Trim:
    """A steady flight.

    Attributes
    ----------
    x, u
        State and inputs of the model, at time 0.
    inputs, states
        The inputs, and the auxiliary states, by name.
    alpha, beta
        Angles of attack and of sideslip of the mass centre's velocity, rad.
    roll, pitch
        rad, of the sequence yaw, pitch, roll.
    angular_velocity_body
        (3,) rad/s.
    residual
        The largest rate that is left of those that vanish, SI.
    """

    x: Array
    u: Array
    inputs: Mapping[str, float]
    states: Mapping[str, float]
    alpha: float
    beta: float
    roll: float
    pitch: float
    angular_velocity_body: Array
    residual: float


def trim(
    model: Model,
    *,
    airspeed: float,
    altitude: float = 0.0,
    flight_path: float = 0.0,
    heading: float = 0.0,
    turn_rate: float = 0.0,
    pitch_rate: float = 0.0,
    roll: float | None = None,
    sideslip: float | None = None,
    inputs: Mapping[str, float] | None = None,
    bounds: Mapping[str, tuple[float, float]] | None = None,
    guess: Mapping[str, float] | None = None,
) -> Trim:
    """Find a steady flight: straight, a turn, or a pull-up at its lowest point.

    In still air over a flat Earth, world axes north, east and down: a model whose environment is another is
    refused. The rates of the body velocities and of
    the auxiliary states vanish; sought are alpha, beta, roll, pitch, the inputs and the auxiliary states.

    Parameters
    ----------
    airspeed, altitude
        Of the mass centre, m/s and m.
    flight_path, heading
        Angle of climb, and the yaw angle, rad.
    turn_rate, pitch_rate
        Rates of the yaw and of the pitch angle, rad/s.
    roll, sideslip
        One of them at most, rad. When both are omitted, a turn is coordinated (no sideward force but
        gravity's), and all else has roll zero.
    inputs
        Those that are given, by name, in the model's units; all others are sought.
    bounds
        Between what inputs and angles are sought, {"throttle": (0.0, 1.0)}; the search starts at several
        places between those of inputs that are not negative.
    guess
        Where the search starts: angles, inputs and auxiliary states by name.

    Raises
    ------
    TrimError
        None was found: says which rates remain.

    Solved by `scipy.optimize.least_squares` (extra `ensemble`) with the exact Jacobian of the model.
    Source of the constraints: Stevens and Lewis, Aircraft Control and Simulation, 2nd ed., section 3.6.
    """
    try:
        from scipy.optimize import least_squares  # noqa: PLC0415  (an extra, and slow to load)
    except ImportError:
        raise InputError("trim needs scipy: pip install 'freebody[ensemble]'") from None
    if not isinstance(model, Model):
        raise InputError(f"model: got {_check.shown(model)}; give a freebody.Model")
    if roll is not None and sideslip is not None:
        raise InputError("roll, sideslip: both came; give one of them")
    task = SteadyFlight(
        Model(model.body, model.forces, "zyx", control=model.control),
        airspeed=_check.number("airspeed", airspeed, positive=True),
        height=_check.number("altitude", altitude) - _ground(model),
        flight_path=_check.number("flight_path", flight_path),
        heading=_check.number("heading", heading),
        turn_rate=_check.number("turn_rate", turn_rate),
        pitch_rate=_check.number("pitch_rate", pitch_rate),
        roll=_given("roll", 0.0 if roll is None and sideslip is None and turn_rate == 0.0 else roll),
        sideslip=_given("sideslip", sideslip),
        fixed=named("inputs", inputs, model.input_names),
    )
    low, high = task.bounds(bounds)
    tried = []
    for start in task.starts(guess, low, high):
        found: Any = least_squares(
            task.residual,
            np.clip(start, low, high),
            jac=task.jacobian,  # pyright: ignore[reportArgumentType]  (its types know no function here)
            bounds=(low, high),
            x_scale="jac",
            xtol=1e-15,
            ftol=1e-15,
            gtol=1e-15,
            max_nfev=100,
        )
        left = np.abs(task.residual(found.x))
        if left.max() <= _STEADY:
            return _found(model, task, found.x, float(left.max()))
        tried.append(left)
    raise TrimError(task.complaint(min(tried, key=np.max)))


def _found(model: Model, task: SteadyFlight, z: Array, residual: float) -> Trim:
    x, _ = task.motion(z)
    alpha, beta, roll, pitch = z[:4].tolist()
    states = {s.name: float(x[12 + i]) for i, s in enumerate(model.auxiliary_states)}
    u = task.inputs(z)
    return Trim(
        x=model.state(
            x[:3],
            Attitude.angles("zyx", x[3:6]),
            velocity_body=x[6:9],
            angular_velocity_body=x[9:12],
            states=states,
        ),
        u=u,
        inputs=dict(zip(model.input_names, u.tolist(), strict=True)),
        states=states,
        alpha=alpha,
        beta=beta,
        roll=roll,
        pitch=pitch,
        angular_velocity_body=x[9:12],
        residual=residual,
    )


def _ground(model: Model) -> float:
    """The altitude of the world origin, where the model says what surrounds it; that it suits."""
    environment = model.environment
    if environment is None:
        return 0.0
    planet = environment.planet
    if not isinstance(planet, FlatEarth) or planet.axes != "ned":
        raise InputError(f'model: over {planet!r}; steady flight is sought over a FlatEarth(axes="ned")')
    if not isinstance(environment.wind, Calm):
        raise InputError(
            f"model: in {type(environment.wind).__name__}; steady flight is sought in still air, in an "
            "environment without wind"
        )
    return planet.altitude


def _given(name: str, value: float | None) -> float | None:
    return None if value is None else _check.number(name, value)
