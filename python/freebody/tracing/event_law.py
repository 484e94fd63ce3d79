"""Events written as Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Literal, TypeAlias, overload

from freebody import _check
from freebody.errors import InputError
from freebody.tracing.declaration import declared
from freebody.tracing.force_law import Declarations
from freebody.tracing.law import Law, Output, function_name, traced
from freebody.tracing.results import sole_number

__all__ = ["Direction", "EventLaw", "event"]

Direction: TypeAlias = Literal["both", "rising", "falling"]


class EventLaw(Law):
    """An event written as a Python function; see `event`, which makes them.

    Plain data, as force laws are.

    Attributes
    ----------
    terminal
        Whether it ends the run.
    direction
        "rising", "falling" or "both": which crossings of zero are the event.
    parameters, parameter_units, inputs
        As of force laws.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        terminal: bool = True,
        direction: Direction = "both",
        parameters: Declarations | None = None,
        inputs: Mapping[str, str] | None = None,
        name: str | None = None,
    ) -> None:
        own_name = function_name(function, "fb.event")
        self.name = own_name if name is None else _check.label("name", name)
        self.__doc__ = function.__doc__
        if not isinstance(terminal, bool):
            raise InputError(f"{own_name}: terminal: got {_check.shown(terminal)}; give True or False")
        self.terminal = terminal
        self.direction = _check.choice(f"{own_name}: direction", direction, ("both", "rising", "falling"))
        what = declared(own_name, parameters, inputs, None)
        self._parameters, self.inputs, self.states = what

        def finish(returned: Any) -> Output:
            return Output([sole_number(returned, "return one number, which crosses zero at the event")])

        self._program, _ = traced(own_name, function, what, finish)

    def _content(self) -> tuple[object, ...]:
        return (*super()._content(), self.terminal, self.direction)


@overload
def event(function: Callable[..., Any], /) -> EventLaw: ...


@overload
def event(
    *,
    terminal: bool = True,
    direction: Direction = "both",
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    name: str | None = None,
) -> Callable[[Callable[..., Any]], EventLaw]: ...


def event(
    function: Callable[..., Any] | None = None,
    /,
    *,
    terminal: bool = True,
    direction: Direction = "both",
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    name: str | None = None,
) -> EventLaw | Callable[[Callable[..., Any]], EventLaw]:
    """Make an event of a Python function of the situation `s`, and of its parameters `p`.

    It comes to pass where the number that the function returns crosses zero. Traced as forces are;
    see `force` for `parameters`, for what `s` has and for errors.

        @fb.event(direction="rising")  # the third axis points down
        def ground(s):
            return s.position_world[2]

    Parameters
    ----------
    terminal
        Whether it ends the run; otherwise it is recorded.
    direction
        "rising": from below zero; "falling": from above; "both".
    inputs
        Name: unit, of the model's inputs and commands that it reads, as `s.inputs.rudder`.
    name
        The function's, when omitted.

    Raises
    ------
    TraceError
        The function does what cannot be traced.
    """

    def decorate(function: Callable[..., Any]) -> EventLaw:
        return EventLaw(function, terminal, direction, parameters, inputs, name)

    return decorate if function is None else decorate(function)
