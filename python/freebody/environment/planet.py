"""Planets: where up is, how high a point is, and how the ground moves."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.environment.geodesy import (
    ENU_FROM_NED,
    altitude_argument,
    components,
    latitude_argument,
    longitude_argument,
    longitude_of,
)
from freebody.environment.limits import Limit
from freebody.environment.motion import Frame, motion_of
from freebody.environment.place import Place
from freebody.environment.track import Track
from freebody.errors import InputError

if TYPE_CHECKING:
    from freebody.environment.environment import Environment
    from freebody.simulation import Trajectory

__all__ = ["FlatEarth", "Place", "Planet"]

ORIGIN = (0.0, 0.0, 0.0)


class Planet(ABC):
    """What forces ask of a planet. World axes are inertial; methods for laws take numbers or traced values.

    Attributes
    ----------
    center
        Of the planet, world axes, (3,) m.
    gravity_parameters
        Name: (value, unit), of what can be dispersed in a law of its gravity.
    """

    center: Array = np.zeros(3)

    @property
    def gravity_parameters(self) -> Mapping[str, tuple[float, str]]:
        return {}

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Where places mean nothing, and what holds there."""
        return ()

    @abstractmethod
    def place(self, position_world: Any, time: Any) -> Place:
        """Where a point (3,) m is."""

    @abstractmethod
    def gravity(self, position_world: Any, time: Any, p: Any = None) -> Any:
        """The acceleration of attraction, world axes, (3,) m/s²; a law of it passes its parameters as `p`."""

    @abstractmethod
    def potential(self, position_world: Any, time: Any) -> Any:
        """Of the attraction, J/kg: gravity is minus its gradient."""

    @abstractmethod
    def ground_velocity(self, position_world: Any) -> Any:
        """The velocity of what turns with the planet at a point, world axes, (3,) m/s."""

    @property
    @abstractmethod
    def angular_velocity_world(self) -> Any:
        """Of the planet, world axes, (3,) rad/s."""

    @abstractmethod
    def earth_from_world(self, time: Any) -> Any:
        """Rotation from world axes into those fixed in the planet, (3, 3)."""

    @abstractmethod
    def position_world(
        self,
        latitude: ArrayLike | None = None,
        longitude: ArrayLike | None = None,
        altitude: ArrayLike = 0.0,
        time: float = 0.0,
    ) -> Array:
        """A place (...) as a position, world axes, (..., 3) m."""

    @abstractmethod
    def ned_rate(self, position_world: Any, velocity_world: Any, time: Any) -> Any:
        """The angular velocity of the local north, east and down axes as they go along with a point that has
        this velocity, world axes, (3,) rad/s. On the axis of a planet longitude is taken as constant.
        """

    def motion(
        self,
        *,
        latitude: float | None = None,
        longitude: float | None = None,
        altitude: float | None = None,
        position_world: ArrayLike | None = None,
        position_earth: ArrayLike | None = None,
        velocity_ned: ArrayLike | None = None,
        velocity_enu: ArrayLike | None = None,
        velocity_earth: ArrayLike | None = None,
        velocity_world: ArrayLike | None = None,
        attitude: Attitude | None = None,
        relative_to: Frame = "ned",
        angular_velocity_body: ArrayLike = ORIGIN,
        rates_relative_to: Frame = "world",
        time: float = 0.0,
        point: ArrayLike = ORIGIN,
    ) -> dict[str, Any]:
        """How a body starts, as the keyword arguments of `Model.state`.

        Parameters
        ----------
        latitude, longitude, altitude
            Where the material point `point` is: rad, rad, m above the ellipsoid ...
        position_world, position_earth
            ... or its position, (3,) m: world axes from the world origin, or axes fixed in the planet from
            its centre.
        velocity_ned, velocity_enu, velocity_earth
            Of the point relative to the turning planet, (3,) m/s: local axes, or those fixed in the planet.
            At rest relative to the planet when no velocity is given.
        velocity_world
            The inertial velocity of the point instead, world axes, (3,) m/s.
        attitude
            Of the body relative to the frame `relative_to`; aligned with it when omitted.
        relative_to
            "ned", "enu": local axes at the point. "world", "earth": inertial axes, axes fixed in the planet.
            "lvlh": see `freebody.environment.lvlh`.
        angular_velocity_body
            (3,) rad/s, body axes, relative to the frame `rates_relative_to`. "ned", "enu": the axes that go
            along with the point, which turn as it moves over the ground.
        time
            Of the start, s: where the turning planet stands.
        point
            Body axes from the body origin, (3,) m.
        """
        place = {"latitude": latitude, "longitude": longitude, "altitude": altitude}
        position = place | {"position_world": position_world, "position_earth": position_earth}
        velocity = {
            "velocity_ned": velocity_ned,
            "velocity_enu": velocity_enu,
            "velocity_earth": velocity_earth,
            "velocity_world": velocity_world,
        }
        turning = attitude, relative_to, angular_velocity_body, rates_relative_to
        return motion_of(self, position, velocity, turning, time, point)

    def track(
        self,
        run: Trajectory,
        point: ArrayLike = ORIGIN,
        *,
        site: tuple[float, float, float] | None = None,
        environment: Environment | None = None,
    ) -> Track:
        """A material point of the body along a run, as seen from this planet.

        Parameters
        ----------
        point
            Body axes from the body origin, (3,) m.
        site
            Latitude, longitude (rad) and altitude (m) of a place on the ground from which positions are
            measured in its local axes.
        environment
            With it the track has the flow of the air too; that of the model when omitted.
        """
        return Track(self, run, point, site, environment)


class FlatEarth(Planet):
    """A plane at rest with uniform gravity.

    Parameters
    ----------
    gravity
        m/s², downwards.
    axes
        World axes: "ned", north, east and down, or "enu", east, north and up.
    latitude, longitude
        rad, of the whole plane: what `place` says everywhere.
    altitude
        Of the world origin, m.
    """

    def __init__(
        self,
        gravity: float = 9.80665,
        axes: Literal["ned", "enu"] = "ned",
        latitude: float = 0.0,
        longitude: float = 0.0,
        altitude: float = 0.0,
    ) -> None:
        self.acceleration = _check.number("gravity", gravity)
        self.axes = _check.choice("axes", axes, ("ned", "enu"))
        self.latitude = float(latitude_argument(_check.number("latitude", latitude)))
        angle = longitude_argument(_check.number("longitude", longitude))
        self.longitude = (
            float(longitude_of(np.sin(angle), np.cos(angle))) if abs(angle) > np.pi else float(angle)
        )
        self.altitude = _check.number("altitude", altitude)
        self._world_from_ned = np.eye(3) if axes == "ned" else ENU_FROM_NED.copy()

    @property
    def gravity_parameters(self) -> Mapping[str, tuple[float, str]]:
        return {"acceleration": (self.acceleration, "m/s^2")}

    def place(self, position_world: Any, time: Any) -> Place:
        return Place(self.latitude, self.longitude, self._height(position_world), self._world_from_ned)

    def gravity(self, position_world: Any, time: Any, p: Any = None) -> Any:
        size = self.acceleration if p is None else p.acceleration
        return size * self._world_from_ned[:, 2]

    def potential(self, position_world: Any, time: Any) -> Any:
        return self.acceleration * self._height(position_world)

    def ground_velocity(self, position_world: Any) -> Any:
        return np.zeros(3)

    @property
    def angular_velocity_world(self) -> Any:
        return np.zeros(3)

    def earth_from_world(self, time: Any) -> Any:
        return np.eye(3)

    def position_world(
        self,
        latitude: ArrayLike | None = None,
        longitude: ArrayLike | None = None,
        altitude: ArrayLike = 0.0,
        time: float = 0.0,
    ) -> Array:
        """A point above or below the world origin: the plane has no latitude and longitude but its own."""
        for name, came, own in (
            ("latitude", latitude, self.latitude),
            ("longitude", longitude, self.longitude),
        ):
            if came is not None and not (np.asarray(came) == own).all():
                raise InputError(
                    f"{name}: got {_check.shown(came)}; a flat earth has one, {own:.6g} rad: say where the "
                    "point is by its position"
                )
        down = self.altitude - altitude_argument(altitude)
        return down[..., None] * self._world_from_ned[:, 2]

    def ned_rate(self, position_world: Any, velocity_world: Any, time: Any) -> Any:
        return np.zeros(3)

    def _height(self, position_world: Any) -> Any:
        _, _, vertical = components(position_world)
        return self.altitude + (vertical if self.axes == "enu" else -vertical)

    def __repr__(self) -> str:
        return f"<FlatEarth: {self.acceleration:g} m/s², axes {self.axes}>"
