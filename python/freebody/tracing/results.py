"""Checks of what a law returns."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from freebody import _check
from freebody.forces import StateQuantity
from freebody.tracing.array import plain
from freebody.tracing.scalar import Condition, Scalar, as_scalar
from freebody.tracing.situation import did_you_mean
from freebody.tracing.trace import fault
from freebody.tracing.wrench import must_measure
from freebody.units import dimension, over_time

__all__ = ["one_number", "rates", "sole_number", "split"]


def split(returned: Any, states: tuple[StateQuantity, ...], what: str) -> tuple[Any, Any]:
    """What a law returned, parted into its own and the rates of its states."""
    if not states:
        return returned, {}
    if not isinstance(returned, tuple) or len(returned) != 2:
        example = f'{{"{states[0].name}": ...}}'
        raise fault(f"returned {_check.shown(returned)}", f"a law with states returns {what}, {example}")
    return returned


def rates(given: Any, states: tuple[StateQuantity, ...]) -> list[Scalar]:
    """The rates of the states in their order."""
    names = [q.name for q in states]
    if not isinstance(given, Mapping):
        raise fault(f"returned the rates {_check.shown(given)}", 'give them by name, {"servo": rate}')
    _same_names(given, names)
    return [
        must_measure(
            f"the rate of {q.name}",
            one_number(f"the rate of {q.name}", given[q.name]),
            over_time(dimension("unit", q.unit)),
        )
        for q in states
    ]


def _same_names(given: Mapping[Any, Any], names: Iterable[str]) -> None:
    for unknown in [name for name in given if name not in set(names)]:
        raise fault(f"returned the rate of {unknown!r}, no state of it", did_you_mean(str(unknown), names))
    for missing in [name for name in names if name not in given]:
        raise fault(f"returned no rate of the state {missing!r}", "give the rates of all states")


def one_number(what: str, value: Any) -> Scalar:
    """One number, traced or plain."""
    held = plain(value)
    if np.shape(held) != ():
        raise fault(f"{what} came with shape {np.shape(held)}", "give one number")
    return as_scalar(value)


def sole_number(returned: Any, remedy: str) -> Scalar:
    """The one number that a law returned."""
    if isinstance(returned, Condition):
        raise fault("returned a condition", remedy)
    if returned is None or isinstance(returned, Mapping) or np.shape(plain(returned)) != ():
        raise fault(f"returned {_check.shown(returned)}", remedy)
    return as_scalar(returned)
