"""The keys of a force, and of a body, that a DAVE-ML file gives."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field

from freebody._check import Array
from freebody.body import RigidBody
from freebody.dave_ml import DaveAerodynamics, DaveModel, load_dave_ml
from freebody.errors import ModelFileError

from .context import Context, ForceSection
from .fields import Choice, Quantity, Section
from .problems import Source

__all__ = ["SECTIONS", "DaveBody", "DaveMl"]

Point = Annotated[Array | None, Quantity("m", (3,))]
Rotation = Annotated[Array | None, Quantity("", (3, 3))]
Length = Annotated[float | None, Quantity("m", positive=True)]


class DaveMl(ForceSection):
    """Aerodynamics, or thrust, of a DAVE-ML file (ANSI/AIAA S-119)."""

    type: Literal["dave_ml"]
    name: str | None = Field(default=None, description="how messages name this force")
    file: str = Field(description="path of the DAVE-ML file, relative to the model file")
    mapping: dict[str, str | float] | None = Field(
        default=None,
        description="variable of the file = standard name, number to hold it at, or name of an input",
    )
    leave_out: list[str] | None = Field(default=None, description="results of the file that are not used")
    reference_point: Point = Field(
        default=None, description="the file's moment reference point from the origin o1, body axes"
    )
    flow_point: Point = Field(
        default=None, description="the point whose motion makes airspeed and angles, body axes"
    )
    body_from_aero: Rotation = Field(
        default=None, description="its columns are forward, right and down of the file, in body axes"
    )
    lift_drag_axes: Annotated[str | None, Choice("wind", "stability")] = Field(
        default=None, description="of the coefficients of lift and drag"
    )
    reference_area: Annotated[float | None, Quantity("m^2", positive=True)] = Field(
        default=None, description="where the file has none, or another"
    )
    reference_span: Length = Field(default=None, description="likewise")
    reference_chord: Length = Field(default=None, description="likewise")
    constants: list[str] | None = Field(
        default=None, description="constants of the file that become parameters, to be dispersed"
    )

    def element(self, context: Context) -> DaveAerodynamics:
        model = _read(self.file, context.source, f"{context.key}.file")
        given = self.given("type", "file", "mapping", "leave_out")
        mapping: dict[str, Any] = {**(self.mapping or {}), **dict.fromkeys(self.leave_out or ())}
        return DaveAerodynamics(context.environment, model, mapping, **given)


class DaveBody(Section):
    """A body whose mass properties a DAVE-ML file gives."""

    name: str | None = Field(default=None, description="how messages name it")
    file: str = Field(description="path of the DAVE-ML file, relative to the model file")
    values: dict[str, float] | None = Field(
        default=None, description="inputs of the file = value, in its units"
    )
    reference_point: Point = Field(
        default=None, description="where the file counts the mass centre from, from the origin o1, body axes"
    )
    body_from_model: Rotation = Field(
        default=None, description="its columns are forward, right and down of the file, in body axes"
    )

    def body(self, source: Source, key: str) -> RigidBody:
        """The body; `key` is where the section stands."""
        model = _read(self.file, source, f"{key}.file")
        with source.blame(key):
            return model.rigid_body(self.values, **self.given("file", "values"))


def _read(name: str, source: Source, key: str) -> DaveModel:
    path = source.path.parent / name
    if not path.is_file():
        raise source.error(key, f"there is no file {path}")
    try:
        return load_dave_ml(path)
    except ModelFileError as error:
        raise source.error(key, str(error)) from error


SECTIONS: tuple[type[ForceSection], ...] = (DaveMl,)
