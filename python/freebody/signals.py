"""What the numbers of x and u are, and which law reads, moves and commands which."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from freebody import _check
from freebody.errors import InputError
from freebody.forces import Control, Force, InputWrench, Quantity, StateQuantity
from freebody.units import agree

__all__ = ["Signals", "connect", "given_states", "input_places", "rigid_state_labels"]


class Signals(NamedTuple):
    """What the laws of a model read and set.

    The core numbers all inputs: those of u, behind them those that the control law commands.
    """

    inputs: tuple[Quantity, ...]
    commands: tuple[Quantity, ...]
    states: tuple[StateQuantity, ...]
    force_places: list[list[int]]
    control_places: list[int]


def connect(forces: Sequence[Force], control: Control | None) -> Signals:
    """Give the inputs of all laws their places; inputs of one name are one input.

    Raises `InputError` where units or names of the laws do not fit together.
    """
    read = [_inputs(force, forces) for force in forces]
    known: dict[str, tuple[Quantity, str]] = {}
    for force, quantities in zip(forces, read, strict=True):
        for quantity in quantities:
            _add(known, quantity, f"force {force.name!r}")
    commands = () if control is None else _commands(known, control)
    if control is not None:
        for quantity in control.inputs:
            if any(quantity.name == c.name for c in commands):
                raise InputError(
                    f"control: {control.name!r} reads {quantity.name!r}, the input that it commands; keep "
                    "what it remembers in a state of the law"
                )
            _add(known, quantity, f"control law {control.name!r}")
    commanded = {quantity.name for quantity in commands}
    inputs = tuple(quantity for quantity, _ in known.values() if quantity.name not in commanded)
    places = {quantity.name: i for i, quantity in enumerate((*inputs, *commands))}
    return Signals(
        inputs,
        commands,
        _states(forces, control),
        [[places[q.name] for q in quantities] for quantities in read],
        [] if control is None else [places[q.name] for q in control.inputs],
    )


def input_places(reader: str, inputs: Sequence[Quantity], known: Mapping[str, str]) -> list[int]:
    """The places of inputs among those that a model has, `known` with their units."""
    names = list(known)
    for name, unit in inputs:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f"did you mean {near[0]!r}?" if near else f"its inputs are {', '.join(map(repr, known))}"
            raise InputError(f"{reader} reads the input {name!r}, which the model has not; {hint}")
        if not agree(known[name], unit):
            raise InputError(
                f"{reader} reads the input {name!r} in {unit!r}; the model has it in {known[name]!r}"
            )
    return [names.index(q.name) for q in inputs]


def _inputs(force: Force, forces: Sequence[Force]) -> tuple[Quantity, ...]:
    """What a force reads; of several input wrenches each puts its name before its inputs."""
    if isinstance(force, InputWrench) and sum(isinstance(f, InputWrench) for f in forces) > 1:
        return tuple(Quantity(f"{force.name}.{q.name}", q.unit) for q in force.inputs)
    return force.inputs


def _add(known: dict[str, tuple[Quantity, str]], quantity: Quantity, reader: str) -> None:
    first, other = known.setdefault(quantity.name, (quantity, reader))
    if not agree(first.unit, quantity.unit):
        raise InputError(
            f"input {quantity.name!r}: {other} reads it in {first.unit!r}, {reader} in {quantity.unit!r}; "
            "inputs of one name are one input: declare one unit, or another name"
        )


def _commands(known: dict[str, tuple[Quantity, str]], control: Control) -> tuple[Quantity, ...]:
    """What a control law commands, with the units in which the forces read it."""
    for command in control.commands:
        if command.name not in known:
            near = difflib.get_close_matches(command.name, known, 1)
            hint = f", did you mean {near[0]!r}?" if near else ""
            raise InputError(
                f"control: {control.name!r} commands {command.name!r}, which no force reads; the forces' "
                f"inputs are {', '.join(map(repr, known))}{hint}"
            )
        quantity, reader = known[command.name]
        if not agree(quantity.unit, command.unit):
            raise InputError(
                f"control: {control.name!r} commands {command.name!r} in {command.unit!r}, {reader} reads it "
                f"in {quantity.unit!r}"
            )
    return tuple(known[command.name][0] for command in control.commands)


def _states(forces: Sequence[Force], control: Control | None) -> tuple[StateQuantity, ...]:
    """The auxiliary states in the order of the core, each with the name of its law before its own."""
    laws: list[Force | Control] = [*forces, *([] if control is None else [control])]
    found: dict[str, StateQuantity] = {}
    for law in laws:
        for state in law.states:
            name = f"{law.name}.{state.name}"
            if name in found:
                raise InputError(
                    f"state {name!r}: two laws called {law.name!r} have it; give each its own name, "
                    f'{law.name}(name="...")'
                )
            found[name] = state._replace(name=name)
    return tuple(found.values())


def given_states(states: Mapping[str, float] | None, known: Iterable[str]) -> dict[str, float]:
    """Check auxiliary states that came by name."""
    if not isinstance(states, Mapping | None):
        raise InputError(
            f'states: got {_check.shown(states)}; give a dictionary such as {{"fin.servo": 0.1}}'
        )
    given, names = states or {}, list(known)
    for name in given:
        if name not in names:
            allowed = ", ".join(map(repr, names)) or "none, for no law of this model has states"
            raise InputError(f"states: got {_check.shown(name)}; allowed are {allowed}")
    return {name: _check.number(f"states[{name!r}]", value) for name, value in given.items()}


def _xyz(stem: str) -> tuple[str, ...]:
    return tuple(f"{stem}_{axis}" for axis in "xyz")


def rigid_state_labels(attitude: str, generalized: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the state of the body itself."""
    turning, unit = ("angle_1", "angle_2", "angle_3"), "rad"
    if attitude == "quaternion":
        turning, unit = tuple(f"quaternion_{c}" for c in "wxyz"), "1"
    names, units = [*_xyz("position"), *turning], ["m"] * 3 + [unit] * len(turning)
    if generalized:
        names += [*_xyz("position_rate"), *(name.replace("_", "_rate_") for name in turning)]
        units += ["m/s"] * 3 + ["rad/s" if unit == "rad" else "1/s"] * len(turning)
    else:
        names += [*_xyz("velocity"), *_xyz("angular_velocity")]
        units += ["m/s"] * 3 + ["rad/s"] * 3
    return tuple(names), tuple(units)
