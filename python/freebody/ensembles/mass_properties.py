"""Mass properties of many bodies, in forms of which every value is a body.

A body is a density that is nowhere negative. Its second moments of mass about the mass centre,
Σ = ∫ r rᵀ dm = ½ tr(J) E - J, may be any positive definite matrix, which the inertia tensor J may not; so it
is Σ that is dispersed: through its principal values and axes, or through the logarithms of a Cholesky factor.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from freebody import forms
from freebody._check import Array
from freebody.body import RigidBody
from freebody.ensembles.rotations import rotation_of_vector
from freebody.errors import InputError

__all__ = [
    "LOG_CHOLESKY",
    "Bodies",
    "bodies",
    "log_cholesky",
    "of_log_cholesky",
    "of_second_moments",
    "principal",
]

LOG_CHOLESKY = ("alpha", "d_1", "d_2", "d_3", "s_12", "s_23", "s_13", "t_1", "t_2", "t_3")
"""The names of the parameters of `log_cholesky`."""

# The core takes no rod that is thinner than the square root of 1e-9 of its length.
_THINNEST = 1e-9


class Bodies(NamedTuple):
    """Masses (n,) kg, mass centres (n, 3) m, inertia tensors about them (n, 3, 3) kg m²."""

    mass: Array
    com: Array
    inertia_about_com: Array


def bodies(body: RigidBody, values: Mapping[str, Array], n: int) -> Bodies | None:
    """The bodies of n runs, of draws (n, k) by the names of quantities; None where all are `body`.

    What is not dispersed stays: a mass that is dispersed leaves the inertia about the mass centre as it is.
    """
    if "log_cholesky" in values:
        return of_log_cholesky(log_cholesky(body) + values["log_cholesky"])
    if not values.keys() & {"mass", "com", "inertia", "second_moments", "principal_axes"}:
        return None
    mass = np.ascontiguousarray(values["mass"][:, 0]) if "mass" in values else np.full(n, body.mass)
    com = values.get("com", np.tile(body.com, (n, 1)))
    inertia = np.tile(body.inertia_about_com, (n, 1, 1))
    if "second_moments" in values or "principal_axes" in values:
        moments, axes = principal(body)
        moments = values.get("second_moments", np.tile(moments, (n, 1)))
        inertia = of_second_moments(moments, axes, values.get("principal_axes"))
    if "inertia" in values:
        inertia = values["inertia"][:, :, None] * inertia
    return Bodies(mass, np.ascontiguousarray(com), np.ascontiguousarray(inertia))


def principal(body: RigidBody) -> tuple[Array, Array]:
    """The principal second moments (3,) kg m² of a body and its principal axes (3, 3), columns in body axes.

    The first is that of the axis next to the first body axis, and so on.
    """
    values, axes = np.linalg.eigh(_second_moments(body.inertia_about_com))
    order = max(
        itertools.permutations(range(3)), key=lambda p: np.prod([abs(axes[i, p[i]]) for i in range(3)])
    )
    values, axes = values[list(order)], axes[:, order]
    axes = axes * np.where(np.diag(axes) < 0.0, -1.0, 1.0)
    if np.linalg.det(axes) < 0.0:
        axes[:, int(np.argmin(np.diag(axes)))] *= -1.0
    return np.maximum(values, 0.0), axes


def of_second_moments(moments: Array, axes: Array, turn: Array | None) -> Array:
    """Inertia tensors (n, 3, 3) of principal second moments (n, 3).

    Parameters
    ----------
    axes
        The principal axes before they are turned, (3, 3), columns.
    turn
        Rotation vectors (n, 3) rad in these axes, or None.
    """
    solid = np.maximum(moments, _THINNEST * moments.max(axis=1)[:, None])
    x, y, z = solid.T
    about = np.stack([y + z, z + x, x + y], axis=1)
    turned = np.broadcast_to(axes, (len(moments), 3, 3))
    if turn is not None:
        turned = np.matmul(turned, forms.rotation_from_quaternion(rotation_of_vector(turn)))
    return sum_of_squares(turned, about)


def sum_of_squares(factors: Array, weights: Array) -> Array:
    """Σₖ wₖ fₖ fₖᵀ (n, 3, 3) of columns fₖ of (n, 3, 3) and weights (n, 3): symmetric to the last bit."""
    f, w = np.ascontiguousarray(np.moveaxis(factors, 0, -1)), weights.T
    sums = np.empty(factors.shape)
    for i, j in itertools.combinations_with_replacement(range(3), 2):
        entry = w[0] * (f[i, 0] * f[j, 0]) + w[1] * (f[i, 1] * f[j, 1]) + w[2] * (f[i, 2] * f[j, 2])
        sums[:, i, j] = sums[:, j, i] = entry
    return sums


def log_cholesky(body: RigidBody) -> Array:
    """The ten parameters of a body: (α, d₁, d₂, d₃, s₁₂, s₂₃, s₁₃, t₁, t₂, t₃).

    Its pseudo-inertia about the origin is U Uᵀ with U = eᵅ [[e^d₁, s₁₂, s₁₃, t₁], [0, e^d₂, s₂₃, t₂],
    [0, 0, e^d₃, t₃], [0, 0, 0, 1]] (Rucker and Wensing, Smooth parameterization of rigid-body inertia, IEEE
    Robotics and Automation Letters 7(2), 2022). So t is the mass centre in m, e^2α the mass in kg.
    """
    try:
        lower = np.linalg.cholesky(_second_moments(body.inertia_about_com)[::-1, ::-1] / body.mass)
    except np.linalg.LinAlgError:
        raise InputError(
            f"log_cholesky: body {body.name!r} is flat or a rod, and has no logarithm; disperse 'mass', "
            "'com', 'inertia' and 'principal_axes'"
        ) from None
    s = lower[::-1, ::-1]
    return np.array(
        [0.5 * np.log(body.mass), *np.log(np.diag(s)), s[0, 1], s[1, 2], s[0, 2], *body.com.tolist()]
    )


def of_log_cholesky(parameters: Array) -> Bodies:
    """The bodies of parameters (n, 10)."""
    alpha, d1, d2, d3, s12, s23, s13, *center = parameters.T
    mass, zero = np.exp(2.0 * alpha), np.zeros(len(parameters))
    rows = [[np.exp(d1), s12, s13], [zero, np.exp(d2), s23], [zero, zero, np.exp(d3)]]
    factor = np.stack([np.stack(row, axis=1) for row in rows], axis=1)
    second = sum_of_squares(factor, np.broadcast_to(mass[:, None], (len(mass), 3)))
    inertia = _trace(second) * np.eye(3) - second
    # Thinner than any body of the core is made as thin as one can be.
    moments = np.linalg.eigvalsh(inertia)
    thin = moments[:, 0] < 2.0 * _THINNEST * moments[:, 2]
    return Bodies(
        mass,
        np.stack(center, axis=1),
        np.where(thin[:, None, None], inertia + 2.0 * _THINNEST * _trace(second) * np.eye(3), inertia),
    )


def _second_moments(inertia: Array) -> Array:
    return 0.5 * np.trace(inertia) * np.eye(3) - inertia


def _trace(matrices: Array) -> Array:
    return (matrices[:, 0, 0] + matrices[:, 1, 1] + matrices[:, 2, 2])[:, None, None]
