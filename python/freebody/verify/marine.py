"""The marine vehicles: their matrices by another way, and what is published of them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from freebody._check import Array
from freebody.model_file import load_model, shipped_model

from .residual import Residual

__all__ = ["about_origin", "otter", "remus", "spheroid"]

# Sums of some dozens of doubles.
MATRIX = 1e-12


def about_origin(mass: float, com: ArrayLike, inertia: ArrayLike) -> Array:
    """M_RB about CO of a body with principal moments about its mass centre, by Fossen's HᵀMH: (6, 6)."""
    x, y, z = np.asarray(com)
    shift = np.eye(6)
    shift[:3, 3:] = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]
    return shift.T @ np.diag([mass, mass, mass, *np.asarray(inertia)]) @ shift


def spheroid(a: float, b: float) -> tuple[float, float, float]:
    """k₁, k₂, k′ of Lamb (articles 114, 115) by quadrature of his integrals, not by their closed forms."""
    # With √(a² + λ) = c coth s, c² = a² - b², both are smooth to the end: thirty points do it to rounding.
    nodes, weights = np.polynomial.legendre.leggauss(30)
    eccentric, end = a**2 - b**2, np.arccosh(a / b)
    s, weights = end * (nodes + 1.0) / 2.0, end * weights / eccentric**1.5
    along, across = weights @ np.tanh(s) ** 2, weights @ np.sinh(s) ** 2
    alpha, beta = a * b**2 * along, a * b**2 * across
    whole = a**2 + b**2
    turning = eccentric**2 * (alpha - beta) / ((whole * (beta - alpha) - 2.0 * eccentric) * whole)
    return alpha / (2.0 - alpha), beta / (2.0 - beta), turning


def remus() -> Iterator[Residual]:
    """A spheroid of water 1.6 m long, 0.19 m thick, its mass centre 2 cm below; and its speed."""
    file = load_model(shipped_model("remus_100"))
    case, a, b, density = "REMUS 100", 0.8, 0.095, 1026.0
    mass = 4.0 / 3.0 * np.pi * density * a * b**2
    moments = mass / 5.0 * np.array([2.0 * b**2, a**2 + b**2, a**2 + b**2])
    k1, k2, turning = spheroid(a, b)
    roll = 0.3 * moments[0]
    added = np.diag([k1 * mass, k2 * mass, k2 * mass, roll, turning * moments[1], turning * moments[1]])
    (element,) = (force for force in file.model.forces if force.added_mass is not None)
    yield _matrix(
        case,
        "M_RB about the origin",
        file.model.body.spatial_inertia,
        about_origin(mass, [0, 0, 0.02], moments),
    )
    assert element.added_mass is not None
    yield _matrix(case, "M_A about the origin", element.added_mass, added)
    # Allen, Vorus and Prestero (2000): 2.5 m/s at 1525 rpm, printed with two digits; the current is 0.3 m/s.
    run = file.model.simulate(file.x0, (0.0, 20.0), inputs=[0.0, 0.0, 1525.0 * np.pi / 30.0])
    speed = float(np.linalg.norm(run.velocity_world[-1] - [0.0, 0.3, 0.0]))
    yield Residual(case, "speed at 1525 rpm, published 2.5 m/s", abs(speed - 2.5), 0.05, "m/s")


def otter() -> Iterator[Residual]:
    """A hull and a payload, each with its inertia about its own mass centre; its speed."""
    file, case = load_model(shipped_model("otter")), "Otter"
    # Radii of gyration 0.4 B, L/4, L/4; the payload is a ball of 2 mm.
    hull = about_origin(55.0, [0.2, 0.0, -0.2], 55.0 * np.array([0.432, 0.5, 0.5]) ** 2)
    payload = about_origin(25.0, [0.0, 0.0, -0.35], 3 * [1e-5])
    body = file.model.body
    yield _matrix(case, "M_RB about the origin, shifted once", body.spatial_inertia, hull + payload)
    # Fossen's formulas for hull and payload, each shifted once; the shift made twice gives 16.679, 57 % more.
    roll = abs(float(body.inertia_about_com[0, 0]) - 10.651)
    yield Residual(case, "roll inertia about the mass centre, 10.651", roll, 5e-4, "kg m²")
    # Floats at rest in its current: heights of centres are typed to 1e-8 m.
    wrench = file.model.wrench(0.0, file.model.state(velocity_body=[0.2, 0.0, 0.0]), np.zeros(2))
    yield Residual(case, "wrench afloat at rest", float(np.abs(wrench).max()), 1e-4, "N, N m")
    # Munk's moment makes the straight course unstable; rounding takes some twenty seconds to turn it.
    run = file.model.simulate(file.x0, (0.0, 12.0), inputs=[1.0, 1.0])
    speed = (float(run.velocity_world[-1, 0]) - 0.2) / 0.5144
    yield Residual(case, "speed at full thrust, published 6 knots", abs(speed - 6.0), 0.05, "knots")


def _matrix(case: str, quantity: str, got: Array, wanted: Array) -> Residual:
    return Residual(case, quantity, float(np.abs(got - wanted).max() / np.abs(wanted).max()), MATRIX)
