"""Section 3: the phase space and the linearization on it, (3.1), (3.2)."""

import mpmath as mp
import numpy as np
import pytest

import freebody as fb
from freebody import forms
from freebody.model import Form
from freebody.verify.point_masses import Cloud, Motion

from . import reference as ref
from .agreement import POINT_MASSES, apply, assert_agree
from .reference_dynamics import Dynamics

# Exact derivatives in double precision: rounding of the operations of f, a few hundred.
JACOBIAN = 1e-12

GRAVITY = np.array([0.0, 0.0, 9.80665])
WORLD_FORCE = np.array([3.0, -1.0, 2.0])
AT = np.array([0.4, -0.3, 0.2])


def test_3_1_phase_velocity(cloud: Cloud, motion: Motion, angles: str) -> None:
    x = np.concatenate([motion.q, motion.q_dot], axis=-1)
    expected = np.concatenate([motion.q_dot, motion.q_ddot], axis=-1)
    convective = apply(forms.generalized(cloud.body, motion.q, motion.q_dot, angles).Phi1, motion.q_dot)
    got = forms.phase_velocity(cloud.body, x, cloud.wrench(motion), angles)
    assert_agree(got, expected, convective, within=POINT_MASSES)


@pytest.mark.parametrize("form", ["quasi_velocity", "generalized"])
@pytest.mark.parametrize("attitude", [*forms.SEQUENCES, "quaternion"])
def test_3_2_linearization(cloud: Cloud, rng: np.random.Generator, attitude: str, form: Form) -> None:
    damping = rng.normal(size=(6, 6))
    forces = [
        fb.UniformGravity(),
        fb.ConstantWrench(force=WORLD_FORCE, axes="world", at=AT),
        fb.LinearDamping(damping),
    ]
    model = fb.Model(cloud.body, forces, attitude=attitude, form=form)
    dynamics = Dynamics(
        attitude=attitude,
        form=form,
        mass=mp.mpf(cloud.mass),
        com=ref.vector(cloud.com),
        inertia_about_com=ref.matrix(cloud.inertia_about(cloud.com)),
        gravity=ref.vector(GRAVITY),
        world_force=ref.vector(WORLD_FORCE),
        at=ref.vector(AT),
        damping=ref.matrix(damping),
    )
    motion = Motion.random(rng, attitude if attitude != "quaternion" else "zyx")
    x = model.state(
        position=motion.position.value,
        attitude=fb.Attitude.rotation(motion.rotation.value),
        velocity_body=motion.twist[:3],
        angular_velocity_body=motion.twist[3:],
    )
    u = rng.normal(size=6)
    at, inputs = ref.vector(x), ref.vector(u)
    f = model.derivative(0.0, x, u)
    assert_agree(f, ref.to_float(dynamics.derivative(at, inputs)), within=JACOBIAN)

    a, b = model.jacobian(0.0, x, u)
    directions = allowed_directions(x, attitude, form)
    assert_agree(
        a @ directions.T,
        np.stack([slope(dynamics, at, inputs, along, np.zeros(6)) for along in directions], axis=-1),
        a,
        within=JACOBIAN,
    )
    at_rest = np.zeros(len(x))
    expected = np.stack([slope(dynamics, at, inputs, at_rest, along) for along in np.eye(6)], axis=-1)
    assert_agree(b, expected, within=JACOBIAN)


def slope(
    dynamics: Dynamics, x: ref.Vector, u: ref.Vector, along_x: np.ndarray, along_u: np.ndarray
) -> np.ndarray:
    """The derivative of f in one direction, by a difference in fifty digits."""
    dx, du = ref.vector(along_x), ref.vector(along_u)
    exact = ref.vector_derivative(lambda t: dynamics.derivative(ref.add(x, dx, t), ref.add(u, du, t)))
    return ref.to_float(exact)


def allowed_directions(x: np.ndarray, attitude: str, form: str) -> np.ndarray:
    """Rows that span the directions in which a state can go.

    Angles go anywhere; a quaternion keeps its length, so |q| = 1 and, with its rate in the state,
    q . dq/dt = 0. Off that surface f is a matter of convention, on it the body's.
    """
    if attitude != "quaternion":
        return np.eye(len(x))
    normals = np.zeros((2 if form == "generalized" else 1, len(x)))
    normals[0, 3:7] = x[3:7]
    if form == "generalized":
        normals[1, 3:7], normals[1, 10:14] = x[10:14], x[3:7]
    return np.linalg.svd(normals)[2][len(normals) :]
