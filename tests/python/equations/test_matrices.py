"""Single matrices, printed by name, are those of `freebody.forms`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody import forms
from freebody.equations.forms import MATRICES

from . import languages
from .kernel import AGREE, POINTS, VANISHING, Array, Values, parameters, random_arguments

BODY = fb.RigidBody(
    2.5, (0.3, -0.2, 0.4), inertia_about_com=[[1.2, 0.1, -0.2], [0.1, 1.5, 0.3], [-0.2, 0.3, 0.9]]
)
Matrix = Callable[[Values, str], Array]

KERNELS: dict[str, Matrix] = {
    "Theta": lambda g, angles: forms.spatial_inertia(BODY),
    "Theta_inv": lambda g, angles: BODY.inverse_spatial_inertia,
    "L": lambda g, angles: forms.wrench_transform(g["position"], forms.rotation(g["alpha"], angles)),
    "L_inv": lambda g, angles: forms.wrench_transform_inverse(
        g["position"], forms.rotation(g["alpha"], angles)
    ),
    "Phi": lambda g, angles: forms.force_cross(g["twist"]),
    "Phi_pi": lambda g, angles: forms.quasi_velocity(BODY, g["twist"]).Phi_pi,
    "C": lambda g, angles: forms.rotation(g["alpha"], angles),
    "M0": lambda g, angles: forms.rate_matrix_world(g["alpha"], angles),
    "M1": lambda g, angles: forms.rate_matrix_body(g["alpha"], angles),
    "M0_inv": lambda g, angles: forms.rate_matrix_world_inverse(g["alpha"], angles),
    "M1_inv": lambda g, angles: forms.rate_matrix_body_inverse(g["alpha"], angles),
    "M0_dot": lambda g, angles: forms.rate_matrix_world_dot(g["alpha"], g["alpha_dot"], angles),
    "omega_skew_world": lambda g, angles: forms.angular_velocity_skew_world(
        g["alpha"], g["alpha_dot"], angles
    ),
    "D": lambda g, angles: forms.velocity_map(g["q"], angles),
    "D_inv": lambda g, angles: forms.velocity_map_inverse(g["q"], angles),
    **{
        name: lambda g, angles, name=name: getattr(forms.generalized(BODY, g["q"], g["q_dot"], angles), name)
        for name in ("K", "A1", "B1", "Phi1", "Phi_qD", "D_inv_D_dot")
    },
    **{
        name: lambda g, angles, name=name: getattr(forms.lagrange(BODY, g["q"], g["q_dot"], angles), name)
        for name in ("A", "B", "Phi_q", "Phi_up_q")
    },
    "christoffel_symbols": lambda g, angles: forms.christoffel_symbols(BODY, g["q"], angles),
}


def cubes(array: Array) -> Array:
    """The norms of what stands together in like units: blocks of 3 x 3, or 3 x 3 x 3, by point."""
    n, *shape = array.shape
    parts = array.reshape(n, *(x for size in shape for x in (size // 3, 3)))
    return np.sqrt((parts**2).sum(axis=tuple(range(2, parts.ndim, 2))))


def arguments(angles: str) -> Values:
    g = random_arguments(np.random.default_rng(1984), angles, POINTS)
    return {**g, "body": np.tile(parameters(BODY), (POINTS, 1))}


def check(name: str, angles: str, way: bool, run: languages.Run) -> None:
    equations = fb.equations(name, angles, simplify=way)
    g = arguments(angles)
    (got,) = run(equations, {argument: g[argument] for argument in equations.arguments})
    wanted = KERNELS[name](g, angles)
    wanted = np.broadcast_to(wanted, (POINTS, *wanted.shape[-2 if name != "christoffel_symbols" else -3 :]))
    got = got.reshape(wanted.shape)
    # Blocks that are zero are what rounding left of their neighbours.
    scale = np.maximum(cubes(wanted), VANISHING * cubes(wanted).max())
    assert (cubes(got - wanted) / scale).max() < AGREE


def test_every_matrix_has_its_kernel() -> None:
    assert KERNELS.keys() == MATRICES.keys()


@pytest.mark.parametrize("way", [True, False], ids=["simplified", "literal"])
@pytest.mark.parametrize("angles", forms.SEQUENCES)
@pytest.mark.parametrize("name", KERNELS)
def test_matrix_is_the_kernels(name: str, angles: str, way: bool) -> None:
    check(name, angles, way, languages.run_graph)


@pytest.mark.parametrize("language", languages.PYTHONIC)
@pytest.mark.parametrize("name", KERNELS)
def test_printed_python_computes_the_matrix(name: str, language: str) -> None:
    check(name, "zyx", True, languages.PYTHONIC[language])


def test_printed_c_computes_the_matrix(tmp_path: Path) -> None:
    library = languages.Library(tmp_path, {f"f_{name}": fb.equations(name, "zyx") for name in KERNELS})
    for name in KERNELS:
        check(name, "zyx", True, lambda _, given, name=name: library.run(f"f_{name}", given))
