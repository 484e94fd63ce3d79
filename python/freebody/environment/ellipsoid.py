"""Round and flattened planets, turning or not."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.environment.geodesy import (
    altitude_argument,
    components,
    latitude_argument,
    longitude_argument,
    longitude_of,
    meridian,
    ned_axes,
    vector_of,
)
from freebody.environment.limits import Limit
from freebody.environment.place import Place
from freebody.environment.planet import ORIGIN, Planet
from freebody.errors import InputError

__all__ = ["WGS84", "Ellipsoid", "RoundEarth"]

# Beyond it the fixed number of steps to the latitude is too small; Saturn has 0.098.
_LARGEST_FLATTENING = 0.1
# Of the radius: as far from the centre of a sphere its directions still have many digits.
_CENTER = 1e-6


class Ellipsoid(Planet):
    """An ellipsoid of revolution that turns about its axis, with point-mass and J2 attraction.

    World axes are inertial, the third along the axis of rotation; they need not start at the centre.

    Parameters
    ----------
    radius
        Of the equator, m.
    mu
        Gravitational parameter GM, m³/s².
    flattening
        (a - b)/a, 0 for a sphere, at most 0.1.
    j2
        Second zonal coefficient, not normalized, for `radius` as its reference length. One that is published
        for another length R is scaled by (R/radius)².
    rotation_rate
        rad/s, about the third axis.
    center
        Of the planet in world axes, (3,) m. A world origin near the vehicle, `center = -r0`, keeps the digits
        of positions there: their rounding is that of the distance from the world origin.
    angle
        From the first world axis to the planet's meridian of longitude 0 at t = 0, rad.
    """

    def __init__(
        self,
        radius: float,
        mu: float,
        flattening: float = 0.0,
        j2: float = 0.0,
        rotation_rate: float = 0.0,
        *,
        center: ArrayLike = ORIGIN,
        angle: float = 0.0,
    ) -> None:
        self.radius = _check.number("radius", radius, positive=True)
        self.mu = _check.number("mu", mu, positive=True)
        self.flattening = _check.number("flattening", flattening)
        if not 0.0 <= self.flattening <= _LARGEST_FLATTENING:
            raise InputError(
                f"flattening: got {self.flattening:.6g}; allowed is 0 to {_LARGEST_FLATTENING:g}; "
                "1/298.257223563 for WGS-84, not its inverse"
            )
        self.j2 = _check.number("j2", j2)
        self.rotation_rate = _check.number("rotation_rate", rotation_rate)
        self.center = _check.vector("center", center, 3)
        self.angle = _check.number("angle", angle)

    @property
    def gravity_parameters(self) -> Mapping[str, tuple[float, str]]:
        point_mass = {"mu": (self.mu, "m^3/s^2")}
        return point_mass | {"j2": (self.j2, "1")} if self.j2 else point_mass

    @property
    def limits(self) -> tuple[Limit, ...]:
        """The neighbourhood of the centre: normals of the ellipsoid meet at up to a e²/√(1 - e²) from it."""
        e2 = self.flattening * (2.0 - self.flattening)
        shrunk = 1.0 - self.flattening
        deep = self.radius * (shrunk - e2 / shrunk - _CENTER)
        message = (
            f"near the planet's centre, below {-deep:.6g} m, points have several latitudes and altitudes; "
            "one of them holds, at the centre itself latitude and longitude 0"
        )
        return (Limit("planet", message, lambda place: place.altitude + deep),)

    def place(self, position_world: Any, time: Any) -> Place:
        """Where a point (..., 3) m is. On the axis longitude is 0; at the centre latitude is 0 too."""
        x, y, z = components(position_world - self.center)
        p = np.hypot(x, y)
        sine, cosine, altitude = meridian(p, z, self.radius, self.flattening)
        sin_turn, cos_turn = self._turn(time)
        on_axis = p <= 0.0
        safe = np.where(on_axis, 1.0, p)
        # Sine and cosine of the right ascension; those of longitude 0 on the axis.
        s, c = np.where(on_axis, sin_turn, y / safe), np.where(on_axis, cos_turn, x / safe)
        longitude = longitude_of(s * cos_turn - c * sin_turn, c * cos_turn + s * sin_turn)
        return Place(np.arctan2(sine, cosine), longitude, altitude, ned_axes((sine, cosine), (s, c)))

    def gravity(self, position_world: Any, time: Any, p: Any = None) -> Any:
        """Point mass and J2 (Vallado, Fundamentals of Astrodynamics, 4th ed., section 8.7), (..., 3) m/s².

        Not finite at the centre, where there is none.
        """
        return self._attraction(position_world, p, 1.0)

    def oblateness(self, position_world: Any, time: Any, p: Any = None) -> Any:
        """The part of gravity that J2 makes, (..., 3) m/s²."""
        return self._attraction(position_world, p, 0.0)

    def _attraction(self, position_world: Any, p: Any, point_mass: float) -> Any:
        x, y, z = components(position_world - self.center)
        closeness = 1.0 / (x * x + y * y + z * z)
        pull = -(self.mu if p is None else p.mu) * (closeness * np.sqrt(closeness))
        if not self.j2:
            return vector_of(pull * x, pull * y, pull * z)
        j2 = self.j2 if p is None else p.j2
        oblate = 1.5 * j2 * self.radius * self.radius * closeness
        across = pull * (point_mass + oblate * (1.0 - 5.0 * z * z * closeness))
        along = across + 2.0 * oblate * pull
        return vector_of(across * x, across * y, along * z)

    def potential(self, position_world: Any, time: Any) -> Any:
        x, y, z = components(position_world - self.center)
        square = x * x + y * y + z * z
        oblate = 0.5 * self.j2 * (self.radius * self.radius / square) * (3.0 * (z * z / square) - 1.0)
        return -self.mu / np.sqrt(square) * (1.0 - oblate)

    def ground_velocity(self, position_world: Any) -> Any:
        x, y, z = components(position_world - self.center)
        return vector_of(-self.rotation_rate * y, self.rotation_rate * x, np.zeros_like(z))

    @property
    def angular_velocity_world(self) -> Any:
        return np.array([0.0, 0.0, self.rotation_rate])

    def earth_from_world(self, time: Any) -> Any:
        s, c = self._turn(time)
        zero, one = np.zeros_like(s), np.ones_like(s)
        rows = (vector_of(c, s, zero), vector_of(-s, c, zero), vector_of(zero, zero, one))
        return np.stack(rows, axis=-2)

    def position_world(
        self,
        latitude: ArrayLike | None = None,
        longitude: ArrayLike | None = None,
        altitude: ArrayLike = 0.0,
        time: float = 0.0,
    ) -> Array:
        if latitude is None or longitude is None:
            raise InputError("latitude, longitude: both are needed to say where a point is")
        lat, lon = latitude_argument(latitude), longitude_argument(longitude)
        h = altitude_argument(altitude, -self.radius * (1.0 - self.flattening))
        s, c = np.sin(lat), np.cos(lat)
        e2 = self.flattening * (2.0 - self.flattening)
        normal = self.radius / np.sqrt(1.0 - e2 * s * s)
        p, z = (normal + h) * c, (normal * (1.0 - e2) + h) * s
        x, y, z = np.broadcast_arrays(p * np.cos(lon), p * np.sin(lon), z)
        earth = vector_of(x, y, z)
        return self.center + np.einsum("...ji,...j->...i", self.earth_from_world(time), earth)

    def ned_rate(self, position_world: Any, velocity_world: Any, time: Any) -> Any:
        relative = velocity_world - self.ground_velocity(position_world)
        x, y, z = components(position_world - self.center)
        p = np.hypot(x, y)
        sine, _, altitude = meridian(p, z, self.radius, self.flattening)
        axes = self.place(position_world, time).world_from_ned
        north, east = (np.sum(relative * axes[..., :, i], axis=-1) for i in range(2))
        e2 = self.flattening * (2.0 - self.flattening)
        bend = 1.0 - e2 * sine * sine
        latitude_rate = north / (self.radius * (1.0 - e2) / (bend * np.sqrt(bend)) + altitude)
        on_axis = p <= 0.0
        longitude_rate = np.where(on_axis, 0.0, east / np.where(on_axis, 1.0, p))
        turning = vector_of(np.zeros_like(p), np.zeros_like(p), self.rotation_rate + longitude_rate)
        return turning - latitude_rate[..., None] * axes[..., :, 1]

    def _turn(self, time: Any) -> tuple[Any, Any]:
        """Sine and cosine of the angle from the first world axis to the meridian of longitude 0."""
        turn = self.angle + self.rotation_rate * time
        return np.sin(turn), np.cos(turn)

    def __repr__(self) -> str:
        return (
            f"<{type(self).__name__}: radius {self.radius:.9g} m, flattening {self.flattening:.9g}, "
            f"{self.rotation_rate:.9g} rad/s>"
        )


class WGS84(Ellipsoid):
    """The Earth of the World Geodetic System 1984; every constant can be replaced by another.

    Defining constants a, 1/f, GM, ω, and the J2 that follows from them: NIMA TR 8350.2, 3rd ed., amendment 1
    (2000), tables 3.1 and 3.3.
    """

    def __init__(
        self,
        radius: float = 6378137.0,
        mu: float = 3.986004418e14,
        flattening: float = 1.0 / 298.257223563,
        j2: float = 1.08262982131e-3,
        rotation_rate: float = 7.292115e-5,
        *,
        center: ArrayLike = ORIGIN,
        angle: float = 0.0,
    ) -> None:
        super().__init__(radius, mu, flattening, j2, rotation_rate, center=center, angle=angle)


class RoundEarth(Ellipsoid):
    """A sphere with a point mass in it, not turning unless told; every constant can be replaced by another.

    The radius is that of the sphere of the same surface as WGS-84, R2: NIMA TR 8350.2, 3rd ed., table 3.3.
    """

    def __init__(
        self,
        radius: float = 6371007.1809,
        mu: float = 3.986004418e14,
        rotation_rate: float = 0.0,
        *,
        center: ArrayLike = ORIGIN,
        angle: float = 0.0,
    ) -> None:
        super().__init__(radius, mu, rotation_rate=rotation_rate, center=center, angle=angle)
