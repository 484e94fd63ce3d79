"""Laws of users for models whose equations are printed."""

from __future__ import annotations

from typing import Any

import numpy as np

import freebody as fb

BODY = fb.RigidBody(
    12.5,
    (0.12, -0.05, 0.08),
    inertia_about_com=[[0.42, 0.01, -0.02], [0.01, 0.91, 0.03], [-0.02, 0.03, 1.10]],
)
LIFT = fb.Table(np.linspace(-1.0, 1.0, 9), np.sin(np.linspace(-2.0, 2.0, 9)), "cubic")

DRAG = fb.Table(
    (np.linspace(-2.0, 2.0, 5), np.linspace(-1.0, 1.0, 4)),
    np.cos(np.add.outer(np.arange(5.0), 0.7 * np.arange(4.0))),
    "cubic",
)

LATTICE = fb.Table(
    (np.linspace(-2.0, 2.0, 4), np.array([-1.0, 0.1, 0.1, 1.0]), np.linspace(-1.0, 1.0, 3)),
    np.sin(np.arange(48.0)).reshape(4, 4, 3),
)
LATTICE_4 = fb.Table(
    tuple(np.linspace(-1.0, 1.0, n) for n in (2, 3, 1, 3)), np.cos(np.arange(18.0)).reshape(2, 3, 1, 3)
)
STEPS = fb.Table(LATTICE.axes, LATTICE.values, "hold")


@fb.force(
    parameters={"area": (0.02, "m^2"), "density": (1.225, "kg/m^3"), "lag": (0.1, "s")},
    inputs={"rudder": "rad"},
    states={"servo": (0.05, "rad")},
)
def fin(s: Any, p: Any) -> Any:
    v = s.velocity_body
    incidence = np.arctan2(v[1], np.hypot(v[0], 1.0)) + np.clip(s.states.servo, -0.4, 0.4)
    side = -0.5 * p.density * p.area * (v @ v) * np.sin(incidence)
    side = side * np.where(s.position_world[2] > 0.0, 1.0, 0.5)
    rate = (s.inputs.rudder - s.states.servo) / p.lag
    return fb.wrench(force=np.stack([0.0, side, 0.0]), at=(-1.0, 0.0, 0.1)), {"servo": rate}


@fb.force(inputs={"throttle": "N"})
def thrust(s: Any) -> Any:
    return fb.wrench(force=np.stack([s.inputs.throttle, 0.0, 0.0]), moment=0.1 * s.twist[3:] * s.time)


@fb.force
def wing(s: Any) -> Any:
    """With a table."""
    return fb.wrench(force=np.stack([0.0, 0.0, LIFT(s.velocity_body[2] / 5.0)]), at=s.com)


@fb.force
def hull(s: Any) -> Any:
    """With a table of two variables."""
    drag = DRAG(s.velocity_body[0], s.angular_velocity_body[2])
    return fb.wrench(force=np.stack([-drag, 0.0, 0.0]), at=s.com)


@fb.force
def fuselage(s: Any) -> Any:
    """With tables of three variables and of four."""
    v, w = s.velocity_body, s.angular_velocity_body
    lift = LATTICE_4(v[0], v[1], w[1], w[2])
    side = LATTICE(v[1], w[0], v[2]) + STEPS(v[0], w[2], w[1])
    return fb.wrench(force=np.stack([lift, side, 0.0]), at=s.com)


@fb.control(parameters={"gain": (0.5, "s")}, inputs={"course": "rad"}, states={"filtered": (0.0, "rad/s")})
def pilot(s: Any, p: Any) -> Any:
    yaw = s.angular_velocity_body[2]
    error = s.inputs.course - np.arctan2(s.world_from_body[1, 0], s.world_from_body[0, 0])
    return {"rudder": 0.3 * error - p.gain * s.states.filtered}, {"filtered": (yaw - s.states.filtered) / 0.2}
