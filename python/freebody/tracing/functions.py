"""The functions of arrays that a law may call: those that only move numbers are NumPy's own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from freebody.tracing import comparison
from freebody.tracing.array import FUNCTIONS, PRODUCTS, UFUNCS, Objects, Traced, each, plain
from freebody.tracing.scalar import Scalar, as_scalar, unify
from freebody.tracing.trace import fault

__all__ = ["own", "vecdot"]

_NUMPYS_OWN = (
    *(np.concatenate, np.stack, np.hstack, np.vstack, np.column_stack, np.block, np.append, np.insert),
    *(np.reshape, np.ravel, np.transpose, np.matrix_transpose, np.swapaxes, np.moveaxis, np.rollaxis),
    *(np.squeeze, np.expand_dims, np.broadcast_to, np.broadcast_arrays, np.atleast_1d, np.atleast_2d),
    *(np.atleast_3d, np.flip, np.flipud, np.fliplr, np.roll, np.rot90, np.repeat, np.tile, np.take, np.split),
    *(np.array_split, np.diag, np.diagflat, np.diagonal, np.copy, np.copyto, np.shape, np.ndim, np.size),
    *(np.cross, np.outer, np.tensordot, np.kron, np.einsum, np.trace, np.sum, np.prod, np.mean, np.cumsum),
    *(np.cumprod, np.diff, np.tril, np.triu, np.delete),
)


def own(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function of NumPy, on arrays of Python objects."""
    return lambda *args, **kwargs: function(
        *(plain(a) for a in args), **{key: plain(a) for key, a in kwargs.items()}
    )


def _where(condition: Any, *values: Any) -> Any:
    if len(values) != 2:
        raise fault("np.where came without values", "give both: np.where(condition, a, b)")
    return each(_CHOOSE, condition, *values)


def _chosen(condition: Any, a: Any, b: Any) -> Scalar:
    a, b = as_scalar(a), as_scalar(b)
    return comparison.choose(condition, a, b, unify("np.where chooses between", a, b))


_CHOOSE = np.frompyfunc(_chosen, 3, 1)


def _select(conditions: Sequence[Any], values: Sequence[Any], default: Any = 0.0) -> Any:
    if len(conditions) != len(values):
        raise fault(
            f"np.select came with {len(conditions)} conditions and {len(values)} values",
            "give one value for each condition, and default=",
        )
    result = default
    for condition, value in zip(reversed(conditions), reversed(values), strict=True):
        result = each(_CHOOSE, condition, value, result)
    return result


_CLIP = np.frompyfunc(comparison.clip, 3, 1)


def _clip(a: Any, a_min: Any = None, a_max: Any = None, *, min: Any = None, max: Any = None) -> Any:
    low, high = (a_min if min is None else min), (a_max if max is None else max)
    return each(_CLIP, a, low, high)


def _reduced(ufunc: np.ufunc) -> Callable[..., Any]:
    def call(a: Any, axis: int | None = None, *, keepdims: bool = False) -> Any:
        return ufunc.reduce(plain(np.asarray(plain(a))).view(Traced), axis=axis, keepdims=keepdims)

    return call


def _dot(a: Any, b: Any) -> Any:
    a, b = plain(a), plain(b)
    return a * b if np.ndim(a) == 0 or np.ndim(b) == 0 else np.dot(a, b)


def _vdot(a: Any, b: Any) -> Any:
    return np.dot(np.ravel(plain(a)), np.ravel(plain(b)))


def _inner(a: Any, b: Any) -> Any:
    return np.inner(plain(a), plain(b))


def _polyval(p: Any, x: Any) -> Any:
    p, x = np.asarray(plain(p), object), plain(x)
    if p.ndim != 1 or p.size == 0:
        raise fault(f"np.polyval came with coefficients {p.shape}", "give (n,), the highest power first")
    result = np.broadcast_to(np.asarray(p[0], object), np.shape(x))
    for coefficient in p[1:]:
        result = each(UFUNCS[np.add], each(UFUNCS[np.multiply], result, x), coefficient)
    return result


def _filled(value: float | None) -> Callable[..., Any]:
    """Arrays that take traced numbers, unlike those of np.zeros."""

    def call(a: Any, fill: Any = value, *, dtype: object = None, shape: Any = None) -> Objects:
        result = np.empty(np.shape(plain(a)) if shape is None else shape, object)
        result[...] = plain(fill)
        return result.view(Traced)

    return call


def vecdot(a: Any, b: Any, /, *, axis: int = -1) -> Any:
    """Scalar products along an axis."""
    return np.sum(np.asarray(plain(a)) * np.asarray(plain(b)), axis=axis)


def _matvec(a: Any, b: Any) -> Any:
    return np.matmul(a, b[..., None])[..., 0]


def _vecmat(a: Any, b: Any) -> Any:
    return np.matmul(a[..., None, :], b)[..., 0, :]


FUNCTIONS.update({function: own(function) for function in _NUMPYS_OWN})
FUNCTIONS.update(
    {
        np.where: _where,
        np.select: _select,
        np.clip: _clip,
        np.max: _reduced(np.maximum),
        np.min: _reduced(np.minimum),
        np.amax: _reduced(np.maximum),
        np.amin: _reduced(np.minimum),
        np.all: _reduced(np.logical_and),
        np.any: _reduced(np.logical_or),
        np.dot: _dot,
        np.vdot: _vdot,
        np.inner: _inner,
        np.polyval: _polyval,
        np.zeros_like: _filled(0.0),
        np.empty_like: _filled(0.0),
        np.ones_like: _filled(1.0),
        np.full_like: _filled(None),
    }
)
PRODUCTS[np.matmul] = np.matmul
PRODUCTS[np.vecdot] = vecdot
for _name, _product in (("matvec", _matvec), ("vecmat", _vecmat)):  # NumPy 2.2 and later
    if hasattr(np, _name):
        PRODUCTS[getattr(np, _name)] = _product
