"""Section 4: the orientation systems by name, and what holds for all twelve."""

import numpy as np
import pytest

from freebody import RigidBody, SingularChartError, forms
from freebody.verify.point_masses import Motion, is_proper_euler

from . import reference as ref
from .agreement import POINT_MASSES, ROUNDING, apply, assert_agree


def c1(a: float) -> np.ndarray:
    return np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])


def c2(a: float) -> np.ndarray:
    return np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])


def c3(a: float) -> np.ndarray:
    return np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])


@pytest.mark.parametrize(
    ("name", "angles", "factors"),
    [("Euler", "zxz", (c3, c1, c3)), ("ship", "zyx", (c3, c2, c1)), ("aircraft", "yzx", (c2, c3, c1))],
)
def test_4_worked_systems(name: str, angles: str, factors: tuple, rng: np.random.Generator) -> None:
    first, second, third = alpha = rng.uniform(-np.pi, np.pi, size=3)
    expected = factors[0](first) @ factors[1](second) @ factors[2](third)
    assert_agree(forms.rotation(alpha, angles), expected, within=ROUNDING)


def test_4_the_sequences_are_twelve() -> None:
    triples = {a + b + c for a in "xyz" for b in "xyz" for c in "xyz" if a != b != c}
    assert set(forms.SEQUENCES) == triples
    assert len(forms.SEQUENCES) == 12


def test_4_determinant_of_the_angle_rate_map(rng: np.random.Generator, angles: str) -> None:
    alpha = rng.uniform(-np.pi, np.pi, size=(50, 3))
    second = alpha[:, 1]
    expected = np.sin(second) if is_proper_euler(angles) else np.cos(second)
    got = np.linalg.det(forms.rate_matrix_world(alpha, angles))
    sign = np.sign(got[0] / expected[0])
    # Determinants of matrices of unit columns: absolute rounding, so relative to one.
    assert_agree(got, sign * expected, 1.0, within=ROUNDING)
    body = np.linalg.det(forms.rate_matrix_body(alpha, angles))
    assert_agree(body, got, 1.0, within=ROUNDING)


def test_4_distance_to_the_singularity(rng: np.random.Generator, angles: str) -> None:
    alpha = rng.uniform(-np.pi, np.pi, size=(50, 3))
    second = alpha[:, 1]
    determinant = np.sin(second) if is_proper_euler(angles) else np.cos(second)
    # asin loses half its digits near one, which is where the distance is pi/2 and its cosine tells more.
    distance = forms.singularity_distance(alpha, angles)
    assert_agree(np.sin(distance), np.abs(determinant), 1.0, within=ROUNDING)
    assert (distance >= 0.0).all()
    assert (distance <= np.pi / 2 + 1e-15).all()


@pytest.mark.parametrize("turns", [0, 1, 50])
def test_4_no_rates_at_the_singularity(turns: int, angles: str, body: RigidBody) -> None:
    second = turns * np.pi + (0.0 if is_proper_euler(angles) else np.pi / 2)
    q = np.array([1.0, 2.0, 3.0, 0.4, second, -0.7])
    zero = np.zeros(6)
    calls = [
        lambda: forms.rate_matrix_world_inverse(q[3:], angles),
        lambda: forms.rate_matrix_body_inverse(q[3:], angles),
        lambda: forms.velocity_map_inverse(q, angles),
        lambda: forms.generalized(body, q, zero, angles),
        lambda: forms.lagrange(body, q, zero, angles),
        lambda: forms.christoffel_symbols(body, q, angles),
        lambda: forms.generalized_acceleration(body, q, zero, zero, angles),
        lambda: forms.phase_velocity(body, np.concatenate([q, zero]), zero, angles),
        lambda: forms.rotation_acceleration(np.eye(3), q[3:], zero[:3], zero[:3], angles),
    ]
    for call in calls:
        with pytest.raises(SingularChartError, match=rf"'{angles}' is {np.rad2deg(second):.12g} deg"):
            call()
    # The body is not a bad body there: what needs no inverse stays finite.
    assert np.isfinite(forms.rotation(q[3:], angles)).all()
    assert np.isfinite(forms.rate_matrix_world(q[3:], angles)).all()
    assert np.isfinite(forms.lagrange_operator(body, q, zero + 1.0, zero, angles)).all()


def test_4_angular_velocity_in_both_frames(motion: Motion, angles: str) -> None:
    alpha, alpha_dot = motion.q[..., 3:], motion.q_dot[..., 3:]
    world = forms.angular_velocity_skew_world(alpha, alpha_dot, angles)
    rotation = forms.rotation(alpha, angles)
    in_body = forms.skew(apply(forms.rate_matrix_body(alpha, angles), alpha_dot))
    assert_agree(np.swapaxes(rotation, -1, -2) @ world @ rotation, in_body, within=POINT_MASSES)
    partial = forms.skew(apply(forms.rate_matrix_world(alpha, angles), alpha_dot))
    assert_agree(world, partial, within=POINT_MASSES)


def test_4_angles_of_a_rotation(rng: np.random.Generator, angles: str) -> None:
    motion = Motion.random(rng, angles, (50,))
    rotation = motion.rotation.value
    alpha = forms.angles_from_rotation(rotation, angles)
    assert_agree(forms.rotation(alpha, angles), rotation, within=ROUNDING)
    second = alpha[:, 1]
    low, high = (0.0, np.pi) if is_proper_euler(angles) else (-np.pi / 2, np.pi / 2)
    assert (second >= low).all()
    assert (second <= high).all()


def test_4_angles_of_a_rotation_at_the_singularity(angles: str) -> None:
    singular = (0.0, np.pi) if is_proper_euler(angles) else (-np.pi / 2, np.pi / 2)
    for second in singular:
        rotation = forms.rotation([0.7, second, -1.9], angles)
        alpha = forms.angles_from_rotation(rotation, angles)
        assert alpha[0] == 0.0
        # The two doubles nearest to a multiple of pi are off by up to 1e-16, the whole by a few of those.
        assert_agree(forms.rotation(alpha, angles), rotation, within=ROUNDING)


def test_4_quaternion_and_rotation(rng: np.random.Generator, motion: Motion) -> None:
    rotation = motion.rotation.value
    quaternion = forms.quaternion_from_rotation(rotation)
    assert_agree(np.linalg.norm(quaternion, axis=-1), np.ones(len(quaternion)), within=ROUNDING)
    assert (quaternion[:, 0] >= 0.0).all()
    for scale in (1.0, 3.0):
        assert_agree(forms.rotation_from_quaternion(scale * quaternion), rotation, within=ROUNDING)
    for q, c in zip(quaternion, rotation, strict=True):
        assert_agree(c, ref.to_float(ref.rotation_of_quaternion(ref.vector(q))), within=ROUNDING)


def test_4_quaternion_of_half_turns() -> None:
    for axis in ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.8, 0.0], [-0.6, 0.0, 0.8]):
        rotation = 2.0 * np.outer(axis, axis) - np.eye(3)
        quaternion = forms.quaternion_from_rotation(rotation)
        assert_agree(np.abs(quaternion @ [0.0, *axis]), 1.0, within=ROUNDING)


def test_4_quaternion_rate(motion: Motion) -> None:
    quaternion = forms.quaternion_from_rotation(motion.rotation.value)
    rate = forms.quaternion_rate(quaternion, motion.twist[..., 3:])
    for q, q_dot, c_dot in zip(quaternion, rate, motion.rotation.rate, strict=True):
        start, slope = ref.vector(q), ref.vector(q_dot)
        exact = ref.derivative(lambda t, a=start, b=slope: ref.rotation_of_quaternion(ref.add(a, b, t)))
        assert_agree(ref.to_float(exact), c_dot, within=POINT_MASSES)
