"""Section 1: screws and quasi-velocities, (1.1)-(1.12)."""

import numpy as np
import pytest

from freebody import RigidBody, forms
from freebody.verify.point_masses import Cloud, Motion

from . import reference as ref
from .agreement import FORMS, POINT_MASSES, ROUNDING, apply, assert_agree

SHIP = "zyx"


@pytest.fixture
def angles() -> str:
    """Section 1 knows no angles: one sequence draws the random attitudes."""
    return SHIP


def test_1_1_screw_of_a_sliding_vector(rng: np.random.Generator) -> None:
    point, force = rng.normal(size=(2, 5, 3))
    screw = apply(forms.line_matrix(point), np.concatenate([force, force], axis=-1))
    assert_agree(screw, np.concatenate([force, np.cross(point, force)], axis=-1), within=ROUNDING)
    slid = apply(forms.line_matrix(point + 2.5 * force), np.concatenate([force, force], axis=-1))
    # Sliding along its line does not change it; the products that cancel are the larger arm's.
    assert_agree(slid, screw, 2.5 * force**2, within=ROUNDING)


def test_1_1_skew_matrix_is_the_cross_product(rng: np.random.Generator) -> None:
    a, b = rng.normal(size=(2, 5, 3))
    assert_agree(apply(forms.skew(a), b), np.cross(a, b), within=ROUNDING)


def test_1_2_wrench_transform(cloud: Cloud, motion: Motion) -> None:
    transform = forms.wrench_transform(motion.position.value, motion.rotation.value)
    assert_agree(apply(transform, cloud.wrench(motion)), cloud.wrench_world(motion), within=POINT_MASSES)


def test_1_3_translation_after_rotation(motion: Motion) -> None:
    position, rotation = motion.position.value, motion.rotation.value
    translation = forms.wrench_transform(position, np.eye(3))
    turn = forms.wrench_transform(np.zeros(3), rotation)
    assert_agree(translation @ turn, forms.wrench_transform(position, rotation), within=ROUNDING)
    assert_agree(turn[..., 3:, :3], np.zeros_like(rotation), 1.0, within=0.0)
    assert_agree(translation[..., 3:, :3], forms.skew(position), within=0.0)


def test_1_4_transforms_form_a_group(rng: np.random.Generator) -> None:
    first, second, third = (Motion.random(rng, angles, (5,)) for angles in ("zxz", "zyx", "yzx"))
    position, rotation = np.zeros(3), np.eye(3)
    product = np.eye(6)
    for step in (first, second, third):
        position = position + apply(rotation, step.position.value)
        rotation = rotation @ step.rotation.value
        product = product @ forms.wrench_transform(step.position.value, step.rotation.value)
    assert_agree(product, forms.wrench_transform(position, rotation), within=FORMS)


def test_1_4_inverse(motion: Motion) -> None:
    frame = motion.position.value, motion.rotation.value
    transform, inverse = forms.wrench_transform(*frame), forms.wrench_transform_inverse(*frame)
    identity = np.broadcast_to(np.eye(6), transform.shape)
    assert_agree(transform @ inverse, identity, transform**2, within=ROUNDING)
    assert_agree(inverse @ transform, identity, transform**2, within=ROUNDING)
    back = -apply(np.swapaxes(motion.rotation.value, -1, -2), motion.position.value)
    reversed_frame = forms.wrench_transform(back, np.swapaxes(motion.rotation.value, -1, -2))
    assert_agree(inverse, reversed_frame, within=ROUNDING)


def test_1_5_momentum(cloud: Cloud, body: RigidBody, motion: Motion) -> None:
    assert_agree(forms.momentum(body, motion.twist), cloud.momentum(motion), within=POINT_MASSES)
    world = forms.momentum_world(body, motion.position.value, motion.rotation.value, motion.twist)
    assert_agree(world, cloud.momentum_world(motion), within=POINT_MASSES)


def test_1_6_spatial_inertia(cloud: Cloud, body: RigidBody) -> None:
    # A particle's velocity is [E, -<r>] V, so twice the energy is V' (sum of m [E, -<r>]' [E, -<r>]) V.
    arm = np.cross(np.eye(3), cloud.points[:, None, :])
    jacobian = np.concatenate([np.broadcast_to(np.eye(3), arm.shape), np.swapaxes(arm, -1, -2)], axis=-1)
    summed = np.einsum("n,nki,nkj->ij", cloud.masses, jacobian, jacobian)
    assert_agree(forms.spatial_inertia(body), summed, within=POINT_MASSES)


def test_1_6_inertial_parameters(cloud: Cloud, body: RigidBody) -> None:
    inertia = cloud.inertia_about(np.zeros(3))
    expected = np.concatenate([[cloud.mass], cloud.mass * cloud.com, inertia[np.triu_indices(3)]])
    assert_agree(forms.inertial_parameters(body), expected, within=POINT_MASSES)


def test_1_7_wrench_is_the_rate_of_world_momentum(cloud: Cloud, body: RigidBody, motion: Motion) -> None:
    needed = forms.inverse_dynamics(body, motion.twist, motion.twist_rate)
    transform = forms.wrench_transform(motion.position.value, motion.rotation.value)
    assert_agree(apply(transform, needed), cloud.wrench_world(motion), within=POINT_MASSES)


def test_1_8_wrench_of_a_motion(cloud: Cloud, body: RigidBody, motion: Motion) -> None:
    wrench = cloud.wrench(motion)
    needed = forms.inverse_dynamics(body, motion.twist, motion.twist_rate)
    assert_agree(needed, wrench, within=POINT_MASSES)
    literal = apply(forms.spatial_inertia(body), motion.twist_rate) + apply(
        forms.force_cross(motion.twist), forms.momentum(body, motion.twist)
    )
    assert_agree(needed, literal, within=FORMS)
    assert_agree(
        forms.quasi_acceleration(body, motion.twist, wrench, form="1.8"),
        motion.twist_rate,
        within=POINT_MASSES,
    )


def test_1_8_inertia_forces_have_no_power(body: RigidBody, motion: Motion) -> None:
    inertia_force = apply(forms.force_cross(motion.twist), forms.momentum(body, motion.twist))
    power = np.einsum("...i,...i->...", motion.twist, inertia_force)
    assert_agree(power, np.zeros_like(power), motion.twist * inertia_force, within=ROUNDING)


def test_1_8_power_of_the_wrench_is_the_rate_of_energy(cloud: Cloud, body: RigidBody, motion: Motion) -> None:
    assert_agree(forms.kinetic_energy(body, motion.twist), cloud.kinetic_energy(motion), within=POINT_MASSES)
    wrench = forms.inverse_dynamics(body, motion.twist, motion.twist_rate)
    paths = cloud.paths(motion)
    rate = np.einsum("n,...ni,...ni->...", cloud.masses, paths.rate, paths.second)
    power = np.einsum("...i,...i->...", motion.twist, wrench)
    assert_agree(power, rate, motion.twist * wrench, within=POINT_MASSES)


def test_1_8_is_linear_in_the_inertial_parameters(
    rng: np.random.Generator, body: RigidBody, motion: Motion
) -> None:
    regressor = forms.inertia_regressor(motion.twist, motion.twist_rate)
    for other in (body, Cloud.random(rng).body):
        needed = forms.inverse_dynamics(other, motion.twist, motion.twist_rate)
        assert_agree(regressor @ forms.inertial_parameters(other), needed, within=FORMS)


def test_1_9_transport_matrix_is_the_logarithmic_rate_of_the_transform(motion: Motion) -> None:
    exact = []
    for q, q_dot, q_ddot in zip(motion.q, motion.q_dot, motion.q_ddot, strict=True):
        along = ref.path(*map(ref.vector, (q, q_dot, q_ddot)))

        def transform(t: ref.Number, along=along) -> ref.Matrix:
            o, c = along(t)[:3], ref.rotation(SHIP, along(t)[3:])
            columns = [ref.apply(c, e) for e in ref.axes()]
            screws = [x + ref.cross(o, x) for x in columns] + [[ref.mp.mpf(0)] * 3 + x for x in columns]
            return ref.mp.matrix(screws).T

        exact.append(ref.to_float(transform(ref.mp.mpf(0)) ** -1 * ref.derivative(transform)))
    assert_agree(forms.force_cross(motion.twist), np.array(exact), within=POINT_MASSES)


def test_1_10_quasi_coordinates(cloud: Cloud, body: RigidBody, motion: Motion) -> None:
    # The rates of the quasi-coordinates are V, their second rates V*: the time derivative of V's components,
    # here by differences of V(t) = (C^T do/dt, axial(C^T dC/dt)).
    twists, rates = [], []
    for q, q_dot, q_ddot in zip(motion.q, motion.q_dot, motion.q_ddot, strict=True):
        along = ref.path(*map(ref.vector, (q, q_dot, q_ddot)))

        def twist(t: ref.Number, along=along) -> ref.Vector:
            to_body = ref.rotation(SHIP, along(t)[3:]).T
            velocity = ref.vector_derivative(lambda s: along(t + s)[:3])
            turn = ref.derivative(lambda s: ref.rotation(SHIP, along(t + s)[3:]))
            return ref.apply(to_body, velocity) + ref.axial(to_body * turn)

        twists.append(ref.to_float(twist(ref.mp.mpf(0))))
        rates.append(ref.to_float(ref.vector_derivative(twist)))
    assert_agree(apply(forms.velocity_map(motion.q, SHIP), motion.q_dot), twists, within=POINT_MASSES)
    got = forms.quasi_acceleration(body, motion.twist, cloud.wrench(motion))
    assert_agree(got, rates, within=POINT_MASSES)


def test_1_11_quasi_velocity_form(cloud: Cloud, body: RigidBody, motion: Motion) -> None:
    wrench = cloud.wrench(motion)
    for form in ("1.11", "blocks"):
        got = forms.quasi_acceleration(body, motion.twist, wrench, form=form)
        assert_agree(got, motion.twist_rate, within=POINT_MASSES)
        literal = forms.quasi_acceleration(body, motion.twist, wrench, form="1.8")
        assert_agree(got, literal, within=FORMS)


def test_1_11_matrices(cloud: Cloud, body: RigidBody, motion: Motion) -> None:
    matrices = forms.quasi_velocity(body, motion.twist)
    theta, inverse = matrices.spatial_inertia, matrices.inverse_spatial_inertia
    assert_agree(theta, forms.spatial_inertia(body), within=0.0)
    assert_agree(matrices.force_cross, forms.force_cross(motion.twist), within=0.0)
    assert_agree(theta @ inverse, np.eye(6), np.abs(theta) @ np.abs(inverse), within=FORMS)
    assert_agree(matrices.Phi_pi, inverse @ matrices.force_cross @ theta, within=FORMS)
    left = motion.twist_rate + apply(matrices.Phi_pi, motion.twist)
    assert_agree(left, apply(inverse, cloud.wrench(motion)), within=POINT_MASSES)


@pytest.mark.parametrize("acceleration", [(0.0, 0.0, 9.80665), (0.0, 0.0, -9.80665), (1.0, -2.0, 3.0)])
def test_1_12_gravity(
    cloud: Cloud, body: RigidBody, motion: Motion, acceleration: tuple[float, float, float]
) -> None:
    weights = cloud.masses[:, None] * (np.array(acceleration) @ motion.rotation.value)[..., None, :]
    moments = np.cross(cloud.points, weights)
    expected = np.concatenate([weights, moments], axis=-1).sum(axis=-2)
    got = forms.gravity_wrench(body, motion.rotation.value, acceleration)
    assert_agree(got, expected, within=POINT_MASSES)


def test_1_12_third_axis_down_by_default(body: RigidBody, motion: Motion) -> None:
    rotation = motion.rotation.value
    down = forms.gravity_wrench(body, rotation, (0.0, 0.0, 9.80665))
    assert_agree(forms.gravity_wrench(body, rotation), down, within=0.0)


def test_1_8_a_change_of_body_frame_changes_no_motion(rng: np.random.Generator, cloud: Cloud) -> None:
    # The same cloud from a frame metres away with turned axes: the accelerations of a material point agree.
    point = rng.normal(size=3)
    offset = 5.0 * rng.normal(size=3)
    turn = Motion.random(rng, SHIP).rotation.value
    motion = Motion.random(rng, SHIP)
    other = Cloud(cloud.masses, (cloud.points - offset) @ turn)
    wrench = cloud.wrench(motion)

    def acceleration(body: RigidBody, twist: np.ndarray, wrench: np.ndarray, r: np.ndarray) -> np.ndarray:
        rate = forms.quasi_acceleration(body, twist, wrench)
        v, w = twist[:3], twist[3:]
        return rate[:3] + np.cross(w, v) + np.cross(rate[3:], r) + np.cross(w, np.cross(w, r))

    here = acceleration(cloud.body, motion.twist, wrench, point)
    frame = forms.wrench_transform_inverse(offset, turn)
    v, w = motion.twist[:3], motion.twist[3:]
    moved = np.concatenate([(v + np.cross(w, offset)) @ turn, w @ turn])
    there = acceleration(other.body, moved, frame @ wrench, (point - offset) @ turn)
    # The offset of metres enters squared through the inertia about the origin.
    assert_agree(turn @ there, here, offset**2, within=FORMS)
