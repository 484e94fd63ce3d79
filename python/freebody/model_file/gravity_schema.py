"""The keys of gravity by spherical harmonics."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from freebody._check import Array
from freebody.elements import HarmonicGravity
from freebody.errors import InputError

from .context import Context, ForceSection
from .fields import Quantity

__all__ = ["SECTIONS"]


class Harmonics(ForceSection):
    """The attraction of a planet by spherical harmonics from a coefficient file."""

    type: Literal["harmonic_gravity"]
    name: str | None = Field(default=None, description="how messages name this force")
    file: str = Field(description="path of the coefficients, .gfc or .csv, relative to the model file")
    degree: int | None = Field(default=None, description="the highest degree taken; all, when left out")
    mu: Annotated[float | None, Quantity("m^3/s^2", positive=True)] = Field(
        default=None, description="the gravitational parameter G M; that of the file, when left out"
    )
    radius: Annotated[float | None, Quantity("m", positive=True)] = Field(
        default=None, description="the reference radius; that of the file, when left out"
    )
    center: Annotated[Array | None, Quantity("m", (3,))] = Field(
        default=None, description="of the planet, world axes"
    )
    rotation_rate: Annotated[float | None, Quantity("rad/s")] = Field(
        default=None, description="of the planet about the third world axis"
    )
    angle: Annotated[float | None, Quantity("rad")] = Field(
        default=None, description="from the first world axis to the planet's own at time zero"
    )
    gradient_torque: bool | None = Field(
        default=None, description="whether the field's gradient turns the body"
    )

    def element(self, context: Context) -> HarmonicGravity:
        path = context.source.path.parent / self.file
        try:
            return HarmonicGravity.from_file(path, **self.given("type", "file"))
        except InputError as error:
            raise context.source.error(f"{context.key}.file", str(error)) from None


SECTIONS: tuple[type[ForceSection], ...] = (Harmonics,)
