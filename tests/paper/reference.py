"""An independent implementation in mpmath, from definitions and numeric differentiation alone.

Vectors are lists of mpf, matrices mpmath matrices. Derivatives by time or by a coordinate are differences in
more digits than are asked for, so that no rule worked out by hand stands between definition and number.
"""

from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import mpmath as mp
import numpy as np
from numpy.typing import NDArray

DIGITS = 50

# mpmath declares no types.
Number: TypeAlias = Any
Matrix: TypeAlias = Any
Vector: TypeAlias = list[Number]


def vector(values: NDArray[np.float64] | Sequence[float]) -> Vector:
    """The exact values of doubles."""
    return [mp.mpf(float(x)) for x in values]


def matrix(values: NDArray[np.float64]) -> Matrix:
    return mp.matrix([vector(row) for row in values])


def to_float(values: Vector | Matrix) -> NDArray[np.float64]:
    """Rounded to doubles, in the same shape."""
    return np.array(values if isinstance(values, list) else values.tolist(), dtype=np.float64)


def add(a: Vector, b: Vector, scale: Number | int = 1) -> Vector:
    return [x + scale * y for x, y in zip(a, b, strict=True)]


def scaled(a: Vector, scale: Number | int) -> Vector:
    return [scale * x for x in a]


def dot(a: Vector, b: Vector) -> Number:
    return mp.fsum(x * y for x, y in zip(a, b, strict=True))


def cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def apply(m: Matrix, v: Vector) -> Vector:
    return list(m * mp.matrix(v))


def solve(m: Matrix, v: Vector) -> Vector:
    return list(mp.lu_solve(m, mp.matrix(v)))


def elementary(axis: int, angle: Number) -> Matrix:
    """The rotation about axis 0, 1 or 2: 1 at (axis, axis), the others by cyclic shift."""
    j, k = (axis + 1) % 3, (axis + 2) % 3
    m = mp.zeros(3)
    m[axis, axis] = 1
    m[j, j] = m[k, k] = mp.cos(angle)
    m[k, j], m[j, k] = mp.sin(angle), -mp.sin(angle)
    return m


def rotation(angles: str, alpha: Vector) -> Matrix:
    """World from body by three elementary rotations about the moving axes."""
    first, second, third = (elementary("xyz".index(i), a) for i, a in zip(angles, alpha, strict=True))
    return first * second * third


def rotation_of_quaternion(q: Vector) -> Matrix:
    """Columns are the images q e q* of the axes."""
    conjugate = [q[0], *scaled(q[1:], -1)]
    images = [quaternion_product(quaternion_product(q, [mp.mpf(0), *axis]), conjugate)[1:] for axis in axes()]
    return mp.matrix(images).T / dot(q, q)


def quaternion_product(a: Vector, b: Vector) -> Vector:
    w = a[0] * b[0] - dot(a[1:], b[1:])
    return [w, *add(add(scaled(b[1:], a[0]), a[1:], b[0]), cross(a[1:], b[1:]))]


def axes() -> list[Vector]:
    return [[mp.mpf(i == k) for i in range(3)] for k in range(3)]


def axial(m: Matrix) -> Vector:
    """The vector of the skew part."""
    return [(m[2, 1] - m[1, 2]) / 2, (m[0, 2] - m[2, 0]) / 2, (m[1, 0] - m[0, 1]) / 2]


def derivative(f: Callable[[Number], Matrix]) -> Matrix:
    """df/dt at 0 by a central difference, to the digits in force; it may be nested."""
    digits = mp.mp.dps
    with mp.workdps(2 * digits):
        step = mp.mpf(10) ** -digits
        return (f(step) - f(-step)) / (2 * step)


def vector_derivative(f: Callable[[Number], Vector]) -> Vector:
    """df/dt at 0 by a central difference."""
    return list(derivative(lambda t: mp.matrix(f(t))))


def second_derivative(f: Callable[[Number], Vector]) -> Vector:
    """d2f/dt2 at 0 by a central difference."""
    digits = mp.mp.dps
    with mp.workdps(3 * digits):
        step = mp.mpf(10) ** -digits
        ends = add(f(step), f(-step))
        return scaled(add(ends, f(mp.mpf(0)), -2), 1 / step**2)


def path(q: Vector, q_dot: Vector, q_ddot: Vector) -> Callable[[Number], Vector]:
    """The coordinates at time t on the parabola through them."""
    return lambda t: [x + t * v + t * t * a / 2 for x, v, a in zip(q, q_dot, q_ddot, strict=True)]


def rates_matrix(angles: str, alpha: Vector, *, world: bool) -> Matrix:
    """M0 or M1 by definition: column k is the axial vector of dC/dalpha_k C^T, or of C^T dC/dalpha_k."""
    c = rotation(angles, alpha)
    columns = []
    for unit in axes():
        dc = derivative(lambda t, unit=unit: rotation(angles, add(alpha, unit, t)))
        columns.append(axial(dc * c.T if world else c.T * dc))
    return mp.matrix(columns).T


def position(angles: str, q: Vector, r: Vector) -> Vector:
    """Where a material point is in world axes."""
    return add(q[:3], apply(rotation(angles, q[3:]), r))


def kinetic_energy(masses: Vector, points: list[Vector], angles: str, q: Vector, q_dot: Vector) -> Number:
    """Half the sum of m v^2 of point masses."""
    along = path(q, q_dot, [mp.mpf(0)] * 6)
    energy = mp.mpf(0)
    for m, r in zip(masses, points, strict=True):
        v = vector_derivative(lambda t, r=r: position(angles, along(t), r))
        energy += m * dot(v, v) / 2
    return energy


def wrench(masses: Vector, points: list[Vector], angles: str, along: Callable[[Number], Vector]) -> Vector:
    """The wrench about the body origin, body axes, that point masses need: sums of m a and r x m a."""
    to_body = rotation(angles, along(mp.mpf(0))[3:]).T
    force, moment = [mp.mpf(0)] * 3, [mp.mpf(0)] * 3
    for m, r in zip(masses, points, strict=True):
        a = second_derivative(lambda t, r=r: position(angles, along(t), r))
        f = scaled(apply(to_body, a), m)
        force, moment = add(force, f), add(moment, cross(r, f))
    return force + moment
