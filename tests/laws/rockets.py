"""A rocket with two tanks and two thrusters about any frame, and its momentum computed apart."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import freebody as fb
from freebody.elements import Propulsion, Tank, Thruster
from freebody.environment import Environment

from .scenes import BODY, START

Array = NDArray[np.float64]
G0 = 9.80665

FUEL = {"at": np.array([0.3, -0.2, 0.4]), "inertia": np.diag([0.05, 0.06, 0.07]), "mass": 4.0}
MASSES = np.array([0.0, 2.0, 6.0])
POINTS = np.array([[-0.4, 0.1, 0.2], [-0.3, 0.12, 0.25], [-0.1, 0.1, 0.3]])
TENSORS = np.array([0.0, 0.08, 0.2])[:, None, None] * np.array([[3, 0.2, 0], [0.2, 2, 0.1], [0, 0.1, 2.5]])
MAIN = {"at": np.array([0.1, 0.05, -1.2]), "direction": np.array([0.02, -0.01, 1.0])}
SIDE = {"at": np.array([0.5, 0.3, 0.2]), "direction": np.array([0.0, -1.0, 0.3])}
HINGES = (np.array([1.0, 0.1, 0.0]), np.array([0.0, 1.0, 0.2]))
AREA, RADIUS, SHARES = 1e-4, 0.15, (0.3, 0.7)


class Frame(NamedTuple):
    """A frame at `origin`, its axes turned by `turn` (old from new)."""

    origin: Array
    turn: Array

    def point(self, r: Array) -> Array:
        return (r - self.origin) @ self.turn

    def vector(self, v: Array) -> Array:
        return v @ self.turn

    def tensor(self, j: Array) -> Array:
        return self.turn.T @ j @ self.turn

    def state(self, model: fb.Model, **other: Any) -> Array:
        """The start of the scenes, or another one, of the same body in this frame."""
        start = START | other
        rotation, spin = start["attitude"].as_rotation(), np.array(start["angular_velocity_body"])
        return model.state(
            start["position"] + rotation @ self.origin,
            fb.Attitude.rotation(rotation @ self.turn),
            velocity_body=self.vector(start["velocity_body"] + np.cross(spin, self.origin)),
            angular_velocity_body=self.vector(spin),
        )


HERE = Frame(np.zeros(3), np.eye(3))


def propulsion(frame: Frame = HERE, **tank: Any) -> Propulsion:
    """Gimballed main engine with lag that draws from both tanks, and a side thruster that air presses on."""
    main = Thruster(
        frame.point(MAIN["at"]),
        frame.vector(MAIN["direction"]),
        120.0,
        specific_impulse=80.0,
        tanks={"fuel": 3.0, "oxygen": 7.0},
        throttle="throttle",
        lag=0.5,
        gimbal=[("pitch", frame.vector(HINGES[0])), ("yaw", frame.vector(HINGES[1]))],
        exit_radius=RADIUS,
        name="main",
    )
    side = Thruster(
        frame.point(SIDE["at"]),
        frame.vector(SIDE["direction"]),
        30.0,
        specific_impulse=60.0,
        tanks="fuel",
        exit_area=AREA,
        name="side",
    )
    fuel = Tank("fuel", FUEL["mass"], frame.point(FUEL["at"]), frame.tensor(FUEL["inertia"]), **tank)
    oxygen = Tank(
        "oxygen",
        5.0,
        frame.point(POINTS),
        np.array([frame.tensor(j) for j in TENSORS]),
        masses=MASSES,
        **tank,
    )
    return Propulsion([main, side], [fuel, oxygen], Environment())


def rocket(frame: Frame = HERE, *others: fb.Force, **tank: Any) -> fb.Model:
    """The body of the scenes with that propulsion."""
    return fb.Model(BODY.in_frame(*frame), [propulsion(frame, **tank), *others])


def at_mass(m: Array | float) -> tuple[Any, Any]:
    """Mass centre and inertia of the oxygen, interpolated apart."""
    com = np.stack([np.interp(m, MASSES, POINTS[:, i]) for i in range(3)], axis=-1)
    flat = TENSORS.reshape(3, 9)
    inertia = np.stack([np.interp(m, MASSES, flat[:, i]) for i in range(9)], axis=-1)
    return com, inertia.reshape(*np.shape(m), 3, 3)


def about_origin(mass: Array, com: Array, inertia: Array) -> Array:
    """Inertia about the origin by the parallel axes, batched."""
    square = np.sum(com * com, axis=-1)[..., None, None] * np.eye(3)
    return inertia + np.asarray(mass)[..., None, None] * (square - com[..., :, None] * com[..., None, :])


def whole(fuel: Array, oxygen: Array) -> tuple[Array, Array, Array]:
    """Mass, first moment and inertia about the origin of body and propellants, in the original frame."""
    com, inertia = at_mass(oxygen)
    share = (fuel / FUEL["mass"])[:, None, None]
    r = np.broadcast_to(FUEL["at"], com.shape)
    mass = BODY.mass + fuel + oxygen
    first = BODY.mass * BODY.com + fuel[:, None] * r + oxygen[:, None] * com
    tensor = BODY.inertia_about_origin + about_origin(fuel, r, share * FUEL["inertia"])
    return mass, first, tensor + about_origin(oxygen, com, inertia)


def momentum(run: fb.Trajectory) -> Array:
    """Of body and propellant turning together, about the world origin, world axes, (n, 6)."""
    mass, q, j = whole(run.states["propulsion.fuel_mass"], run.states["propulsion.oxygen_mass"])
    v, w, c = run.velocity_body, run.angular_velocity_body, run.world_from_body
    linear = np.einsum("nij,nj->ni", c, mass[:, None] * v + np.cross(w, q))
    own = np.einsum("nij,nj->ni", c, np.einsum("nij,nj->ni", j, w) + np.cross(q, v))
    return np.hstack([linear, np.cross(run.position_world, linear) + own])
