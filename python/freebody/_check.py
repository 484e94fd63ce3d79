"""Checks of what users pass: each error names the argument, says what came and what is allowed."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freebody.errors import InputError

Array: TypeAlias = NDArray[np.float64]

SEQUENCES = ("zxz", "xyx", "yzy", "zyz", "xzx", "yxy", "xyz", "yzx", "zxy", "xzy", "zyx", "yxz")
"""The twelve intrinsic angle sequences: six proper Euler, six Tait-Bryan (section 4)."""

# A rotation typed with seven digits is a rotation; one in degrees, or a reflection, is not.
_ROTATION_DEFECT = 1e-6


class Argument(NamedTuple):
    """A checked array with its name and the shape of one item; the rest of its shape is batch."""

    name: str
    array: Array
    item: tuple[int, ...]

    @property
    def batch(self) -> tuple[int, ...]:
        return self.array.shape[: self.array.ndim - len(self.item)]


def argument(name: str, value: ArrayLike, *item: int) -> Argument:
    """Check that `value` is real, finite, not empty and of shape (..., *item)."""
    allowed = f"(..., {', '.join(map(str, item))})"
    try:
        array = np.asarray(value)
    except (ValueError, TypeError) as fault:
        raise InputError(f"{name}: not an array ({fault}); give real numbers of shape {allowed}") from None
    if array.dtype.kind not in "iuf":
        raise InputError(f"{name}: got dtype {array.dtype}; give real numbers of shape {allowed}")
    if array.shape[-len(item) :] != item:
        raise InputError(f"{name}: got shape {array.shape}; allowed is {allowed}")
    if array.size == 0:
        raise InputError(f"{name}: got an empty array of shape {array.shape}; give at least one item")
    with np.errstate(over="ignore"):  # a long double beyond the range becomes inf and is refused below
        array = array.astype(np.float64)
    if not np.isfinite(array).all():
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
        raise InputError(f"{name}: got {array[index]} at index {index}; every number must be finite")
    return Argument(name, array, item)


def rotation_argument(name: str, value: ArrayLike) -> Argument:
    """Check a rotation matrix (..., 3, 3)."""
    checked = argument(name, value, 3, 3)
    matrix = checked.array
    with np.errstate(over="ignore", invalid="ignore"):
        defect = np.abs(np.swapaxes(matrix, -1, -2) @ matrix - np.eye(3)).max()
    # "not <=" instead of ">": an overflow to NaN must be refused too.
    if not defect <= _ROTATION_DEFECT or (np.linalg.det(matrix) < 0.0).any():
        raise InputError(
            f"{name}: not a rotation matrix (largest entry of C^T C - E is {defect:.3g}, allowed "
            f"{_ROTATION_DEFECT:g}; the determinant must be +1)"
        )
    return checked


def inertia_argument(name: str, value: ArrayLike) -> Argument:
    """Check an inertia tensor (..., 3, 3): symmetric to rounding, positive definite."""
    checked = argument(name, value, 3, 3)
    tensor = checked.array
    skewness = np.abs(tensor - np.swapaxes(tensor, -1, -2)).max(axis=(-1, -2))
    if (skewness > 1e-9 * np.abs(tensor).max(axis=(-1, -2))).any():
        raise InputError(f"{name}: not symmetric (entries differ by up to {skewness.max():.6g} kg m^2)")
    smallest = np.linalg.eigvalsh(tensor)[..., 0].min()
    if not smallest > 0.0:
        raise InputError(f"{name}: smallest principal moment is {smallest:.6g} kg m^2; it must be positive")
    return checked


def sequence(angles: str) -> str:
    """Check the name of an angle sequence."""
    if not isinstance(angles, str) or angles not in SEQUENCES:
        raise InputError(
            f"angles: got {angles!r}; allowed are {', '.join(SEQUENCES)} "
            "(lower case, rotations about moving axes)"
        )
    return angles


def choice(name: str, value: str, allowed: tuple[str, ...]) -> str:
    """Check a word that is one of a few."""
    if not isinstance(value, str) or value not in allowed:
        raise InputError(f"{name}: got {value!r}; allowed are {', '.join(map(repr, allowed))}")
    return value


def vector(name: str, value: ArrayLike, *shape: int) -> Array:
    """Check one array of exactly this shape; a copy that nobody else can change."""
    checked = argument(name, value, *shape)
    if checked.batch:
        raise InputError(f"{name}: got shape {checked.array.shape}; allowed is {shape}")
    array = np.array(checked.array, order="C")
    array.flags.writeable = False
    return array


def number(name: str, value: float, *, positive: bool = False) -> float:
    """Check one finite number."""
    array = np.asarray(value)
    if array.ndim != 0 or array.dtype.kind not in "iuf":
        raise InputError(f"{name}: got {value!r}; give one real number")
    if not np.isfinite(array) or (positive and not array > 0):
        raise InputError(f"{name}: got {value!r}; it must be finite{' and positive' if positive else ''}")
    return float(array)


def label(name: str, value: str) -> str:
    """Check a name that is not empty."""
    if not isinstance(value, str) or not value.strip():
        raise InputError(f"{name}: got {value!r}; give a word that is not empty")
    return value
