"""What a law is given: the situation `s` and the parameters `p`."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Final, NoReturn

import numpy as np

from freebody.tracing.array import Traced
from freebody.tracing.scalar import Scalar
from freebody.tracing.trace import Trace, fault
from freebody.units import Dimension, dimension

__all__ = ["N_GIVEN", "Names", "Situation", "did_you_mean", "named", "situation"]

# The layout of the given numbers, which the core fills: name, shape, units of the entries or of halves.
LAYOUT: Final = (
    ("time", (), ("s",)),
    ("position_world", (3,), ("m",)),
    ("world_from_body", (3, 3), ("1",)),
    ("twist", (6,), ("m/s", "rad/s")),
    ("mass", (), ("kg",)),
    ("com", (3,), ("m",)),
)
N_GIVEN: Final = 23


class Names(Mapping[str, Any]):
    """Values by name, as attributes and as items."""

    def __init__(self, what: str, values: Mapping[str, Any]) -> None:
        vars(self).update(_what=what, _values=dict(values))

    def __getitem__(self, name: str) -> Any:
        if name not in self._values:
            what = self._what
            raise _unknown(name, f"no {what} of this law", self._values, f"declare it, {what}s={{...}}")
        return self._values[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise _read_only(f"the {self._what} {name}")

    def __setitem__(self, name: str, value: object) -> NoReturn:
        raise _read_only(f"the {self._what} {name}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)


class Situation:
    """Where the body is, how it moves, and what the law reads; SI, arrays that cannot be written.

    Attributes
    ----------
    time
        s.
    position_world
        Of the body origin, (3,) m.
    world_from_body
        Rotation matrix (3, 3).
    twist
        Velocity of the body origin and angular velocity, body axes, (6,) m/s and rad/s.
    velocity_body, angular_velocity_body
        Its halves, (3,) each.
    mass
        kg.
    com
        Mass centre from the body origin, body axes, (3,) m.
    inputs, states
        What the law declares, by name.

    In a callback every number has one axis more in front, the batch.
    """

    time: Any
    position_world: Any
    world_from_body: Any
    twist: Any
    velocity_body: Any
    angular_velocity_body: Any
    mass: Any
    com: Any
    inputs: Names
    states: Names

    def __init__(self, values: Mapping[str, Any], inputs: Names, states: Names) -> None:
        twist = values["twist"]
        halves = {"velocity_body": twist[..., :3], "angular_velocity_body": twist[..., 3:]}
        vars(self).update(values, **halves, inputs=inputs, states=states)
        for value in vars(self).values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    def __getattr__(self, name: str) -> NoReturn:
        if name.startswith("__"):
            raise AttributeError(name)
        raise _unknown(name, "nothing that the situation s has", vars(self), "see fb.force for what it has")

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise _read_only(f"s.{name}")


def situation(
    trace: Trace, inputs: Mapping[str, str], states: Mapping[str, str]
) -> tuple[Situation, list[int]]:
    """The situation of a trace, and the nodes of its symbols in the order of the core."""
    values, nodes = {}, []
    for name, shape, units in LAYOUT:
        count = int(np.prod(shape))
        dimensions = [dimension(name, units[i * len(units) // count]) for i in range(count)]
        symbols = [f"{name}[{i}]" for i in range(count)] if shape else [name]
        entries = np.empty(count, object)
        entries[:] = [symbol(trace, s, d) for s, d in zip(symbols, dimensions, strict=True)]
        values[name] = entries.reshape(shape).view(Traced) if shape else entries[0]
        nodes += [scalar.node for scalar in entries]
    read = named(trace, "input", inputs)
    own = named(trace, "state", states)
    nodes += [scalar.node for names in (read, own) for scalar in names.values()]
    return Situation(values, read, own), nodes


def named(trace: Trace, what: str, units: Mapping[str, str]) -> Names:
    """Symbols by name."""
    return Names(what, {n: symbol(trace, f"{what}s.{n}", dimension(n, unit)) for n, unit in units.items()})


def symbol(trace: Trace, name: str, unit: Dimension) -> Scalar:
    """A number that the law is given."""
    return Scalar(trace, trace.symbol(name), unit)


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """The near names, or all."""
    known = sorted(known)
    near = difflib.get_close_matches(name, known, 3, 0.6)
    if near:
        return f"did you mean {' or '.join(map(repr, near))}?"
    return f"known are {', '.join(known)}" if known else "there is none"


def _unknown(name: str, what: str, known: Iterable[str], otherwise: str) -> Exception:
    hint = did_you_mean(name, known)
    return fault(
        f"{name!r} is {what}", f"{hint} Or {otherwise}" if hint.endswith("?") else f"{hint}; {otherwise}"
    )


def _read_only(what: str) -> Exception:
    return fault(f"{what} is assigned", "a law has no side effects: compute with a copy, x = s.twist.copy()")
