"""What the numbers of x and u are, and which law reads, moves and commands which."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from freebody import _check
from freebody.errors import InputError
from freebody.forces import InputWrench
from freebody.interfaces import Contents, Control, Force, Quantity, StateQuantity
from freebody.units import agree

__all__ = [
    "Signals",
    "Source",
    "connect",
    "given_states",
    "input_places",
    "labels",
    "reads_inputs",
    "rigid_state_labels",
]


class Source(NamedTuple):
    """Where the core finds a number that laws read by name.

    From 0 on all inputs are numbered, those of u first; below 0 auxiliary states, of which -1 is the first.
    """

    number: int
    unit: str


class Signals(NamedTuple):
    """What the laws of a model read and set.

    Inputs are those of u; `sources` has them, behind them what the control law commands, and the states that
    forces publish. The places are numbers of sources, one list for each force, and for all contents in turn.
    """

    inputs: tuple[Quantity, ...]
    commands: tuple[Quantity, ...]
    states: tuple[StateQuantity, ...]
    sources: dict[str, Source]
    force_places: list[list[int]]
    control_places: list[int]
    contents_places: list[list[int]]


def connect(forces: Sequence[Force], control: Control | None) -> Signals:
    """Give the inputs of all laws their sources; inputs of one name are one input, or one published state.

    Raises `InputError` where units or names of the laws do not fit together.
    """
    states, published = _states(forces, control), _published(forces)
    read = [_inputs(force, forces) for force in forces]
    known: dict[str, tuple[Quantity, str]] = {}
    for force, quantities in zip(forces, read, strict=True):
        _take(known, published, quantities, f"force {force.name!r}", isinstance(force, InputWrench))
    commands = () if control is None else _commands(known, published, control)
    commanded = {quantity.name for quantity in commands}
    contents = [own for force in forces for own in force.contents]
    for own in contents:
        if not isinstance(own, Contents):
            raise InputError(f"contents: got {_check.shown(own)}; make them with @fb.contents")
        for name in [q.name for q in own.inputs if q.name in commanded]:
            raise InputError(
                f"contents: {own.name!r} reads {name!r}, which a control law commands; contents come before "
                "all commands: let a state follow the command, and publish that"
            )
        _take(known, published, own.inputs, f"contents {own.name!r}")
    if control is not None:
        for quantity in control.inputs:
            if quantity.name in commanded:
                raise InputError(
                    f"control: {control.name!r} reads {quantity.name!r}, the input that it commands; keep "
                    "what it remembers in a state of the law"
                )
        _take(known, published, control.inputs, f"control law {control.name!r}")
    inputs = tuple(quantity for quantity, _ in known.values() if quantity.name not in commanded)
    sources = {q.name: Source(i, q.unit) for i, q in enumerate((*inputs, *commands))}
    names = [state.name for state in states]
    for name, (_, unit, law) in published.items():
        sources[name] = Source(-1 - names.index(f"{law}.{name}"), unit)

    def places(quantities: Iterable[Quantity]) -> list[int]:
        return [sources[q.name].number for q in quantities]

    return Signals(
        inputs,
        commands,
        states,
        sources,
        [places(quantities) for quantities in read],
        [] if control is None else places(control.inputs),
        [places(own.inputs) for own in contents],
    )


def reads_inputs(forces: Sequence[Force]) -> bool:
    """Whether a force reads what no force publishes."""
    published = {name for force in forces for name in force.publishes}
    return any(q.name not in published for force in forces for q in force.inputs)


def input_places(reader: str, inputs: Sequence[Quantity], known: Mapping[str, Source]) -> list[int]:
    """The numbers of the sources that a law reads, of those that a model has."""
    for name, unit in inputs:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f"did you mean {near[0]!r}?" if near else f"its inputs are {', '.join(map(repr, known))}"
            raise InputError(f"{reader} reads the input {name!r}, which the model has not; {hint}")
        if not agree(known[name].unit, unit):
            raise InputError(
                f"{reader} reads the input {name!r} in {unit!r}; the model has it in {known[name].unit!r}"
            )
    return [known[q.name].number for q in inputs]


class _Published(NamedTuple):
    """A state that other laws read, and the force that has it."""

    name: str
    unit: str
    force: str


def _published(forces: Sequence[Force]) -> dict[str, _Published]:
    """The published states by their names."""
    found: dict[str, _Published] = {}
    for force in forces:
        units = {state.name: state.unit for state in force.states}
        for name in force.publishes:
            if name not in units:
                own = ", ".join(map(repr, units)) or "none"
                raise InputError(
                    f"force {force.name!r}: publishes {_check.shown(name)}, which is no state of it; its "
                    f"states are {own}"
                )
            if name in found:
                raise InputError(
                    f"state {name!r}: force {found[name].force!r} and force {force.name!r} both publish it; "
                    "what laws read by a name is one number: rename one of the two"
                )
            found[name] = _Published(name, units[name], force.name)
    return found


def _inputs(force: Force, forces: Sequence[Force]) -> tuple[Quantity, ...]:
    """What a force reads; of several input wrenches each puts its name before its inputs."""
    if isinstance(force, InputWrench) and sum(isinstance(f, InputWrench) for f in forces) > 1:
        return tuple(Quantity(f"{force.name}.{q.name}", q.unit) for q in force.inputs)
    return force.inputs


def _take(
    known: dict[str, tuple[Quantity, str]],
    published: Mapping[str, _Published],
    quantities: Iterable[Quantity],
    reader: str,
    refuses_states: bool = False,
) -> None:
    """Note what a law reads, unless it is a published state."""
    for quantity in quantities:
        state = published.get(quantity.name)
        if state is None:
            _add(known, quantity, reader)
        elif refuses_states:
            raise InputError(
                f"input {quantity.name!r}: force {state.force!r} publishes a state of this name, and "
                f"{reader} reads inputs of u alone; rename the state"
            )
        elif not agree(state.unit, quantity.unit):
            raise InputError(
                f"input {quantity.name!r}: force {state.force!r} publishes it in {state.unit!r}, {reader} "
                f"reads it in {quantity.unit!r}"
            )


def _add(known: dict[str, tuple[Quantity, str]], quantity: Quantity, reader: str) -> None:
    first, other = known.setdefault(quantity.name, (quantity, reader))
    if not agree(first.unit, quantity.unit):
        raise InputError(
            f"input {quantity.name!r}: {other} reads it in {first.unit!r}, {reader} in {quantity.unit!r}; "
            "inputs of one name are one input: declare one unit, or another name"
        )


def _commands(
    known: dict[str, tuple[Quantity, str]], published: Mapping[str, _Published], control: Control
) -> tuple[Quantity, ...]:
    """What a control law commands, with the units in which the forces read it."""
    for command in control.commands:
        if command.name in published:
            raise InputError(
                f"control: {control.name!r} commands {command.name!r}, a state that force "
                f"{published[command.name].force!r} publishes; command an input which that force reads"
            )
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


def labels(quantities: Iterable[Quantity]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units."""
    return tuple(q.name for q in quantities), tuple(q.unit for q in quantities)


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
