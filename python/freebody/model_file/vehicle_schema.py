"""What moves: a body, or parts of one, with its forces and inputs."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, Field, PlainValidator, model_validator

from freebody._check import Array

from .context import ForceSection
from .dave_ml_schema import DaveBody
from .fields import OneOf, Quantity, Section
from .sections import SECTIONS
from .units import FieldError

__all__ = ["Body", "Inertia", "Vehicle"]

Point = Annotated[Array, Quantity("m", (3,))]
Moment = Annotated[float | None, Quantity("kg m^2")]


class Inertia(Section):
    """An inertia tensor: a 3 x 3 array, or a table of principal moments, or of named components."""

    tensor: Annotated[Array | None, Quantity("kg m^2", (3, 3))] = Field(
        default=None, description="the array itself"
    )
    principal: Annotated[Array | None, Quantity("kg m^2", (3,))] = Field(
        default=None, description="principal moments"
    )
    axes: Annotated[Array | None, Quantity("", (3, 3))] = Field(
        default=None, description="principal axes as columns, in body axes"
    )
    Ixx: Moment = Field(default=None, description="moment about the first axis")
    Iyy: Moment = Field(default=None, description="moment about the second axis")
    Izz: Moment = Field(default=None, description="moment about the third axis")
    Pxy: Moment = Field(default=None, description="product as a positive integral: + the integral of x y dm")
    Pxz: Moment = Field(default=None, description="+ the integral of x z dm")
    Pyz: Moment = Field(default=None, description="+ the integral of y z dm")

    @model_validator(mode="after")
    def _check(self) -> Inertia:
        keys = self.model_fields_set
        moments = {"Ixx", "Iyy", "Izz"}
        ways = (
            ({"tensor"}, set[str]()),
            ({"principal"}, {"axes"}),
            (moments, {"Pxy", "Pxz", "Pyz"}),
        )
        if not any(needed <= keys <= needed | allowed for needed, allowed in ways):
            raise FieldError(
                "needs a 3 x 3 array, { principal, axes } or { Ixx, Iyy, Izz, Pxy, Pxz, Pyz }; "
                f"came {', '.join(sorted(keys)) or 'nothing'}"
            )
        return self


def _array_as_table(value: Any) -> Any:
    return value if isinstance(value, dict) else {"tensor": value}


AnyInertia = Annotated[Inertia, BeforeValidator(_array_as_table)]


class Body(Section):
    """[body], or one of [[parts]] rigidly joined: all vectors from the origin o1, in body axes."""

    name: str | None = Field(default=None, description="how messages name it")
    mass: Annotated[float, Quantity("kg")] = Field(description="the mass")
    com: Point | None = Field(default=None, description="the mass centre")
    inertia_about_com: AnyInertia | None = Field(
        default=None, description="the inertia about the mass centre"
    )
    inertia_about_origin: AnyInertia | None = Field(
        default=None, description="the inertia about the origin o1"
    )

    @model_validator(mode="after")
    def _check(self) -> Body:
        self.exactly_one("inertia_about_com", "inertia_about_origin")
        return self


def _body(value: Any) -> Any:
    """A body that is given by a DAVE-ML file, or by its numbers."""
    kind = DaveBody if isinstance(value, dict) and "file" in value else Body
    return kind.model_validate(value)


class Vehicle(Section):
    """A body, what acts on it and what it reads."""

    body: Annotated[Body | DaveBody | None, PlainValidator(_body)] = Field(
        default=None, description="the body"
    )
    parts: list[Body] | None = Field(
        default=None, description="bodies that are rigidly joined into one, same frame"
    )
    forces: list[Annotated[ForceSection, OneOf("type", SECTIONS)]] = Field(
        default_factory=list, description="what acts on the body"
    )
    inputs: dict[str, Any] = Field(
        default_factory=dict, description="numbers, or tables over time, that the model reads"
    )

    @model_validator(mode="after")
    def _check_body(self) -> Vehicle:
        self.exactly_one("body", "parts")
        if self.parts == []:
            raise FieldError("needs at least one part", ("parts",))
        return self
