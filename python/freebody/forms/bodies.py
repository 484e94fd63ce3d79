"""One body in quasi-velocities: (1.5)-(1.12).

A twist (..., 6) is the velocity of the body origin o1 (m/s) and the angular velocity (rad/s), a wrench
(..., 6) the force (N) and its moment about o1 (N m), both in body axes.
"""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from freebody import _core
from freebody._check import Array, argument, choice, rotation_argument
from freebody.forms._call import checked_body, evaluate
from freebody.forms.screws import force_cross


class QuasiVelocity(NamedTuple):
    """The matrices of form (1.11); the body's own are (6, 6), those of the motion (..., 6, 6)."""

    spatial_inertia: Array
    inverse_spatial_inertia: Array
    force_cross: Array
    Phi_pi: Array


def spatial_inertia(body: _core.RigidBody) -> Array:
    """Theta, the Mises inertia matrix (6, 6) about the body origin, body axes. Konoplev (1.6)"""
    return checked_body(body).spatial_inertia


def inertial_parameters(body: _core.RigidBody) -> Array:
    """The ten parameters (m, m r_c, Jxx, Jxy, Jxz, Jyy, Jyz, Jzz), J about the body origin: (10,)."""
    return evaluate("inertial_parameters", (10,), body=checked_body(body))


def inertia_regressor(twist: ArrayLike, twist_rate: ArrayLike) -> Array:
    """Y (..., 6, 10) with Theta V* + Phi Theta V = Y theta, theta = `inertial_parameters`. Konoplev (1.8)"""
    return evaluate(
        "inertia_regressor", (6, 10), argument("twist", twist, 6), argument("twist_rate", twist_rate, 6)
    )


def kinetic_energy(body: _core.RigidBody, twist: ArrayLike) -> Array:
    """T = V^T Theta V / 2 in J: (..., 6) -> (...)."""
    return evaluate("kinetic_energy", (), argument("twist", twist, 6), body=checked_body(body))


def momentum(body: _core.RigidBody, twist: ArrayLike) -> Array:
    """Z1 = Theta V: linear momentum and moment of momentum about o1, body axes: (..., 6). Konoplev (1.5)"""
    return evaluate("momentum", (6,), argument("twist", twist, 6), body=checked_body(body))


def momentum_world(
    body: _core.RigidBody, position: ArrayLike, world_from_body: ArrayLike, twist: ArrayLike
) -> Array:
    """Z0 = L Theta V: linear momentum and moment of momentum about the world origin, world axes: (..., 6).

    Its rate is the wrench about that origin (1.7). Konoplev (1.5)
    """
    return evaluate(
        "momentum_world",
        (6,),
        argument("position", position, 3),
        rotation_argument("world_from_body", world_from_body),
        argument("twist", twist, 6),
        body=checked_body(body),
    )


def inverse_dynamics(body: _core.RigidBody, twist: ArrayLike, twist_rate: ArrayLike) -> Array:
    """F1 = Theta V* + Phi Theta V, the wrench (..., 6) that a motion needs.

    `twist_rate` V* (..., 6) is the derivative of the components of the twist in body axes. Konoplev (1.8)
    """
    return evaluate(
        "inverse_dynamics",
        (6,),
        argument("twist", twist, 6),
        argument("twist_rate", twist_rate, 6),
        body=checked_body(body),
    )


def quasi_acceleration(
    body: _core.RigidBody, twist: ArrayLike, wrench: ArrayLike, *, form: str = "blocks"
) -> Array:
    """V* (..., 6) of a body under a wrench.

    `form`: "1.8" solves (1.8), "1.11" multiplies out (1.11), "blocks" is the same at the mass centre and the
    fastest; they agree to rounding. Konoplev (1.8), (1.11)
    """
    form = choice("form", form, ("blocks", "1.8", "1.11"))
    return evaluate(
        f"quasi_acceleration.{form}",
        (6,),
        argument("twist", twist, 6),
        argument("wrench", wrench, 6),
        body=checked_body(body),
    )


def quasi_velocity(body: _core.RigidBody, twist: ArrayLike) -> QuasiVelocity:
    """The matrices of V* + Phi_pi V = Theta^-1 F1, Phi_pi = Theta^-1 Phi Theta. Konoplev (1.11)"""
    phi_pi = evaluate("quasi_velocity.Phi_pi", (6, 6), argument("twist", twist, 6), body=checked_body(body))
    return QuasiVelocity(body.spatial_inertia, body.inverse_spatial_inertia, force_cross(twist), phi_pi)


def gravity_wrench(
    body: _core.RigidBody, world_from_body: ArrayLike, acceleration: ArrayLike = (0.0, 0.0, 9.80665)
) -> Array:
    """G1 = S_c [C^T] (m g; m g): the wrench (..., 6) of uniform gravity, body axes about o1.

    `acceleration` g (..., 3) in world axes, m/s^2; the default has the third world axis down. Konoplev (1.12)
    """
    return evaluate(
        "gravity_wrench",
        (6,),
        rotation_argument("world_from_body", world_from_body),
        argument("acceleration", acceleration, 3),
        body=checked_body(body),
    )
