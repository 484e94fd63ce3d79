"""The double-precision point masses against fifty digits: what the other tests stand on is itself held."""

import numpy as np

from freebody.verify.point_masses import Cloud, Motion

from . import reference as ref
from .agreement import ROUNDING, assert_agree


def test_point_masses_to_rounding(rng: np.random.Generator, cloud: Cloud, angles: str) -> None:
    motion = Motion.random(rng, angles)
    masses, points = ref.vector(cloud.masses), [ref.vector(r) for r in cloud.points]
    q, q_dot, q_ddot = map(ref.vector, (motion.q, motion.q_dot, motion.q_ddot))
    wrench = ref.wrench(masses, points, angles, ref.path(q, q_dot, q_ddot))
    assert_agree(cloud.wrench(motion), ref.to_float(wrench), within=ROUNDING)
    energy = float(ref.kinetic_energy(masses, points, angles, q, q_dot))
    assert_agree(cloud.kinetic_energy(motion), energy, within=ROUNDING)


def test_sums_of_the_cloud(cloud: Cloud) -> None:
    masses, points = ref.vector(cloud.masses), [ref.vector(r) for r in cloud.points]
    first = [ref.mp.fsum(m * r[i] for m, r in zip(masses, points, strict=True)) for i in range(3)]
    assert_agree(cloud.mass * cloud.com, ref.to_float(first), within=ROUNDING)
    inertia = np.zeros((3, 3))
    for m, r in zip(cloud.masses, cloud.points, strict=True):
        arm = np.cross(np.eye(3), r)
        inertia += m * arm @ arm.T
    assert_agree(cloud.inertia_about(np.zeros(3)), inertia, within=ROUNDING)
