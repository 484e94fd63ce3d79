"""Lengths and small matrices of traced numbers."""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody.tracing.arithmetic import root_of_squares
from freebody.tracing.array import FUNCTIONS, UFUNCS, Objects, each, plain
from freebody.tracing.functions import own, vecdot
from freebody.tracing.trace import fault

__all__: list[str] = []

_ROOT = np.frompyfunc(root_of_squares, 1, 1)


def _norm(x: Any, ord: int | None = None, axis: int | None = None, keepdims: bool = False) -> Any:
    x = np.asarray(plain(x), object)
    if ord not in (None, 2) or isinstance(axis, tuple) or (ord == 2 and axis is None and x.ndim != 1):
        raise fault(
            "np.linalg.norm came with another norm than the Euclidean length of vectors",
            "use np.sum(np.abs(x)) or np.max(np.abs(x)), np.sqrt(np.sum(x * x))",
        )
    squares = each(UFUNCS[np.square], x)
    if axis is None:
        length = each(_ROOT, UFUNCS[np.add].reduce(np.ravel(squares)))
        return np.full((1,) * x.ndim, plain(length), object) if keepdims else length
    return each(_ROOT, UFUNCS[np.add].reduce(squares, axis=axis, keepdims=keepdims))


def _vector_norm(x: Any, /, *, axis: int | None = None, keepdims: bool = False, ord: int = 2) -> Any:
    return _norm(x, None if ord == 2 else ord, axis, keepdims)


def _square(name: str, a: Any) -> Objects:
    matrix = np.asarray(plain(a), object)
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not 1 <= len(matrix) <= 3:
        raise fault(
            f"np.linalg.{name} came with a matrix of shape {matrix.shape}",
            "traced matrices can be (1, 1), (2, 2) or (3, 3); invert larger ones of plain numbers beforehand",
        )
    return matrix


def _adjugate(a: Objects) -> Objects:
    if len(a) == 1:
        return np.ones((1, 1), object)
    if len(a) == 2:
        return np.array([[a[1, 1], -a[0, 1]], [-a[1, 0], a[0, 0]]], object)
    return np.stack([np.cross(a[:, (i + 1) % 3], a[:, (i + 2) % 3]) for i in range(3)])


def _det(a: Any) -> Any:
    matrix = _square("det", a)
    return np.dot(_adjugate(matrix)[0], matrix[:, 0])


def _inv(a: Any) -> Any:
    matrix = _square("inv", a)
    adjugate = _adjugate(matrix)
    return adjugate / np.dot(adjugate[0], matrix[:, 0])


def _solve(a: Any, b: Any) -> Any:
    matrix = _square("solve", a)
    adjugate = _adjugate(matrix)
    return np.matmul(adjugate, np.asarray(plain(b), object)) / np.dot(adjugate[0], matrix[:, 0])


FUNCTIONS.update(
    {
        np.linalg.norm: _norm,
        np.linalg.vector_norm: _vector_norm,
        np.linalg.det: _det,
        np.linalg.inv: _inv,
        np.linalg.solve: _solve,
        np.linalg.cross: own(np.cross),
        np.linalg.outer: own(np.outer),
        np.linalg.trace: own(np.trace),
        np.linalg.diagonal: own(np.diagonal),
        np.linalg.matmul: own(np.matmul),
        np.linalg.matrix_transpose: own(np.matrix_transpose),
        np.linalg.vecdot: vecdot,
    }
)
