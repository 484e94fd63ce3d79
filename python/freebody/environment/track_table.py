"""Everything that a track knows, as a table of named arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from freebody._check import Array
from freebody.environment.motion import Frame
from freebody.errors import InputError

if TYPE_CHECKING:
    import xarray

    from freebody.environment.track import Track

__all__ = ["Row", "dataset", "rows"]

AXES = ("axis", ("x", "y", "z"))
NED = ("ned", ("north", "east", "down"))
ENU = ("enu", ("east", "north", "up"))
ANGLES = ("yaw_pitch_roll", ("yaw", "pitch", "roll"))


class Row(NamedTuple):
    """An array over time: its dimension and labels, or None for a scalar, its unit and its meaning."""

    name: str
    values: Array
    components: tuple[str, tuple[str, ...]] | None
    unit: str
    meaning: str


def rows(track: Track) -> list[Row]:
    """See `Track.rows`."""
    found = [
        Row("latitude", track.latitude, None, "rad", "geodetic latitude"),
        Row("longitude", track.longitude, None, "rad", "longitude, east positive"),
        Row("altitude", track.altitude, None, "m", "altitude above the ellipsoid"),
        Row("position_world", track.position_world, AXES, "m", "position, world axes"),
        Row("position_earth", track.position_earth, AXES, "m", "position from the centre, Earth-fixed axes"),
        Row("velocity_world", track.velocity_world, AXES, "m s-1", "inertial velocity, world axes"),
        Row("velocity_earth", track.velocity_earth, AXES, "m s-1", "relative to the Earth, Earth-fixed axes"),
        Row("velocity_ned", track.velocity_ned, NED, "m s-1", "relative to the Earth, local axes"),
        Row("speed", track.speed, None, "m s-1", "speed relative to the Earth"),
        Row("course", track.course, None, "rad", "direction of motion over the ground, north to east"),
        Row("flight_path_angle", track.flight_path_angle, None, "rad", "of the velocity above the horizon"),
        Row("angles_ned", track.angles(), ANGLES, "rad", "yaw, pitch, roll relative to local axes"),
        *(_rates(track, frame) for frame in ("world", "earth", "ned")),
        Row("acceleration_world", track.acceleration_world, AXES, "m s-2", "inertial, world axes"),
        Row("acceleration_body", track.acceleration_body, AXES, "m s-2", "inertial, body axes"),
        Row("acceleration_earth", track.acceleration_earth, AXES, "m s-2", "relative to the Earth, its axes"),
        Row("specific_force_body", track.specific_force_body, AXES, "m s-2", "accelerometer, body axes"),
        Row("gravity", track.gravity, None, "m s-2", "size of the attraction"),
    ]
    if track.site is not None:
        found.append(Row("position_ned", track.position_ned, NED, "m", "from the site, its local axes"))
        found.append(Row("position_enu", track.position_enu, ENU, "m", "from the site, its local axes"))
    return found + _orbit(track) + (_air(track) if track.environment is not None else [])


def _rates(track: Track, frame: Frame) -> Row:
    meaning = f"angular velocity relative to the frame {frame}, body axes"
    return Row(f"rates_{frame}", track.angular_velocity(frame), AXES, "rad s-1", meaning)


def _orbit(track: Track) -> list[Row]:
    """Nothing over a flat planet, and where a body falls straight to the centre: it has no orbital plane."""
    from freebody.environment.planet import FlatEarth  # noqa: PLC0415  (planets make tracks)

    if isinstance(track.planet, FlatEarth):
        return []
    try:
        angles = track.angles(relative_to="lvlh")
    except InputError:
        return []
    return [
        Row("angles_lvlh", angles, ANGLES, "rad", "yaw, pitch, roll relative to LVLH"),
        _rates(track, "lvlh"),
    ]


def _air(track: Track) -> list[Row]:
    flow = track.flow
    return [
        Row("airspeed", flow.airspeed, None, "m s-1", "speed relative to the air"),
        Row("angle_of_attack", flow.angle_of_attack, None, "rad", "arctan(w/u) of the velocity in the air"),
        Row("sideslip", flow.sideslip, None, "rad", "arcsin(v/V) of the velocity in the air"),
        Row("mach", flow.mach, None, "1", "airspeed over the speed of sound"),
        Row("dynamic_pressure", flow.dynamic_pressure, None, "Pa", "half density times airspeed squared"),
        Row("density", flow.air.density, None, "kg m-3", "of the air"),
        Row("pressure", flow.air.pressure, None, "Pa", "of the air"),
        Row("temperature", flow.air.temperature, None, "K", "of the air"),
        Row("speed_of_sound", flow.air.speed_of_sound, None, "m s-1", "in the air"),
        Row("velocity_air", flow.velocity_body, AXES, "m s-1", "relative to the air, body axes"),
    ]


def dataset(track: Track) -> xarray.Dataset:
    """See `Track.to_xarray`."""
    import xarray as xr  # noqa: PLC0415  (an extra: only who asks needs it)

    made = xr.Dataset(coords={"time": ("time", track.t, {"units": "s", "long_name": "time"})})
    for row in rows(track):
        dims: tuple[str, ...] = ("time",)
        if row.components is not None:
            dimension, labels = row.components
            dims = ("time", dimension)
            made.coords[dimension] = list(labels)
        attributes = {"units": row.unit, "long_name": row.meaning}
        made[row.name] = (dims, np.asarray(row.values), attributes)
    made.attrs = {"planet": repr(track.planet), "point": ", ".join(f"{x:g}" for x in track.point)}
    return made
