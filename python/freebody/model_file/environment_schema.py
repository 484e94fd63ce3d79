"""[environment]: the planet, the medium, the wind."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from freebody._check import Array
from freebody.elements import TurbulencePath
from freebody.environment import Environment, Winds
from freebody.forces import Force

from .atmosphere_schema import AnyAtmosphere
from .context import Context, ForceSection
from .fields import Quantity, Section
from .planet_schema import AnyPlanet
from .problems import Source
from .wind_schema import AnyWind

__all__ = ["SECTIONS", "EnvironmentTable", "TurbulencePathSection", "build"]


def _one_as_list(value: Any) -> Any:
    return value if isinstance(value, list) else [value]


class EnvironmentTable(Section):
    """[environment]: what is left out is a flat Earth, air of one density, and calm."""

    planet: AnyPlanet | None = Field(default=None, description="the planet")
    atmosphere: AnyAtmosphere | None = Field(default=None, description="the air or the water")
    wind: Annotated[list[AnyWind], BeforeValidator(_one_as_list)] = Field(
        default_factory=list, description="a wind or a current, or several that are added"
    )


def build(section: EnvironmentTable, source: Source) -> Environment:
    """The environment; refusals name the key they stand at."""
    planet = atmosphere = None
    if section.planet is not None:
        with source.blame("environment.planet"):
            planet = section.planet.planet()
    if section.atmosphere is not None:
        with source.blame("environment.atmosphere"):
            atmosphere = section.atmosphere.atmosphere("environment.atmosphere", source)
    winds = []
    for i, part in enumerate(section.wind):
        key = f"environment.wind[{i}]" if isinstance(_given(source), list) else "environment.wind"
        with source.blame(key):
            winds.append(part.wind(key, source))
    with source.blame("environment.wind"):
        return Environment(
            planet, atmosphere, Winds(*winds) if len(winds) > 1 else winds[0] if winds else None
        )


def _given(source: Source) -> Any:
    return source.data.get("environment", {}).get("wind")


class TurbulencePathSection(ForceSection):
    """The way through the air, which turbulence and gusts on the way read."""

    type: Literal["turbulence_path"]
    name: str | None = Field(default=None, description="how messages name it")
    at: Annotated[Array | None, Quantity("m", (3,))] = Field(
        default=None, description="the point of the body whose way it is, from the origin o1, body axes"
    )

    def element(self, context: Context) -> Force:
        return TurbulencePath(context.environment, **self.given("type"))


SECTIONS = (TurbulencePathSection,)
