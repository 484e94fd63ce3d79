"""What crosses a threshold: in [[events]], and where a stage begins."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Annotated, Any

import numpy as np
from pydantic import Field, model_validator

from freebody.environment import Environment
from freebody.model import Model
from freebody.tracing import EventLaw

from .fields import Section, did_you_mean
from .planet_schema import MaterialPoint
from .problems import Source
from .units import FieldError, to_si

__all__ = ["Crossing", "EventTable", "build_event", "build_events"]

Point = Annotated[Any, MaterialPoint("m", (3,))]

_WATCHED = ("signal", "altitude", "distance")


class Crossing(Section):
    """A number that falls below a threshold, or rises above it."""

    signal: str | None = Field(
        default=None, description="an input of the model, a command, or a state that a force publishes"
    )
    altitude: Point = Field(
        default=None, description='of "origin", "com" or a point in body axes, above the planet'
    )
    distance: Point = Field(default=None, description="of such a point from the world origin")
    below: Any = Field(default=None, description="the threshold, when it falls")
    above: Any = Field(default=None, description="the threshold, when it rises")

    @model_validator(mode="after")
    def _check(self) -> Crossing:
        self.exactly_one(*_WATCHED)
        self.exactly_one("below", "above")
        if self.signal is None:
            self.threshold("m")
        return self

    @property
    def words(self) -> tuple[str, str]:
        """What is watched, and which way: "fuel_mass", "below"."""
        (what,) = self.model_fields_set & set(_WATCHED)
        (way,) = self.model_fields_set & {"below", "above"}
        return self.signal or what, way

    def threshold(self, unit: str) -> float:
        """The number of `below` or `above`, SI."""
        key = self.words[1]
        try:
            return float(to_si(getattr(self, key), "" if unit == "1" else unit, ()))
        except FieldError as error:
            raise FieldError(str(error), (key,)) from None


class EventTable(Crossing):
    """One of [[events]]."""

    name: str = Field(description="how the outcome and the data name it")
    terminal: bool = Field(default=True, description="whether it ends the run")


def build_event(
    crossing: Crossing, name: str | None, model: Model, source: Source, key: str, *, terminal: bool = True
) -> EventLaw:
    """The event, called by what it is where it has no name; a signal that the model has not is refused."""
    unit = "m"
    if crossing.signal is not None:
        if crossing.signal not in model.sources:
            raise source.error(
                f"{key}.signal",
                f"the model has no signal {crossing.signal!r}{did_you_mean(crossing.signal, model.sources)}",
            )
        unit = model.sources[crossing.signal].unit
    try:
        threshold = crossing.threshold(unit)
    except FieldError as error:
        raise source.error(f"{key}.{error.at[0]}", str(error)) from None
    watched, way = crossing.words
    with source.blame(key):
        return EventLaw(
            _number(crossing, model),
            terminal,
            "falling" if way == "below" else "rising",
            {"threshold": (threshold, unit)},
            {} if crossing.signal is None else {crossing.signal: unit},
            name or f"{watched} {way} {threshold:g} {unit}",
        )


def build_events(
    tables: Iterable[EventTable], models: tuple[Model, ...], source: Source
) -> list[tuple[EventLaw, ...]]:
    """The events of each model: those of places, and those of the signals that it has."""
    found: list[list[EventLaw]] = [[] for _ in models]
    for i, table in enumerate(tables):
        able = [n for n, model in enumerate(models) if table.signal is None or table.signal in model.sources]
        for n in able or range(1):  # a signal that no model has is refused for the first
            law = build_event(table, table.name, models[n], source, f"events[{i}]", terminal=table.terminal)
            found[n].append(law)
    return [tuple(laws) for laws in found]


def _number(crossing: Crossing, model: Model) -> Callable[[Any, Any], Any]:
    """What is compared with the threshold."""
    planet = (model.environment or Environment()).planet
    point = crossing.altitude if crossing.distance is None else crossing.distance

    def place(s: Any) -> Any:
        at = s.com if isinstance(point, str) and point == "com" else point
        at = np.zeros(3) if isinstance(at, str) else at
        return s.position_world + s.world_from_body @ at

    def signal(s: Any, p: Any) -> Any:
        return s.inputs[crossing.signal] - p.threshold

    def altitude(s: Any, p: Any) -> Any:
        return planet.place(place(s), s.time).altitude - p.threshold

    def distance(s: Any, p: Any) -> Any:
        return np.linalg.norm(place(s)) - p.threshold

    if crossing.signal is not None:
        return signal
    return altitude if crossing.distance is None else distance
