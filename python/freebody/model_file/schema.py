"""The sections and keys of a model file (docs/model-file.md), as pydantic models."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import Field, model_validator

from freebody._check import Array
from freebody.forms import SEQUENCES
from freebody.simulation.settings import FIXED_STEP, METHODS

from .attitude_schema import AttitudeTable
from .dispersion_schema import AnyDistribution, EnsembleTable
from .environment_schema import EnvironmentTable
from .event_schema import Crossing, EventTable
from .fields import Choice, Quantity, Section
from .planet_schema import StartOnPlanet, TrackTable
from .stage_schema import StageTable
from .units import FieldError
from .vehicle_schema import Vehicle

__all__ = ["Header", "Initial", "ModelFile", "Output", "Simulation"]

Velocity = Annotated[Array | None, Quantity("m/s", (3,))]
AngularVelocity = Annotated[Array | None, Quantity("rad/s", (3,))]
Point = Annotated[Array, Quantity("m", (3,))]
Duration = Annotated[float | None, Quantity("s", positive=True)]
Tolerance = Annotated[float | None, Quantity("", positive=True)]


class Header(Section):
    """[model]: what the file is about."""

    name: str = Field(description="a short title")
    description: str = Field(default="", description="what happens, and why it is of interest")
    sources: list[str] = Field(default_factory=list, description="where the numbers come from")


class Initial(StartOnPlanet):
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
    states: dict[str, Any] = Field(
        default_factory=dict, description="auxiliary states by name, force.state = value"
    )

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
    tracks: dict[str, TrackTable] = Field(
        default_factory=dict, description="points of the body as seen from the planet"
    )
    format: Annotated[str, Choice("netcdf", "csv")] = Field(
        default="netcdf", description="the data file's format"
    )

    @model_validator(mode="after")
    def _check(self) -> Output:
        self.at_most_one("save_every", "save_at")
        for what, names in (("point", self.points), ("track", self.tracks)):
            for name in names:
                if not name.isidentifier():
                    raise FieldError(
                        f"the name of a {what} has letters, digits and _ only", (f"{what}s", name)
                    )
        return self


class ModelFile(Vehicle):
    """A whole model file."""

    model: Header = Field(description="the table [model]")
    environment: EnvironmentTable = Field(
        default=EnvironmentTable(), description="the planet, the air or water, the wind"
    )
    stages: list[StageTable] = Field(
        default_factory=list, description="the bodies that go on, one after another"
    )
    events: list[EventTable] = Field(
        default_factory=list, description="what is recorded when it happens, or ends the run"
    )
    initial: Initial = Field(default=Initial(), description="the initial state")
    simulation: Simulation = Field(description="the table [simulation]")
    output: Output = Field(default=Output(), description="what is kept of the run")
    dispersions: dict[str, AnyDistribution] = Field(
        default_factory=dict, description="how quantities differ between the runs of an ensemble"
    )
    ensemble: EnsembleTable = Field(default=EnsembleTable(), description="how many runs, and which")

    @model_validator(mode="after")
    def _check(self) -> ModelFile:
        self._check_stages()
        start, end = self.simulation.start, self.simulation.end
        for section, times in (("output", self.output.save_at), ("ensemble", self.ensemble.save_at)):
            if times is not None and (times[0] < start or times[-1] > end or np.any(np.diff(times) <= 0)):
                raise FieldError(
                    f"the times must rise from {start:g} to {end:g} s at most", (section, "save_at")
                )
        return self

    def _check_stages(self) -> None:
        start, end = self.simulation.start, self.simulation.end
        before = start
        for i, stage in enumerate(self.stages):
            if isinstance(stage.begins, Crossing):
                continue
            if not before < stage.begins < end:
                raise FieldError(
                    f"must come after {before:g} s and before the end, {end:g} s; came {stage.begins:g} s",
                    ("stages", i, "begins"),
                )
            before = stage.begins
        names = set[str]()
        for key, sections in (("stages", self.stages), ("events", self.events)):
            for i, section in enumerate(sections):
                if section.name in names:
                    raise FieldError(f"the name {section.name!r} stands twice", (key, i, "name"))
                names.add(section.name)
