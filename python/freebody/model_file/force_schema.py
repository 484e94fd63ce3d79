"""The keys of [[forces]]: one section for each kind of force element."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from freebody import forces
from freebody._check import Array

from .context import Context, ForceSection
from .csv_table import read_wrench
from .fields import Choice, Quantity

__all__ = ["SECTIONS"]

Axes = Annotated[str, Choice("body", "world")]
Point = Annotated[Array, Quantity("m", (3,))]
Damping = Annotated[Array, Quantity("", (6,), (6, 6))]

_NAME = Field(default=None, description="how messages name this force")
_AXES = Field(default=None, description="axes of force and moment: body or world")
_AT = Field(default=None, description="point of application from the origin o1, body axes")


class UniformGravity(ForceSection):
    """The same acceleration everywhere, Konoplev (1.12)."""

    type: Literal["uniform_gravity"]
    name: str | None = _NAME
    acceleration: Annotated[float | None, Quantity("m/s^2")] = Field(default=None, description="its size")
    direction: Annotated[Array | None, Quantity("", (3,))] = Field(
        default=None, description="down, world axes"
    )

    def element(self, context: Context) -> forces.Force:
        return forces.UniformGravity(**self.given("type"))


class PointMassGravity(ForceSection):
    """The attraction of a point mass."""

    type: Literal["point_mass_gravity"]
    name: str | None = _NAME
    mu: Annotated[float, Quantity("m^3/s^2")] = Field(description="the gravitational parameter G M")
    center: Annotated[Array | None, Quantity("m", (3,))] = Field(
        default=None, description="where it is, world axes"
    )
    gradient_torque: bool | None = Field(
        default=None, description="whether the gravity gradient turns the body"
    )

    def element(self, context: Context) -> forces.Force:
        return forces.PointMassGravity(**self.given("type"))


class ConstantWrench(ForceSection):
    """A force and a moment, constant in the axes they are given in."""

    type: Literal["constant_wrench"]
    name: str | None = _NAME
    force: Annotated[Array | None, Quantity("N", (3,))] = Field(default=None, description="the force")
    moment: Annotated[Array | None, Quantity("N m", (3,))] = Field(default=None, description="the moment")
    axes: Axes | None = _AXES
    at: Point | None = _AT

    def element(self, context: Context) -> forces.Force:
        return forces.ConstantWrench(**self.given("type"))


class TabulatedWrench(ForceSection):
    """A force and a moment by time, from the file itself or from a CSV file beside it."""

    type: Literal["tabulated_wrench"]
    name: str | None = _NAME
    times: Annotated[Array | None, Quantity("s", (None,))] = Field(
        default=None, description="increasing times"
    )
    force: Annotated[Array | None, Quantity("N", (None, 3))] = Field(
        default=None, description="a row for each time"
    )
    moment: Annotated[Array | None, Quantity("N m", (None, 3))] = Field(
        default=None, description="a row for each time"
    )
    csv: str | None = Field(default=None, description="path of a table instead, relative to the model file")
    axes: Axes | None = _AXES
    at: Point | None = _AT
    interpolation: Annotated[str | None, Choice("linear", "hold")] = Field(
        default=None, description="between two times"
    )

    @model_validator(mode="after")
    def _check(self) -> TabulatedWrench:
        self.exactly_one("times", "csv")
        if self.csv is not None:
            self.at_most_one("csv", "force")
            self.at_most_one("csv", "moment")
        return self

    def element(self, context: Context) -> forces.Force:
        values = self.given("type", "csv")
        if self.csv is not None:
            values |= read_wrench(self.csv, f"{context.key}.csv", context.source)
        return forces.TabulatedWrench(**values)


class LinearDamping(ForceSection):
    """F = -D V."""

    type: Literal["linear_damping"]
    name: str | None = _NAME
    coefficients: Damping = Field(description="D in SI units, its diagonal or all of it, linear part first")

    def element(self, context: Context) -> forces.Force:
        return forces.LinearDamping(**self.given("type"))


class QuadraticDamping(ForceSection):
    """F = -D (|V| V)."""

    type: Literal["quadratic_damping"]
    name: str | None = _NAME
    coefficients: Damping = Field(description="D in SI units, its diagonal or all of it, linear part first")

    def element(self, context: Context) -> forces.Force:
        return forces.QuadraticDamping(**self.given("type"))


class InputWrench(ForceSection):
    """Six inputs, a force and a moment, that the caller of `simulate` gives."""

    type: Literal["input_wrench"]
    name: str | None = _NAME
    axes: Axes | None = _AXES
    at: Point | None = _AT

    def element(self, context: Context) -> forces.Force:
        return forces.InputWrench(**self.given("type"))


SECTIONS: tuple[type[ForceSection], ...] = (
    UniformGravity,
    PointMassGravity,
    ConstantWrench,
    TabulatedWrench,
    LinearDamping,
    QuadraticDamping,
    InputWrench,
)
