"""Propellers and rotors: thrust and torque by advance ratio, and the momentum of what turns."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.commands import Command, command, unit_vector
from freebody.elements.seats import at_least
from freebody.environment import Environment, Flow, checked_environment
from freebody.errors import InputError
from freebody.forces import Spin
from freebody.tables import Table
from freebody.tracing import ForceLaw, NoticeLaw, wrench
from freebody.tracing.declaration import check_name

__all__ = ["Coefficient", "Propeller"]

Coefficient: TypeAlias = float | Sequence[float] | Table
"""A number, a polynomial in the advance ratio, lowest power first, or a table of it."""

_TURN = 2.0 * np.pi
# Below a hundredth of a turn a second the advance ratio is taken to zero: a rotor at rest has none.
_SLOW = 0.01


class Propeller(ForceLaw):
    """A propeller or a rotor, in air or water.

    At n revolutions a second, W = 2 pi n, in a medium of density rho that it meets with the speed u along its
    axis, it gives

        thrust T = (1 - t) K_T(J) rho n |n| D^4    along the axis
        torque Q = K_Q(J) rho n |n| D^5            against its rotation

    with the advance ratio J = (1 - w) u/(n D). Carlton, Marine Propellers and Propulsion (2012), chapter 6;
    for aircraft the same numbers are called C_T and C_Q. Beside these acts what its angular momentum
    h = I W about the axis asks for, -omega x h, and the reaction of a changing speed.

    Its speed is one of three:

    - `speed`: an input or a number. How fast that input changes is not known here, and has no reaction.
    - `speed` and `lag`: the speed follows it, W' = (speed - W)/lag; a state. The body gets -I W'.
    - `torque`: of the motor, an input or a number: I (W' + a . omega') = torque - Q, a its axis of rotation;
      a state. The body gets the motor's torque back, and not Q.

    Parameters
    ----------
    environment
        Air or water, and how it moves.
    at
        Its hub, body axes, (3,) m; where the medium meets it.
    axis
        Where its thrust points while it turns forwards, body axes, (3,); scaled to length one.
    diameter
        D, m.
    thrust_coefficient, torque_coefficient
        K_T and K_Q: numbers, coefficients of polynomials in J, lowest power first, or tables of J. Where a
        run leaves a table is said by its `notices`.
    hand
        "right": forwards it turns about its axis as a right-hand screw; "left".
    speed, torque, lag
        See above: rad/s, N m, s.
    inertia
        I of what turns, about the axis, kg m^2. Its mass and this inertia belong to the body as well.
    initial_speed
        rad/s; where the speed is a state, called `<name>_speed` and a signal that others read.
    wake_fraction, thrust_deduction
        w and t, of a propeller behind a hull.
    name
        A word.

    Parameters of the law: `diameter`, `inertia` (not with `torque`), `lag`, `wake_fraction`,
    `thrust_deduction`; `thrust_coefficient` and `torque_coefficient` where they are one number; `speed` or
    `torque` where it is a number.
    """

    def __init__(
        self,
        environment: Environment,
        at: ArrayLike,
        axis: ArrayLike,
        diameter: float,
        *,
        thrust_coefficient: Coefficient,
        torque_coefficient: Coefficient = 0.0,
        hand: Literal["right", "left"] = "right",
        speed: str | float | None = None,
        lag: float | None = None,
        torque: str | float | None = None,
        inertia: float = 0.0,
        initial_speed: float = 0.0,
        wake_fraction: float = 0.0,
        thrust_deduction: float = 0.0,
        name: str = "propeller",
    ) -> None:
        check_name("name", name)
        checked_environment(environment, f"{name}: ")
        hub = _check.vector(f"{name}: at", at, 3)
        line = unit_vector(f"{name}: axis", axis)
        sense = 1.0 if _check.choice(f"{name}: hand", hand, ("right", "left")) == "right" else -1.0
        drive = _drive(name, speed, torque, lag)
        about = _inertia(f"{name}: inertia", inertia, torque is not None)
        parameters: dict[str, tuple[float | str, str]] = {
            "diameter": (_check.number(f"{name}: diameter", diameter, positive=True), "m"),
            "wake_fraction": (_check.number(f"{name}: wake_fraction", wake_fraction), "1"),
            "thrust_deduction": (_check.number(f"{name}: thrust_deduction", thrust_deduction), "1"),
            **drive.parameters,
            **environment.parameters,
        }
        if torque is None:
            parameters["inertia"] = (about, "kg m^2")
        if lag is not None:
            parameters["lag"] = (_check.number(f"{name}: lag", lag, positive=True), "s")
        k_t = _coefficient(f"{name}: thrust_coefficient", thrust_coefficient, parameters)
        k_q = _coefficient(f"{name}: torque_coefficient", torque_coefficient, parameters)
        state = f"{name}_speed"
        states = {} if speed is not None and lag is None else {state: (initial_speed, "rad/s")}

        def advance_ratio(flow: Flow, p: Any, n: Any) -> Any:
            inflow = (1.0 - p.wake_fraction) * (line @ flow.velocity)
            return inflow * n / (p.diameter * (n * n + _SLOW**2))

        def load(s: Any, p: Any, turning: Any) -> tuple[Any, Any]:
            flow = environment.flow(s, p, hub)
            n, diameter = turning / _TURN, p.diameter
            advance = advance_ratio(flow, p, n)
            pressure = 1.0 * flow.air.density * n * np.abs(n) * diameter**4
            thrust = (1.0 - p.thrust_deduction) * k_t(advance, p) * pressure
            return thrust, k_q(advance, p) * pressure * diameter

        def propeller(s: Any, p: Any) -> Any:
            told = drive.value(s, p)
            turning = s.states[state] if states else told
            thrust, against = load(s, p, turning)
            if torque is None:
                rate = (told - turning) / p.lag if states else 0.0
                reaction, of_inertia = against + p.inertia * rate, p.inertia
            else:
                rate, reaction, of_inertia = (told - against) / about, told, about
            gyroscopic = np.cross(s.angular_velocity_body, line * (sense * of_inertia * turning))
            acts = wrench(thrust * line, -sense * reaction * line - gyroscopic, hub)
            return (acts, {state: rate}) if states else acts

        super().__init__(propeller, parameters, {**drive.inputs, **environment.inputs}, states, name)
        self.publishes = tuple(states)
        read = {state: "rad/s"} if states else drive.inputs
        own = () if states else drive.parameters
        known = {key: parameters[key] for key in ("diameter", "wake_fraction", *own, *environment.parameters)}

        def advance(s: Any, p: Any) -> Any:
            turning = 1.0 * (s.inputs[state] if states else drive.value(s, p))
            return 1.0 * advance_ratio(environment.flow(s, p, hub), p, turning / _TURN)

        given = {"thrust": thrust_coefficient, "torque": torque_coefficient}
        ends = _ends(name, given, advance, known, {**read, **environment.inputs})
        self.notices = (*environment.notices, *ends)
        if torque is not None:
            x, y, z = sense * line
            self.spins = (Spin((x, y, z), about, state),)


def _inertia(where: str, given: float, needed: bool) -> float:
    return _check.number(where, given, positive=True) if needed else at_least(where, given)


def _ends(
    name: str,
    given: Mapping[str, Coefficient],
    advance: Callable[[Any, Any], Any],
    parameters: Mapping[str, tuple[float | str, str]],
    inputs: Mapping[str, str],
) -> Iterator[NoticeLaw]:
    """Say that the advance ratio left the table of a coefficient."""
    for what, table in given.items():
        if isinstance(table, Table):
            low, high = float(table.axes[0][0]), float(table.axes[0][-1])

            message = f"{name}: the advance ratio leaves {low:.6g} to {high:.6g} of the table of {what}, "
            inside = _between(advance, low, high)
            yield NoticeLaw(message + "which holds its border values", inside, parameters, inputs)


def _between(value: Callable[[Any, Any], Any], low: float, high: float) -> Callable[[Any, Any], Any]:
    """How far a value of a law is from the nearer of two borders; negative beyond."""

    def inside(s: Any, p: Any) -> Any:
        ratio = value(s, p)
        return np.minimum(ratio - low, high - ratio)

    return inside


def _drive(name: str, speed: object, torque: object, lag: object) -> Command:
    if (speed is None) == (torque is None):
        raise InputError(
            f"{name}: speed, torque: give one of the two, the name of an input or a number: how fast it "
            "turns, or the torque of its motor"
        )
    if torque is None:
        return command(f"{name}: speed", speed, "rad/s", "speed")  # pyright: ignore[reportArgumentType]
    if lag is not None:
        raise InputError(f"{name}: lag: belongs to a speed; what a torque drives is slow by its inertia")
    return command(f"{name}: torque", torque, "N m", "torque")  # pyright: ignore[reportArgumentType]


def _coefficient(where: str, given: Coefficient, parameters: dict[str, Any]) -> Callable[[Any, Any], Any]:
    key = where.rpartition(" ")[2]
    if isinstance(given, Table):
        if len(given.axes) != 1:
            raise InputError(f"{where}: got a table of {len(given.axes)}; give one of the advance ratio")
        return lambda advance, p: given(advance)
    if np.ndim(given) == 0:
        parameters[key] = (_check.number(where, given), "1")  # pyright: ignore[reportArgumentType]
        return lambda advance, p: p[key]
    powers = [float(c) for c in _check.series(where, given)][::-1]  # pyright: ignore[reportArgumentType]
    return lambda advance, p: np.polyval(powers, advance)
