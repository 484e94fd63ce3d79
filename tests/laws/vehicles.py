"""A wheel, a fluid and a tank with its engine, told in any frame of the body."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath as mp
import numpy as np

import freebody as fb

from .scenes import BODY, Array, positive_matrix

NO_MOVE, NO_TURN = np.zeros(3), np.eye(3)
AXIS = np.array([0.36, -0.48, 0.8])
WHEEL = 0.15  # kg m², about its axis
ADDED = 8.0 * positive_matrix(np.random.default_rng(7))
FULL, FLOW, SPEED = 4.0, 0.3, 250.0  # kg, kg/s, m/s
TANK, TANK_INERTIA = np.array([0.2, 0.1, -0.15]), np.diag([0.2, 0.3, 0.4])
EXITS = np.array([[-0.9, 0.2, 0.1], [-0.8, -0.3, 0.05]])
SHARES = np.array([0.7, 0.3])
WAYS = np.array([[0.96, 0.28, 0.0], [0.8, 0.0, 0.6]])  # of the thrust


def wheel(turn: Array = NO_TURN, torque: float = 0.0, speed: float = 40.0) -> fb.ForceLaw:
    """A wheel with a motor of constant torque; its state "work" is what that has done."""
    a = turn.T @ AXIS

    @fb.force(
        parameters={"torque": (torque, "N m")},
        states={"speed": (speed, "rad/s"), "work": (0.0, "J")},
        publishes=("speed",),
        spins=(fb.Spin(tuple(a), WHEEL, "speed"),),
    )
    def wheel(s: Any, p: Any) -> Any:
        h = a * (WHEEL * s.states.speed)
        moment = -a * p.torque - np.cross(s.angular_velocity_body, h)
        return fb.wrench(moment=moment), {"speed": p.torque / WHEEL, "work": p.torque * s.states.speed}

    return wheel


def added_mass(origin: Array = NO_MOVE, turn: Array = NO_TURN) -> Array:
    """V_old = X V_new, and the kinetic energy of the fluid is the same."""
    x = np.block([[turn, fb.forms.skew(origin) @ turn], [np.zeros((3, 3)), turn]])
    return x.T @ ADDED @ x


def fluid(origin: Array = NO_MOVE, turn: Array = NO_TURN) -> fb.ForceLaw:
    """A fluid at rest: -Φ(V) M V (Kirchhoff), beside its mass on the left."""
    mass = added_mass(origin, turn)

    @fb.force(added_mass=mass)
    def fluid(s: Any) -> Any:
        v, w = s.velocity_body, s.angular_velocity_body
        p, k = mass[:3] @ s.twist, mass[3:] @ s.twist
        return fb.wrench(force=-np.cross(w, p), moment=-np.cross(v, p) - np.cross(w, k))

    return fluid


def about_origin(r: Any) -> Any:
    return (r @ r) * np.eye(3) - np.stack([r * r[i] for i in range(3)])


def engine(origin: Array = NO_MOVE, turn: Array = NO_TURN) -> fb.ForceLaw:
    """A tank that is emptied at a constant rate through two exits, straight and steadily.

    Fuel stays where its mass centre is, so that its flow relative to the body has the constant momentum h;
    about that mass centre it has no angular momentum.
    """
    place, tensor = turn.T @ (TANK - origin), turn.T @ TANK_INERTIA @ turn
    exits, ways = (EXITS - origin) @ turn, WAYS @ turn
    flow = FLOW * SHARES
    h = flow @ exits - FLOW * place
    inertia_rate = -FLOW * (tensor / FULL + about_origin(place))

    @fb.contents(inputs={"fuel": "kg"})
    def tank(s: Any) -> Any:
        fuel = s.inputs.fuel
        return fb.mass_properties(mass=fuel, com=place, inertia_about_com=tensor * (fuel / FULL))

    @fb.force(
        parameters={"exhaust_speed": (SPEED, "m/s")},
        states={"fuel": (FULL, "kg")},
        publishes=("fuel",),
        contents=(tank,),
    )
    def engine(s: Any, p: Any) -> Any:
        w = s.angular_velocity_body
        thrust = [ways[i] * (flow[i] * p.exhaust_speed) for i in range(2)]
        carried = [flow[i] * np.cross(exits[i], np.cross(w, exits[i])) for i in range(2)]
        moment = sum(np.cross(exits[i], thrust[i]) - carried[i] for i in range(2)) - inertia_rate @ w
        moment = moment - np.cross(w, np.cross(place, h))
        return fb.wrench(force=thrust[0] + thrust[1] - 2.0 * np.cross(w, h), moment=moment), {"fuel": -FLOW}

    return engine


def flow_momentum() -> Array:
    """h of the engine, body axes."""
    return FLOW * (SHARES @ EXITS - TANK)


def all_of_it(origin: Array = NO_MOVE, turn: Array = NO_TURN) -> list[fb.Force]:
    """Seven states' worth: wheel with a motor, fluid, engine, and a weight."""
    return [fb.UniformGravity(1.5), wheel(turn, 0.2), fluid(origin, turn), engine(origin, turn)]


def vehicle(attitude: str = "quaternion", form: Any = "quasi_velocity") -> fb.Model:
    """The body with all of it."""
    return fb.Model(BODY, all_of_it(), attitude, form)


def by_hand(x: Sequence[Any]) -> list[Any]:
    """The rates of twist, speed, work and fuel of `vehicle("zyx")`, by full matrices on mpmath's numbers."""
    _, theta, phi = x[3:6]
    v, w = mp.matrix(x[6:9]), mp.matrix(x[9:12])
    speed, fuel = x[12], x[14]
    sin, cos = mp.sin, mp.cos
    down = mp.matrix([-sin(theta), cos(theta) * sin(phi), cos(theta) * cos(phi)])
    a, flow = mp.matrix(AXIS.tolist()), [mp.mpf(f) for f in FLOW * SHARES]
    r = [mp.matrix(e.tolist()) for e in EXITS]
    place, tensor = mp.matrix(TANK.tolist()), mp.matrix(TANK_INERTIA.tolist())

    def skew(q: Any) -> Any:
        return mp.matrix([[0, -q[2], q[1]], [q[2], 0, -q[0]], [-q[1], q[0], 0]])

    def spatial(m: Any, com: Any, j: Any) -> Any:
        theta = mp.zeros(6)
        s = m * skew(com)
        theta[:3, :3], theta[:3, 3:] = m * mp.eye(3), -s
        theta[3:, :3], theta[3:, 3:] = s, j - m * skew(com) * skew(com)
        return theta

    com, j = mp.matrix(BODY.com.tolist()), mp.matrix(BODY.inertia_about_com.tolist())
    body = spatial(mp.mpf(BODY.mass), com, j) + spatial(fuel, place, tensor * fuel / FULL)
    added, twist = mp.matrix(ADDED.tolist()), mp.matrix([*v, *w])
    cross = mp.zeros(6)
    cross[:3, :3], cross[3:, :3], cross[3:, 3:] = skew(w), skew(v), skew(w)
    weight = mp.mpf(1.5) * down
    force = (mp.mpf(BODY.mass) + fuel) * weight
    moment = skew(mp.mpf(BODY.mass) * com + fuel * place) * weight
    torque = mp.mpf(0.2)
    moment += -a * torque - skew(w) * a * (mp.mpf(WHEEL) * speed)
    h = -mp.mpf(FLOW) * place
    for e, share, way in zip(r, flow, WAYS, strict=True):
        thrust = mp.matrix(way.tolist()) * share * mp.mpf(SPEED)
        force += thrust
        moment += skew(e) * thrust - share * skew(e) * skew(w) * e
        h += share * e
    force -= 2 * skew(w) * h
    moment -= skew(w) * skew(place) * h
    moment += mp.mpf(FLOW) * (tensor / FULL - skew(place) * skew(place)) * w
    wrench = mp.matrix([*force, *moment])
    mass = body + added
    mass[3:, 3:] -= mp.mpf(WHEEL) * a * a.T
    rate = mp.lu_solve(mass, wrench - cross * (body + added) * twist)
    along = sum(a[i] * rate[3 + i] for i in range(3))
    return [*rate, torque / mp.mpf(WHEEL) - along, torque * speed, -mp.mpf(FLOW)]
