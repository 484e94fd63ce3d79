"""Contents of a body written as Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, overload

import numpy as np

from freebody import _check, _core
from freebody.interfaces import Contents
from freebody.tracing.array import plain
from freebody.tracing.declaration import declared
from freebody.tracing.force_law import Declarations
from freebody.tracing.law import Law, Output, function_name, traced
from freebody.tracing.results import one_number
from freebody.tracing.scalar import Scalar
from freebody.tracing.trace import CURRENT, fault
from freebody.tracing.wrench import ORIGIN, Vector, must_measure
from freebody.units import dimension

__all__ = ["ContentsLaw", "MassProperties", "contents", "mass_properties"]

_MASS, _LENGTH, _INERTIA = (dimension("unit", unit) for unit in ("kg", "m", "kg m^2"))
_UPPER = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))


class MassProperties(NamedTuple):
    """What `mass_properties` makes: mass, mass centre, and the tensor by its upper triangle."""

    mass: Any
    com: list[Any]
    tensor: list[Any]


def mass_properties(mass: Any, com: Vector = ORIGIN, inertia_about_com: Any = ORIGIN) -> MassProperties:
    """The mass properties that a contents law returns.

    Parameters
    ----------
    mass
        kg, zero or more.
    com
        Mass centre from the body origin, body axes, (3,) m. It must be finite at zero mass, too.
    inertia_about_com
        About this mass centre, body axes, symmetric (3, 3) or its diagonal (3,), kg m²; none of a point.
    """
    if CURRENT.get() is None:
        raise fault(
            "fb.mass_properties is called outside a contents law",
            "return it from a function under @fb.contents",
        )
    place, tensor = np.asarray(plain(com), object), np.asarray(plain(inertia_about_com), object)
    if place.shape != (3,):
        raise fault(f"fb.mass_properties came with com of shape {place.shape}", "give three components, (3,)")
    if tensor.shape == (3,):
        diagonal, tensor = tensor, np.zeros((3, 3), object)
        np.fill_diagonal(tensor, diagonal)
    if tensor.shape != (3, 3):
        raise fault(
            f"fb.mass_properties came with inertia_about_com of shape {tensor.shape}",
            "give (3, 3), or the diagonal (3,)",
        )
    return MassProperties(
        must_measure("mass", one_number("mass", mass), _MASS),
        [must_measure(f"com[{i}]", one_number("com", x), _LENGTH) for i, x in enumerate(place)],
        [must_measure(f"inertia[{i}, {j}]", _symmetric(tensor, i, j), _INERTIA) for i, j in _UPPER],
    )


def _symmetric(tensor: Any, i: int, j: int) -> Scalar:
    """An entry of the symmetric part."""
    one, other = (one_number("inertia_about_com", tensor[k]) for k in ((i, j), (j, i)))
    return one if one.node == other.node else one_number("inertia_about_com", 0.5 * (one + other))


class ContentsLaw(Law, Contents):
    """What a body carries, written as a Python function; see `contents`, which makes them.

    Plain data, as force laws are.

    Attributes
    ----------
    parameters, parameter_units, inputs
        As of force laws.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        parameters: Declarations | None = None,
        inputs: Mapping[str, str] | None = None,
        name: str | None = None,
    ) -> None:
        own_name = function_name(function, "fb.contents")
        self.name = own_name if name is None else _check.label("name", name)
        self.__doc__ = function.__doc__
        what = declared(own_name, parameters, inputs, None)
        self._parameters, self.inputs, self.states = what

        def finish(returned: Any) -> Output:
            if not isinstance(returned, MassProperties):
                raise fault(
                    f"returned {_check.shown(returned)}",
                    "return fb.mass_properties(mass=..., com=..., inertia_about_com=...)",
                )
            return Output([returned.mass, *returned.com, *returned.tensor])

        self._program, _ = traced(own_name, function, what, finish)

    def core(self) -> tuple[_core.Program, list[float]]:
        return self._program, [p.value for p in self._parameters]


@overload
def contents(function: Callable[..., Any], /) -> ContentsLaw: ...


@overload
def contents(
    *,
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    name: str | None = None,
) -> Callable[[Callable[..., Any]], ContentsLaw]: ...


def contents(
    function: Callable[..., Any] | None = None,
    /,
    *,
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    name: str | None = None,
) -> ContentsLaw | Callable[[Callable[..., Any]], ContentsLaw]:
    """Make contents of a Python function of the situation `s`, and of its parameters `p`.

    A force has them as its `contents`. The body and all contents are one body at every moment: its mass, mass
    centre and inertia are what forces see and what the equations have. `s.mass` and `s.com` in here are those
    of the body alone. Traced as forces are; see `force` for the arguments and for errors.

        @fb.contents(inputs={"fuel": "kg"})  # published by a force that has the state "fuel"
        def tank(s):
            return fb.mass_properties(mass=s.inputs.fuel, com=(-1.2, 0.0, 0.0))

    What flows in or out acts by wrenches, which forces give: nothing is added for it.

    Raises
    ------
    TraceError
        The function does what cannot be traced.
    """

    def decorate(function: Callable[..., Any]) -> ContentsLaw:
        return ContentsLaw(function, parameters, inputs, name)

    return decorate if function is None else decorate(function)
