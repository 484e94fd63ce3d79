"""Attitudes in and out of every chart."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, forms
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["Attitude"]


class Attitude:
    """How body axes stand in world axes: made from one description, given back in any other.

    Make one with `Attitude.angles`, `.quaternion`, `.rotation` or `.identity`.
    """

    __slots__ = ("_angles", "_quaternion", "_rotation")

    _rotation: Array
    _quaternion: Array
    _angles: tuple[str, Array] | None

    def __init__(self, *_: object, **__: object) -> None:
        raise InputError("Attitude: make one with Attitude.angles, .quaternion, .rotation or .identity")

    @classmethod
    def _of(cls, rotation: Array, quaternion: Array, angles: tuple[str, Array] | None = None) -> Attitude:
        self = cls.__new__(cls)
        self._rotation, self._quaternion, self._angles = rotation, quaternion, angles
        return self

    @classmethod
    def angles(cls, sequence: str, angles: ArrayLike) -> Attitude:
        """Of the angles (3,) rad of an intrinsic sequence such as "zyx". Konoplev (2.3), section 4."""
        sequence = _check.sequence(sequence, "sequence")
        alpha = _check.vector("angles", angles, 3)
        rotation = forms.rotation(alpha, sequence)
        return cls._of(rotation, forms.quaternion_from_rotation(rotation), (sequence, alpha))

    @classmethod
    def quaternion(cls, quaternion: ArrayLike) -> Attitude:
        """Of a quaternion (4,) (w, x, y, z), world from body; its length must be 1 to 1e-6."""
        q = _check.vector("quaternion", quaternion, 4)
        with np.errstate(over="ignore"):
            length = float(np.linalg.norm(q))
        if abs(length - 1.0) > 1e-6:
            raise InputError(
                f"quaternion: its length is {length:.9g}, allowed is 1 to 1e-6; divide by the length"
            )
        return cls._of(forms.rotation_from_quaternion(q), q / length)

    @classmethod
    def rotation(cls, world_from_body: ArrayLike) -> Attitude:
        """Of a rotation matrix (3, 3), world from body, orthogonal to 1e-6."""
        quaternion = forms.quaternion_from_rotation(_check.rotation("world_from_body", world_from_body))
        return cls._of(forms.rotation_from_quaternion(quaternion), quaternion)

    @classmethod
    def identity(cls) -> Attitude:
        """Body axes along world axes."""
        return cls._of(np.eye(3), np.array([1.0, 0.0, 0.0, 0.0]))

    def as_rotation(self) -> Array:
        """The rotation matrix (3, 3), world from body."""
        return self._rotation.copy()

    def as_quaternion(self) -> Array:
        """The unit quaternion (4,) (w, x, y, z), world from body."""
        return self._quaternion.copy()

    def as_angles(self, sequence: str) -> Array:
        """The angles (3,) rad of a sequence; those it was made of, where it was made of this sequence.

        Otherwise the second angle lies in [0, π] (proper Euler) or [-π/2, π/2] (Tait-Bryan); at the
        singularity the first angle is zero.
        """
        sequence = _check.sequence(sequence, "sequence")
        if self._angles is not None and self._angles[0] == sequence:
            return self._angles[1].copy()
        return forms.angles_from_rotation(self._rotation, sequence) + 0.0  # which turns -0 into 0

    def __repr__(self) -> str:
        return f"Attitude.quaternion({self._quaternion.tolist()})"
