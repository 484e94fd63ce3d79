"""Attitudes of many runs."""

from __future__ import annotations

import numpy as np

from freebody import forms
from freebody._check import Array

__all__ = ["nearest_angles", "product", "rotation_of_vector", "turned"]


def rotation_of_vector(vector: Array) -> Array:
    """The unit quaternions (n, 4) of rotation vectors (n, 3) rad."""
    x, y, z = vector.T
    half = 0.5 * np.sqrt(x * x + y * y + z * z)
    shape = np.where(half > 0.0, np.sin(half) / np.where(half > 0.0, half, 1.0), 1.0)
    return np.column_stack([np.cos(half), 0.5 * shape[:, None] * vector])


def product(a: Array, b: Array) -> Array:
    """The quaternions a b (n, 4): first b, then a."""
    (aw, ax, ay, az), (bw, bx, by, bz) = a.T, b.T
    return np.column_stack(
        [
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ]
    )


def turned(rotations: Array, vectors: Array) -> Array:
    """The vectors (n, 3) turned by rotations (n, 3, 3)."""
    x, y, z = vectors.T
    return rotations[:, :, 0] * x[:, None] + rotations[:, :, 1] * y[:, None] + rotations[:, :, 2] * z[:, None]


def nearest_angles(rotations: Array, sequence: str, nominal: Array) -> Array:
    """The angles (n, 3) of rotations in a sequence: of those of one attitude the ones next to nominal."""
    first, second, third = forms.angles_from_rotation(rotations, sequence).T
    proper = sequence[0] == sequence[2]
    other = [first + np.pi, -second if proper else np.pi - second, third + np.pi]
    both = np.stack([np.stack([first, second, third], axis=1), np.stack(other, axis=1)])
    both -= 2.0 * np.pi * np.round((both - nominal) / (2.0 * np.pi))
    distance = ((both - nominal) ** 2).max(axis=2)
    return np.where((distance[0] <= distance[1])[:, None], both[0], both[1])
