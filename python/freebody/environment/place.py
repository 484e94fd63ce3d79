"""Where a point is on a planet."""

from __future__ import annotations

from typing import Any, NamedTuple

__all__ = ["Place"]


class Place(NamedTuple):
    """Where a point is on a planet; arrays or traced values.

    Attributes
    ----------
    latitude, longitude
        Geodetic, rad; longitude in (-π, π].
    altitude
        Above the ellipsoid, m.
    world_from_ned
        Rotation of the local north, east and down axes, (3, 3).
    """

    latitude: Any
    longitude: Any
    altitude: Any
    world_from_ned: Any
