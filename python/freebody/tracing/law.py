"""Laws: functions traced into programs, with their declarations."""

from __future__ import annotations

import copy
import inspect
from collections.abc import Callable, Mapping
from types import CodeType, MappingProxyType
from typing import Any, NamedTuple, TypeAlias, TypeVar

from freebody import _check, _core
from freebody.errors import InputError, TraceError
from freebody.forces import Quantity, StateQuantity
from freebody.tracing import place
from freebody.tracing.declaration import Declared, Parameter
from freebody.tracing.place import Place
from freebody.tracing.scalar import Scalar
from freebody.tracing.situation import did_you_mean, named, situation
from freebody.tracing.trace import CURRENT, Trace, fault
from freebody.units import to_si

__all__ = ["Law", "Output", "function_name", "traced"]

L = TypeVar("L", bound="Law")


class Output(NamedTuple):
    """What a law gives: its numbers, and what it says of them beside."""

    numbers: list[Scalar]
    beside: Any = None


Finish: TypeAlias = Callable[[Any], Output]


class Law:
    """What the laws share. See `force`, `control`, `event` and `output`."""

    name: str
    inputs: tuple[Quantity, ...]
    states: tuple[StateQuantity, ...]
    _parameters: tuple[Parameter, ...]
    _program: _core.Program

    @property
    def program(self) -> _core.Program:
        """What it computes, of the core."""
        return self._program

    @property
    def parameters(self) -> Mapping[str, float]:
        """The values of the parameters by name, in their units."""
        return MappingProxyType({p.name: p.value for p in self._parameters})

    @property
    def parameter_units(self) -> Mapping[str, str]:
        """The units of the parameters by name."""
        return MappingProxyType({p.name: p.unit for p in self._parameters})

    @property
    def shared(self) -> frozenset[str]:
        """Those of the parameters that other laws of a model have in common with this one."""
        return frozenset(p.name for p in self._parameters if p.shared)

    def __call__(self: L, *positional: object, name: str | None = None, **values: float | str) -> L:
        """The same law with other values of parameters, and another name.

        Values are numbers in the declared unit, or strings with a unit of the same kind, `"0.3 ft^2"` (extra
        `cli` for units outside SI).
        """
        if positional:
            raise InputError(
                f"{self.name}: got {_check.shown(positional[0])}; a law is called with values of its "
                "parameters by name, and gives the law with these values"
            )
        units = self.parameter_units
        for unknown in values.keys() - units.keys():
            raise InputError(f"{self.name}: {unknown!r} is no parameter; {did_you_mean(unknown, units)}")
        new = copy.copy(self)
        new.name = self.name if name is None else _check.label("name", name)
        given = {n: to_si(f"{self.name}: {n}", value, units[n]) for n, value in values.items()}
        new._parameters = tuple(p._replace(value=given.get(p.name, p.value)) for p in self._parameters)
        return new

    def _content(self) -> tuple[object, ...]:
        return (type(self), self.name, self._program, self._parameters, self.inputs, self.states)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash(self._content())

    def __repr__(self) -> str:
        parts = [f"{p.name}={p.value:g} {p.unit}" for p in self._parameters]
        parts += [f"input {q.name} ({q.unit})" for q in self.inputs]
        parts += [f"state {q.name} ({q.unit})" for q in self.states]
        return f"<{type(self).__name__} {self.name!r}{': ' if parts else ''}{', '.join(parts)}>"


def function_name(function: object, decorator: str) -> str:
    """Check that a decorator got a function."""
    if not (inspect.isfunction(function) or inspect.ismethod(function)):
        raise InputError(
            f"{decorator}: got {_check.shown(function)}; decorate a Python function of (s) or (s, p), with "
            f"arguments by name: @{decorator}(parameters={{...}})"
        )
    return function.__name__


def traced(law: str, function: Any, what: Declared, finish: Finish) -> tuple[_core.Program, Any]:
    """The program of a function, and what `finish` says of its results beside.

    The function runs twice: a law whose runs differ depends on something that is not in its arguments.
    """
    arguments = _signature(law, function, what)
    first, second = (_run(Trace(law), function, arguments, what, finish) for _ in range(2))
    if first == second:
        return first
    traces = [Trace(law, logs=True) for _ in range(2)]
    for trace in traces:
        _run(trace, function, arguments, what, finish)
    raise _differing(law, traces, place.definition(function.__code__))


def _run(
    trace: Trace, function: Any, arguments: int, what: Declared, finish: Finish
) -> tuple[_core.Program, Any]:
    token = CURRENT.set(trace)
    try:
        p = named(trace, "parameter", {q.name: q.unit for q in what.parameters})
        inputs, states = ({q.name: q.unit for q in group} for group in (what.inputs, what.states))
        s, given = situation(trace, inputs, states)
        try:
            returned = function(*(s, p)[:arguments])
        except TraceError:
            raise
        except Exception as wrong:  # whatever users' code raises is told with the line it came from
            raise _foreign(wrong, function.__code__) from wrong
        trace.returned_at = place.of_return(function.__code__)
        output = finish(returned)
        parameters = [scalar.node for scalar in p.values()]
        program = trace.graph.program(parameters, given, [scalar.node for scalar in output.numbers])
        return program, output.beside
    finally:
        CURRENT.reset(token)


def _signature(law: str, function: Any, what: Declared) -> int:
    at = place.definition(function.__code__)
    kinds = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    wanted = list(inspect.signature(function).parameters.values())
    came = f"the signature is {law}{inspect.signature(function)}"
    if inspect.iscoroutinefunction(function) or inspect.isgeneratorfunction(function):
        raise _at(law, at, f"{law} is no ordinary function; use `def` without async and without yield")
    if not 1 <= len(wanted) <= 2 or any(p.kind not in kinds or p.default is not p.empty for p in wanted):
        raise _at(law, at, f"{came}; write def {law}(s), or def {law}(s, p) with parameters")
    if what.parameters and len(wanted) == 1:
        raise _at(law, at, f"{came}, and parameters are declared; write def {law}(s, p)")
    return len(wanted)


def _foreign(wrong: Exception, code: CodeType) -> TraceError:
    at = place.of_fault(wrong.__traceback__, place.definition(code))
    message = " ".join(str(wrong).split())
    remedy = next((r for words, r in _REMEDIES if words in message), "the function must run on traced values")
    return fault(f"{type(wrong).__name__}: {message}", remedy, at)


_STACK = "np.array([...]) of traced values is an array of Python objects: build it with np.stack([...])"
_REMEDIES = (
    ("loop of ufunc", _STACK),
    ("dtype('O')", _STACK),
    ("valid indices", "a traced value is no index: use np.where to choose, fb.Table or np.interp to look up"),
    ("read-only", "what the law is given cannot be written: compute with a copy, x = s.twist.copy()"),
    ("has no len()", "a traced number has no entries"),
    ("unsupported format string", "a traced value is no number yet: print it without a format"),
    ("broadcast", "shapes must go together; s.twist is (6,), its halves and positions are (3,)"),
    ("mismatch", "shapes must go together; s.twist is (6,), its halves and positions are (3,)"),
    ("dimensions", "shapes must go together; s.twist is (6,), its halves and positions are (3,)"),
)


def _differing(law: str, traces: list[Trace], definition: Place) -> TraceError:
    logs = [trace.log or [] for trace in traces]
    at = next((b[1] for a, b in zip(*logs, strict=False) if a[0] != b[0]), None) or definition
    return _at(
        law,
        at,
        "two runs of the function differ; a law has no side effects and depends on s and p alone: random "
        "numbers, counters, clocks and changing globals become parameters, inputs or states",
    )


def _at(law: str, at: Place, message: str) -> TraceError:
    return TraceError(message, function=law, file=at.file, line=at.line, text=at.text)
