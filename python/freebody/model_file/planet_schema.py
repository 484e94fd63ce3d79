"""The planet of [environment], starts and tracks relative to it, and its gravity in [[forces]]."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike
from pydantic import BeforeValidator, Field, model_validator

from freebody import elements, forces
from freebody import environment as surroundings
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.environment import Environment, Planet
from freebody.environment.motion import FRAMES, Frame
from freebody.environment.track import Track
from freebody.simulation import Trajectory

from .context import Context, ForceSection
from .fields import Choice, OneOf, Quantity, Section
from .units import FieldError, to_si
from .words import word_as_table

__all__ = ["SECTIONS", "AnyPlanet", "PlanetSection", "StartOnPlanet", "TrackTable", "start_on_planet"]

Vector = Annotated[Array | None, Quantity("m", (3,))]
Velocity = Annotated[Array | None, Quantity("m/s", (3,))]
Angle = Annotated[float | None, Quantity("rad")]
Length = Annotated[float | None, Quantity("m")]
Mu = Annotated[float | None, Quantity("m^3/s^2")]
Number = Annotated[float | None, Quantity("")]
AnyFrame = Annotated[Frame | None, Choice(*FRAMES)]


class _Latitude(Quantity):
    """From pole to pole."""

    def read(self, value: Any) -> Any:
        angle = super().read(value)
        if np.abs(angle) > np.pi / 2.0:
            raise FieldError(f'allowed are -90 to 90 degrees; came {value!r}, write "45 deg" for degrees')
        return angle


class PlaceTable(Section):
    """A place on a planet."""

    latitude: Annotated[float, _Latitude("rad")] = Field(description="geodetic")
    longitude: Annotated[float, Quantity("rad")] = Field(description="east positive")
    altitude: Annotated[float, Quantity("m")] = Field(default=0.0, description="above the ellipsoid")

    @property
    def place(self) -> tuple[float, float, float]:
        return self.latitude, self.longitude, self.altitude


class PlanetSection(Section):
    """One of the kinds of planet."""

    @abstractmethod
    def planet(self) -> Planet:
        """The planet."""


class _Turning(PlanetSection):
    """What round and flattened planets share."""

    make: ClassVar[Callable[..., Planet]]

    rotation_rate: Annotated[float | None, Quantity("rad/s")] = Field(
        default=None, description="about the third world axis"
    )
    center: Vector = Field(default=None, description="where the planet is, from the world origin, world axes")
    origin: PlaceTable | None = Field(
        default=None, description="the place of the world origin at time 0, instead of center"
    )
    angle: Angle = Field(default=None, description="from the first world axis to longitude 0 at time 0")

    @model_validator(mode="after")
    def _check_center(self) -> _Turning:
        self.at_most_one("center", "origin")
        return self

    def planet(self) -> Planet:
        values = self.given("type", "origin")
        if "inverse_flattening" in values:
            values["flattening"] = 1.0 / values.pop("inverse_flattening")
        if self.origin is not None:
            values["center"] = -type(self).make(**values).position_world(*self.origin.place)
        return type(self).make(**values)


class RoundEarth(_Turning):
    """A sphere with a point mass; what is given replaces a constant of the Earth."""

    make = surroundings.RoundEarth
    type: Literal["round_earth"]
    radius: Length = Field(default=None, description="of the sphere")
    mu: Mu = Field(default=None, description="the gravitational parameter G M")


class _Flattened(_Turning):
    """What flattened planets share."""

    flattening: Number = Field(default=None, description="(a - b)/a")
    inverse_flattening: Annotated[float | None, Quantity("", positive=True)] = Field(
        default=None, description="1/flattening instead"
    )
    j2: Number = Field(default=None, description="second zonal coefficient, for radius as its length")

    @model_validator(mode="after")
    def _check_flattening(self) -> _Flattened:
        self.at_most_one("flattening", "inverse_flattening")
        return self


class WGS84(_Flattened):
    """The Earth of the World Geodetic System 1984; what is given replaces a constant of it."""

    make = surroundings.WGS84
    type: Literal["wgs84"]
    radius: Length = Field(default=None, description="of the equator")
    mu: Mu = Field(default=None, description="the gravitational parameter G M")


class Ellipsoid(_Flattened):
    """Any planet; without the optional keys a sphere that does not turn."""

    make = surroundings.Ellipsoid
    type: Literal["ellipsoid"]
    radius: Annotated[float, Quantity("m")] = Field(description="of the equator")
    mu: Annotated[float, Quantity("m^3/s^2")] = Field(description="the gravitational parameter G M")


class FlatEarth(PlanetSection):
    """A plane at rest with uniform gravity."""

    type: Literal["flat"]
    gravity: Annotated[float | None, Quantity("m/s^2")] = Field(default=None, description="downwards")
    axes: Annotated[str | None, Choice("ned", "enu")] = Field(default=None, description="the world axes")
    latitude: Angle = Field(default=None, description="of the whole plane")
    longitude: Angle = Field(default=None, description="of the whole plane")
    altitude: Length = Field(default=None, description="of the world origin")

    def planet(self) -> Planet:
        return surroundings.FlatEarth(**self.given("type"))


PLANETS = (WGS84, RoundEarth, FlatEarth, Ellipsoid)

AnyPlanet = Annotated[
    PlanetSection, OneOf("type", PLANETS), BeforeValidator(word_as_table("planet", PLANETS))
]
"""`"wgs84"`, or `{ type = "wgs84", mu = "1.407644311e16 ft^3/s^2" }`."""


class StartOnPlanet(Section):
    """The keys of [initial] that speak of the planet; `Initial` has them beside its own.

    Without a velocity the point rests on the planet. The attitude is relative to north, east and down where
    latitude, longitude or altitude are given, and to the world otherwise; rates are relative to the world.
    """

    latitude: Annotated[float | None, _Latitude("rad")] = Field(
        default=None, description="of the point, geodetic"
    )
    longitude: Angle = Field(default=None, description="of the point, east positive")
    altitude: Length = Field(default=None, description="of the point, above the ellipsoid")
    position_earth: Vector = Field(default=None, description="from the centre, axes fixed in the planet")
    velocity_ned: Velocity = Field(default=None, description="relative to the planet; north, east, down")
    velocity_enu: Velocity = Field(default=None, description="relative to the planet; east, north, up")
    velocity_earth: Velocity = Field(default=None, description="relative to the planet, axes fixed in it")
    attitude_relative_to: AnyFrame = Field(default=None, description="the frame that attitude is relative to")
    rates_relative_to: AnyFrame = Field(default=None, description="the frame that the rates are relative to")

    @model_validator(mode="after")
    def _check_start(self) -> StartOnPlanet:
        velocities = "velocity_ned", "velocity_enu", "velocity_earth", "velocity_world", "velocity_body"
        self.at_most_one(*velocities)
        self.at_most_one("position", "position_earth", "latitude")
        self.at_most_one("angular_velocity_world", "rates_relative_to")
        if self.speaks_of_planet and "velocity_body" in self.model_fields_set:
            raise FieldError(
                "does not go with keys of the planet; say velocity_ned or velocity_world", ("velocity_body",)
            )
        return self

    @property
    def speaks_of_planet(self) -> bool:
        """Whether the file gives one of these keys."""
        return bool(StartOnPlanet.model_fields.keys() & self.model_fields_set)

    @property
    def frame_of_attitude(self) -> Frame:
        """What the attitude is relative to."""
        by_place = self.model_fields_set & {"latitude", "longitude", "altitude"}
        return self.attitude_relative_to or ("ned" if by_place else "world")


def start_on_planet(
    initial: StartOnPlanet, planet: Planet, attitude: Attitude, point: ArrayLike, time: float
) -> dict[str, Any]:
    """The keyword arguments of `Model.state`; `point` (3,) is that of [initial], body axes."""
    values = initial.given("point", "attitude", "attitude_relative_to", "angular_velocity_world", "states")
    if "position" in values:
        values["position_world"] = values.pop("position")
    values |= {"attitude": attitude, "relative_to": initial.frame_of_attitude, "point": point, "time": time}
    rates = initial.given().get("angular_velocity_world")
    if rates is not None:
        values["angular_velocity_body"] = planet.motion(**values)["attitude"].as_rotation().T @ rates
    return planet.motion(**values)


class MaterialPoint(Quantity):
    """ "origin", "com", or a point in body axes from the origin."""

    def read(self, value: Any) -> Any:
        if not isinstance(value, str) or value.lstrip().startswith("["):
            return to_si(value, self.unit, *self.shapes)
        if value not in ("origin", "com"):
            raise FieldError(f'needs "origin", "com" or three numbers, a length (m); came {value!r}')
        return value


class TrackTable(Section):
    """[output.tracks.NAME]: a point of the body as seen from the planet."""

    point: Annotated[Any, MaterialPoint("m", (3,))] = Field(
        default="origin", description='"origin", "com", or a point in body axes'
    )
    site: PlaceTable | None = Field(default=None, description="where positions are measured from too")

    def track(self, run: Trajectory, environment: Environment) -> Track:
        """The track of a run."""
        points = {"origin": np.zeros(3), "com": np.asarray(run.model.body.com)}
        point = points[self.point] if isinstance(self.point, str) else self.point
        site = None if self.site is None else self.site.place
        return environment.planet.track(run, point, site=site, environment=environment)


class Gravity(ForceSection):
    """The attraction of the environment's planet, at the mass centre."""

    type: Literal["gravity"]
    name: str | None = Field(default=None, description="how messages name this force")
    point_mass: bool | None = Field(default=None, description="false: only what J2 adds")

    def element(self, context: Context) -> forces.Force:
        return elements.Gravity(context.environment, **self.given("type"))


SECTIONS: tuple[type[ForceSection], ...] = (Gravity,)
