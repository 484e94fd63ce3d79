"""The keys of propulsion in [[forces]]: actuators, thrusters and tanks, propellers, wheels."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, Field, model_validator

from freebody import elements, forces
from freebody._check import Array
from freebody.tables import Table

from .context import Context, ForceSection
from .fields import Choice, Quantity, Section
from .units import FieldError, to_si

__all__ = ["SECTIONS"]

Point = Annotated[Array, Quantity("m", (3,))]
Direction = Annotated[Array, Quantity("", (3,))]
Number = Annotated[float, Quantity("")]
Seconds = Annotated[float | None, Quantity("s", positive=True)]
Tensors = Annotated[Array | None, Quantity("kg m^2", (3,), (3, 3), (None, 3), (None, 3, 3))]

_NAME = Field(default=None, description="how messages name this force")
_WORD = Field(default=None, description="a word: how messages, states and signals name it")


class Told(Quantity):
    """A word, the name of an input; or a number."""

    def read(self, value: Any) -> Any:
        return value if isinstance(value, str) and value.isidentifier() else super().read(value)


class Actuator(ForceSection):
    """What is commanded comes late, and not beyond the stops."""

    type: Literal["actuator"]
    name: str | None = _NAME
    signal: str = Field(description="the name that other forces read")
    unit: str | None = Field(default=None, description="of the signal, SI")
    time_constant: Seconds = Field(default=None, description="of an actuator of the first order")
    natural_frequency: Annotated[float | None, Quantity("rad/s", positive=True)] = Field(
        default=None, description="of one of the second order"
    )
    damping: Number | None = Field(default=None, description="its damping ratio")
    limits: Any = Field(default=None, description="two stops, in units of the signal")
    rate_limit: Any = Field(default=None, description="the largest speed, units of the signal a second")
    command: Any = Field(default=None, description="the input that commands it, or a number")
    initial: Any = Field(default=None, description="where it starts")

    @model_validator(mode="after")
    def _check(self) -> Actuator:
        self.exactly_one("time_constant", "natural_frequency")
        self._in_unit()
        return self

    def _in_unit(self) -> dict[str, Any]:
        unit = "rad" if self.unit is None else self.unit
        plain = "" if unit == "1" else unit
        found: dict[str, Any] = {}
        for key, of, *shape in (
            ("limits", plain, (2,)),
            ("rate_limit", f"{unit}/s"),
            ("command", plain),
            ("initial", plain),
        ):
            value = getattr(self, key)
            if value is None:
                continue
            try:
                kind = Told(of, *shape) if key == "command" else Quantity(of, *shape)
                found[key] = kind.read(value)
            except FieldError as error:
                raise FieldError(str(error), (key, *error.at)) from None
        return found

    def element(self, context: Context) -> forces.Force:
        own = self.given("type", "limits", "rate_limit", "command", "initial")
        return elements.Actuator(**own, **self._in_unit())


class GimbalTable(Section):
    """One hinge of a thruster."""

    angle: Annotated[str | float, Told("rad")] = Field(description="an input, or a number")
    axis: Direction = Field(description="body axes")


class ThrusterTable(Section):
    """One of the thrusters."""

    name: str | None = _WORD
    at: Point = Field(description="where it acts and the propellant leaves")
    direction: Direction = Field(description="of the force on the body, body axes")
    thrust: Annotated[float, Quantity("N")] = Field(description="in vacuum, where there is an exit_area")
    specific_impulse: Seconds = Field(default=None, description="of that thrust; without it nothing flows")
    tanks: str | dict[str, Number] | None = Field(
        default=None, description="the tank it draws from, or shares by mass, { oxygen = 6, hydrogen = 1 }"
    )
    throttle: Annotated[str | float | None, Told("")] = Field(
        default=None, description="an input, or a number from 0 to 1"
    )
    lag: Seconds = Field(default=None, description="time constant of the level")
    gimbal: list[GimbalTable] = Field(default_factory=list, description="hinges, the outer one first")
    exit_area: Annotated[float | None, Quantity("m^2", positive=True)] = Field(
        default=None, description="on which the air presses"
    )
    exit_radius: Annotated[float | None, Quantity("m", positive=True)] = Field(
        default=None, description="of the disc over which the propellant leaves"
    )

    def built(self) -> elements.Thruster:
        """The thruster."""
        return elements.Thruster(
            **self.given("gimbal"), gimbal=[(hinge.angle, hinge.axis) for hinge in self.gimbal]
        )


class TankTable(Section):
    """One of the tanks."""

    name: str = Field(description="a word; its mass is the signal <name>_mass")
    mass: Annotated[float, Quantity("kg")] = Field(description="of the propellant at the start")
    com: Annotated[Array, Quantity("m", (3,), (None, 3))] = Field(
        description="its mass centre, body axes; with masses a row for each"
    )
    inertia_about_com: Tensors = Field(
        default=None, description="of the full load: principal moments or tensor; with masses one for each"
    )
    capacity: Annotated[float | None, Quantity("kg", positive=True)] = Field(
        default=None, description="the full load"
    )
    masses: Annotated[Array | None, Quantity("kg", (None,))] = Field(
        default=None, description="at which mass centre and inertia are given, 0 first"
    )
    interpolation: Annotated[str | None, Choice("linear", "cubic")] = Field(
        default=None, description="between these masses"
    )
    tail_off: Annotated[float | None, Quantity("kg", positive=True)] = Field(
        default=None, description="when less is left, flow and thrust fade"
    )

    def built(self) -> elements.Tank:
        """The tank."""
        values = self.given()
        inertia = self.inertia_about_com
        principal = (3,) if self.masses is None else (len(self.masses), 3)
        # (3, 3) is a tensor, but with three masses it has a row of principal moments for each.
        if inertia is not None and inertia.shape == principal:
            values["inertia_about_com"] = inertia[..., None] * np.eye(3)
        return elements.Tank(**values)


class Propulsion(ForceSection):
    """Thrusters, and the tanks that feed them."""

    type: Literal["propulsion"]
    name: str | None = _NAME
    thrusters: list[ThrusterTable] = Field(description="tables [[forces.thrusters]]")
    tanks: list[TankTable] = Field(default_factory=list, description="tables [[forces.tanks]]")

    def element(self, context: Context) -> forces.Force:
        parts: dict[str, list[Any]] = {"thrusters": [], "tanks": []}
        for key, built in parts.items():
            for i, table in enumerate(getattr(self, key)):
                with context.source.blame(f"{context.key}.{key}[{i}]"):
                    built.append(table.built())
        return elements.Propulsion(**parts, environment=context.environment, **self.given("type", *parts))


class CoefficientTable(Section):
    """A coefficient by advance ratio."""

    advance_ratio: Annotated[Array, Quantity("", (None,))] = Field(description="rising")
    values: Annotated[Array, Quantity("", (None,))] = Field(description="one for each")
    interpolation: Annotated[str | None, Choice("linear", "cubic", "hold")] = Field(
        default=None, description="between them"
    )

    def built(self) -> Table:
        """The table."""
        return Table(self.advance_ratio, self.values, **self.given("advance_ratio", "values"))


def _coefficient(value: Any) -> Any:
    return (
        CoefficientTable.model_validate(value) if isinstance(value, dict) else to_si(value, "", (), (None,))
    )


Coefficient = Annotated[Any, BeforeValidator(_coefficient)]


class Propeller(ForceSection):
    """A propeller or a rotor in the air or water of the file's environment."""

    type: Literal["propeller"]
    name: str | None = _WORD
    at: Point = Field(description="its hub")
    axis: Direction = Field(description="where its thrust points, body axes")
    diameter: Annotated[float, Quantity("m", positive=True)] = Field(description="its diameter")
    thrust_coefficient: Coefficient = Field(
        description="K_T: a number, powers of the advance ratio, or { advance_ratio, values, interpolation }"
    )
    torque_coefficient: Coefficient = Field(default=0.0, description="K_Q, likewise")
    hand: Annotated[str | None, Choice("right", "left")] = Field(
        default=None, description="which way it turns about its axis"
    )
    speed: Annotated[str | float | None, Told("rad/s")] = Field(
        default=None, description="an input, or a number"
    )
    lag: Seconds = Field(default=None, description="with which it follows its speed")
    torque: Annotated[str | float | None, Told("N m")] = Field(
        default=None, description="of its motor, instead of a speed: an input, or a number"
    )
    inertia: Annotated[float | None, Quantity("kg m^2", positive=True)] = Field(
        default=None, description="of what turns, about the axis"
    )
    initial_speed: Annotated[float | None, Quantity("rad/s")] = Field(
        default=None, description="where the speed is a state"
    )
    wake_fraction: Number | None = Field(default=None, description="behind a hull")
    thrust_deduction: Number | None = Field(default=None, description="behind a hull")

    @model_validator(mode="after")
    def _check(self) -> Propeller:
        self.exactly_one("speed", "torque")
        self.at_most_one("lag", "torque")
        return self

    def element(self, context: Context) -> forces.Force:
        values = self.given("type")
        for key in ("thrust_coefficient", "torque_coefficient"):
            if isinstance(values.get(key), CoefficientTable):
                with context.source.blame(f"{context.key}.{key}"):
                    values[key] = values[key].built()
        return elements.Propeller(context.environment, **values)


class GyroscopicMomentum(ForceSection):
    """A constant momentum inside the body."""

    type: Literal["gyroscopic_momentum"]
    name: str | None = _NAME
    momentum: Annotated[Array, Quantity("N m s", (3,))] = Field(description="relative to the body, body axes")

    def element(self, context: Context) -> forces.Force:
        return elements.GyroscopicMomentum(**self.given("type"))


class ReactionWheels(ForceSection):
    """Wheels whose motors push the body back."""

    type: Literal["reaction_wheels"]
    name: str | None = _NAME
    axes: Annotated[Array, Quantity("", (None, 3))] = Field(description="a row for each wheel, body axes")
    inertias: Annotated[Array, Quantity("kg m^2", (), (None,))] = Field(description="of each, or of all")
    torques: list[Annotated[str | float, Told("N m")]] | None = Field(
        default=None, description="for each motor an input, or a number"
    )
    max_torque: Annotated[float | None, Quantity("N m", positive=True)] = Field(
        default=None, description="of a motor"
    )
    max_speed: Annotated[float | None, Quantity("rad/s", positive=True)] = Field(
        default=None, description="of a wheel"
    )
    viscous: Annotated[float | None, Quantity("N m s")] = Field(default=None, description="friction by speed")
    coulomb: Annotated[float | None, Quantity("N m")] = Field(default=None, description="dry friction")
    stiction_speed: Annotated[float | None, Quantity("rad/s", positive=True)] = Field(
        default=None, description="below which dry friction falls off"
    )
    initial_speeds: Annotated[Array | None, Quantity("rad/s", (None,))] = Field(
        default=None, description="one for each"
    )
    prefix: str | None = Field(default=None, description="states and inputs are <prefix>_1_speed ...")

    def element(self, context: Context) -> forces.Force:
        return elements.ReactionWheels(**self.given("type"))


SECTIONS: tuple[type[ForceSection], ...] = (
    Actuator,
    GyroscopicMomentum,
    Propeller,
    Propulsion,
    ReactionWheels,
)
