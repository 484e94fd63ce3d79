"""Orientation: angles of the twelve sequences (2.1)-(2.6), quaternions, rotation matrices.

`angles` names an intrinsic sequence such as "zyx"; alpha (..., 3) are its angles, rad, alpha_dot their rates,
rad/s. A quaternion is (w, x, y, z). Every rotation matrix (..., 3, 3) is world_from_body.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from freebody._check import Argument, Array, argument, rotation_argument, sequence
from freebody.errors import InputError
from freebody.forms._call import evaluate, orientation, regular


def rotation(alpha: ArrayLike, angles: str) -> Array:
    """C = C_i1(alpha1) C_i2(alpha2) C_i3(alpha3): (..., 3, 3). Konoplev (2.3)"""
    return evaluate("rotation", (3, 3), argument("alpha", alpha, 3), angles=sequence(angles))


def rate_matrix_world(alpha: ArrayLike, angles: str) -> Array:
    """M0 (..., 3, 3): the angular velocity in world axes is M0 alpha_dot. Konoplev (2.3)"""
    return evaluate("rate_matrix_world", (3, 3), argument("alpha", alpha, 3), angles=sequence(angles))


def rate_matrix_body(alpha: ArrayLike, angles: str) -> Array:
    """M1 = C^T M0 (..., 3, 3): the angular velocity in body axes is M1 alpha_dot. Konoplev (2.3)"""
    return evaluate("rate_matrix_body", (3, 3), argument("alpha", alpha, 3), angles=sequence(angles))


def rate_matrix_world_inverse(alpha: ArrayLike, angles: str) -> Array:
    """M0^-1 (..., 3, 3) in closed form; SingularChartError where it does not exist. Konoplev (2.3)"""
    return _inverse("rate_matrix_world_inverse", argument("alpha", alpha, 3), sequence(angles))


def rate_matrix_body_inverse(alpha: ArrayLike, angles: str) -> Array:
    """M1^-1 (..., 3, 3) in closed form; SingularChartError where it does not exist. Konoplev (2.3)"""
    return _inverse("rate_matrix_body_inverse", argument("alpha", alpha, 3), sequence(angles))


def _inverse(name: str, alpha: Argument, angles: str) -> Array:
    regular(alpha, angles)
    return evaluate(name, (3, 3), alpha, angles=angles)


def rate_matrix_world_dot(alpha: ArrayLike, alpha_dot: ArrayLike, angles: str) -> Array:
    """The time derivative of M0 (..., 3, 3). Konoplev (2.5)"""
    return evaluate(
        "rate_matrix_world_dot",
        (3, 3),
        argument("alpha", alpha, 3),
        argument("alpha_dot", alpha_dot, 3),
        angles=sequence(angles),
    )


def angular_velocity_skew_world(alpha: ArrayLike, alpha_dot: ArrayLike, angles: str) -> Array:
    """The skew matrix of the angular velocity in world axes, summed over the rotations. Konoplev (2.6)"""
    return evaluate(
        "angular_velocity_skew_world",
        (3, 3),
        argument("alpha", alpha, 3),
        argument("alpha_dot", alpha_dot, 3),
        angles=sequence(angles),
    )


def singularity_distance(alpha: ArrayLike, angles: str) -> Array:
    """Distance (...) in rad of the second angle from the nearest one where M0 is singular (section 4)."""
    return evaluate("singularity_distance", (), argument("alpha", alpha, 3), angles=sequence(angles))


def velocity_map(q: ArrayLike, angles: str) -> Array:
    """D = diag(C^T, M1) (..., 6, 6): the twist is D q_dot.

    q (..., 6) is the position of the body origin in world axes, m, and alpha. Konoplev (2.2)
    """
    return evaluate("velocity_map", (6, 6), argument("q", q, 6), angles=sequence(angles))


def velocity_map_inverse(q: ArrayLike, angles: str) -> Array:
    """D^-1 = diag(C, M1^-1) (..., 6, 6); SingularChartError where it does not exist. Konoplev (2.2)"""
    checked = argument("q", q, 6)
    regular(orientation(checked), sequence(angles))
    return evaluate("velocity_map_inverse", (6, 6), checked, angles=angles)


def rotation_from_quaternion(quaternion: ArrayLike) -> Array:
    """The rotation (..., 3, 3) of a quaternion (..., 4) of any length but zero."""
    checked = argument("quaternion", quaternion, 4)
    if not checked.array.any(axis=-1).all():
        raise InputError("quaternion: got (0, 0, 0, 0), which is no rotation; the identity is (1, 0, 0, 0)")
    return evaluate("rotation_from_quaternion", (3, 3), checked)


def quaternion_from_rotation(rotation: ArrayLike) -> Array:
    """The unit quaternion (..., 4) of a rotation matrix, with w >= 0."""
    return evaluate("quaternion_from_rotation", (4,), rotation_argument("rotation", rotation))


def angles_from_rotation(rotation: ArrayLike, angles: str) -> Array:
    """The angles (..., 3) of a rotation matrix in one sequence.

    The second lies in [-pi/2, pi/2] for Tait-Bryan and in [0, pi] for proper Euler sequences. At the
    singularity only the sum or difference of the first and third exists; the first is then zero.
    """
    return evaluate(
        "angles_from_rotation", (3,), rotation_argument("rotation", rotation), angles=sequence(angles)
    )


def quaternion_rate(quaternion: ArrayLike, angular_velocity_body: ArrayLike) -> Array:
    """The derivative (..., 4) of a quaternion under an angular velocity (..., 3) in body axes, rad/s."""
    return evaluate(
        "quaternion_rate",
        (4,),
        argument("quaternion", quaternion, 4),
        argument("angular_velocity_body", angular_velocity_body, 3),
    )
