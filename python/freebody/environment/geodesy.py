"""Geodetic coordinates on an ellipsoid of revolution; numbers, arrays (...) and traced values alike."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError

__all__ = [
    "ENU_FROM_NED",
    "Meridian",
    "altitude_argument",
    "components",
    "latitude_argument",
    "longitude_argument",
    "longitude_of",
    "meridian",
    "ned_axes",
    "vector_of",
]

ENU_FROM_NED = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
"""Turns north, east, down into east, north, up, and back."""

# The start errs by a part of the flattening; each step squares the error. Three are enough for the planets.
_STEPS = 3
# Of the radius. The slope vanishes where normals of the ellipse meet, which they do near the centre only.
_LEAST_SLOPE = 1e-4


class Meridian(NamedTuple):
    """A point in its meridian plane: sine and cosine of the geodetic latitude, altitude in m."""

    sine: Any
    cosine: Any
    altitude: Any


def meridian(p: Any, z: Any, radius: float, flattening: float) -> Meridian:
    """Of the point at the distance p from the axis and z from the equator, m.

    Newton's method for the reduced latitude β of the foot of the normal, where
    p sin β − (1 − f) z cos β = a e² sin β cos β (Heiskanen and Moritz, Physical Geodesy, 1967, section 5-3).
    β is held as its sine and cosine, so that neither equator nor pole is special. A fixed number of steps:
    the last one also makes the derivatives exact. At the centre itself the latitude is 0 and the altitude −a.
    """
    shrunk, e2 = 1.0 - flattening, flattening * (2.0 - flattening)
    pa, za = p / radius, z / radius
    s, c = _unit(za, shrunk * pa)
    for _ in range(_STEPS if flattening else 0):
        defect = pa * s - shrunk * za * c - e2 * s * c
        slope = np.maximum(pa * c + shrunk * za * s - e2 * (c * c - s * s), _LEAST_SLOPE)
        turn = defect / slope
        s, c = _unit(s - turn * c, c + turn * s)
    sine, cosine = _unit(s, shrunk * c)
    # From the foot of the normal: small differences near the ground, where a sum of squares would cancel.
    altitude = (p - radius * c) * cosine + (z - radius * shrunk * s) * sine
    return Meridian(sine, cosine, altitude)


def _unit(s: Any, c: Any) -> tuple[Any, Any]:
    """The direction of (c, s); that of (1, 0) for the zero vector."""
    length = np.hypot(s, c)
    none = length <= 0.0
    safe = np.where(none, 1.0, length)
    return s / safe, np.where(none, 1.0, c / safe)


def longitude_of(sine: Any, cosine: Any) -> Any:
    """The angle in (-π, π]."""
    angle = np.arctan2(sine, cosine)
    return np.where(angle <= -np.pi, angle + 2.0 * np.pi, angle)


def ned_axes(latitude: tuple[Any, Any], longitude: tuple[Any, Any]) -> Any:
    """North, east and down as columns, (..., 3, 3), from sine and cosine of latitude and longitude."""
    (sin_lat, cos_lat), (sin_lon, cos_lon) = latitude, longitude
    rows = (
        (-sin_lat * cos_lon, -sin_lon, -cos_lat * cos_lon),
        (-sin_lat * sin_lon, cos_lon, -cos_lat * sin_lon),
        (cos_lat, np.zeros_like(cos_lat), -sin_lat),
    )
    return np.stack([vector_of(*row) for row in rows], axis=-2)


def components(vector: Any) -> tuple[Any, Any, Any]:
    """The three components (...) of vectors (..., 3)."""
    x, y, z = np.moveaxis(vector, -1, 0)
    return x, y, z


def vector_of(x: Any, y: Any, z: Any) -> Any:
    """Vectors (..., 3) of their components (...)."""
    return np.stack([x, y, z], axis=-1)


def latitude_argument(value: ArrayLike) -> Array:
    """Check latitudes of any shape, rad."""
    return _bounded(
        "latitude", value, -np.pi / 2.0, np.pi / 2.0, "from -π/2 to π/2; np.deg2rad converts degrees"
    )


def longitude_argument(value: ArrayLike) -> Array:
    """Check longitudes of any shape, rad; any turn to east or west is allowed."""
    return _bounded(
        "longitude", value, -2.0 * np.pi, 2.0 * np.pi, "from -2π to 2π; np.deg2rad converts degrees"
    )


def altitude_argument(value: ArrayLike, lowest: float = -np.inf) -> Array:
    """Check altitudes of any shape, m, not below the centre."""
    return _bounded("altitude", value, lowest, np.inf, f"above {lowest:.6g} m")


def _bounded(name: str, value: ArrayLike, low: float, high: float, allowed: str) -> Array:
    try:
        shape = np.shape(value)
    except ValueError:
        shape = ()
    array = _check.numbers(name, value, *shape)
    inside = (array >= low) & (array <= high) & np.isfinite(array)
    if not inside.all():
        came = array[~inside][0]
        raise InputError(f"{name}: got {came:.6g}; allowed are values {allowed}")
    return array
