"""The sections and keys of a model file (docs/model-file.md), as pydantic models."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator, Field, model_validator

from freebody._check import Array
from freebody.forms import SEQUENCES
from freebody.simulation.settings import FIXED_STEP, METHODS

from .dispersion_schema import AnyDistribution, EnsembleTable
from .fields import Choice, Quantity, Section
from .force_schema import AnyForce
from .units import FieldError

__all__ = ["AttitudeTable", "Body", "Header", "Inertia", "Initial", "ModelFile", "Output", "Simulation"]

Velocity = Annotated[Array | None, Quantity("m/s", (3,))]
AngularVelocity = Annotated[Array | None, Quantity("rad/s", (3,))]
Point = Annotated[Array, Quantity("m", (3,))]
Moment = Annotated[float | None, Quantity("kg m^2")]
Duration = Annotated[float | None, Quantity("s", positive=True)]
Tolerance = Annotated[float | None, Quantity("", positive=True)]


class Header(Section):
    """[model]: what the file is about."""

    name: str = Field(description="a short title")
    description: str = Field(default="", description="what happens, and why it is of interest")
    sources: list[str] = Field(default_factory=list, description="where the numbers come from")


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


class AttitudeTable(Section):
    """The attitude, world from body: angles of a sequence, or a quaternion, or a rotation matrix."""

    angles: Annotated[Array | None, Quantity("rad", (3,))] = Field(
        default=None, description="three angles, with"
    )
    sequence: Annotated[str | None, Choice(*SEQUENCES)] = Field(
        default=None, description="their intrinsic sequence"
    )
    quaternion: Annotated[Array | None, Quantity("", (4,))] = Field(default=None, description="w, x, y, z")
    rotation: Annotated[Array | None, Quantity("", (3, 3))] = Field(
        default=None, description="world from body"
    )

    @model_validator(mode="after")
    def _check(self) -> AttitudeTable:
        self.exactly_one("angles", "quaternion", "rotation")
        if (self.angles is None) != (self.sequence is None):
            raise FieldError('angles and their sequence go together: { angles = [...], sequence = "zyx" }')
        return self


class Initial(Section):
    """[initial]: the state at the start; what is left out is zero, the attitude the identity."""

    point: Annotated[str, Choice("origin", "com")] = Field(
        default="origin", description="the point whose position and velocity are given"
    )
    position: Annotated[Array | None, Quantity("m", (3,))] = Field(default=None, description="world axes")
    attitude: AttitudeTable | None = Field(default=None, description="world from body")
    velocity_body: Velocity = Field(default=None, description="of that point, body axes")
    velocity_world: Velocity = Field(default=None, description="of that point, world axes")
    angular_velocity_body: AngularVelocity = Field(default=None, description="body axes")
    angular_velocity_world: AngularVelocity = Field(default=None, description="world axes")

    @model_validator(mode="after")
    def _check(self) -> Initial:
        self.at_most_one("velocity_body", "velocity_world")
        self.at_most_one("angular_velocity_body", "angular_velocity_world")
        return self


class Simulation(Section):
    """[simulation]: the time span, the form of the equations, the method."""

    start: Annotated[float, Quantity("s")] = Field(default=0.0, description="time of the initial state")
    end: Annotated[float, Quantity("s")] = Field(description="time of the end")
    attitude: Annotated[str | None, Choice("quaternion", *SEQUENCES)] = Field(
        default=None, description="the attitude chart"
    )
    form: Annotated[str | None, Choice("quasi_velocity", "generalized")] = Field(
        default=None, description="the velocities in the state"
    )
    method: Annotated[str | None, Choice(*METHODS)] = Field(default=None, description="the integrator")
    rtol: Tolerance = Field(default=None, description="relative tolerance")
    atol: Tolerance = Field(default=None, description="absolute tolerance, SI units")
    step: Duration = Field(
        default=None, description="the step of rk4 and gauss6, the first step of the others"
    )
    max_steps: int | None = Field(default=None, ge=1, description="the run ends there at the latest")

    @model_validator(mode="after")
    def _check(self) -> Simulation:
        if self.end <= self.start:
            raise FieldError(f"end must be later than start; came {self.start:g} s to {self.end:g} s")
        if self.method in FIXED_STEP and self.step is None:
            raise FieldError(f'method = "{self.method}" needs a step')
        return self


class Output(Section):
    """[output]: what is kept of the run."""

    save_every: Duration = Field(default=None, description="time between two samples")
    save_at: Annotated[Array | None, Quantity("s", (None,))] = Field(
        default=None, description="the sample times"
    )
    points: dict[str, Point] = Field(
        default_factory=dict, description="material points, body axes, whose paths are kept"
    )
    format: Annotated[str, Choice("netcdf", "csv")] = Field(
        default="netcdf", description="the data file's format"
    )

    @model_validator(mode="after")
    def _check(self) -> Output:
        self.at_most_one("save_every", "save_at")
        for name in self.points:
            if not name.isidentifier():
                raise FieldError("the name of a point has letters, digits and _ only", ("points", name))
        return self


class ModelFile(Section):
    """A whole model file."""

    model: Header = Field(description="the table [model]")
    body: Body | None = Field(default=None, description="the body")
    parts: list[Body] | None = Field(
        default=None, description="bodies that are rigidly joined into one, same frame"
    )
    forces: list[AnyForce] = Field(default_factory=list, description="what acts on the body")
    initial: Initial = Field(default=Initial(), description="the initial state")
    simulation: Simulation = Field(description="the table [simulation]")
    output: Output = Field(default=Output(), description="what is kept of the run")
    dispersions: dict[str, AnyDistribution] = Field(
        default_factory=dict, description="how quantities differ between the runs of an ensemble"
    )
    ensemble: EnsembleTable = Field(default=EnsembleTable(), description="how many runs, and which")

    @model_validator(mode="after")
    def _check(self) -> ModelFile:
        self.exactly_one("body", "parts")
        if self.parts == []:
            raise FieldError("needs at least one part", ("parts",))
        start, end = self.simulation.start, self.simulation.end
        for section, times in (("output", self.output.save_at), ("ensemble", self.ensemble.save_at)):
            if times is not None and (times[0] < start or times[-1] > end or np.any(np.diff(times) <= 0)):
                raise FieldError(
                    f"the times must rise from {start:g} to {end:g} s at most", (section, "save_at")
                )
        return self
