"""The keys of [[stages]]: what goes on when the body before has had its time."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, PlainValidator

from freebody._check import Array

from .attitude_schema import AttitudeTable
from .event_schema import Crossing
from .fields import Quantity
from .vehicle_schema import Vehicle

__all__ = ["StageTable"]


def _begins(value: Any) -> Any:
    return Crossing.model_validate(value) if isinstance(value, dict) else Quantity("s").read(value)


class StageTable(Vehicle):
    """A vehicle that takes over the motion of the one before."""

    name: str = Field(description="how the outcome and the data name it")
    begins: Annotated[float | Crossing, PlainValidator(_begins)] = Field(
        description='a time, or what the stage before crosses, { signal = "fuel_mass", below = "2 kg" }'
    )
    origin: Annotated[Array | None, Quantity("m", (3,))] = Field(
        default=None, description="its origin, from that of the body before in the axes of that body"
    )
    rotation: AttitudeTable | None = Field(
        default=None, description="its axes in the body before, as an attitude relative to that body"
    )
    velocity_increment: Annotated[Array | None, Quantity("m/s", (3,))] = Field(
        default=None, description="what the separation gives its origin, its own body axes"
    )
    angular_velocity_increment: Annotated[Array | None, Quantity("rad/s", (3,))] = Field(
        default=None, description="likewise"
    )
    states: dict[str, Any] = Field(
        default_factory=dict, description="auxiliary states at its start, force.state = value"
    )
