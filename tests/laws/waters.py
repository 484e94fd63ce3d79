"""Water, currents, and one of every element that acts in it or on the ground, described in any body frame."""

from __future__ import annotations

from typing import Any

import numpy as np

import freebody as fb
from freebody.elements import (
    AddedMass,
    Buoyancy,
    Contact,
    CrossFlowDrag,
    Fin,
    Flotation,
    HullLiftDrag,
    HydrodynamicDamping,
    RotationalSpring,
    Spring,
    Tether,
)
from freebody.environment import ConstantWind, Ellipsoid, Environment, Planet, UniformAtmosphere

from .scenes import Array, positive_matrix

DENSITY = 1025.0
CURRENT = np.array([0.4, -0.3, 0.1])


def water(current: Array | None = None, planet: Planet | None = None) -> Environment:
    return Environment(planet, UniformAtmosphere(DENSITY), None if current is None else ConstantWind(current))


# Turns in a hundred minutes.
TURNING = Ellipsoid(1.0e6, 1.0e13, rotation_rate=1e-3)

# About as heavy as the water it displaces: the water carries it along.
BODY = fb.RigidBody(
    31.0,
    [0.05, -0.02, 0.06],
    inertia_about_com=fb.principal_inertia(
        [0.5, 4.0, 4.2], fb.Attitude.angles("zyx", [0.1, 0.2, -0.1]).as_rotation()
    ),
)
# In the axes of the first frame.
TILT = fb.Attitude.angles("zyx", [0.2, -0.3, 0.1]).as_rotation()
PLACE = np.array([0.1, -0.05, 0.03])
MASS = positive_matrix(np.random.default_rng(21)) * np.repeat([100.0, 10.0], 3) ** 0.5
MASS = 40.0 * (MASS + MASS.T)
RESISTANCE = positive_matrix(np.random.default_rng(22))
FAST = np.diag([8.0, 20.0, 20.0, 0.2, 2.0, 2.0])


def in_water(env: Environment, origin: Array | None = None, turn: Array | None = None) -> dict[str, fb.Force]:
    """The elements, their numbers written in the frame at `origin` with axes `turn` (old from new)."""
    o = np.zeros(3) if origin is None else origin
    c = np.eye(3) if turn is None else turn

    def place(point: Any) -> Array:
        return c.T @ (np.asarray(point) - o)

    seat: dict[str, Any] = {"at": place(PLACE), "axes": c.T @ TILT}
    return {
        "added mass": AddedMass(env, MASS, **seat),
        "damping": HydrodynamicDamping(env, RESISTANCE, FAST, **seat),
        "cross flow": CrossFlowDrag(env, 1.6, [0.1, 0.19, 0.15], **seat),
        "hull": HullLiftDrag(env, 0.2, 0.12, lift_slope=1.2, induced_drag=0.5, **seat),
        "buoyancy": Buoyancy(env, 31.0 / DENSITY, place([0.03, 0.01, -0.02])),
        "fin": Fin(
            env,
            0.02,
            place([-0.7, 0.05, 0.02]),
            span=c.T @ np.array([0.1, 0.2, -1.0]),
            chord=c.T @ np.array([1.0, 0.1, 0.0]),
            angle=0.15,
            aspect_ratio=2.2,
            drag_coefficient=0.01,
        ),
    }


def on_ground(origin: Array | None = None, turn: Array | None = None) -> dict[str, fb.Force]:
    """Flotation, springs, tethers and contact, likewise."""
    o = np.zeros(3) if origin is None else origin
    c = np.eye(3) if turn is None else turn

    def place(point: Any) -> Array:
        return c.T @ (np.asarray(point) - o)

    feet = [place([0.3, 0.2, 0.4]), place([-0.3, 0.1, 0.5]), place([0.0, -0.4, 0.45])]
    return {
        "flotation": Flotation(
            water(),
            0.031,
            place([0.05, 0.0, 0.1]),
            waterplane_area=0.3,
            transverse_moment=0.02,
            longitudinal_moment=0.05,
            at=place([0.02, 0.0, -0.05]),
            axes=c.T,
        ),
        "spring": Spring(200.0, at=place(PLACE), anchor=[1.0, 2.0, 1.0], length=0.5, damping=3.0),
        "tether": Tether(
            300.0, 1.0, at=place([0.2, 0.1, 0.0]), anchor=[2.0, 1.0, -1.0], damping=5.0, onset=2.0
        ),
        "rotational spring": RotationalSpring(
            c.T @ np.diag([3.0, 4.0, 5.0]) @ c, TILT @ c, c.T @ np.diag([0.1, 0.2, 0.3]) @ c
        ),
        "contact": Contact(
            feet,
            2.0e3,
            through=[0.0, 0.0, 0.4],
            normal=[0.1, -0.2, -1.0],
            velocity=[0.1, 0.0, 0.02],
            damping=0.3,
            friction=0.4,
            onset=0.05,
            slip_speed=0.5,
        ),
        "ground": Contact.on_ground(water(), feet, 2.0e3, damping=0.3, friction=0.4, onset=0.05),
    }
