"""Equations in generalized coordinates: (2.1)-(2.10), (2.13), (3.1).

q (..., 6) is the position of the body origin in world axes (m) and the angles of the sequence `angles` (rad);
q_dot and q_ddot are its derivatives. A wrench F1 (..., 6) is in body axes about the body origin. Where the
angles are at the singularity of their chart the forms raise SingularChartError.
"""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from freebody import _core
from freebody._check import Array, argument, choice, inertia_argument, sequence
from freebody.forms._call import checked_body, evaluate, orientation, regular

ACCELERATION_FORMS = ("blocks", "2.4", "2.7", "2.8", "2.9", "2.10")


class Generalized(NamedTuple):
    """The matrices of forms (2.2)-(2.8): the first four (..., 3, 3), the others (..., 6, 6)."""

    C: Array
    M0: Array
    M1: Array
    M0_dot: Array
    D: Array
    D_inv: Array
    K: Array
    A1: Array
    B1: Array
    Phi1: Array
    Phi_qD: Array
    D_inv_D_dot: Array


def generalized(body: _core.RigidBody, q: ArrayLike, q_dot: ArrayLike, angles: str) -> Generalized:
    """The matrices of q_ddot + Phi1 q_dot = A1^-1 F1 and A1 q_ddot + B1 q_dot = F1. Konoplev (2.2)-(2.8)"""
    checked_body(body)
    sequence(angles)
    coordinates, rates = argument("q", q, 6), argument("q_dot", q_dot, 6)
    alpha = orientation(coordinates)
    alpha_dot = orientation(rates)
    regular(alpha, angles)

    def of_motion(name: str) -> Array:
        return evaluate(f"generalized.{name}", (6, 6), coordinates, rates, angles=angles, body=body)

    return Generalized(
        C=evaluate("rotation", (3, 3), alpha, angles=angles),
        M0=evaluate("rate_matrix_world", (3, 3), alpha, angles=angles),
        M1=evaluate("rate_matrix_body", (3, 3), alpha, angles=angles),
        M0_dot=evaluate("rate_matrix_world_dot", (3, 3), alpha, alpha_dot, angles=angles),
        D=evaluate("velocity_map", (6, 6), coordinates, angles=angles),
        D_inv=evaluate("velocity_map_inverse", (6, 6), coordinates, angles=angles),
        K=of_motion("K"),
        A1=of_motion("A1"),
        B1=of_motion("B1"),
        Phi1=of_motion("Phi1"),
        Phi_qD=of_motion("Phi_qD"),
        D_inv_D_dot=of_motion("D_inv_D_dot"),
    )


def generalized_force(q: ArrayLike, wrench: ArrayLike, angles: str) -> Array:
    """Q = D^T F1 (..., 6): N for the position, N m for the angles. Konoplev (2.9)"""
    return evaluate(
        "generalized_force",
        (6,),
        argument("q", q, 6),
        argument("wrench", wrench, 6),
        angles=sequence(angles),
    )


def generalized_acceleration(
    body: _core.RigidBody,
    q: ArrayLike,
    q_dot: ArrayLike,
    wrench: ArrayLike,
    angles: str,
    *,
    form: str = "blocks",
) -> Array:
    """q_ddot (..., 6) of a body under a wrench.

    `form`: "2.4", "2.7", "2.8", "2.9", "2.10" evaluate that equation as it stands, "blocks" reduces it to the
    mass centre and is the fastest; they agree to rounding. Konoplev (2.4), (2.7)-(2.10)
    """
    form = choice("form", form, ACCELERATION_FORMS)
    coordinates = argument("q", q, 6)
    regular(orientation(coordinates), sequence(angles))
    return evaluate(
        f"generalized_acceleration.{form}",
        (6,),
        coordinates,
        argument("q_dot", q_dot, 6),
        argument("wrench", wrench, 6),
        angles=angles,
        body=checked_body(body),
    )


def rotation_acceleration(
    inertia: ArrayLike, alpha: ArrayLike, alpha_dot: ArrayLike, moment: ArrayLike, angles: str
) -> Array:
    """alpha_ddot (..., 3) of a body turning about its mass centre.

    `inertia` (..., 3, 3) about the mass centre, kg m^2, and `moment` (..., 3), N m, in body axes.
    Konoplev (2.13)
    """
    checked = argument("alpha", alpha, 3)
    regular(checked, sequence(angles))
    return evaluate(
        "rotation_acceleration",
        (3,),
        inertia_argument("inertia", inertia),
        checked,
        argument("alpha_dot", alpha_dot, 3),
        argument("moment", moment, 3),
        angles=angles,
    )


def phase_velocity(body: _core.RigidBody, x: ArrayLike, wrench: ArrayLike, angles: str) -> Array:
    """x_dot = (q_dot; q_ddot) of the phase point x = (q; q_dot): (..., 12). Konoplev (3.1)"""
    point = argument("x", x, 12)
    regular(orientation(point), sequence(angles))
    return evaluate(
        "phase_velocity",
        (12,),
        point,
        argument("wrench", wrench, 6),
        angles=angles,
        body=checked_body(body),
    )
