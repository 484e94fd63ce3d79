"""Dispersed mass properties: every draw is a body, whatever the numbers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import freebody as fb
from freebody.ensembles.mass_properties import (
    bodies,
    log_cholesky,
    of_log_cholesky,
    of_second_moments,
    principal,
)

from .scene import BODY

vectors = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3)
moments = st.lists(st.floats(1e-12, 1e6), min_size=3, max_size=3)
parameters = st.lists(st.floats(-12.0, 12.0), min_size=10, max_size=10)


def second_moments(inertia: np.ndarray) -> np.ndarray:
    return 0.5 * np.trace(inertia) * np.eye(3) - inertia


@given(moments, vectors)
def test_every_positive_second_moments_are_a_body(values: list[float], turn: list[float]):
    """Rods and discs too: the core checks that there is such a body."""
    _, axes = principal(BODY)
    (tensor,) = of_second_moments(np.array([values]), axes, np.array([turn]))
    assert (tensor == tensor.T).all()
    body = fb.RigidBody(1.0, inertia_about_com=tensor)
    sums = np.sort([values[1] + values[2], values[2] + values[0], values[0] + values[1]])
    # Only what is thinner than 1e-9 of the largest is changed, by less than that.
    np.testing.assert_allclose(body.principal_moments, sums, rtol=1e-8, atol=2e-9 * sums[2])


@given(parameters)
def test_every_log_cholesky_parameters_are_a_body(values: list[float]):
    one = of_log_cholesky(np.array([values]))
    (tensor,) = one.inertia_about_com
    assert (tensor == tensor.T).all()
    body = fb.RigidBody(one.mass[0], one.com[0], inertia_about_com=tensor)
    assert body.mass > 0.0


def test_log_cholesky_parameters_are_those_of_the_pseudo_inertia():
    """U of the ten parameters has the pseudo-inertia about the origin as its square: m, m c, ∫ r rᵀ dm."""
    a, d1, d2, d3, s12, s23, s13, t1, t2, t3 = log_cholesky(BODY)
    U = np.exp(a) * np.array(
        [
            [np.exp(d1), s12, s13, t1],
            [0.0, np.exp(d2), s23, t2],
            [0.0, 0.0, np.exp(d3), t3],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
    first = BODY.mass * BODY.com
    about_origin = second_moments(BODY.inertia_about_origin)
    pseudo = np.block([[about_origin, first[:, None]], [first[None], np.array([[BODY.mass]])]])
    # Rounding of a Cholesky factor of a well-conditioned matrix.
    np.testing.assert_allclose(U @ U.T, pseudo, rtol=1e-13, atol=1e-14)


def test_log_cholesky_returns_the_body():
    one = of_log_cholesky(log_cholesky(BODY)[None])
    np.testing.assert_allclose(one.mass[0], BODY.mass, rtol=1e-14)
    assert (one.com[0] == BODY.com).all()
    np.testing.assert_allclose(one.inertia_about_com[0], BODY.inertia_about_com, rtol=1e-13, atol=1e-14)


def test_principal_second_moments_stand_by_the_nearest_body_axes():
    values, axes = principal(BODY)
    np.testing.assert_allclose(
        axes @ np.diag(values) @ axes.T, second_moments(BODY.inertia_about_com), atol=1e-14
    )
    assert np.linalg.det(axes) == pytest.approx(1.0, abs=1e-14)
    assert (np.diag(axes) > 0.9).all()
    box = fb.RigidBody(3.0, inertia_about_com=np.diag([2.5, 1.0, 2.0]))
    values, axes = principal(box)
    np.testing.assert_allclose(values, [0.25, 1.75, 0.75])
    assert (axes == np.eye(3)).all()


def test_what_is_not_dispersed_stays_to_the_last_bit():
    one = bodies(BODY, {"mass": np.array([[11.0], [13.0]])}, 2)
    assert one is not None
    assert one.mass.tolist() == [11.0, 13.0]
    assert (one.com == BODY.com).all()
    assert (one.inertia_about_com == BODY.inertia_about_com).all()
    assert bodies(BODY, {"position": np.zeros((2, 3))}, 2) is None


def test_a_common_factor_multiplies_the_inertia():
    one = bodies(BODY, {"inertia": np.array([[1.0], [1.5]])}, 2)
    assert one is not None
    assert (one.inertia_about_com == np.array([1.0, 1.5])[:, None, None] * BODY.inertia_about_com).all()


def test_principal_axes_turn_the_inertia():
    """Turned by a vector in principal axes, its moments stay and its axes turn by that angle."""
    turn = np.array([0.1, -0.2, 0.05])
    one = bodies(BODY, {"principal_axes": turn[None]}, 1)
    assert one is not None
    body = fb.RigidBody(12.5, inertia_about_com=one.inertia_about_com[0])
    np.testing.assert_allclose(body.principal_moments, BODY.principal_moments, rtol=1e-13)
    _, before = principal(BODY)
    _, after = principal(body)
    angle = np.arccos((np.trace(before.T @ after) - 1.0) / 2.0)
    assert angle == pytest.approx(np.linalg.norm(turn), abs=1e-13)


def test_dispersed_bodies_are_the_same_alone_and_in_company():
    values = np.random.default_rng(1).normal(0.0, 0.2, (100, 10))
    together = bodies(BODY, {"log_cholesky": values}, 100)
    assert together is not None
    for i in (0, 57, 99):
        alone = bodies(BODY, {"log_cholesky": values[i : i + 1]}, 1)
        assert alone is not None
        assert all((a[0] == b[i]).all() for a, b in zip(alone, together, strict=True))
