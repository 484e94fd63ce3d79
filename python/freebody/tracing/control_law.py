"""Control laws written as Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, overload

from freebody import _check, _core
from freebody.forces import Control, Quantity
from freebody.tracing.declaration import check_name, declared
from freebody.tracing.force_law import Declarations
from freebody.tracing.law import Law, Output, function_name, traced
from freebody.tracing.results import one_number, rates, split
from freebody.tracing.trace import fault
from freebody.units import text_of

__all__ = ["ControlLaw", "control"]


class ControlLaw(Law, Control):
    """A control law u = k(t, x) written as a Python function; see `control`, which makes them.

    Plain data, as force laws are.

    Attributes
    ----------
    commands
        What it sets, with units; "" where the unit is not known.
    parameters, parameter_units, inputs, states
        As of force laws.
    """

    commands: tuple[Quantity, ...]

    def __init__(
        self,
        function: Callable[..., Any],
        parameters: Declarations | None = None,
        inputs: Mapping[str, str] | None = None,
        states: Declarations | None = None,
        name: str | None = None,
    ) -> None:
        own_name = function_name(function, "fb.control")
        super().__init__(own_name if name is None else name)
        self.__doc__ = function.__doc__
        what = declared(own_name, parameters, inputs, states)
        self._parameters, self.inputs, self.states = what

        def finish(returned: Any) -> Output:
            commands, given = split(returned, what.states, '{"rudder": ...}')
            if not isinstance(commands, Mapping) or not commands:
                raise fault(
                    f"returned {_check.shown(commands)}", 'return commands by name, {"rudder": value, ...}'
                )
            for command in commands:
                check_name(f"{own_name}: command", command)
            numbers = [one_number(f"the command {n!r}", value) for n, value in commands.items()]
            units = ["" if x.unit is None else text_of(x.unit) for x in numbers]
            quantities = tuple(Quantity(*pair) for pair in zip(commands, units, strict=True))
            return Output([*numbers, *rates(given, what.states)], quantities)

        self._program, self.commands = traced(own_name, function, what, finish)

    def _content(self) -> tuple[object, ...]:
        return (*super()._content(), self.commands)

    def core(self) -> _core.Control:
        values = [p.value for p in self._parameters]
        return _core.Control(self._program, values, len(self.commands), len(self.states))


@overload
def control(function: Callable[..., Any], /) -> ControlLaw: ...


@overload
def control(
    *,
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    states: Declarations | None = None,
    name: str | None = None,
) -> Callable[[Callable[..., Any]], ControlLaw]: ...


def control(
    function: Callable[..., Any] | None = None,
    /,
    *,
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    states: Declarations | None = None,
    name: str | None = None,
) -> ControlLaw | Callable[[Callable[..., Any]], ControlLaw]:
    """Make a control law of a Python function: it returns commands, `{"rudder": angle, ...}`.

    Traced as forces are; see `force` for the arguments, for what `s` has and for errors. `inputs` are
    references that stay inputs of the closed loop. With states it returns `commands, {"servo": rate}`.

    Raises
    ------
    TraceError
        The function does what cannot be traced.
    """

    def decorate(function: Callable[..., Any]) -> ControlLaw:
        return ControlLaw(function, parameters, inputs, states, name)

    return decorate if function is None else decorate(function)
