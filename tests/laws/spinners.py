"""A body with rotors, wheels and a constant momentum about any frame."""

from typing import Any

import numpy as np

import freebody as fb
from freebody.elements import GyroscopicMomentum, Propeller, ReactionWheels
from freebody.environment import Environment, UniformAtmosphere
from freebody.environment.wind import Wind, WindHere

from .rockets import HERE, Frame
from .scenes import BODY, Array

AXES = np.array([[1.0, 0.2, 0.0], [0.0, 1.0, 0.0], [-0.3, 0.0, 1.0], [1.0, 1.0, 1.0]])
INERTIAS = np.array([0.05, 0.08, 0.03, 0.06])
MOMENTUM = np.array([0.5, -1.0, 2.0])
HUBS = np.array([[0.4, 0.1, -0.2], [-0.3, 0.2, -0.1]])
SHAFTS = np.array([[0.1, 0.0, -1.0], [0.9, 0.1, 0.2]])
THRUST = [0.12, -0.05, -0.06]
TORQUE = fb.Table(np.linspace(-1.0, 2.0, 7), [0.02, 0.03, 0.025, 0.02, 0.01, -0.01, -0.03], "cubic")


class Breeze(Wind):
    """A constant wind."""

    def here(self, place: Any, s: Any, p: Any) -> WindHere:
        return WindHere(np.array([2.0, -1.0, 0.5]), np.zeros(3))


AIR = Environment(atmosphere=UniformAtmosphere(1.1), wind=Breeze())
VACUUM = Environment(atmosphere=UniformAtmosphere(1e-30))


def wheels(frame: Frame = HERE, **more: Any) -> ReactionWheels:
    speeds = [50.0, -30.0, 10.0, 20.0]
    return ReactionWheels(np.array([frame.vector(a) for a in AXES]), INERTIAS, initial_speeds=speeds, **more)


def rotors(frame: Frame = HERE, environment: Environment = AIR) -> list[fb.Force]:
    """One that follows its command late, one that a motor drives."""
    late = Propeller(
        environment,
        frame.point(HUBS[0]),
        frame.vector(SHAFTS[0]),
        0.5,
        thrust_coefficient=THRUST,
        torque_coefficient=TORQUE,
        hand="left",
        speed="lift_speed",
        lag=0.3,
        inertia=0.01,
        initial_speed=100.0,
        name="lift",
    )
    driven = Propeller(
        environment,
        frame.point(HUBS[1]),
        frame.vector(SHAFTS[1]),
        0.4,
        thrust_coefficient=0.1,
        torque_coefficient=0.02,
        torque="motor",
        inertia=0.02,
        initial_speed=60.0,
        name="pusher",
    )
    return [late, driven]


def vehicle(frame: Frame = HERE, environment: Environment = AIR, *others: fb.Force) -> fb.Model:
    """A body with all of them."""
    all_of_them = [
        *rotors(frame, environment),
        wheels(frame, viscous=1e-4, coulomb=1e-3),
        GyroscopicMomentum(frame.vector(MOMENTUM)),
    ]
    return fb.Model(BODY.in_frame(*frame), [*all_of_them, *others])


INPUTS = {
    "lift_speed": 250.0,
    "motor": 1.5,
    "wheel_1_torque": 0.2,
    "wheel_2_torque": -0.3,
    "wheel_4_torque": 0.1,
}


def inputs_of(model: fb.Model) -> Array:
    return np.array([INPUTS.get(name, 0.0) for name in model.input_names])


def wheel_momentum(run: fb.Trajectory) -> Array:
    """Of all that turns, relative to the body, body axes, (n, 3)."""
    total = np.tile(MOMENTUM, (len(run.t), 1))
    for i, (axis, inertia) in enumerate(zip(AXES, INERTIAS, strict=True)):
        speed = run.states[f"reaction_wheels.wheel_{i + 1}_speed"]
        total += np.outer(inertia * speed, axis / np.linalg.norm(axis))
    lift, pusher = (a / np.linalg.norm(a) for a in SHAFTS)
    total -= np.outer(0.01 * run.states["lift.lift_speed"], lift)
    total += np.outer(0.02 * run.states["pusher.pusher_speed"], pusher)
    return total
