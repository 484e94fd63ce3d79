"""Outputs of runs written as Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Literal, TypeAlias, overload

from freebody import _check
from freebody.tracing.declaration import declared
from freebody.tracing.force_law import Declarations
from freebody.tracing.law import Law, Output, function_name, traced
from freebody.tracing.results import sole_number
from freebody.tracing.wrench import must_measure
from freebody.units import dimension, text_of

__all__ = ["OutputLaw", "Take", "output"]

Take: TypeAlias = Literal["final", "min", "max"]


class OutputLaw(Law):
    """An output of a run written as a Python function; see `output`, which makes them.

    Plain data, as force laws are.

    Attributes
    ----------
    unit
        Of its value; "" where it is not known.
    take
        "final", "min" or "max".
    parameters, parameter_units, inputs
        As of force laws.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        unit: str | None = None,
        take: Take = "final",
        parameters: Declarations | None = None,
        inputs: Mapping[str, str] | None = None,
        name: str | None = None,
    ) -> None:
        own_name = function_name(function, "fb.output")
        self.name = own_name if name is None else _check.label("name", name)
        self.__doc__ = function.__doc__
        self.take = _check.choice(f"{own_name}: take", take, ("final", "min", "max"))
        wanted = None if unit is None else dimension(f"{own_name}: unit", unit)
        what = declared(own_name, parameters, inputs, None)
        self._parameters, self.inputs, self.states = what

        def finish(returned: Any) -> Output:
            number = sole_number(returned, "return one number")
            if wanted is not None:
                must_measure("what is returned", number, wanted)
            return Output([number], "" if number.unit is None else text_of(number.unit))

        self._program, known = traced(own_name, function, what, finish)
        self.unit: str = known if unit is None else unit

    def _content(self) -> tuple[object, ...]:
        return (*super()._content(), self.unit, self.take)


@overload
def output(function: Callable[..., Any], /) -> OutputLaw: ...


@overload
def output(
    *,
    unit: str | None = None,
    take: Take = "final",
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    name: str | None = None,
) -> Callable[[Callable[..., Any]], OutputLaw]: ...


def output(
    function: Callable[..., Any] | None = None,
    /,
    *,
    unit: str | None = None,
    take: Take = "final",
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    name: str | None = None,
) -> OutputLaw | Callable[[Callable[..., Any]], OutputLaw]:
    """Make an output of a Python function of the situation `s`, and of its parameters `p`: one number a run.

    Traced as forces are, see `force` for `parameters`, for what `s` has and for errors.

        @fb.output(unit="m", take="max")
        def altitude(s):
            return -s.position_world[2]

    Parameters
    ----------
    unit
        Of SI, "m/s", "1" for none; it must be that of the number returned, where that is known. When omitted,
        the known one.
    take
        "final": the value at the end of the run; "min", "max": the least or greatest value on the way, inside
        the steps as well. One that is not a number at any step's end is not a number.
    inputs
        Name: unit, of the model's inputs and commands that it reads, as `s.inputs.rudder`.
    name
        The function's, when omitted.

    Raises
    ------
    TraceError
        The function does what cannot be traced.
    """

    def decorate(function: Callable[..., Any]) -> OutputLaw:
        return OutputLaw(function, unit, take, parameters, inputs, name)

    return decorate if function is None else decorate(function)
