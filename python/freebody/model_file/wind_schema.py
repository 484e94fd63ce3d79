"""Winds and currents of [environment]."""

from __future__ import annotations

from abc import abstractmethod
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, Field, model_validator

from freebody import environment as surroundings
from freebody._check import Array
from freebody.environment import Wind
from freebody.environment.turbulence_scales import SEVERITIES

from .csv_table import read_columns
from .fields import Choice, OneOf, Quantity, Section
from .problems import Source
from .units import FieldError
from .words import word_as_table

__all__ = ["AnyWind", "WindSection"]

Velocity = Annotated[Array | None, Quantity("m/s", (3,))]
Angle = Annotated[float | None, Quantity("rad")]
Length = Annotated[float | None, Quantity("m")]
_NAME = Field(default=None, description="the word before the names of its parameters")
_VELOCITY = Field(default=None, description="towards which it blows or flows: north, east, down")
_FROM = Field(default=None, description="from where it blows, clockwise from north")
_GROUND = Field(default=None, description="altitude of the ground")
_TOP = Field(default=None, description="height above ground from which on the wind is the same")


class WindSection(Section):
    """One of the kinds of wind."""

    name: str | None = _NAME

    @abstractmethod
    def wind(self, key: str, source: Source) -> Wind:
        """The wind; `key` is where the section stands."""


class Constant(WindSection):
    """One velocity everywhere: `velocity`, or `from` and `speed`."""

    type: Literal["constant"]
    velocity: Velocity = _VELOCITY
    blowing_from: Angle = _FROM
    speed: Annotated[float | None, Quantity("m/s")] = Field(
        default=None, description="how fast, with blowing_from"
    )

    @model_validator(mode="after")
    def _check(self) -> Constant:
        self.exactly_one("velocity", "blowing_from")
        if (self.blowing_from is None) != (self.speed is None):
            raise FieldError("blowing_from and speed go together")
        return self

    def wind(self, key: str, source: Source) -> Wind:
        values = self.given("type", "blowing_from")
        if self.blowing_from is None:
            return surroundings.ConstantWind(**values)
        return surroundings.ConstantWind.blowing_from(self.blowing_from, **values)


class WindTable(WindSection):
    """A wind by altitude, from the file itself or from a CSV file beside it."""

    type: Literal["table"]
    altitude: Annotated[Array | None, Quantity("m", (None,))] = Field(default=None, description="rising")
    velocity: Annotated[Array | None, Quantity("m/s", (None, 3))] = Field(
        default=None, description="a row of north, east, down for each altitude"
    )
    blowing_from: Annotated[Array | None, Quantity("rad", (None,))] = Field(
        default=None, description="instead: from where, for each altitude"
    )
    speed: Annotated[Array | None, Quantity("m/s", (None,))] = Field(
        default=None, description="how fast, with blowing_from"
    )
    csv: str | None = Field(default=None, description="path of a table instead, relative to the model file")

    @model_validator(mode="after")
    def _check(self) -> WindTable:
        self.exactly_one("altitude", "csv")
        self.exactly_one("velocity", "blowing_from", "csv")
        if (self.blowing_from is None) != (self.speed is None):
            raise FieldError("blowing_from and speed go together")
        return self

    def wind(self, key: str, source: Source) -> Wind:
        values = self.given("type", "csv")
        if self.csv is not None:
            units = {"altitude": "m", "north": "m/s", "east": "m/s", "down": "m/s"}
            units |= {"blowing_from": "rad", "speed": "m/s"}
            rows = read_columns(self.csv, f"{key}.csv", source, units, ("altitude",))
            if not rows.keys() >= {"blowing_from", "speed"} and rows.keys() & {"blowing_from", "speed"}:
                raise source.error(f"{key}.csv", "blowing_from and speed go together")
            zero = np.zeros_like(rows["altitude"])
            if "speed" not in rows:
                columns = [rows.pop(word, zero) for word in ("north", "east", "down")]
                rows["velocity"] = np.column_stack(columns)
            values |= rows
        if "speed" in values:
            direction = values.pop("blowing_from")
            return surroundings.WindTable.blowing_from(values.pop("altitude"), direction, **values)
        return surroundings.WindTable(**values)


class Shear(WindSection):
    """A wind that grows linearly with the altitude."""

    type: Literal["shear"]
    gradient: Annotated[Array, Quantity("1/s", (3,))] = Field(
        description="of the velocity towards which it blows: north, east, down"
    )
    velocity: Velocity = Field(default=None, description="at one altitude")
    altitude: Length = Field(default=None, description="which one; 0 when omitted")

    def wind(self, key: str, source: Source) -> Wind:
        return surroundings.WindShear(**self.given("type"))


class _BoundaryLayer(WindSection):
    """What winds near the ground share."""

    speed: Annotated[float, Quantity("m/s")] = Field(description="how fast, at the height")
    towards: Angle = Field(default=None, description="where it blows to, clockwise from north")
    blowing_from: Angle = _FROM
    height: Length = Field(default=None, description="above ground, at which the speed is known")
    ground: Length = _GROUND
    top: Length = _TOP

    @model_validator(mode="after")
    def _check_direction(self) -> _BoundaryLayer:
        self.exactly_one("towards", "blowing_from")
        return self

    def _values(self) -> dict[str, Any]:
        towards = self.towards if self.blowing_from is None else self.blowing_from + np.pi
        return self.given("type", "towards", "blowing_from") | {"direction": towards}


class LogWind(_BoundaryLayer):
    """The logarithmic wind profile near the ground."""

    type: Literal["log"]
    roughness: Length = Field(default=None, description="roughness length of the ground")

    def wind(self, key: str, source: Source) -> Wind:
        return surroundings.LogWind(**self._values())


class PowerLaw(_BoundaryLayer):
    """The power law of the wind near the ground."""

    type: Literal["power_law"]
    exponent: Annotated[float | None, Quantity("")] = Field(default=None, description="of the height")

    def wind(self, key: str, source: Source) -> Wind:
        return surroundings.PowerLawWind(**self._values())


_AERO_AXES = Annotated[
    Array | None,
    Quantity("", (3, 3)),
    Field(description="columns: forward, right and down in body axes, when those are others"),
]


class Gust(WindSection):
    """A 1-cosine gust, in time or on the way through the air."""

    type: Literal["gust"]
    velocity: Annotated[Array, Quantity("m/s", (3,))] = Field(description="its amplitude, in its axes")
    start_time: Annotated[float | None, Quantity("s")] = Field(default=None, description="when it begins")
    duration: Annotated[float | None, Quantity("s", positive=True)] = Field(
        default=None, description="how long it grows, with start_time"
    )
    start_distance: Length = Field(default=None, description="instead: after which way through the air")
    length: Annotated[float | None, Quantity("m", positive=True)] = Field(
        default=None, description="on which way it grows, with start_distance"
    )
    axes: Annotated[str | None, Choice("ned", "body")] = Field(
        default=None, description="north, east, down; or the body's"
    )
    body_from_aero: _AERO_AXES = None
    shape: Annotated[str | None, Choice("ramp", "pulse")] = Field(
        default=None, description="stays, or falls again"
    )

    @model_validator(mode="after")
    def _check(self) -> Gust:
        self.exactly_one("start_time", "start_distance")
        for start, extent in (("start_time", "duration"), ("start_distance", "length")):
            if (start in self.model_fields_set) != (extent in self.model_fields_set):
                raise FieldError(f"{start} and {extent} go together")
        return self

    def wind(self, key: str, source: Source) -> Wind:
        start = self.start_distance if self.start_time is None else self.start_time
        return surroundings.OneMinusCosineGust(
            **self.given("type", "start_time", "start_distance"),
            start=start,  # type: ignore[arg-type]
        )


class Dryden(WindSection):
    """Dryden turbulence: by `severity`, or by `sigma` and `length`; it needs the force `turbulence_path`."""

    type: Literal["dryden"]
    seed: int = Field(description="a whole number from which the gusts follow")
    span: Annotated[float, Quantity("m", positive=True)] = Field(description="of the wings")
    severity: Annotated[str | None, Choice(*SEVERITIES)] = Field(default=None, description="of MIL-F-8785C")
    height: Length = Field(default=None, description="above ground, held; that of the body when omitted")
    ground: Length = _GROUND
    wind_at_20_ft: Annotated[float | None, Quantity("m/s")] = Field(
        default=None, description="in place of that of the severity"
    )
    sigma: Velocity = Field(default=None, description="root mean squares of u, v, w")
    length: Annotated[Array | None, Quantity("m", (3,))] = Field(
        default=None, description="scale lengths of u, v, w, with sigma"
    )
    shortest: Length = Field(
        default=None, description="shorter waves are left out; half of the span when omitted"
    )
    harmonics: int | None = Field(default=None, ge=1, description="how many to a component")
    axes: Annotated[str | None, Choice("body", "level")] = Field(default=None, description="of u, v, w")
    body_from_aero: _AERO_AXES = None

    @model_validator(mode="after")
    def _check(self) -> Dryden:
        self.exactly_one("severity", "sigma")
        if (self.sigma is None) != (self.length is None):
            raise FieldError("sigma and length go together")
        for key in ("height", "ground", "wind_at_20_ft"):
            self.at_most_one("sigma", key)
        return self

    def wind(self, key: str, source: Source) -> Wind:
        make = surroundings.DrydenTurbulence
        values = self.given("type")
        return make(**values) if self.severity is None else make.specified(**values)


WINDS = (Constant, WindTable, Shear, LogWind, PowerLaw, Gust, Dryden)
AnyWind = Annotated[WindSection, OneOf("type", WINDS), BeforeValidator(word_as_table("wind", WINDS))]
"""`{ type = "constant", blowing_from = "270 deg", speed = "20 kt" }`."""
