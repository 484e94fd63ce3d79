"""Screws and their transport: (1.1)-(1.4), (1.9). Linear part first, SI units."""

from __future__ import annotations

from numpy.typing import ArrayLike

from freebody._check import Array, argument, rotation_argument
from freebody.forms._call import evaluate


def skew(vector: ArrayLike) -> Array:
    """The matrix of the cross product, skew(a) b = a x b: (..., 3) -> (..., 3, 3)."""
    return evaluate("skew", (3, 3), argument("vector", vector, 3))


def line_matrix(point: ArrayLike) -> Array:
    """S = diag(E, skew(point)): the screw of a force x applied at `point` is S (x; x).

    `point` (..., 3) in m, in the axes of x; moments are about their origin. Returns (..., 6, 6).
    Konoplev (1.1)
    """
    return evaluate("line_matrix", (6, 6), argument("point", point, 3))


def wrench_transform(position: ArrayLike, world_from_body: ArrayLike) -> Array:
    """L: a wrench or momentum about the body origin, body axes -> about the world origin, world axes.

    `position` (..., 3) of the body origin in world axes, m; `world_from_body` (..., 3, 3) rotation.
    Returns (..., 6, 6). Konoplev (1.2), (1.3)
    """
    return evaluate(
        "wrench_transform",
        (6, 6),
        argument("position", position, 3),
        rotation_argument("world_from_body", world_from_body),
    )


def wrench_transform_inverse(position: ArrayLike, world_from_body: ArrayLike) -> Array:
    """L^-1 in closed form; arguments and shape as in `wrench_transform`. Konoplev (1.4)"""
    return evaluate(
        "wrench_transform_inverse",
        (6, 6),
        argument("position", position, 3),
        rotation_argument("world_from_body", world_from_body),
    )


def force_cross(twist: ArrayLike) -> Array:
    """Phi = L^-1 dL/dt, the transport matrix of wrenches and momenta in body axes.

    `twist` (..., 6): velocity of the body origin (m/s) and angular velocity (rad/s), body axes.
    Returns (..., 6, 6). Konoplev (1.9)
    """
    return evaluate("force_cross", (6, 6), argument("twist", twist, 6))
