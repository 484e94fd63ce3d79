"""Traced arrays: NumPy arrays of traced numbers, and how NumPy's functions reach them.

Shapes, indices and broadcasting stay NumPy's: an array of dtype object goes through its functions, and only
what happens to one number is ours. `UFUNCS`, `PRODUCTS` and `FUNCTIONS` list what is allowed.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable
from typing import Any, NoReturn, TypeAlias

import numpy as np
from numpy.typing import NDArray

from freebody.tables import Table
from freebody.tracing import truth
from freebody.tracing.trace import current, fault

__all__ = [
    "FUNCTIONS",
    "PRODUCTS",
    "TABLES",
    "UFUNCS",
    "Dispatches",
    "Objects",
    "Traced",
    "each",
    "plain",
    "wrapped",
]

Objects: TypeAlias = NDArray[np.object_]

UFUNCS: dict[np.ufunc, Any] = {}
"""Element operations, as NumPy wraps functions of one element."""
PRODUCTS: dict[np.ufunc, Callable[..., Any]] = {}
"""Operations on whole arrays that NumPy calls ufuncs too."""
TABLES: dict[type[Table], Callable[..., Any]] = {}
"""What a table does with traced arguments."""
FUNCTIONS: dict[Callable[..., Any], Callable[..., Any]] = {}
"""Functions of arrays."""

_REMEDIES = {
    "array_equal": "use np.abs(a - b) < tolerance",
    "allclose": "use np.abs(a - b) < tolerance",
    "isclose": "use np.abs(a - b) < tolerance",
    "equal": "use np.abs(a - b) < tolerance: equality of computed numbers is chance",
    "not_equal": "use np.abs(a - b) > tolerance: equality of computed numbers is chance",
    "piecewise": "use np.select(conditions, values)",
    "round": "use np.floor(x + 0.5)",
    "rint": "use np.floor(x + 0.5)",
    "isnan": "leave it out: guard the operation that could fail with np.where",
    "isfinite": "leave it out: guard the operation that could fail with np.where",
    "nan_to_num": "leave it out: guard the operation that could fail with np.where",
}


class Dispatches:
    """What NumPy's functions call when they meet a traced value."""

    __slots__ = ()

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        current()
        return _into(options.pop("out", None), _ufunc(ufunc, method, inputs, options))

    def __freebody_lookup__(self, table: Table, at: tuple[Any, ...]) -> Any:
        current()
        return TABLES[Table](table.core(), *at)

    def __array_function__(
        self, func: Callable[..., Any], types: object, args: tuple[Any, ...], kwargs: dict[str, Any]
    ) -> Any:
        current()
        ours = FUNCTIONS.get(func)
        if ours is None:
            module = func.__module__.removeprefix("numpy").lstrip(".")
            raise _unsupported(f"{module}.{func.__name__}" if module else func.__name__)
        return wrapped(ours(*args, **kwargs))


class Traced(Dispatches, np.ndarray[Any, np.dtype[np.object_]]):
    """An array of traced numbers, conditions and plain numbers."""

    def __bool__(self) -> NoReturn:
        raise truth.asked()

    def clip(  # pyright: ignore[reportIncompatibleMethodOverride]  (NumPy's has overloads)
        self, min: Any = None, max: Any = None, **options: Any
    ) -> Any:
        return np.clip(self, min, max, **options)

    def __getitem__(self, index: Any) -> Any:
        return super().__getitem__(_index(index))

    def __setitem__(self, index: Any, value: Any) -> None:
        super().__setitem__(_index(index), plain(value))


def _index(index: Any) -> Any:
    parts = index if isinstance(index, tuple) else (index,)
    if any(isinstance(part, Dispatches) for part in parts):
        raise truth.index_asked()
    return index


def plain(value: Any) -> Any:
    """The same as arrays of Python objects that NumPy handles without asking us."""
    if isinstance(value, np.ndarray):
        return value.view(np.ndarray)
    if isinstance(value, Dispatches):
        held = np.empty((), object)
        held[()] = value
        return held
    if isinstance(value, tuple | list):
        return type(value)(plain(item) for item in value)
    return value


def each(operation: Any, *values: Any) -> Any:
    """An element operation, as `UFUNCS` has them, on traced and plain values."""
    # The core folds constants, and NumPy would read the processor's flags of that.
    with np.errstate(all="ignore"):
        return operation(*(plain(value) for value in values))


def wrapped(value: Any) -> Any:
    """What came of arrays of Python objects, as the user's code meets it."""
    if isinstance(value, np.ndarray) and value.dtype == object:
        return value[()] if value.ndim == 0 else value.view(Traced)
    if isinstance(value, tuple | list):
        return type(value)(wrapped(item) for item in value)
    return value


def _ufunc(ufunc: np.ufunc, method: str, inputs: tuple[Any, ...], options: dict[str, Any]) -> Any:
    name = ufunc.__name__
    if options.pop("where", True) is not True or "initial" in options:
        raise fault(f"np.{name} came with where= or initial=", "use np.where on its result")
    given = [plain(value) for value in inputs]
    if ufunc in PRODUCTS and method == "__call__":
        return wrapped(PRODUCTS[ufunc](*given))
    if ufunc not in UFUNCS:
        raise _unsupported(name)
    if method in ("__call__", "outer"):
        return wrapped(each(getattr(UFUNCS[ufunc], method), *given))
    if method in ("reduce", "accumulate"):
        return wrapped(_along(UFUNCS[ufunc], method, given[0], options))
    raise _unsupported(f"{name}.{method}")


def _along(operation: Any, method: str, array: Objects, options: dict[str, Any]) -> Any:
    with np.errstate(all="ignore"):
        return _folded(operation, method, array, options)


def _folded(operation: Any, method: str, array: Objects, options: dict[str, Any]) -> Any:
    axis = options.get("axis", 0)
    if method == "accumulate":
        return operation.accumulate(array, axis=axis)
    if axis is not None:
        return operation.reduce(array, axis=axis, keepdims=bool(options.get("keepdims")))
    result = operation.reduce(array.ravel())
    return np.full((1,) * array.ndim, plain(result), object) if options.get("keepdims") else result


def _into(out: tuple[Any, ...] | None, result: Any) -> Any:
    if out is None:
        return result
    (target,) = out
    if target.dtype != object:
        raise truth.numbers_asked(target.dtype)
    plain(target)[...] = plain(result)
    return target


def _unsupported(name: str) -> Exception:
    names = {f.__name__ for f in (*UFUNCS, *PRODUCTS)} | {
        f"{f.__module__}.{f.__name__}".removeprefix("numpy.") for f in FUNCTIONS
    }
    near = difflib.get_close_matches(name, sorted(names), 3, 0.6)
    hint = f"near it: {', '.join(f'np.{n}' for n in near)}; or" if near else "use others, or"
    remedy = _REMEDIES.get(name.rpartition(".")[2], f"{hint} fb.callback, which is slow and takes any code")
    return fault(f"np.{name} is not supported in a traced law", remedy)
