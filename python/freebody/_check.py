"""Checks of what users pass: each error names the argument, says what came and what is allowed."""

from __future__ import annotations

import math
import reprlib
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freebody import _core
from freebody.errors import InputError

Array: TypeAlias = NDArray[np.float64]

SEQUENCES = ("zxz", "xyx", "yzy", "zyz", "xzx", "yxy", "xyz", "yzx", "zxy", "xzy", "zyx", "yxz")
"""The twelve intrinsic angle sequences: six proper Euler, six Tait-Bryan (section 4)."""

# A rotation typed with seven digits is a rotation; one in degrees, or a reflection, is not.
_ROTATION_DEFECT = 1e-6

_SHORT = reprlib.Repr()
_SHORT.maxother = _SHORT.maxstring = 60


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
    array = _real(name, value, allowed)
    if array.shape[-len(item) :] != item:
        raise InputError(f"{name}: got shape {array.shape}; allowed is {allowed}")
    return Argument(name, _finite(name, array), item)


def _real(name: str, value: ArrayLike, allowed: object) -> NDArray[np.generic]:
    """Check that `value` is an array of real numbers."""
    try:
        array = np.asarray(value)
    except Exception as fault:  # what a foreign object raises when it is converted is its own affair
        raise InputError(f"{name}: not an array ({fault}); give real numbers of shape {allowed}") from None
    if array.dtype.kind not in "iuf":
        raise InputError(
            f"{name}: got {shown(value)} of dtype {array.dtype}; give real numbers of shape {allowed}"
        )
    if np.ma.is_masked(value):
        raise InputError(f"{name}: some of its numbers are masked; fill them in or leave them out")
    return array


def _finite(name: str, array: NDArray[np.generic]) -> Array:
    """Check that numbers came and that they are finite doubles."""
    if array.size == 0:
        raise InputError(f"{name}: got an empty array of shape {array.shape}; give at least one item")
    with np.errstate(over="ignore"):  # a long double beyond the range becomes inf and is refused below
        array = array.astype(np.float64)
    if not np.isfinite(array).all():
        index = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
        raise InputError(f"{name}: got {array[index]} at index {index}; every number must be finite")
    return array


def shown(value: object) -> str:
    """What came, in one line that is not too long."""
    return " ".join(_SHORT.repr(value).split())


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


def rotation(name: str, value: ArrayLike) -> Array:
    """Check one rotation matrix (3, 3); the nearest one that is orthogonal to rounding."""
    matrix = rotation_argument(name, vector(name, value, 3, 3)).array
    for _ in range(2):  # Newton's iteration to the polar factor squares the defect: 1e-6, 1e-12, 1e-24
        matrix = 0.5 * matrix @ (3.0 * np.eye(3) - matrix.T @ matrix)
    return matrix


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


def sequence(angles: str, name: str = "angles") -> str:
    """Check the name of an angle sequence."""
    if not isinstance(angles, str) or angles not in SEQUENCES:
        raise InputError(
            f"{name}: got {shown(angles)}; allowed are {', '.join(SEQUENCES)} "
            "(lower case, rotations about moving axes)"
        )
    return angles


def choice(name: str, value: str, allowed: tuple[str, ...]) -> str:
    """Check a word that is one of a few."""
    if not isinstance(value, str) or value not in allowed:
        raise InputError(f"{name}: got {shown(value)}; allowed are {', '.join(map(repr, allowed))}")
    return value


def numbers(name: str, value: ArrayLike, *shape: int) -> Array:
    """Check real numbers of exactly this shape, finite or not."""
    array = _real(name, value, shape)
    if array.shape != shape:
        raise InputError(f"{name}: got shape {array.shape}; allowed is {shape}")
    with np.errstate(over="ignore"):
        return array.astype(np.float64)


def vector(name: str, value: ArrayLike, *shape: int) -> Array:
    """Check finite numbers of exactly this shape; a copy that nobody else can change."""
    array = _core.frozen(value)  # the usual case, without the questions of the others
    if array is None or array.shape != shape:
        array = np.ascontiguousarray(_finite(name, numbers(name, value, *shape)))
        array.flags.writeable = False
    return array


def series(name: str, value: ArrayLike) -> Array:
    """Check finite numbers (n,), n at least 1; a copy that nobody else can change."""
    frozen = _core.frozen(value)
    if frozen is not None and frozen.ndim == 1:
        return frozen
    array = _real(name, value, "(n,)")
    if array.ndim != 1:
        raise InputError(f"{name}: got shape {array.shape}; allowed is (n,) with n of at least 1")
    return vector(name, array, len(array))


def columns(name: str, value: ArrayLike, rows: int) -> Array:
    """Check finite numbers (rows, n), n at least 1; a copy that nobody else can change."""
    array = _real(name, value, f"({rows}, n)")
    if array.ndim != 2 or len(array) != rows:
        raise InputError(f"{name}: got shape {array.shape}; allowed is ({rows}, n) with n of at least 1")
    return vector(name, array, *array.shape)


def diagonal_or_full(name: str, value: ArrayLike, n: int) -> Array:
    """Check a finite matrix (n, n) or its diagonal (n,); a copy that nobody else can change."""
    array = _real(name, value, f"({n},) or ({n}, {n})")
    if array.shape not in ((n,), (n, n)):
        raise InputError(f"{name}: got shape {array.shape}; allowed are ({n},) and ({n}, {n})")
    return vector(name, array, *array.shape)


def out_refusal(name: str, out: object, shape: Sequence[int] | None) -> InputError:
    """Why results cannot be written to `out`, an array of this shape, or without one a pair of arrays."""
    came = shown(out)
    if isinstance(out, np.ndarray):
        came = f"an array of {out.dtype}, shape {out.shape}, strides {out.strides}"
        came += "" if out.flags.writeable else ", read-only"
    if shape is None:
        return InputError(f"{name}: got {came}; give a pair of arrays")
    return InputError(f"{name}: got {came}; give a writable contiguous float64 array of shape {tuple(shape)}")


def number(name: str, value: float, *, positive: bool = False) -> float:
    """Check one finite number."""
    if type(value) is float and math.isfinite(value) and (value > 0.0 or not positive):
        return value
    rule = f"give one finite{' positive' if positive else ''} number"
    try:
        array = np.asarray(value)
    except Exception as fault:
        raise InputError(f"{name}: not a number ({fault}); {rule}") from None
    if array.ndim != 0 or array.dtype.kind not in "iuf" or np.ma.is_masked(value):
        raise InputError(f"{name}: got {shown(value)}; {rule}")
    with np.errstate(over="ignore"):
        checked = float(array.astype(np.float64))
    if not np.isfinite(checked) or (positive and not checked > 0.0):
        raise InputError(f"{name}: got {shown(value)}; {rule}")
    return checked


def count(name: str, value: float) -> int:
    """Check a whole number from 1 to 2^53, up to which doubles count."""
    if type(value) is int and 1 <= value <= 2**53:
        return value
    checked = number(name, value)
    if not (checked.is_integer() and 1.0 <= checked <= 2.0**53):
        raise InputError(f"{name}: got {shown(value)}; give a whole number from 1 to 2^53")
    return int(checked)


def flag(name: str, value: bool) -> bool:
    """Check a truth value."""
    if not isinstance(value, bool | np.bool_):
        raise InputError(f"{name}: got {shown(value)}; give True or False")
    return bool(value)


def label(name: str, value: str) -> str:
    """Check a name that is not empty."""
    if not isinstance(value, str) or not value.strip():
        raise InputError(f"{name}: got {shown(value)}; give a word that is not empty")
    return value


def in_body_axes(name: str, body: ArrayLike | None, world: ArrayLike | None, body_from_world: Array) -> Array:
    """A vector in body axes, given in body or world axes."""
    if body is not None and world is not None:
        raise InputError(f"{name}_body, {name}_world: both came; give one of them")
    if body is not None:
        return vector(f"{name}_body", body, 3)
    if world is not None:
        with np.errstate(over="ignore", invalid="ignore"):  # beyond doubles: the core refuses the state
            return body_from_world @ vector(f"{name}_world", world, 3)
    return np.zeros(3)
