"""The keys of water in [[forces]]: added mass, damping, drag, buoyancy, fins."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from freebody import elements, forces
from freebody._check import Array

from .context import Context, ForceSection
from .fields import Quantity, Section
from .propulsion_schema import Told
from .units import FieldError

__all__ = ["SECTIONS"]

Point = Annotated[Array, Quantity("m", (3,))]
Direction = Annotated[Array, Quantity("", (3,))]
Axes = Annotated[Array | None, Quantity("", (3, 3))]
Matrix = Annotated[Array | None, Quantity("", (6,), (6, 6))]
Profile = Annotated[Array | float, Quantity("m", (), (None,))]
Length = Annotated[float, Quantity("m", positive=True)]
Number = Annotated[float, Quantity("")]
Density = Annotated[float | None, Quantity("kg/m^3", positive=True)]

_NAME = Field(default=None, description="how messages name this force")
_AT = Field(default=None, description="the point it is about, from the origin o1, body axes")
_AXES = Field(default=None, description="its own axes as columns, in body axes")
_DENSITY = Field(default=None, description="of the water, instead of the environment's")


class SpheroidTable(Section):
    """The added mass of a prolate spheroid."""

    semi_major: Length = Field(description="along its first axis")
    semi_minor: Length = Field(description="across")
    roll: Annotated[float | None, Quantity("kg m^2")] = Field(
        default=None, description="added moment about the long axis"
    )
    density: Density = _DENSITY


class CylinderTable(Section):
    """The added mass of a slender cylinder, by strips."""

    length: Length = Field(description="along its first axis")
    radius: Length = Field(description="its radius")
    axial: Annotated[float | None, Quantity("kg")] = Field(default=None, description="along its axis")
    roll: Annotated[float | None, Quantity("kg m^2")] = Field(default=None, description="about its axis")
    density: Density = _DENSITY


class DerivativesTable(Section):
    """Hydrodynamic derivatives of acceleration, none positive."""

    X_udot: Annotated[float, Quantity("kg")] = Field(default=0.0, description="surge")
    Y_vdot: Annotated[float, Quantity("kg")] = Field(default=0.0, description="sway")
    Z_wdot: Annotated[float, Quantity("kg")] = Field(default=0.0, description="heave")
    K_pdot: Annotated[float, Quantity("kg m^2")] = Field(default=0.0, description="roll")
    M_qdot: Annotated[float, Quantity("kg m^2")] = Field(default=0.0, description="pitch")
    N_rdot: Annotated[float, Quantity("kg m^2")] = Field(default=0.0, description="yaw")


class AddedMass(ForceSection):
    """The water that the body sets in motion."""

    type: Literal["added_mass"]
    name: str | None = _NAME
    matrix: Matrix = Field(default=None, description="M_A in SI units, its diagonal or all of it")
    derivatives: DerivativesTable | None = Field(default=None, description="the negatives of its diagonal")
    spheroid: SpheroidTable | None = Field(default=None, description="of a prolate spheroid")
    cylinder: CylinderTable | None = Field(default=None, description="of a slender cylinder")
    at: Point | None = _AT
    axes: Axes = _AXES

    @model_validator(mode="after")
    def _check(self) -> AddedMass:
        self.exactly_one("matrix", "derivatives", "spheroid", "cylinder")
        return self

    def element(self, context: Context) -> forces.Force:
        seat = self.given("type", "matrix", "derivatives", "spheroid", "cylinder")
        kind = elements.AddedMass
        ways = (
            ("derivatives", kind.from_derivatives, self.derivatives),
            ("spheroid", kind.spheroid, self.spheroid),
            ("cylinder", kind.cylinder, self.cylinder),
        )
        for key, make, table in ways:
            if table is not None:
                with context.source.blame(f"{context.key}.{key}"):
                    return make(context.environment, **table.given(), **seat)
        assert self.matrix is not None
        return kind(context.environment, self.matrix, **seat)


class HydrodynamicDamping(ForceSection):
    """Linear and quadratic damping relative to the water."""

    type: Literal["hydrodynamic_damping"]
    name: str | None = _NAME
    linear: Matrix = Field(default=None, description="D in SI units, its diagonal or all of it")
    quadratic: Matrix = Field(default=None, description="D_q, likewise")
    at: Point | None = _AT
    axes: Axes = _AXES

    @model_validator(mode="after")
    def _check(self) -> HydrodynamicDamping:
        if self.linear is None and self.quadratic is None:
            raise FieldError("needs linear, quadratic or both")
        return self

    def element(self, context: Context) -> forces.Force:
        return elements.HydrodynamicDamping(context.environment, **self.given("type"))


class CrossFlowDrag(ForceSection):
    """Drag across a slender body, by strips."""

    type: Literal["cross_flow_drag"]
    name: str | None = _NAME
    length: Length = Field(description="along its first axis, `at` in the middle")
    height: Profile = Field(description="shown to sway: a number, or values from stern to bow")
    breadth: Profile | None = Field(default=None, description="shown to heave; the height when omitted")
    drag_coefficient: Number | None = Field(default=None, description="C_d of the strips")
    strips: int | None = Field(default=None, ge=1, description="how many")
    at: Point | None = _AT
    axes: Axes = _AXES

    def element(self, context: Context) -> forces.Force:
        return elements.CrossFlowDrag(context.environment, **self.given("type"))


class HullLiftDrag(ForceSection):
    """Lift and drag of a hull of revolution."""

    type: Literal["hull_lift_drag"]
    name: str | None = _NAME
    area: Annotated[float, Quantity("m^2", positive=True)] = Field(description="that coefficients are of")
    drag_coefficient: Number = Field(description="C_D0, without lift")
    lift_slope: Number | None = Field(default=None, description="C_Lalpha, 1/rad")
    induced_drag: Number | None = Field(default=None, description="k of C_D = C_D0 + k C_L^2")
    at: Point | None = _AT
    axes: Axes = _AXES

    def element(self, context: Context) -> forces.Force:
        return elements.HullLiftDrag(context.environment, **self.given("type"))


class Buoyancy(ForceSection):
    """Buoyancy of a body that is under water."""

    type: Literal["buoyancy"]
    name: str | None = _NAME
    volume: Annotated[float | None, Quantity("m^3", positive=True)] = Field(
        default=None, description="displaced; that of the body's own mass of water when omitted"
    )
    at: Point | None = Field(default=None, description="the centre of buoyancy, from o1, body axes")

    def element(self, context: Context) -> forces.Force:
        env = context.environment
        neutral = context.body.mass / env.atmosphere.at(0.0).density
        return elements.Buoyancy(env, **{"volume": neutral, **self.given("type")})


class Flotation(ForceSection):
    """Buoyancy of a hull that floats."""

    type: Literal["flotation"]
    name: str | None = _NAME
    volume: Annotated[float | None, Quantity("m^3", positive=True)] = Field(
        default=None, description="displaced at rest; that of the body's own mass of water when omitted"
    )
    center: Point = Field(description="the centre of that volume, from o1, body axes")
    waterplane_area: Annotated[float, Quantity("m^2", positive=True)] = Field(description="A")
    moments: Annotated[Array | None, Quantity("m^4", (2,))] = Field(
        default=None, description="I_T and I_L of the waterplane"
    )
    metacentric_heights: Annotated[Array | None, Quantity("m", (2,))] = Field(
        default=None, description="GM_T and GM_L, instead"
    )
    at: Point | None = Field(default=None, description="the centroid of the waterplane, from o1, body axes")
    axes: Axes = Field(default=None, description="forward, starboard, down as columns, in body axes")

    @model_validator(mode="after")
    def _check(self) -> Flotation:
        self.exactly_one("moments", "metacentric_heights")
        return self

    def element(self, context: Context) -> forces.Force:
        env, body = context.environment, context.body
        values: dict[str, Any] = {"volume": body.mass / env.atmosphere.at(0.0).density}
        values |= self.given("type", "moments", "metacentric_heights")
        if self.moments is not None:
            across, along = (float(m) for m in self.moments)
            return elements.Flotation(env, transverse_moment=across, longitudinal_moment=along, **values)
        assert self.metacentric_heights is not None
        across, along = (float(h) for h in self.metacentric_heights)
        make = elements.Flotation.from_metacentric_heights
        return make(env, com=body.com, transverse=across, longitudinal=along, **values)


class Fin(ForceSection):
    """A fin or a rudder."""

    type: Literal["fin"]
    name: str | None = _NAME
    area: Annotated[float, Quantity("m^2", positive=True)] = Field(description="planform")
    at: Point = Field(description="its centre of pressure, from o1, body axes")
    span: Direction = Field(description="out along the fin, body axes; the angle turns about it")
    chord: Direction | None = Field(default=None, description="forward; the first body axis when omitted")
    angle: Annotated[str | float | None, Told("rad")] = Field(
        default=None, description="the name of its input, or a number"
    )
    aspect_ratio: Annotated[float | None, Quantity("", positive=True)] = Field(
        default=None, description="gives the slope of lift and the induced drag"
    )
    slope: Number | None = Field(default=None, description="of lift, 1/rad, instead")
    drag_coefficient: Number | None = Field(default=None, description="C_D0")
    stall: Annotated[float | None, Quantity("rad", positive=True)] = Field(
        default=None, description="angle at which lift no longer grows"
    )

    def element(self, context: Context) -> forces.Force:
        return elements.Fin(context.environment, **self.given("type"))


SECTIONS: tuple[type[ForceSection], ...] = (
    AddedMass,
    Buoyancy,
    CrossFlowDrag,
    Fin,
    Flotation,
    HullLiftDrag,
    HydrodynamicDamping,
)
