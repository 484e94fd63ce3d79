"""Events and outputs: what the core is given, and what comes back."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, TypeVar

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import InputError
from freebody.signals import input_places
from freebody.tracing import EventLaw, OutputLaw

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Occurrence", "Watched", "watched"]

CoreEvent: TypeAlias = tuple[_core.Program, list[float], list[int], str, bool]
CoreOutput: TypeAlias = tuple[_core.Program, list[float], list[int], str]
L = TypeVar("L", EventLaw, OutputLaw)


@dataclass(frozen=True)
class Occurrence:
    """An event that came to pass.

    Attributes
    ----------
    name
        Of the event.
    time
        s; its number is then zero or just on its new side.
    state
        Of the model, (n_states,).
    """

    name: str
    time: float
    state: Array


class Watched(NamedTuple):
    """The events and outputs of a run, checked; as the core takes them."""

    events: tuple[EventLaw, ...]
    outputs: tuple[OutputLaw, ...]
    core_events: list[CoreEvent]
    core_outputs: list[CoreOutput]

    def occurrences(self, result: _core.RunResult) -> tuple[Occurrence, ...]:
        """The events of a run."""
        rows = zip(*result.occurrences(), strict=True)
        return tuple(Occurrence(self.events[place].name, float(t), x) for place, t, x in rows)

    def values(self, result: _core.RunResult) -> tuple[dict[str, float], dict[str, str]]:
        """The outputs of a run and their units, by name."""
        names = [law.name for law in self.outputs]
        units = [law.unit for law in self.outputs]
        return dict(zip(names, result.outputs, strict=True)), dict(zip(names, units, strict=True))


def watched(model: Model, events: Iterable[EventLaw], outputs: Iterable[OutputLaw]) -> Watched:
    """Check events and outputs for a model.

    Raises `InputError` for what is none, for a name that stands twice and for inputs that the model has not.
    """
    if events == () and outputs == ():
        return Watched((), (), [], [])
    known = dict(
        zip(
            (*model.input_names, *model.command_names),
            (*model.input_units, *model.command_units),
            strict=True,
        )
    )
    event_laws = _checked("events", events, EventLaw)
    output_laws = _checked("outputs", outputs, OutputLaw)
    return Watched(
        event_laws,
        output_laws,
        [(*_core_law("event", law, known), law.direction, law.terminal) for law in event_laws],
        [(*_core_law("output", law, known), law.take) for law in output_laws],
    )


def _checked(what: str, laws: Iterable[L], kind: type[L]) -> tuple[L, ...]:
    one = what.removesuffix("s")
    allowed = f"give a list of {what} made by @fb.{one}"
    if isinstance(laws, str) or not isinstance(laws, Iterable):
        raise InputError(f"{what}: got {_check.shown(laws)}; {allowed}")
    found = tuple(laws)
    names = set()
    for i, law in enumerate(found):
        if not isinstance(law, kind):
            raise InputError(f"{what}[{i}]: got {_check.shown(law)}; {allowed}")
        if law.name in names:
            raise InputError(
                f'{what}[{i}]: the name {law.name!r} stands twice; give each its own, {law.name}(name="...")'
            )
        names.add(law.name)
    return found


def _core_law(
    what: str, law: EventLaw | OutputLaw, known: dict[str, str]
) -> tuple[_core.Program, list[float], list[int]]:
    places = input_places(f"{what} {law.name!r}", law.inputs, known)
    return law.program, list(law.parameters.values()), places
