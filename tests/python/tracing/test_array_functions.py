"""Every array function of NumPy that a law may call gives NumPy's numbers."""

from typing import Any

import numpy as np
import pytest

from python.tracing.expressions import MATRIX, Expression, check

EXPRESSIONS: dict[str, Expression] = {
    "products": lambda x, y, v, w, m: [
        v @ w,
        np.dot(v, w),
        np.vdot(v, w),
        np.inner(v, w),
        v.dot(w),
        np.vecdot(v, w),
        np.dot(x, y),
        np.linalg.vecdot(v, w),
        np.einsum("i,i", v, w),
        np.sum(v * w),
        v @ MATRIX @ w,
        np.tensordot(v, w, 1),
    ],
    "vectors": lambda x, y, v, w, m: [
        np.cross(v, w),
        np.cross([0.0, 0.0, 1.0], w),
        np.linalg.cross(v, w),
        m @ v,
        m.T @ v,
        v @ m,
        MATRIX @ v,
        np.matmul(m, v),
        m.dot(v),
        np.einsum("ij,j->i", m, v),
        np.dot(MATRIX, v),
        x * v,
        v / (3 + y),
        v * w,
    ],
    "matrices": lambda x, y, v, w, m: [
        np.outer(v, w),
        m @ MATRIX,
        m.T,
        m - m.T,
        np.transpose(m),
        m * v,
        m[:, None, 0] * w,
        np.multiply.outer(v, w),
        np.einsum("ij,jk->ik", m, m),
        np.kron(v, w).reshape(3, 3),
        np.linalg.outer(v, w),
        np.diag(v),
        m.transpose(),
        np.linalg.matmul(m, m),
        np.linalg.matrix_transpose(m),
        np.matrix_transpose(m),
    ],
    "matrix products by rows": lambda x, y, v, w, m: [np.linalg.vecdot(m, v), np.vecdot(m, m)],
    "small systems": lambda x, y, v, w, m: [
        np.linalg.inv(m + 5 * np.eye(3)),
        np.linalg.solve(m + 5 * np.eye(3), MATRIX),
        np.linalg.inv(MATRIX * np.stack([1.0 + 0 * x])),
    ],
    "determinants": lambda x, y, v, w, m: [
        np.linalg.det(m),
        np.linalg.det(m[:2, :2]),
        np.linalg.det(m[:1, :1]),
        np.linalg.inv(m[:1, :1])[0, 0],
        np.linalg.solve(m + 5 * np.eye(3), v)[0],
        np.linalg.inv(m[:2, :2] + 5 * np.eye(2))[0, 1],
    ],
    "lengths": lambda x, y, v, w, m: [
        np.linalg.norm(v),
        np.linalg.norm(m),
        np.linalg.norm(m, axis=1)[0],
        np.linalg.norm(v, 2),
        np.linalg.vector_norm(v),
        *np.linalg.vector_norm(m, axis=1, keepdims=True)[0],
        np.linalg.norm(0 * v),
    ],
    "sums": lambda x, y, v, w, m: [
        np.sum(v),
        v.sum(),
        np.prod(v),
        v.prod(),
        np.mean(v),
        v.mean(),
        np.trace(m),
        m.trace(),
        np.sum(m),
        np.add.reduce(v),
        sum(v),
        np.linalg.trace(m),
        np.mean(m),
        m.sum(),
    ],
    "sums along axes": lambda x, y, v, w, m: [
        m.sum(axis=0),
        np.sum(m, axis=1),
        m.mean(axis=1),
        np.mean(m, axis=0),
        np.cumsum(v),
        np.add.accumulate(v),
        np.cumprod(v),
        np.prod(m, axis=0),
        m.sum(axis=0, keepdims=True)[0],
        np.diagonal(m),
        np.linalg.diagonal(m),
    ],
    "joining": lambda x, y, v, w, m: [
        np.concatenate([v, w]),
        np.concatenate((v, [0.0, x, 1.0])),
        np.hstack([v, w]),
        np.hstack([x, y, v, 0.0]),
        np.append(v, [1.0, 2.0, x]),
        np.block([v, w]),
        np.repeat(x, 6),
        np.tile(v, 2),
        np.roll(np.hstack([v, w]), 2),
        np.flip(np.hstack([w, v])),
    ],
    "stacking": lambda x, y, v, w, m: [
        np.stack([v, w, v]),
        np.vstack([v, w, [x, 0.0, y]]),
        np.column_stack([v, w, v]),
        np.stack([v, w, w], axis=1),
        np.stack([v, np.zeros(3), w]),
        np.tril(m),
        np.triu(m),
        np.rot90(m),
        np.flipud(m),
        np.fliplr(m),
    ],
    "shapes": lambda x, y, v, w, m: [
        np.reshape(m, (9,)),
        m.reshape(9),
        np.ravel(m),
        m.ravel(),
        m.flatten(),
        np.moveaxis(m, 0, 1).ravel(),
        np.swapaxes(m, 0, 1).ravel(),
        np.expand_dims(m, 0).ravel(),
        np.squeeze(m[None]).ravel(),
        np.broadcast_to(v, (3, 3)).ravel(),
        np.atleast_2d(m).ravel(),
        np.concatenate(np.split(m.ravel(), 3)),
        np.copy(m).ravel(),
        m.copy().ravel(),
        m[[2, 0, 1]].ravel(),
        m[::-1, ::-1].ravel(),
        np.take(m, range(9)),
    ],
    "numbers as arrays": lambda x, y, v, w, m: [
        np.atleast_1d(x)[0],
        np.ravel(y)[0],
        np.size(m),
        np.ndim(x),
        v.size,
    ],
    "filled": lambda x, y, v, w, m: [
        np.zeros_like(v),
        np.ones_like(v),
        np.full_like(v, x),
        np.empty_like(v) * 0,
    ],
    "writing": lambda x, y, v, w, m: [written(v, x), added(v, w), np.full(3, x) * v],
    "np.array": lambda x, y, v, w, m: [
        np.array([x, 0.0, y]),
        np.array([x, 0.0, y]) * w,
        2 * np.array([x, 0.0, y]) + v,
        np.array([x, 1, y]) @ m,
        np.cross(np.array([0.0, x, y]), v),
        m @ np.array([1.0, x, y]),
        np.array([v, w, v]) @ w,
        np.where(v > 0, np.array([x, 0.0, y]), v),
        np.maximum(np.stack([x, 0.0, y]), 0.0),
        -np.array([x, 1.0, y]),
        np.array([x, 2.0, y]) / (3 + abs(v)),
        np.concatenate([np.array([x]), v[:2]]),
    ],
    "length of np.array": lambda x, y, v, w, m: [
        np.linalg.norm(np.stack([x, 0.0, y])),
        np.array([x, y]) @ v[:2],
    ],
    "differences": lambda x, y, v, w, m: np.diff(v),
}


def written(v: Any, x: Any) -> Any:
    """A copy of traced numbers takes traced and plain numbers."""
    changed = v.copy()
    changed[1] = x
    changed[2] = 4.0
    return changed


def added(v: Any, w: Any) -> Any:
    total = np.zeros_like(v)
    total += w
    total *= 2
    total -= v
    return total


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_function_gives_the_numbers_of_numpy(name: str) -> None:
    check(EXPRESSIONS[name])
