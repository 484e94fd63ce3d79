"""Section 2, dynamics: equations in generalized coordinates, (2.4)-(2.13)."""

import mpmath as mp
import numpy as np
import pytest

from freebody import RigidBody, forms
from freebody.verify.point_masses import Cloud, Motion

from . import reference as ref
from .agreement import FORMS, POINT_MASSES, apply, assert_agree

ACCELERATION_FORMS = ("2.4", "2.7", "2.8", "2.9", "2.10", "blocks")


def assert_acceleration(cloud: Cloud, motion: Motion, form: str) -> None:
    """The form gives the motion's own second derivatives, and what every other form gives."""
    wrench = cloud.wrench(motion)
    state = cloud.body, motion.q, motion.q_dot, wrench, motion.angles
    got = forms.generalized_acceleration(*state, form=form)
    convective = apply(forms.generalized(*state[:3], motion.angles).Phi1, motion.q_dot)
    assert_agree(got, motion.q_ddot, convective, within=POINT_MASSES)
    for other in ACCELERATION_FORMS:
        expected = forms.generalized_acceleration(*state, form=other)
        assert_agree(got, expected, convective, within=FORMS)


def test_2_4_acceleration(cloud: Cloud, motion: Motion) -> None:
    assert_acceleration(cloud, motion, "2.4")
    g = forms.generalized(cloud.body, motion.q, motion.q_dot, motion.angles)
    phi_pi = forms.quasi_velocity(cloud.body, motion.twist).Phi_pi
    assert_agree(g.Phi_qD, g.D_inv @ phi_pi @ g.D, within=FORMS)
    # (Theta D)^-1 Phi (Theta D) is the same matrix.
    assert_agree(g.A1 @ g.Phi_qD, forms.force_cross(motion.twist) @ g.A1, within=FORMS)


def test_2_7_acceleration(cloud: Cloud, motion: Motion) -> None:
    assert_acceleration(cloud, motion, "2.7")
    assert_acceleration(cloud, motion, "blocks")
    g = forms.generalized(cloud.body, motion.q, motion.q_dot, motion.angles)
    assert_agree(g.A1, forms.spatial_inertia(cloud.body) @ g.D, within=FORMS)
    assert_agree(g.Phi1, g.K + g.Phi_qD, within=FORMS)


def test_2_8_balance(cloud: Cloud, motion: Motion) -> None:
    assert_acceleration(cloud, motion, "2.8")
    g = forms.generalized(cloud.body, motion.q, motion.q_dot, motion.angles)
    left = apply(g.A1, motion.q_ddot) + apply(g.B1, motion.q_dot)
    assert_agree(left, cloud.wrench(motion), within=POINT_MASSES)
    assert_agree(g.B1, g.A1 @ g.Phi1, within=FORMS)


def test_2_9_acceleration(cloud: Cloud, motion: Motion, angles: str) -> None:
    assert_acceleration(cloud, motion, "2.9")
    q, q_dot = motion.q, motion.q_dot
    force = forms.generalized_force(q, cloud.wrench(motion), angles)
    assert_agree(force, cloud.generalized_force(motion), within=POINT_MASSES)
    lag = forms.lagrange(cloud.body, q, q_dot, angles)
    assert_agree(lag.A, cloud.mass_matrix(motion), within=POINT_MASSES)
    g = forms.generalized(cloud.body, q, q_dot, angles)
    transposed = np.swapaxes(g.D, -1, -2)
    phi = forms.force_cross(motion.twist)
    assert_agree(lag.Phi_up_q @ transposed, transposed @ phi, within=FORMS)
    # The paper's remark in one line: Lagrange's terms are the same matrix, formed at a higher cost.
    assert_agree(lag.Phi_q, g.Phi1, within=FORMS)


def test_2_10_balance(cloud: Cloud, motion: Motion, angles: str) -> None:
    assert_acceleration(cloud, motion, "2.10")
    lag = forms.lagrange(cloud.body, motion.q, motion.q_dot, angles)
    left = apply(lag.A, motion.q_ddot) + apply(lag.B, motion.q_dot)
    assert_agree(left, cloud.generalized_force(motion), within=POINT_MASSES)
    g = forms.generalized(cloud.body, motion.q, motion.q_dot, angles)
    assert_agree(lag.B, np.swapaxes(g.D, -1, -2) @ g.B1, within=FORMS)


def test_2_11_lagrange_operator_on_point_masses(cloud: Cloud, motion: Motion, angles: str) -> None:
    got = forms.lagrange_operator(cloud.body, motion.q, motion.q_dot, motion.q_ddot, angles)
    assert_agree(got, cloud.generalized_force(motion), within=POINT_MASSES)
    lag = forms.lagrange(cloud.body, motion.q, motion.q_dot, angles)
    left = apply(lag.A, motion.q_ddot) + apply(lag.B, motion.q_dot)
    assert_agree(got, left, within=FORMS)


def test_2_11_lagrange_operator_by_fifty_digit_differentiation(rng: np.random.Generator, angles: str) -> None:
    # Three masses suffice for the energy of a body and keep the nested differences quick.
    cloud = Cloud.random(rng, count=3)
    motion = Motion.random(rng, angles)
    masses, points = ref.vector(cloud.masses), [ref.vector(r) for r in cloud.points]
    q, q_dot, q_ddot = map(ref.vector, (motion.q, motion.q_dot, motion.q_ddot))
    places = ref.path(q, q_dot, q_ddot)

    def energy(at: ref.Vector, rates: ref.Vector) -> ref.Matrix:
        return mp.matrix([ref.kinetic_energy(masses, points, angles, at, rates)])

    def speeds(t: ref.Number) -> ref.Vector:
        return ref.add(q_dot, q_ddot, t)

    expected = []
    for unit in ([mp.mpf(i == k) for i in range(6)] for k in range(6)):
        by_rate = ref.derivative(
            lambda t, e=unit: ref.derivative(lambda s: energy(places(t), ref.add(speeds(t), e, s)))
        )
        by_place = ref.derivative(lambda s, e=unit: energy(ref.add(q, e, s), q_dot))
        expected.append(float(by_rate[0] - by_place[0]))
    got = forms.lagrange_operator(cloud.body, motion.q, motion.q_dot, motion.q_ddot, angles)
    assert_agree(got, expected, within=POINT_MASSES)


def test_2_12_christoffel_symbols(cloud: Cloud, motion: Motion, angles: str) -> None:
    symbols = forms.christoffel_symbols(cloud.body, motion.q, angles)
    lag = forms.lagrange(cloud.body, motion.q, motion.q_dot, angles)
    lowered = np.einsum("...sr,...rij->...sij", lag.A, symbols)
    assert_agree(lowered, cloud.christoffel_first_kind(motion), lag.A, within=POINT_MASSES)
    assert_agree(symbols, np.swapaxes(symbols, -1, -2), within=FORMS)


def test_2_12_christoffel_sums(cloud: Cloud, motion: Motion, angles: str) -> None:
    lag = forms.lagrange(cloud.body, motion.q, motion.q_dot, angles)
    assert_agree(lag.christoffel, apply(lag.Phi_q, motion.q_dot), within=FORMS)
    symbols = forms.christoffel_symbols(cloud.body, motion.q, angles)
    sums = np.einsum("...sij,...i,...j->...s", symbols, motion.q_dot, motion.q_dot)
    assert_agree(lag.christoffel, sums, within=FORMS)


def test_2_12_christoffel_symbols_by_fifty_digit_differentiation(
    rng: np.random.Generator, angles: str
) -> None:
    cloud = Cloud.random(rng, count=3)
    q = Motion.random(rng, angles).q
    masses, points = ref.vector(cloud.masses), [ref.vector(r) for r in cloud.points]
    unit = [[mp.mpf(i == k) for i in range(6)] for k in range(6)]

    def mass_matrix(at: ref.Vector) -> ref.Matrix:
        tangents = [
            [
                ref.vector_derivative(lambda t, r=r, e=e: ref.position(angles, ref.add(at, e, t), r))
                for r in points
            ]
            for e in unit
        ]
        return mp.matrix(6, 6) + mp.matrix(
            [
                [mp.fsum(m * ref.dot(a, b) for m, a, b in zip(masses, x, y, strict=True)) for y in tangents]
                for x in tangents
            ]
        )

    exact = ref.vector(q)
    by_q = np.array(
        [ref.derivative(lambda t, e=e: mass_matrix(ref.add(exact, e, t))).tolist() for e in unit],
        dtype=object,
    )
    first_kind = (np.moveaxis(by_q, 0, 1) + np.moveaxis(by_q, 0, 2) - by_q) / 2
    inverse = np.array((mass_matrix(exact) ** -1).tolist(), dtype=object)
    expected = np.tensordot(inverse, first_kind, axes=1).astype(float)
    assert_agree(forms.christoffel_symbols(cloud.body, q, angles), expected, within=POINT_MASSES)


def test_2_13_rotation_about_the_mass_centre(cloud: Cloud, motion: Motion, angles: str) -> None:
    centred = Cloud(cloud.masses, cloud.points - cloud.com)
    inertia = centred.inertia_about(np.zeros(3))
    alpha, alpha_dot = motion.q[..., 3:], motion.q_dot[..., 3:]
    convective = apply(forms.generalized(cloud.body, motion.q, motion.q_dot, angles).Phi1, motion.q_dot)
    wrench = centred.wrench(motion)
    got = forms.rotation_acceleration(inertia, alpha, alpha_dot, wrench[..., 3:], angles)
    assert_agree(got, motion.q_ddot[..., 3:], convective, within=POINT_MASSES)
    # The lower half of (2.7), hence of (1.8), with the mass centre at the origin.
    body = RigidBody(cloud.mass, inertia_about_com=inertia)
    whole = forms.generalized_acceleration(body, motion.q, motion.q_dot, wrench, angles)
    assert_agree(got, whole[..., 3:], convective, within=FORMS)
    rate = forms.quasi_acceleration(body, motion.twist, wrench)[..., 3:]
    m1 = forms.rate_matrix_body(alpha, angles)
    g = forms.generalized(body, motion.q, motion.q_dot, angles)
    bias = np.einsum("...ji,...j->...i", g.C, apply(g.M0_dot, alpha_dot))
    assert_agree(apply(m1, got) + bias, rate, bias, within=FORMS)


@pytest.mark.parametrize("form", ACCELERATION_FORMS)
def test_2_7_all_sequences_give_one_motion(rng: np.random.Generator, cloud: Cloud, form: str) -> None:
    # The twist rate behind q_ddot does not depend on the sequence that q is written in.
    start = Motion.random(rng, "zyx")
    wrench = cloud.wrench(start)
    rotation = start.rotation.value
    for angles in forms.SEQUENCES:
        alpha = forms.angles_from_rotation(rotation, angles)
        q = np.concatenate([start.position.value, alpha])
        q_dot = forms.velocity_map_inverse(q, angles) @ start.twist
        q_ddot = forms.generalized_acceleration(cloud.body, q, q_dot, wrench, angles, form=form)
        again = Motion(angles, q, q_dot, q_ddot)
        # A sequence may draw near its singularity here: the distance, 0.05 rad at worst, costs its square.
        assert_agree(again.twist_rate, start.twist_rate, q_ddot, within=POINT_MASSES)
