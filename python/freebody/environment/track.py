"""How a point of the body moves over a planet, along a run."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, forms
from freebody._check import Array
from freebody.environment.flow_along import FlowAlong, flow_along
from freebody.environment.frames import lvlh
from freebody.environment.geodesy import ENU_FROM_NED
from freebody.environment.motion import FRAMES, Frame
from freebody.environment.track_table import Row, dataset, rows
from freebody.errors import InputError

if TYPE_CHECKING:
    import xarray

    from freebody.environment.environment import Environment
    from freebody.environment.place import Place
    from freebody.environment.planet import Planet
    from freebody.simulation import Trajectory

__all__ = ["Track"]


class Track:
    """A material point of the body along a run, as seen from a planet; SI and radians, n samples.

    See `Planet.track`, which makes them. Vectors with a frame in their name have its axes; "relative" and
    everything that names the Earth is seen from the planet that turns.
    """

    def __init__(
        self,
        planet: Planet,
        run: Trajectory,
        point: ArrayLike = (0.0, 0.0, 0.0),
        site: tuple[float, float, float] | None = None,
        environment: Environment | None = None,
    ) -> None:
        self.planet, self.run = planet, run
        self.environment = run.model.environment if environment is None else environment
        self.point = _check.vector("point", point, 3)
        self.site = site
        self._site = None if site is None else self._seat(*_check.vector("site", site, 3))

    @property
    def t(self) -> Array:
        """Times, (n,) s."""
        return self.run.t

    @cached_property
    def position_world(self) -> Array:
        """World axes, (n, 3) m."""
        return self.run.point(self.point)

    @cached_property
    def velocity_world(self) -> Array:
        """The inertial velocity, world axes, (n, 3) m/s."""
        return self.run.velocity_world + self._to_world(np.cross(self._rates, self.point))

    @cached_property
    def acceleration_body(self) -> Array:
        """The inertial acceleration, body axes, (n, 3) m/s²: from the model's derivative at the samples."""
        rate, v, omega = self._twist_rate, self.run.velocity_body, self._rates
        swing = np.cross(omega, self.point)
        return rate[:, :3] + np.cross(rate[:, 3:], self.point) + np.cross(omega, v + swing)

    @cached_property
    def acceleration_world(self) -> Array:
        """The inertial acceleration, world axes, (n, 3) m/s²."""
        return self._to_world(self.acceleration_body)

    @cached_property
    def specific_force_body(self) -> Array:
        """What an accelerometer at the point feels, body axes, (n, 3) m/s²: the inertial acceleration less
        the planet's attraction there.
        """
        return self.acceleration_body - self._to_body(self._gravity_world)

    @cached_property
    def gravity(self) -> Array:
        """The size of the planet's attraction at the point, (n,) m/s²."""
        return np.linalg.norm(self._gravity_world, axis=-1)

    @property
    def latitude(self) -> Array:
        """Geodetic, (n,) rad."""
        return np.broadcast_to(self._place.latitude, self.t.shape)

    @property
    def longitude(self) -> Array:
        """In (-π, π], (n,) rad."""
        return np.broadcast_to(self._place.longitude, self.t.shape)

    @property
    def altitude(self) -> Array:
        """Above the ellipsoid, (n,) m."""
        return self._place.altitude

    @cached_property
    def position_earth(self) -> Array:
        """From the centre, axes fixed in the planet, (n, 3) m."""
        return self.resolve(self.position_world - self.planet.center, "earth")

    @property
    def position_ned(self) -> Array:
        """From the site, in its north, east and down axes, (n, 3) m."""
        if self._site is None:
            raise InputError("site: the track has none; give site=(latitude, longitude, altitude)")
        seat, earth_from_ned = self._site
        return (self.position_earth - seat) @ earth_from_ned

    @property
    def position_enu(self) -> Array:
        """From the site, in its east, north and up axes, (n, 3) m."""
        return self.position_ned @ ENU_FROM_NED

    @cached_property
    def velocity_earth(self) -> Array:
        """Relative to the turning planet, axes fixed in it, (n, 3) m/s."""
        return self.resolve(self._relative_world, "earth")

    @cached_property
    def velocity_ned(self) -> Array:
        """Relative to the turning planet, local north, east and down axes, (n, 3) m/s."""
        return self.resolve(self._relative_world, "ned")

    @property
    def velocity_enu(self) -> Array:
        """Relative to the turning planet, local east, north and up axes, (n, 3) m/s."""
        return self.velocity_ned @ ENU_FROM_NED

    @cached_property
    def acceleration_earth(self) -> Array:
        """As seen from the turning planet, its axes, (n, 3) m/s²: without Coriolis and centrifugal."""
        turn = self.planet.angular_velocity_world
        carried = np.cross(turn, self.planet.ground_velocity(self.position_world))
        seen = self.acceleration_world - 2.0 * np.cross(turn, self._relative_world) - carried
        return self.resolve(seen, "earth")

    @property
    def speed(self) -> Array:
        """Relative to the turning planet, (n,) m/s."""
        return np.linalg.norm(self._relative_world, axis=-1)

    @property
    def course(self) -> Array:
        """Direction of motion over the ground from north to east, (n,) rad in (-π, π]."""
        return np.arctan2(self.velocity_ned[:, 1], self.velocity_ned[:, 0])

    @property
    def flight_path_angle(self) -> Array:
        """Of the velocity relative to the turning planet above the local horizon, (n,) rad."""
        north, east, down = self.velocity_ned.T
        return np.arctan2(-down, np.hypot(north, east))

    def axes(self, frame: Frame | Literal["body"]) -> Array:
        """The axes of a frame as columns, in world axes, (n, 3, 3): "world", "earth", "ned", "enu", "lvlh" at
        the point, or "body".
        """
        _check.choice("frame", frame, (*FRAMES, "body"))
        if frame == "body":
            return self.run.world_from_body
        if frame == "lvlh":
            return lvlh(self.position_world - self.planet.center, self.velocity_world).world_from_lvlh
        if frame == "world":
            axes = np.eye(3)
        elif frame == "earth":
            axes = np.swapaxes(self.planet.earth_from_world(self.t), -1, -2)
        else:
            axes = self._place.world_from_ned
            axes = axes if frame == "ned" else axes @ ENU_FROM_NED
        return np.broadcast_to(axes, (len(self.t), 3, 3))

    def resolve(self, vectors_world: ArrayLike, frame: Frame | Literal["body"]) -> Array:
        """Vectors (n, 3) given in world axes, in those of a frame; see `axes`."""
        vectors = _check.numbers("vectors_world", vectors_world, len(self.t), 3)
        return np.einsum("nji,nj->ni", self.axes(frame), vectors)

    def angles(self, sequence: str = "zyx", relative_to: Frame = "ned") -> Array:
        """Attitude relative to a frame, (n, 3) rad; "zyx" and "ned": yaw, pitch and roll."""
        _check.sequence(sequence, "sequence")
        _check.choice("relative_to", relative_to, FRAMES)
        if not len(self.t):
            return np.empty((0, 3))
        frame_from_body = np.swapaxes(self.axes(relative_to), -1, -2) @ self.run.world_from_body
        return forms.angles_from_rotation(frame_from_body, sequence)

    def angular_velocity(self, relative_to: Frame = "world") -> Array:
        """Relative to a frame, body axes, (n, 3) rad/s; "ned", "enu" and "lvlh" go along with the point."""
        _check.choice("relative_to", relative_to, FRAMES)
        if relative_to == "world":
            return self._rates
        if relative_to == "earth":
            turning = self.planet.angular_velocity_world
        elif relative_to == "lvlh":
            orbit = lvlh(self.position_world - self.planet.center, self.velocity_world)
            turning = orbit.angular_velocity_world
        else:
            turning = self.planet.ned_rate(self.position_world, self.velocity_world, self.t)
        return self._rates - self._to_body(np.broadcast_to(turning, self._rates.shape))

    @cached_property
    def flow(self) -> FlowAlong:
        """Airspeed, angles of attack and sideslip, Mach number and so on; the track needs an environment."""
        if self.environment is None:
            raise InputError("environment: the track has none; give environment=, with its air and wind")
        return flow_along(self.environment, self.run, self.point)

    def rows(self) -> list[Row]:
        """All that the track knows, as named arrays with units and meanings."""
        return rows(self)

    def to_xarray(self) -> xarray.Dataset:
        """The same as a labelled dataset (extra `data`)."""
        return dataset(self)

    @cached_property
    def _place(self) -> Place:
        return self.planet.place(self.position_world, self.t)

    @property
    def _rates(self) -> Array:
        return self.run.angular_velocity_body

    @cached_property
    def _relative_world(self) -> Array:
        return self.velocity_world - self.planet.ground_velocity(self.position_world)

    @cached_property
    def _gravity_world(self) -> Array:
        with np.errstate(divide="ignore", invalid="ignore"):  # a run that ended at the centre is shown too
            pull = self.planet.gravity(self.position_world, self.t)
        return np.broadcast_to(pull, self.position_world.shape)

    @cached_property
    def _twist_rate(self) -> Array:
        """Rate of the twist of the origin, body axes, (n, 6): of the model in the chart that has it in x'."""
        run, model = self.run, self.run.model
        rigid = np.concatenate([run.position_world, run.quaternion, run.velocity_body, self._rates], axis=1)
        own = type(model)(model.body, model.forces, control=model.control)
        x = np.concatenate([rigid, run.x[:, model.n_states - len(model.auxiliary_states) :]], axis=1)
        rates = own.derivative_batch(run.t, np.ascontiguousarray(x.T), np.ascontiguousarray(run.u.T))
        return rates[7:13].T

    def _to_world(self, vectors: Array) -> Array:
        return np.einsum("nij,nj->ni", self.run.world_from_body, vectors)

    def _to_body(self, vectors: Array) -> Array:
        return np.einsum("nji,nj->ni", self.run.world_from_body, vectors)

    def _seat(self, latitude: float, longitude: float, altitude: float) -> tuple[Array, Any]:
        """A site in axes fixed in the planet: where it is, and its north, east and down axes as columns."""
        position = self.planet.position_world(latitude, longitude, altitude)
        earth_from_world = self.planet.earth_from_world(0.0)
        axes = self.planet.place(position, 0.0).world_from_ned
        return earth_from_world @ (position - self.planet.center), earth_from_world @ axes
