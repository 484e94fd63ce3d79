"""A rigid cloud of point masses: Newton's law particle by particle, which the forms are held against.

Nothing here knows a screw, an inertia matrix or an angle-rate map. A particle is at o(t) + C(alpha(t)) r, its
velocity and acceleration follow by the product and chain rules, exact to rounding, and every dynamic quantity
is a sum over particles.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody._check import Array
from freebody.body import RigidBody

# Distance kept from the singular second angle, rad: a residual is to show the form, not the chart.
_MARGIN = 0.45


@dataclass(frozen=True)
class Jet:
    """A function of time up to its second derivative."""

    value: Array
    rate: Array
    second: Array

    def __matmul__(self, other: Jet) -> Jet:
        return Jet(
            self.value @ other.value,
            self.rate @ other.value + self.value @ other.rate,
            self.second @ other.value + 2.0 * self.rate @ other.rate + self.value @ other.second,
        )

    @property
    def transposed(self) -> Jet:
        return Jet(*(np.swapaxes(a, -1, -2) for a in (self.value, self.rate, self.second)))


def elementary_rotation(axis: int, angle: Jet) -> Jet:
    """The rotation (..., 3, 3) about a coordinate axis (0, 1, 2) by an angle (...)."""
    s, c = np.sin(angle.value), np.cos(angle.value)
    rate, second = angle.rate, angle.second
    sine = (s, c * rate, c * second - s * rate**2)
    cosine = (c, -s * rate, -s * second - c * rate**2)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    matrices = np.zeros((3, *s.shape, 3, 3))
    matrices[0, ..., axis, axis] = 1.0
    for matrix, sin_a, cos_a in zip(matrices, sine, cosine, strict=True):
        matrix[..., j, j] = matrix[..., k, k] = cos_a
        matrix[..., k, j], matrix[..., j, k] = sin_a, -sin_a
    return Jet(*matrices)


def axial(matrix: Array) -> Array:
    """The vector (..., 3) of the skew part of a matrix (..., 3, 3)."""
    transposed = np.swapaxes(matrix, -1, -2)
    return 0.5 * (matrix - transposed)[..., [2, 0, 1], [1, 2, 0]]


def is_proper_euler(angles: str) -> bool:
    """Whether the first and third axes of a sequence are the same."""
    return angles[0] == angles[2]


@dataclass(frozen=True)
class Motion:
    """The body frame at one instant: q = (o; alpha) and two derivatives, each (..., 6), in a sequence."""

    angles: str
    q: Array
    q_dot: Array
    q_ddot: Array

    @classmethod
    def random(cls, rng: np.random.Generator, angles: str, batch: tuple[int, ...] = ()) -> Motion:
        """A random motion, its second angle at least 0.45 rad from where the chart is singular."""
        q, q_dot, q_ddot = rng.normal(size=(3, *batch, 6))
        q[..., 3:] = rng.uniform(-np.pi, np.pi, size=(*batch, 3))
        second = rng.uniform(_MARGIN, np.pi - _MARGIN, size=batch)
        q[..., 4] = second * rng.choice([-1.0, 1.0], size=batch)
        if not is_proper_euler(angles):
            q[..., 4] = second - np.pi / 2
        return cls(angles, q, q_dot, q_ddot)

    @cached_property
    def position(self) -> Jet:
        """The path of the frame's origin, world axes."""
        return Jet(self.q[..., :3], self.q_dot[..., :3], self.q_ddot[..., :3])

    @cached_property
    def rotation(self) -> Jet:
        """C, body to world."""
        first, second, third = (
            elementary_rotation(
                "xyz".index(letter), Jet(self.q[..., k], self.q_dot[..., k], self.q_ddot[..., k])
            )
            for k, letter in enumerate(self.angles, start=3)
        )
        return first @ second @ third

    @cached_property
    def angular_velocity_world(self) -> Array:
        """The vector of the skew matrix dC/dt C^T."""
        return axial(self.rotation.rate @ self.rotation.transposed.value)

    @cached_property
    def twist(self) -> Array:
        """Velocity of the frame's origin and angular velocity, in body axes: (..., 6)."""
        turned = self.rotation.transposed
        return np.concatenate(
            [_apply(turned.value, self.position.rate), axial(turned.value @ self.rotation.rate)], axis=-1
        )

    @cached_property
    def twist_rate(self) -> Array:
        """The derivative of the components of `twist`: (..., 6)."""
        turned = self.rotation.transposed
        velocity = _apply(turned.rate, self.position.rate) + _apply(turned.value, self.position.second)
        spin = axial(turned.rate @ self.rotation.rate + turned.value @ self.rotation.second)
        return np.concatenate([velocity, spin], axis=-1)

    def along(self, direction: Array) -> Motion:
        """A motion through the same place along a constant `direction` of q."""
        q_dot = np.broadcast_to(direction, self.q.shape)
        return Motion(self.angles, self.q, q_dot, np.zeros_like(self.q))


@dataclass(frozen=True)
class Cloud:
    """Point masses (n,) in kg at points (n, 3) fixed in the body frame, m."""

    masses: Array
    points: Array

    @classmethod
    def random(cls, rng: np.random.Generator, count: int = 8) -> Cloud:
        """Random masses, their centre about a metre off the origin of a random frame."""
        centre = rng.normal(size=3)
        return cls(rng.uniform(0.5, 2.0, size=count), centre + rng.normal(size=(count, 3)))

    @property
    def mass(self) -> float:
        return float(self.masses.sum())

    @property
    def com(self) -> Array:
        return self.masses @ self.points / self.mass

    def inertia_about(self, point: Array) -> Array:
        """The inertia tensor (3, 3) about a point, body axes."""
        arms = self.points - point
        squares = np.einsum("n,ni,ni", self.masses, arms, arms)
        return squares * np.eye(3) - np.einsum("n,ni,nj->ij", self.masses, arms, arms)

    @cached_property
    def body(self) -> RigidBody:
        """The rigid body with the cloud's mass, mass centre and inertia."""
        return RigidBody(self.mass, self.com, inertia_about_com=self.inertia_about(self.com), name="cloud")

    def paths(self, motion: Motion) -> Jet:
        """The particles' positions in world axes, (..., n, 3)."""
        o, rotation = motion.position, motion.rotation.transposed
        return Jet(
            o.value[..., None, :] + self.points @ rotation.value,
            o.rate[..., None, :] + self.points @ rotation.rate,
            o.second[..., None, :] + self.points @ rotation.second,
        )

    def kinetic_energy(self, motion: Motion) -> Array:
        """Half the sum of m v^2: (...)."""
        velocity = self.paths(motion).rate
        return 0.5 * np.einsum("n,...ni,...ni->...", self.masses, velocity, velocity)

    def momentum_world(self, motion: Motion) -> Array:
        """Linear momentum and moment of momentum about the world origin, world axes: (..., 6)."""
        paths = self.paths(motion)
        return self._screw(paths.value, paths.rate)

    def wrench_world(self, motion: Motion) -> Array:
        """The force and its moment about the world origin that the motion needs, world axes: (..., 6)."""
        paths = self.paths(motion)
        return self._screw(paths.value, paths.second)

    def momentum(self, motion: Motion) -> Array:
        """Linear momentum and moment of momentum about the body origin, body axes: (..., 6)."""
        return self._in_body(motion, self.paths(motion).rate)

    def wrench(self, motion: Motion) -> Array:
        """The force and its moment about the body origin that the motion needs, body axes: (..., 6)."""
        return self._in_body(motion, self.paths(motion).second)

    def tangents(self, motion: Motion) -> Array:
        """The derivatives of the particles' positions by the coordinates q: (..., 6, n, 3)."""
        return np.stack([self.paths(motion.along(e)).rate for e in np.eye(6)], axis=-3)

    def generalized_force(self, motion: Motion) -> Array:
        """D'Alembert and Lagrange: the sum of m a dx/dq, (..., 6)."""
        return np.einsum(
            "n,...ni,...kni->...k", self.masses, self.paths(motion).second, self.tangents(motion)
        )

    def mass_matrix(self, motion: Motion) -> Array:
        """The sums of m dx/dq_k dx/dq_l: (..., 6, 6)."""
        tangents = self.tangents(motion)
        return np.einsum("n,...kni,...lni->...kl", self.masses, tangents, tangents)

    def christoffel_first_kind(self, motion: Motion) -> Array:
        """The sums of m dx/dq_s d2x/dq_i dq_j, Christoffel's symbols of the first kind: (..., 6, 6, 6)."""
        unit = np.eye(6)
        curvature = [[self.paths(motion.along(a + b)).second for b in unit] for a in unit]
        double = np.stack([np.stack(row, axis=-3) for row in curvature], axis=-4)
        # Along a + b the second derivative is x_aa + 2 x_ab + x_bb, and along a + a it is 4 x_aa.
        own = np.einsum("...iinc->...inc", double) / 4.0
        mixed = 0.5 * (double - own[..., :, None, :, :] - own[..., None, :, :, :])
        return np.einsum("n,...snc,...ijnc->...sij", self.masses, self.tangents(motion), mixed)

    def _screw(self, arms: Array, vectors: Array) -> Array:
        weighted = self.masses[:, None] * vectors
        return np.concatenate([weighted.sum(axis=-2), np.cross(arms, weighted).sum(axis=-2)], axis=-1)

    def _in_body(self, motion: Motion, vectors: Array) -> Array:
        return self._screw(self.points, vectors @ motion.rotation.value)


def _apply(matrix: Array, vector: Array) -> Array:
    return np.einsum("...ij,...j->...i", matrix, vector)
