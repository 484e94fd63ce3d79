"""Force laws written as Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias, overload

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody.interfaces import Contents, Force, Spin
from freebody.tracing.declaration import declared
from freebody.tracing.law import Law, Output, function_name, traced
from freebody.tracing.results import rates, split
from freebody.tracing.trace import fault
from freebody.tracing.wrench import Wrench

__all__ = ["Declarations", "ForceLaw", "force"]

Declarations: TypeAlias = Mapping[str, tuple[float | str, str]]
"""By name: a value and its unit of SI."""


class ForceLaw(Law, Force):
    """A force written as a Python function; see `force`, which makes them.

    The law is plain data, the function is not kept: laws pickle, compare and hash by what they compute, and
    run where the source is not.

    Attributes
    ----------
    parameters, parameter_units
        Values and units by name.
    inputs, states
        What it reads from u, and its own states with their start values.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        parameters: Declarations | None = None,
        inputs: Mapping[str, str] | None = None,
        states: Declarations | None = None,
        name: str | None = None,
        *,
        publishes: Sequence[str] = (),
        added_mass: ArrayLike | None = None,
        spins: Sequence[Spin] = (),
        contents: Sequence[Contents] = (),
        notices: Sequence[Any] = (),
    ) -> None:
        own_name = function_name(function, "fb.force")
        super().__init__(own_name if name is None else name)
        self.__doc__ = function.__doc__
        # Subclasses may have them as attributes of their own.
        if publishes:
            self.publishes = tuple(publishes)
        if added_mass is not None:
            self.added_mass = _check.vector(f"{own_name}: added_mass", added_mass, 6, 6)
        if spins:
            self.spins = tuple(spins)
        if contents:
            self.contents = tuple(contents)
        if notices:
            self.notices = tuple(notices)
        what = declared(own_name, parameters, inputs, states)
        self._parameters, self.inputs, self.states = what

        def finish(returned: Any) -> Output:
            wrench, given = split(returned, what.states, "fb.wrench(...)")
            if not isinstance(wrench, Wrench):
                raise fault(
                    f"returned {_check.shown(wrench)}",
                    "return fb.wrench(force=..., moment=..., at=...), with states: that and their rates",
                )
            return Output([*wrench.force, *wrench.moment, *rates(given, what.states)])

        self._program, _ = traced(own_name, function, what, finish)

    def _content(self) -> tuple[object, ...]:
        added = None if self.added_mass is None else np.asarray(self.added_mass, float).tobytes()
        return (*super()._content(), self.publishes, self.spins, self.contents, self.notices, added)

    def core(self) -> _core.Force:
        return _core.Force.traced(self._program, [p.value for p in self._parameters], len(self.states))


@overload
def force(function: Callable[..., Any], /) -> ForceLaw: ...


@overload
def force(
    *,
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    states: Declarations | None = None,
    name: str | None = None,
    publishes: Sequence[str] = (),
    added_mass: ArrayLike | None = None,
    spins: Sequence[Spin] = (),
    contents: Sequence[Contents] = (),
    notices: Sequence[Any] = (),
) -> Callable[[Callable[..., Any]], ForceLaw]: ...


def force(
    function: Callable[..., Any] | None = None,
    /,
    *,
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    states: Declarations | None = None,
    name: str | None = None,
    publishes: Sequence[str] = (),
    added_mass: ArrayLike | None = None,
    spins: Sequence[Spin] = (),
    contents: Sequence[Contents] = (),
    notices: Sequence[Any] = (),
) -> ForceLaw | Callable[[Callable[..., Any]], ForceLaw]:
    """Make a force of a Python function of the situation `s`, and of its parameters `p`.

    The function runs on symbols, once and for all; what it computes with NumPy becomes a program that runs
    without Python, over many motions at once, and is differentiated exactly. Both sides of every choice are
    computed: `np.where`, not `if`.

        @fb.force(parameters={"area": (0.02, "m^2")}, inputs={"rudder": "rad"})
        def fin(s, p):
            v = s.velocity_body
            return fb.wrench(force=np.stack([0.0, -500.0 * p.area * v[0] ** 2 * s.inputs.rudder, 0.0]))

    Parameters
    ----------
    parameters
        Name: (value, unit). Inside the function everything is SI, so that the unit is one of SI, "N s/m", "1"
        for none; a value may be a string with another unit, `("0.3 ft^2", "m^2")`.
    inputs
        Name: unit, of what the law reads from u, as `s.inputs.rudder`.
    states
        Name: (start value, unit), of states that the law itself moves: it reads `s.states.servo` and returns
        `fb.wrench(...), {"servo": rate}`.
    name
        The function's, when omitted.
    publishes
        Names of its states that other laws read, as inputs of these names.
    added_mass, spins, contents
        What it puts on the left of the equations: see `Force`.
    notices
        Made by `freebody.notice`: what the outcome of every run has to say.

    Units are checked where they are known: those of `s` and `p` are, a literal number may have any, and so
    has what it multiplies. A derivative at a zero length, `np.linalg.norm` and `np.hypot`, is taken as zero.

    Raises
    ------
    TraceError
        The function does what cannot be traced; the error names the line and what to write instead. A side
        effect is found when it changes the result or stores a traced value that is used later.

    See `Situation` for what `s` has, and `fb.callback` for code that cannot be traced.
    """

    def decorate(function: Callable[..., Any]) -> ForceLaw:
        left = {"added_mass": added_mass, "spins": spins, "contents": contents}
        beside: dict[str, Any] = {"publishes": publishes, "notices": notices}
        return ForceLaw(function, parameters, inputs, states, name, **left, **beside)

    return decorate if function is None else decorate(function)
