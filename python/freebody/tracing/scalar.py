"""Traced numbers: nodes of the graph and what they measure; and conditions on them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NoReturn, TypeAlias

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

from freebody import _check
from freebody.tracing import truth
from freebody.tracing.array import Dispatches
from freebody.tracing.trace import Trace, current, fault
from freebody.units import DIMENSIONLESS, Dimension, text_of

__all__ = [
    "Choose",
    "Condition",
    "Scalar",
    "Unit",
    "as_scalar",
    "binary",
    "constant",
    "dimensionless",
    "unary",
    "unify",
    "with_unit",
]

Unit: TypeAlias = Dimension | None
"""What a traced number measures; `None` where that is not known: literals and what they multiply."""


class _Value(Dispatches, NDArrayOperatorsMixin):
    """What numbers and conditions share: what they are is not known while a law is traced."""

    __slots__ = ("trace",)
    __hash__ = None  # pyright: ignore[reportAssignmentType]

    shape = ()
    ndim = 0
    size = 1

    def __init__(self, trace: Trace) -> None:
        self.trace = trace

    def __copy__(self) -> _Value:
        return self

    def __deepcopy__(self, _: object) -> _Value:
        return self

    def __reduce_ex__(self, _: object) -> NoReturn:
        raise fault("a traced value is pickled", "a law must have no side effects: return what is needed")

    def __bool__(self) -> NoReturn:
        current(self.trace)
        raise truth.asked()

    def __float__(self) -> NoReturn:
        current(self.trace)
        raise truth.number_asked()

    __int__ = __complex__ = __float__

    def __index__(self) -> NoReturn:
        current(self.trace)
        raise truth.index_asked()

    def __round__(self, *_: object) -> NoReturn:
        raise fault("round() needs a number, and a traced value is not known yet", "use np.floor(x + 0.5)")

    def __floor__(self) -> NoReturn:
        raise truth.number_asked()

    __ceil__ = __trunc__ = __floor__


class Scalar(_Value):
    """A traced number."""

    __slots__ = ("node", "unit")

    def __init__(self, trace: Trace, node: int, unit: Unit) -> None:
        super().__init__(trace)
        self.node, self.unit = node, unit

    def __repr__(self) -> str:
        return f"<traced number, {'unit not known' if self.unit is None else text_of(self.unit)}>"


Choose: TypeAlias = Callable[[int, int], int]
"""The node that is the first of two where a condition holds, else the second."""


class Condition(_Value):
    """A comparison of traced numbers, and what `&`, `|`, `~` make of such."""

    __slots__ = ("choose",)

    def __init__(self, trace: Trace, choose: Choose) -> None:
        super().__init__(trace)
        self.choose = choose

    def __repr__(self) -> str:
        return "<traced condition>"


def as_scalar(value: Any) -> Scalar:
    """A number of the trace under way: itself, or a constant of unknown unit."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, Scalar):
        current(value.trace)
        return value
    if isinstance(value, Condition):
        raise fault("computes with a condition", "make a number of it: np.where(condition, 1.0, 0.0)")
    if not isinstance(value, int | float | np.integer | np.floating | np.bool_):
        raise fault(f"computes with {_check.shown(value)}", "use real numbers and traced values")
    trace = current()
    try:
        return Scalar(trace, trace.constant(float(value)), None)
    except OverflowError:
        raise fault("computes with an integer beyond the range of doubles", "write a smaller one") from None


def unify(what: str, *values: Scalar) -> Unit:
    """The unit of numbers that must measure the same."""
    known = [v.unit for v in values if v.unit is not None]
    for other in known[1:]:
        if other != known[0]:
            raise fault(
                f"{what} {text_of(known[0])} and {text_of(other)}",
                "units must agree: a factor is missing, or a declared unit is wrong",
            )
    return known[0] if known else None


def dimensionless(what: str, value: Scalar) -> Unit:
    """Refuse what is known to have a unit."""
    if value.unit not in (None, DIMENSIONLESS):
        raise fault(
            f"{what} of a value in {text_of(value.unit)}",
            "its argument must have no unit: divide by a reference of the same unit",
        )
    return DIMENSIONLESS


def unary(op: str, a: Scalar, unit: Unit) -> Scalar:
    """An operation of the graph on a number; what comes is measured in `unit`."""
    trace = current(a.trace)
    return Scalar(trace, trace.unary(op, a.node), unit)


def binary(op: str, a: Scalar, b: Scalar, unit: Unit) -> Scalar:
    """An operation of the graph on two numbers; what comes is measured in `unit`."""
    trace = current(a.trace)
    return Scalar(trace, trace.binary(op, a.node, b.node), unit)


def with_unit(a: Scalar, unit: Unit) -> Scalar:
    """The same number, measured in `unit`."""
    return Scalar(a.trace, a.node, unit)


def constant(value: float, unit: Unit = DIMENSIONLESS) -> Scalar:
    """A number of known unit."""
    return with_unit(as_scalar(value), unit)
