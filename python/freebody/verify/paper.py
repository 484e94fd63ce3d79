"""Every numbered equation against point masses: random bodies, frames and motions in all twelve sequences."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody import forms
from freebody.verify.law import FORM_AGAINST_FORM, Array, Law
from freebody.verify.linearization import linearization
from freebody.verify.point_masses import Cloud, Motion, axial, is_proper_euler
from freebody.verify.residual import Residual

# Random motions per body and sequence.
_MOTIONS = 8


def cases(seed: int = 0, n: int = 10) -> Iterator[Residual]:
    """The largest residual of every identity over `n` random bodies, each moved in all twelve sequences."""
    rng = np.random.default_rng(seed)
    found: dict[tuple[str, str, float], list[float]] = {}
    for _ in range(n):
        for law in laws(Cloud.random(rng), rng):
            found.setdefault((law.number, law.quantity, law.allowed), []).append(law.residual)
    for number, quantity, allowed in sorted(found, key=lambda key: [int(part) for part in key[0].split(".")]):
        largest = float(np.max(found[number, quantity, allowed]))
        yield Residual(f"paper ({number})", quantity, largest, allowed)


def laws(cloud: Cloud, rng: np.random.Generator) -> Iterator[Law]:
    """Both sides of every numbered equation for one body in random motions."""
    for angles in forms.SEQUENCES:
        yield from _of_motion(cloud, Motion.random(rng, angles, (_MOTIONS,)), rng)
    yield from linearization(cloud, rng)


def _of_motion(cloud: Cloud, motion: Motion, rng: np.random.Generator) -> Iterator[Law]:
    yield from _screws(cloud, motion, rng)
    yield from _quasi_velocities(cloud, motion)
    yield from _charts(motion)
    yield from _generalized(cloud, motion)
    yield from _lagrange(cloud, motion)
    yield from _rotation(cloud, motion)


def apply(matrix: Array, vector: Array) -> Array:
    """Matrix times vector over leading dimensions."""
    return np.einsum("...ij,...j->...i", matrix, vector)


def _screws(cloud: Cloud, motion: Motion, rng: np.random.Generator) -> Iterator[Law]:
    position, rotation = motion.position.value, motion.rotation.value
    wrench = cloud.wrench(motion)
    forces = cloud.masses[:, None] * (cloud.paths(motion).second @ rotation)
    doubled = np.concatenate([forces, forces], axis=-1)
    summed = apply(forms.line_matrix(cloud.points), doubled).sum(axis=-2)
    yield Law("1.1", "screws of the particles' forces, summed", summed, wrench, (forces,))

    transform = forms.wrench_transform(position, rotation)
    yield Law("1.2", "wrench, body to world", apply(transform, wrench), cloud.wrench_world(motion))
    turned = forms.wrench_transform(np.zeros(3), rotation)
    moved = forms.wrench_transform(position, np.eye(3))
    yield Law("1.3", "L = T [C]", moved @ turned, transform, allowed=FORM_AGAINST_FORM)
    further = Motion.random(rng, motion.angles)
    chained = forms.wrench_transform(
        position + apply(rotation, further.position.value), rotation @ further.rotation.value
    )
    step = forms.wrench_transform(further.position.value, further.rotation.value)
    yield Law("1.4", "group of L", transform @ step, chained, allowed=FORM_AGAINST_FORM)
    inverse = forms.wrench_transform_inverse(position, rotation)
    yield Law("1.4", "inverse of L", transform @ inverse, np.eye(6), (transform,), FORM_AGAINST_FORM)


def _quasi_velocities(cloud: Cloud, motion: Motion) -> Iterator[Law]:
    body, twist, twist_rate = cloud.body, motion.twist, motion.twist_rate
    position, rotation = motion.position.value, motion.rotation.value
    wrench = cloud.wrench(motion)

    yield Law("1.5", "momentum, body", forms.momentum(body, twist), cloud.momentum(motion))
    momentum_world = forms.momentum_world(body, position, rotation, twist)
    yield Law("1.5", "momentum, world", momentum_world, cloud.momentum_world(motion))
    by_inertia = 0.5 * np.einsum("...i,ij,...j->...", twist, forms.spatial_inertia(body), twist)
    yield Law("1.6", "kinetic energy by the inertia", by_inertia, cloud.kinetic_energy(motion))

    needed = forms.inverse_dynamics(body, twist, twist_rate)
    transform = forms.wrench_transform(position, rotation)
    yield Law("1.7", "rate of world momentum", apply(transform, needed), cloud.wrench_world(motion))
    yield Law("1.8", "wrench of the motion", needed, wrench)
    phi = forms.force_cross(twist)
    inertia_force = apply(phi, forms.momentum(body, twist))
    power = np.einsum("...i,...i->...", twist, inertia_force)
    yield Law("1.8", "power of the inertia forces", power, np.zeros_like(power), (inertia_force,))
    regressor = forms.inertia_regressor(twist, twist_rate)
    by_parameters = regressor @ forms.inertial_parameters(body)
    yield Law("1.8", "linear in the inertial parameters", by_parameters, needed, allowed=FORM_AGAINST_FORM)
    rate = _wrench_transform_rate(motion)
    yield Law("1.9", "rate of L", transform @ phi, rate, (transform,))
    for form in ("1.8", "1.11", "blocks"):
        got = forms.quasi_acceleration(body, twist, wrench, form=form)
        number = "1.8" if form == "1.8" else "1.11"
        yield Law(number, f"quasi-acceleration, {form}", got, twist_rate)
    matrices = forms.quasi_velocity(body, twist)
    left = twist_rate + apply(matrices.Phi_pi, twist)
    right = apply(matrices.inverse_spatial_inertia, wrench)
    yield Law("1.11", "both sides", left, right, (twist_rate,))
    gravity = np.array([0.3, -0.2, 9.8])
    weights = cloud.masses[:, None] * (gravity @ rotation)[..., None, :]
    weight = np.concatenate([weights, np.cross(cloud.points, weights)], axis=-1).sum(axis=-2)
    yield Law("1.12", "wrench of gravity", forms.gravity_wrench(body, rotation, gravity), weight)


def _charts(motion: Motion) -> Iterator[Law]:
    angles, q, q_dot = motion.angles, motion.q, motion.q_dot
    alpha, alpha_dot = q[..., 3:], q_dot[..., 3:]
    rotation, omega = motion.rotation.value, motion.angular_velocity_world

    yield Law("2.1", "rotation", forms.rotation(alpha, angles), rotation)
    yield Law("2.2", "twist", apply(forms.velocity_map(q, angles), q_dot), motion.twist)
    back = apply(forms.velocity_map_inverse(q, angles), motion.twist)
    yield Law("2.2", "coordinate rates of the twist", back, q_dot)
    world, in_body = forms.rate_matrix_world(alpha, angles), forms.rate_matrix_body(alpha, angles)
    yield Law("2.3", "angular velocity, world", apply(world, alpha_dot), omega)
    yield Law("2.3", "angular velocity, body", apply(in_body, alpha_dot), motion.twist[..., 3:])
    inverse = forms.rate_matrix_world_inverse(alpha, angles)
    yield Law("2.3", "inverse of M0", inverse @ world, np.eye(3), (inverse,), FORM_AGAINST_FORM)
    acceleration = axial(
        motion.rotation.second @ motion.rotation.transposed.value
        + motion.rotation.rate @ motion.rotation.transposed.rate
    )
    world_dot = forms.rate_matrix_world_dot(alpha, alpha_dot, angles)
    got = apply(world, motion.q_ddot[..., 3:]) + apply(world_dot, alpha_dot)
    yield Law("2.5", "angular acceleration, world", got, acceleration)
    skew = motion.rotation.rate @ motion.rotation.transposed.value
    yield Law(
        "2.6", "angular velocity, summed", forms.angular_velocity_skew_world(alpha, alpha_dot, angles), skew
    )
    second = alpha[..., 1]
    determinant = np.sin(second) if is_proper_euler(angles) else np.cos(second)
    yield Law("4", "determinant of M0", np.abs(np.linalg.det(world)), np.abs(determinant))


def _generalized(cloud: Cloud, motion: Motion) -> Iterator[Law]:
    body, angles = cloud.body, motion.angles
    q, q_dot, q_ddot = motion.q, motion.q_dot, motion.q_ddot
    wrench = cloud.wrench(motion)
    g = forms.generalized(body, q, q_dot, angles)
    by_map, by_k = apply(g.D_inv_D_dot, q_dot), apply(g.K, q_dot)
    yield Law("1.10", "second rates of the quasi-coordinates", apply(g.D, q_ddot + by_map), motion.twist_rate)
    left = q_ddot + apply(g.Phi_qD, q_dot) + by_map
    right = apply(g.D_inv @ body.inverse_spatial_inertia, wrench)
    yield Law("2.4", "both sides", left, right, (q_ddot, by_map))
    yield Law("2.5", "K on the rates", by_k, by_map, (q_dot,), FORM_AGAINST_FORM)
    left = apply(g.A1, q_ddot) + apply(g.B1, q_dot)
    yield Law("2.8", "wrench of the motion", left, wrench)
    for form in ("2.4", "2.7", "2.8", "2.9", "2.10", "blocks"):
        got = forms.generalized_acceleration(body, q, q_dot, wrench, angles, form=form)
        yield Law("2.7" if form == "blocks" else form, f"acceleration, {form}", got, q_ddot, (by_k,))
    phase = np.concatenate([q, q_dot], axis=-1)
    expected = np.concatenate([q_dot, q_ddot], axis=-1)
    yield Law("3.1", "phase velocity", forms.phase_velocity(body, phase, wrench, angles), expected, (by_k,))


def _lagrange(cloud: Cloud, motion: Motion) -> Iterator[Law]:
    body, angles = cloud.body, motion.angles
    q, q_dot, q_ddot = motion.q, motion.q_dot, motion.q_ddot
    force = cloud.generalized_force(motion)
    lag = forms.lagrange(body, q, q_dot, angles)
    generalized = forms.generalized(body, q, q_dot, angles)
    yield Law("2.9", "kinetic-energy matrix", lag.A, cloud.mass_matrix(motion))
    got = forms.generalized_force(q, cloud.wrench(motion), angles)
    yield Law("2.9", "generalized force", got, force)
    yield Law("2.9", "Phi_q = Phi1", lag.Phi_q, generalized.Phi1, allowed=FORM_AGAINST_FORM)
    left = apply(lag.A, q_ddot) + apply(lag.B, q_dot)
    yield Law("2.10", "generalized force of the motion", left, force)
    yield Law("2.11", "Lagrange's operator", forms.lagrange_operator(body, q, q_dot, q_ddot, angles), force)
    symbols = forms.christoffel_symbols(body, q, angles)
    first_kind = np.einsum("...sr,...rij->...sij", lag.A, symbols)
    yield Law("2.12", "Christoffel symbols", first_kind, cloud.christoffel_first_kind(motion), (lag.A,))
    sums = apply(lag.Phi_q, q_dot)
    yield Law("2.12", "Christoffel sums", lag.christoffel, sums, allowed=FORM_AGAINST_FORM)


def _rotation(cloud: Cloud, motion: Motion) -> Iterator[Law]:
    centred = Cloud(cloud.masses, cloud.points - cloud.com)
    moment = centred.wrench(motion)[..., 3:]
    inertia = centred.inertia_about(np.zeros(3))
    alpha, alpha_dot = motion.q[..., 3:], motion.q_dot[..., 3:]
    got = forms.rotation_acceleration(inertia, alpha, alpha_dot, moment, motion.angles)
    convective = apply(forms.rate_matrix_world_dot(alpha, alpha_dot, motion.angles), alpha_dot)
    yield Law("2.13", "angle accelerations about the mass centre", got, motion.q_ddot[..., 3:], (convective,))


def _wrench_transform_rate(motion: Motion) -> Array:
    """dL/dt entry by entry: the columns of L are the screws of unit forces and moments."""
    o, rotation = motion.position, motion.rotation
    rate = np.zeros((*o.value.shape[:-1], 6, 6))
    rate[..., :3, :3] = rate[..., 3:, 3:] = rotation.rate
    for k in range(3):
        rate[..., 3:, k] = np.cross(o.rate, rotation.value[..., k]) + np.cross(o.value, rotation.rate[..., k])
    return rate
