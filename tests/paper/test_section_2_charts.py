"""Section 2, kinematics: coordinates, angle-rate maps and their derivatives, (2.1)-(2.6)."""

import numpy as np

from freebody import RigidBody, forms
from freebody.verify.point_masses import Cloud, Motion

from . import reference as ref
from .agreement import FORMS, POINT_MASSES, ROUNDING, apply, assert_agree


def columns(angles: str, alpha: np.ndarray) -> list[np.ndarray]:
    """The axes of the three rotations in world axes, each turned by the rotations before it."""
    unit = np.eye(3)
    first, second, third = ("xyz".index(letter) for letter in angles)
    turned = ref.to_float(ref.elementary(first, ref.mp.mpf(alpha[0])))
    twice = turned @ ref.to_float(ref.elementary(second, ref.mp.mpf(alpha[1])))
    return [unit[first], turned @ unit[second], twice @ unit[third]]


def test_2_1_coordinates_place_every_particle(cloud: Cloud, motion: Motion, angles: str) -> None:
    turned = cloud.points @ np.swapaxes(forms.rotation(motion.q[..., 3:], angles), -1, -2)
    placed = motion.q[..., None, :3] + turned
    assert_agree(placed, cloud.paths(motion).value, within=POINT_MASSES)
    for alpha, got in zip(motion.q[..., 3:], forms.rotation(motion.q[..., 3:], angles), strict=True):
        assert_agree(got, ref.to_float(ref.rotation(angles, ref.vector(alpha))), within=ROUNDING)


def test_2_2_velocity_map(motion: Motion, angles: str) -> None:
    velocity_map = forms.velocity_map(motion.q, angles)
    assert_agree(apply(velocity_map, motion.q_dot), motion.twist, within=POINT_MASSES)
    inverse = forms.velocity_map_inverse(motion.q, angles)
    assert_agree(apply(inverse, motion.twist), motion.q_dot, within=POINT_MASSES)
    identity = np.broadcast_to(np.eye(6), inverse.shape)
    assert_agree(velocity_map @ inverse, identity, within=FORMS)
    alpha = motion.q[..., 3:]
    rotation = forms.rotation(alpha, angles)
    assert_agree(velocity_map[..., :3, :3], np.swapaxes(rotation, -1, -2), within=0.0)
    assert_agree(velocity_map[..., 3:, 3:], forms.rate_matrix_body(alpha, angles), within=0.0)
    assert not velocity_map[..., :3, 3:].any()
    assert not velocity_map[..., 3:, :3].any()


def test_2_3_angle_rate_maps(motion: Motion, angles: str) -> None:
    alpha, alpha_dot = motion.q[..., 3:], motion.q_dot[..., 3:]
    world, body = forms.rate_matrix_world(alpha, angles), forms.rate_matrix_body(alpha, angles)
    assert_agree(apply(world, alpha_dot), motion.angular_velocity_world, within=POINT_MASSES)
    assert_agree(apply(body, alpha_dot), motion.twist[..., 3:], within=POINT_MASSES)
    assert_agree(forms.rotation(alpha, angles) @ body, world, within=ROUNDING)
    for place, m0, m1 in zip(alpha, world, body, strict=True):
        assert_agree(m0, np.stack(columns(angles, place), axis=-1), within=ROUNDING)
        exact = ref.vector(place)
        assert_agree(m0, ref.to_float(ref.rates_matrix(angles, exact, world=True)), within=ROUNDING)
        assert_agree(m1, ref.to_float(ref.rates_matrix(angles, exact, world=False)), within=ROUNDING)


def test_2_3_inverse_maps(motion: Motion, angles: str) -> None:
    alpha = motion.q[..., 3:]
    for name in ("world", "body"):
        matrix = getattr(forms, f"rate_matrix_{name}")(alpha, angles)
        inverse = getattr(forms, f"rate_matrix_{name}_inverse")(alpha, angles)
        # 0.45 rad from the singularity the entries of the inverse are below 3: no loss to speak of.
        identity = np.broadcast_to(np.eye(3), matrix.shape)
        assert_agree(matrix @ inverse, identity, within=ROUNDING)
        assert_agree(inverse @ matrix, identity, within=ROUNDING)


def test_2_4_rate_of_the_velocity_map(body: RigidBody, motion: Motion, angles: str) -> None:
    g = forms.generalized(body, motion.q, motion.q_dot, angles)
    exact = []
    for q, q_dot in zip(motion.q, motion.q_dot, strict=True):
        along = ref.path(ref.vector(q), ref.vector(q_dot), [ref.mp.mpf(0)] * 6)

        def turn(t: ref.Number, along=along) -> ref.Matrix:
            return ref.rotation(angles, along(t)[3:]).T

        def rates(t: ref.Number, along=along) -> ref.Matrix:
            return ref.rates_matrix(angles, along(t)[3:], world=False)

        d_dot = np.zeros((6, 6))
        d_dot[:3, :3], d_dot[3:, 3:] = (ref.to_float(ref.derivative(f)) for f in (turn, rates))
        exact.append(d_dot)
    assert_agree(g.D @ g.D_inv_D_dot, np.array(exact), within=POINT_MASSES)


def test_2_5_rate_of_the_angle_rate_map(motion: Motion, angles: str) -> None:
    alpha, alpha_dot = motion.q[..., 3:], motion.q_dot[..., 3:]
    got = forms.rate_matrix_world_dot(alpha, alpha_dot, angles)
    for place, rate, m0_dot in zip(alpha, alpha_dot, got, strict=True):
        along = ref.path(ref.vector(place), ref.vector(rate), [ref.mp.mpf(0)] * 3)
        exact = ref.derivative(lambda t, along=along: ref.rates_matrix(angles, along(t), world=True))
        assert_agree(m0_dot, ref.to_float(exact), within=POINT_MASSES)


def test_2_5_k_stands_for_the_rate_of_the_map_on_the_rates_only(
    body: RigidBody, motion: Motion, angles: str
) -> None:
    g = forms.generalized(body, motion.q, motion.q_dot, angles)
    on_rates = apply(g.D_inv_D_dot, motion.q_dot)
    assert_agree(apply(g.K, motion.q_dot), on_rates, motion.q_dot, within=FORMS)
    difference = np.abs(g.K - g.D_inv_D_dot).max(axis=(-1, -2))
    assert (difference > 0.1 * np.abs(motion.angular_velocity_world).max(axis=-1)).all()
    omega = forms.skew(motion.angular_velocity_world)
    assert_agree(g.K[..., :3, :3], -omega, within=POINT_MASSES)
    m0 = forms.rate_matrix_world(motion.q[..., 3:], angles)
    assert_agree(m0 @ g.K[..., 3:, 3:], g.M0_dot, within=FORMS)
    assert not g.K[..., :3, 3:].any()
    assert not g.K[..., 3:, :3].any()


def test_2_6_angular_velocity_rotation_by_rotation(motion: Motion, angles: str) -> None:
    got = forms.angular_velocity_skew_world(motion.q[..., 3:], motion.q_dot[..., 3:], angles)
    exact = motion.rotation.rate @ motion.rotation.transposed.value
    assert_agree(got, exact, within=POINT_MASSES)
