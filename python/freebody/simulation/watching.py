"""Events and outputs: what the core is given, and what comes back."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, TypeVar

from freebody import _check, _core
from freebody._check import Array
from freebody.environment import Environment
from freebody.errors import InputError
from freebody.interfaces import Force
from freebody.signals import Source, input_places
from freebody.simulation.outcome import Notice
from freebody.tracing import EventLaw, NoticeLaw, OutputLaw

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Occurrence", "Watched", "notices_of", "watched"]

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
    """The events and outputs of a run, checked; as the core takes them.

    The core watches the notices of the model's forces as events behind the others. Whether one holds from the
    start is told by a run of no length, of which they are the outputs.
    """

    events: tuple[EventLaw, ...]
    outputs: tuple[OutputLaw, ...]
    core_events: list[CoreEvent]
    core_outputs: list[CoreOutput]
    notices: tuple[tuple[str, EventLaw], ...]
    core_notices: list[CoreOutput]

    def occurrences(self, result: _core.RunResult) -> tuple[Occurrence, ...]:
        """The events of a run."""
        rows = zip(*result.occurrences(), strict=True)
        known = len(self.events)
        return tuple(
            Occurrence(self.events[place].name, float(t), x) for place, t, x in rows if place < known
        )

    @property
    def messages(self) -> tuple[str, ...]:
        """Of the notices."""
        return tuple(_message(law) for _, law in self.notices)

    def told(self, start: float, at_start: list[float], result: _core.RunResult) -> tuple[Notice, ...]:
        """The notices of a run, of their values at the start and what came to pass later."""
        found = [
            Notice(start, name, _message(law), True)
            for (name, law), value in zip(self.notices, at_start, strict=True)
            if value < 0.0
        ]
        places, times, _ = result.occurrences()
        for place, time in zip(places, times, strict=True):
            if place >= len(self.events):
                name, law = self.notices[place - len(self.events)]
                found.append(Notice(float(time), name, _message(law)))
        return tuple(found)

    def values(self, result: _core.RunResult) -> dict[str, float]:
        """The outputs of a run by name."""
        return dict(zip((law.name for law in self.outputs), result.outputs, strict=True))

    @property
    def output_units(self) -> dict[str, str]:
        """Of the outputs, by name."""
        return {law.name: law.unit for law in self.outputs}


_NOTHING = Watched((), (), [], [], (), [])


def watched(model: Model, events: Iterable[EventLaw], outputs: Iterable[OutputLaw]) -> Watched:
    """Check events and outputs for a model.

    Raises `InputError` for what is none, for a name that stands twice and for inputs that the model has not.
    """
    notices = model.notices
    if events == () and outputs == () and not notices:
        return _NOTHING
    known = model.sources
    event_laws = _checked("events", events, EventLaw)
    output_laws = _checked("outputs", outputs, OutputLaw)
    told = [_core_law("notice", law, known) for _, law in notices]
    return Watched(
        event_laws,
        output_laws,
        [
            *((*_core_law("event", law, known), law.direction, law.terminal) for law in event_laws),
            *((*law, "falling", False) for law in told),
        ],
        [(*_core_law("output", law, known), law.take) for law in output_laws],
        notices,
        [(*law, "final") for law in told],
    )


def notices_of(forces: Iterable[Force], environment: Environment | None) -> tuple[tuple[str, EventLaw], ...]:
    """The notices of a model's forces and surroundings, each once, with the name of who says it."""
    found: dict[EventLaw, str] = {}
    for force in forces:
        for law in force.notices:
            found.setdefault(law, force.name)
    for law in () if environment is None else environment.notices:
        found.setdefault(law, "environment")
    return tuple((name, law) for law, name in found.items())


def _message(law: EventLaw) -> str:
    return law.message if isinstance(law, NoticeLaw) else law.name


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
    what: str, law: EventLaw | OutputLaw, known: Mapping[str, Source]
) -> tuple[_core.Program, list[float], list[int]]:
    places = input_places(f"{what} {law.name!r}", law.inputs, known)
    return law.program, list(law.parameters.values()), places
