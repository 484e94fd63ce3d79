"""The trace that is under way: its graph, and how its errors know their line."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextvars import ContextVar
from typing import Final

from freebody import _core
from freebody.errors import TraceError
from freebody.tables import CoreTable
from freebody.tracing import place
from freebody.tracing.place import Place

__all__ = ["CURRENT", "Trace", "current", "fault"]


class Trace:
    """One run of a law on symbols."""

    def __init__(self, law: str, *, logs: bool = False) -> None:
        self.law: Final = law
        self.graph: Final = _core.Graph(False)
        self.log: Final[list[tuple[object, Place | None]] | None] = [] if logs else None
        # Once the law has returned, faults belong to its `return`.
        self.returned_at: Place | None = None

    def here(self) -> Place | None:
        return self.returned_at or place.here()

    def symbol(self, name: str) -> int:
        return self.graph.symbol(name, name)

    def constant(self, value: float) -> int:
        if not math.isfinite(value):
            raise fault(
                f"works with the constant {value}",
                "write finite numbers only; leave out a bound that never acts",
            )
        return self._noted(self.graph.constant(value), value)

    def unary(self, op: str, a: int) -> int:
        return self._finite(op, self._noted(self.graph.unary(op, a), (op, a)), a)

    def binary(self, op: str, a: int, b: int) -> int:
        return self._finite(op, self._noted(self.graph.binary(op, a, b), (op, a, b)), a, b)

    def select_le(self, a: int, b: int, x: int, y: int) -> int:
        return self._noted(self.graph.select_le(a, b, x, y), (a, b, x, y))

    def lookup(self, table: CoreTable, at: Sequence[int]) -> int:
        return self._noted(self.graph.lookup(table, at), (table, *at))

    def _noted(self, node: int, what: object) -> int:
        if self.log is not None:
            self.log.append((what, self.here()))
        return node

    def _finite(self, op: str, node: int, *operands: int) -> int:
        values = [self.graph.value(operand) for operand in operands]
        if op == "div" and values[1] == 0.0:
            raise fault("divides by the constant zero", "write finite numbers only")
        result = self.graph.value(node)
        # The graph leaves an operation on constants as it stands when its result is not finite.
        if None not in values and (result is None or not math.isfinite(result)):
            words = ", ".join(f"{value:g}" for value in values if value is not None)
            raise fault(f"{_WORDS.get(op, op)} of {words} is not finite", "write finite numbers only")
        return node


_WORDS = {"ln": "the logarithm", "sqrt": "the square root", "pow": "the power", "mul": "the product"}

CURRENT: ContextVar[Trace | None] = ContextVar("freebody_trace", default=None)


def current(origin: Trace | None = None) -> Trace:
    """The trace under way, which must be `origin`, where the value at hand comes from."""
    trace = CURRENT.get()
    if trace is None or origin not in (None, trace):
        raise _error(
            "a traced value is used after its trace has ended: it was kept outside the function; a law must "
            "have no side effects, return what is needed and keep nothing",
            None if origin is None else origin.law,
            place.here(),
        )
    return trace


def fault(what: str, remedy: str, at: Place | None = None) -> TraceError:
    """The error of the trace under way: what the law does, what to write instead."""
    trace = CURRENT.get()
    if trace is None:
        return _error(f"{what}; {remedy}", None, at or place.here())
    return _error(f"{what}; {remedy}", trace.law, at or trace.here())


def _error(message: str, law: str | None, at: Place | None) -> TraceError:
    file, line, text = at or (None, None, None)
    return TraceError(message, function=law, file=file, line=line, text=text)
