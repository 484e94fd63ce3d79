"""A body, its start and forces of every kind, and how far two runs lie apart."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

import freebody as fb

Array = NDArray[np.float64]

CHARTS = ("quaternion", *fb.forms.SEQUENCES)
FORMS = ("quasi_velocity", "generalized")

# Three different moments about axes that are none of the body's, the mass centre off the origin.
BODY = fb.RigidBody(
    mass=12.5,
    com=[0.12, -0.05, 0.08],
    inertia_about_com=fb.principal_inertia(
        [0.7, 1.1, 1.5], fb.Attitude.angles("zyx", [0.3, 0.2, -0.4]).as_rotation()
    ),
)
START: dict[str, Any] = {
    "position": [1.0, 2.0, 3.0],
    "attitude": fb.Attitude.angles("zyx", [0.5, -0.2, 0.3]),
    "velocity_body": [1.0, -2.0, 0.5],
    "angular_velocity_body": [0.6, 1.1, -0.4],
}


def positive_matrix(rng: np.random.Generator) -> Array:
    """A full symmetric positive definite matrix (6, 6)."""
    root = rng.normal(size=(6, 6))
    return 0.01 * root @ root.T + 0.1 * np.diag([1.0, 2.0, 3.0, 0.1, 0.2, 0.3])


def every_force(rng: np.random.Generator) -> list[fb.Force]:
    """One element of every kind; six inputs."""
    return [
        fb.UniformGravity(1.5),
        fb.PointMassGravity(50.0, center=[2.0, 3.0, -8.0]),
        fb.ConstantWrench([3.0, -2.0, 1.0], [0.1, 0.2, -0.1], at=[0.3, 0.2, -0.1]),
        fb.ConstantWrench([1.0, 2.0, 3.0], [0.2, 0.1, 0.3], axes="world", at=[-0.2, 0.1, 0.4]),
        fb.TabulatedWrench(
            [0.0, 2.0, 2.0, 5.0, 10.0],
            force=3.0 * rng.normal(size=(5, 3)),
            moment=0.3 * rng.normal(size=(5, 3)),
            at=[0.1, 0.1, 0.1],
        ),
        fb.LinearDamping(positive_matrix(rng)),
        fb.QuadraticDamping([0.1, 0.2, 0.3, 0.01, 0.02, 0.03]),
        fb.InputWrench(at=[0.1, 0.0, -0.2]),
    ]


def relative(got: Array, expected: Array) -> float:
    """The largest difference of two paths, relative to the longest vector of the second."""
    return float(np.abs(got - expected).max() / np.linalg.norm(expected, axis=-1).max())


def motion_gap(run: fb.Trajectory, other: fb.Trajectory) -> float:
    """How far two runs lie apart: position and both velocities relative to their sizes, attitude in rad."""
    return max(
        relative(run.position_world, other.position_world),
        float(np.abs(run.world_from_body - other.world_from_body).max()),
        relative(run.velocity_body, other.velocity_body),
        relative(run.angular_velocity_body, other.angular_velocity_body),
    )
