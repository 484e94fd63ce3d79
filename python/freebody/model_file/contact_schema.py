"""The keys of springs, tethers and contact in [[forces]]."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from freebody import elements, forces
from freebody._check import Array

from .context import Context, ForceSection
from .fields import Choice, Quantity
from .units import FieldError

__all__ = ["SECTIONS"]

Point = Annotated[Array, Quantity("m", (3,))]
Stiffness = Annotated[float, Quantity("N/m")]
Damping = Annotated[float | None, Quantity("N s/m")]
PositiveLength = Annotated[float | None, Quantity("m", positive=True)]

_NAME = Field(default=None, description="how messages name this force")
_END = Field(default=None, description="its end on the body, from o1, body axes")
_ANCHOR = Field(default=None, description="its end in the world, world axes, at rest")
_MOVING = Field(default=None, description="instead: a word, whose inputs say how that end moves")


class _Line(ForceSection):
    """What springs and tethers share."""

    name: str | None = _NAME
    at: Point | None = _END
    anchor: Point | None = _ANCHOR
    moving: str | None = _MOVING
    stiffness: Stiffness = Field(description="k")
    damping: Damping = Field(default=None, description="c")

    @model_validator(mode="after")
    def _check(self) -> _Line:
        self.at_most_one("anchor", "moving")
        return self

    def _ends(self) -> dict[str, Any]:
        moved = {} if self.moving is None else {"anchor": self.moving}
        return self.given("type", "moving") | moved


class Spring(_Line):
    """A spring and a damper in line."""

    type: Literal["spring"]
    length: Annotated[float | None, Quantity("m")] = Field(default=None, description="free of load")

    def element(self, context: Context) -> forces.Force:
        return elements.Spring(**self._ends())


class Tether(_Line):
    """A line that only pulls."""

    type: Literal["tether"]
    length: Annotated[float, Quantity("m", positive=True)] = Field(description="up to which it is slack")
    onset: PositiveLength = Field(default=None, description="over which its tension sets in")

    def element(self, context: Context) -> forces.Force:
        return elements.Tether(**self._ends())


class RotationalSpring(ForceSection):
    """A spring and a damper against turning."""

    type: Literal["rotational_spring"]
    name: str | None = _NAME
    stiffness: Annotated[Array | float, Quantity("N m/rad", (), (3,), (3, 3))] = Field(
        description="in the body axes"
    )
    attitude: Annotated[Array | None, Quantity("", (3, 3))] = Field(
        default=None, description="world from body at rest, a rotation matrix"
    )
    damping: Annotated[Array | float | None, Quantity("N m s/rad", (), (3,), (3, 3))] = Field(
        default=None, description="by the angular velocity"
    )

    def element(self, context: Context) -> forces.Force:
        return elements.RotationalSpring(**self.given("type"))


class Contact(ForceSection):
    """Points of the body that meet a plane."""

    type: Literal["contact"]
    name: str | None = _NAME
    points: Annotated[Array, Quantity("m", (3,), (None, 3))] = Field(description="from o1, body axes")
    stiffness: Annotated[float, Quantity("N/m", positive=True)] = Field(description="of each point")
    surface: Annotated[str, Choice("plane", "ground")] = Field(
        default="plane", description="a plane in the world, or the level ground of the planet"
    )
    through: Point | None = Field(default=None, description="a point of the plane, world axes")
    normal: Annotated[Array | None, Quantity("", (3,))] = Field(
        default=None, description="out of the plane, world axes"
    )
    velocity: Annotated[Array | None, Quantity("m/s", (3,))] = Field(
        default=None, description="of the plane, world axes"
    )
    moving: str | None = Field(default=None, description="a word: <word>_height and <word>_speed are inputs")
    altitude: Annotated[float | None, Quantity("m")] = Field(default=None, description="of the ground")
    damping: Annotated[float | None, Quantity("s/m")] = Field(default=None, description="Hunt and Crossley's")
    friction: Annotated[float | None, Quantity("")] = Field(default=None, description="Coulomb's coefficient")
    onset: PositiveLength = Field(default=None, description="depth over which the force sets in")
    slip_speed: Annotated[float | None, Quantity("m/s", positive=True)] = Field(
        default=None, description="speed over which friction sets in"
    )

    @model_validator(mode="after")
    def _check(self) -> Contact:
        plane = {"through", "normal", "velocity", "moving"}
        other = {"altitude"} if self.surface == "plane" else plane
        for key in sorted(other & self.model_fields_set):
            raise FieldError(f'is not for surface = "{self.surface}"', (key,))
        return self

    def element(self, context: Context) -> forces.Force:
        values = self.given("type", "surface")
        if self.surface == "ground":
            return elements.Contact.on_ground(context.environment, **values)
        return elements.Contact(**values)


SECTIONS: tuple[type[ForceSection], ...] = (Contact, RotationalSpring, Spring, Tether)
