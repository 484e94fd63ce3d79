"""The keys of the forces of air: aerodynamics from coefficients, drag, and the engine of the F-16."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field

from freebody._check import Array
from freebody.elements import Aerodynamics, Drag
from freebody.forces import Force
from freebody.tables import Table
from freebody.vehicles import f16

from .coefficients import read_all, read_slope
from .context import Context, ForceSection
from .fields import Choice, Quantity

__all__ = ["SECTIONS"]

Point = Annotated[Array | None, Quantity("m", (3,))]

_NAME = Field(default=None, description="how messages name this force, and dispersions its parameters")


class AerodynamicsSection(ForceSection):
    """Forces and moments from coefficients."""

    type: Literal["aerodynamics"]
    name: str | None = _NAME
    reference_area: Annotated[float, Quantity("m^2", positive=True)] = Field(description="S")
    span: Annotated[float, Quantity("m", positive=True)] = Field(description="b, the length of Cl and Cn")
    chord: Annotated[float, Quantity("m", positive=True)] = Field(description="c, the length of Cm")
    coefficients: dict[str, Any] = Field(description="by name: numbers, tables, derivatives")
    reference_point: Point = Field(default=None, description="where force and moment are given, body axes")
    flow_point: Point = Field(
        default=None, description="whose velocity counts; the reference point by default"
    )
    body_from_aero: Annotated[Array | None, Quantity("", (3, 3))] = Field(
        default=None, description="columns: forward, right and down in body axes"
    )
    axes: Annotated[str | None, Choice("body", "stability", "wind")] = Field(
        default=None, description="of the force coefficients"
    )
    controls: dict[str, str] = Field(default_factory=dict, description="inputs by name, with their units")

    def element(self, context: Context) -> Force:
        given = self.given("type", "coefficients")
        read = read_all(self.coefficients, self.controls, f"{context.key}.coefficients", context.source)
        return Aerodynamics(context.environment, coefficients=read, **given)


class DragSection(ForceSection):
    """Drag against the velocity relative to the medium."""

    type: Literal["drag"]
    name: str | None = _NAME
    area: Annotated[float, Quantity("m^2", positive=True)] = Field(description="A")
    coefficient: Any = Field(description="C_D: a number, or a table of mach")
    at: Point = Field(default=None, description="where it acts, body axes from the origin")

    def element(self, context: Context) -> Force:
        key = f"{context.key}.coefficient"
        slope = read_slope(self.coefficient, "", {}, key, context.source)
        if not isinstance(slope, float):
            if isinstance(slope, list) or slope.of != ("mach",):
                raise context.source.error(key, 'needs a number, or one table with of = ["mach"]')
            if slope.extrapolate:
                raise context.source.error(key, "a table of drag does not go on beyond its samples")
            slope = slope.table
        assert isinstance(slope, float | Table)
        return Drag(context.environment, coefficient=slope, **self.given("type", "coefficient"))


class F16Engine(ForceSection):
    """The engine of the F-16 of Stevens and Lewis: input throttle, state power."""

    type: Literal["f16_engine"]
    name: str | None = _NAME
    xcg: Annotated[float | None, Quantity("")] = Field(
        default=None, description="mass centre in chords behind the leading edge; 0.35 by default"
    )

    def element(self, context: Context) -> Force:
        return f16.Engine(context.environment, **self.given("type"))


SECTIONS: tuple[type[ForceSection], ...] = (AerodynamicsSection, DragSection, F16Engine)
