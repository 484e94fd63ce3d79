"""The medium of [environment]: air or water."""

from __future__ import annotations

from abc import abstractmethod
from typing import Annotated, Literal

from pydantic import BeforeValidator, Field, model_validator

from freebody import environment as surroundings
from freebody._check import Array
from freebody.environment import Atmosphere
from freebody.vehicles import f16

from .csv_table import read_columns
from .fields import Choice, OneOf, Quantity, Section
from .problems import Source
from .words import word_as_table

__all__ = ["AnyAtmosphere", "AtmosphereSection"]

Rows = tuple[int | None]
_FACTOR = Field(default=None, description="multiplies the density")
_NAME = Field(default=None, description="the word before the names of its parameters")
Number = Annotated[float | None, Quantity("")]


class AtmosphereSection(Section):
    """One of the kinds of medium."""

    @abstractmethod
    def atmosphere(self, key: str, source: Source) -> Atmosphere:
        """The medium; `key` is where the section stands."""


class US76(AtmosphereSection):
    """The U.S. Standard Atmosphere 1976."""

    type: Literal["us76"]
    temperature_offset: Annotated[float | None, Quantity("K")] = Field(
        default=None, description="added to the temperature"
    )
    density_factor: Number = _FACTOR
    upper: bool | None = Field(default=None, description="whether there are tables above 86 km")
    name: str | None = _NAME

    def atmosphere(self, key: str, source: Source) -> Atmosphere:
        return surroundings.USStandard1976(**self.given("type"))


class Uniform(AtmosphereSection):
    """A medium that is the same everywhere."""

    type: Literal["uniform"]
    density: Annotated[float | None, Quantity("kg/m^3")] = Field(default=None, description="its density")
    pressure: Annotated[float | None, Quantity("Pa")] = Field(default=None, description="its pressure")
    temperature: Annotated[float | None, Quantity("K")] = Field(default=None, description="its temperature")
    speed_of_sound: Annotated[float | None, Quantity("m/s")] = Field(
        default=None, description="its speed of sound"
    )
    dynamic_viscosity: Annotated[float | None, Quantity("Pa s")] = Field(
        default=None, description="its viscosity"
    )
    density_factor: Number = _FACTOR
    name: str | None = _NAME

    def atmosphere(self, key: str, source: Source) -> Atmosphere:
        return surroundings.UniformAtmosphere(**self.given("type"))


class Water(AtmosphereSection):
    """Water of 15 degrees Celsius."""

    type: Literal["water"]
    kind: Annotated[str | None, Choice("sea", "fresh")] = Field(default=None, description="sea or fresh")
    density_factor: Number = _FACTOR

    def atmosphere(self, key: str, source: Source) -> Atmosphere:
        return surroundings.UniformAtmosphere.water(**self.given("type"))


class AtmosphereTable(AtmosphereSection):
    """A medium by altitude, from the file itself or from a CSV file beside it."""

    type: Literal["table"]
    altitude: Annotated[Array | None, Quantity("m", (None,))] = Field(default=None, description="rising")
    density: Annotated[Array | None, Quantity("kg/m^3", (None,))] = Field(
        default=None, description="one for each altitude; two of density, pressure, temperature are needed"
    )
    pressure: Annotated[Array | None, Quantity("Pa", (None,))] = Field(
        default=None, description="one for each altitude"
    )
    temperature: Annotated[Array | None, Quantity("K", (None,))] = Field(
        default=None, description="one for each altitude"
    )
    speed_of_sound: Annotated[Array | None, Quantity("m/s", (None,))] = Field(
        default=None, description="one for each altitude; by gamma, pressure and density when omitted"
    )
    dynamic_viscosity: Annotated[Array | None, Quantity("Pa s", (None,))] = Field(
        default=None, description="one for each altitude; that of air when omitted"
    )
    csv: str | None = Field(default=None, description="path of a table instead, relative to the model file")
    gas_constant: Annotated[float | None, Quantity("J/(kg K)")] = Field(
        default=None, description="R of p = ρ R T"
    )
    gamma: Number = Field(default=None, description="ratio of specific heats")
    density_factor: Number = _FACTOR
    name: str | None = _NAME

    @model_validator(mode="after")
    def _check(self) -> AtmosphereTable:
        self.exactly_one("altitude", "csv")
        for column in ("density", "pressure", "temperature", "speed_of_sound", "dynamic_viscosity"):
            self.at_most_one("csv", column)
        return self

    def atmosphere(self, key: str, source: Source) -> Atmosphere:
        values = self.given("type", "csv")
        if self.csv is not None:
            units = {"altitude": "m", "density": "kg/m^3", "pressure": "Pa", "temperature": "K"}
            units |= {"speed_of_sound": "m/s", "dynamic_viscosity": "Pa s"}
            values |= read_columns(self.csv, f"{key}.csv", source, units, ("altitude",))
        return surroundings.TabulatedAtmosphere(**values)


class StevensLewis(AtmosphereSection):
    """The atmosphere of the F-16 model of Stevens and Lewis."""

    type: Literal["stevens_lewis"]

    def atmosphere(self, key: str, source: Source) -> Atmosphere:
        return f16.StevensLewisAtmosphere()


ATMOSPHERES = (US76, Uniform, Water, AtmosphereTable, StevensLewis)
AnyAtmosphere = Annotated[
    AtmosphereSection, OneOf("type", ATMOSPHERES), BeforeValidator(word_as_table("atmosphere", ATMOSPHERES))
]
"""`"us76"`, or `{ type = "us76", temperature_offset = "10 K" }`."""
