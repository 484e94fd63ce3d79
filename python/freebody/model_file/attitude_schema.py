"""Attitudes, as files write them."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, model_validator

from freebody._check import Array
from freebody.attitude import Attitude
from freebody.forms import SEQUENCES

from .fields import Choice, Quantity, Section
from .units import FieldError

__all__ = ["AttitudeTable"]


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

    def attitude(self) -> Attitude:
        """The attitude."""
        if self.quaternion is not None:
            return Attitude.quaternion(self.quaternion)
        if self.rotation is not None:
            return Attitude.rotation(self.rotation)
        assert self.angles is not None
        assert self.sequence is not None
        return Attitude.angles(self.sequence, self.angles)
