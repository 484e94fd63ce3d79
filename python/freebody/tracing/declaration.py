"""What a law declares beside its function: parameters, inputs, states."""

from __future__ import annotations

import keyword
from collections.abc import Mapping
from typing import Any, NamedTuple

from freebody import _check
from freebody.errors import InputError
from freebody.forces import Quantity, StateQuantity
from freebody.units import dimension, to_si

__all__ = ["Declared", "Parameter", "Shared", "declared", "declared_inputs"]


class Shared(NamedTuple):
    """Value and unit of a parameter that all laws of a model which have it have in common."""

    value: float
    unit: str


class Parameter(NamedTuple):
    """A parameter: its name, its unit of SI, its value; whether other laws have the same."""

    name: str
    unit: str
    value: float
    shared: bool = False


class Declared(NamedTuple):
    """What a law reads and moves beside the motion of the body."""

    parameters: tuple[Parameter, ...]
    inputs: tuple[Quantity, ...]
    states: tuple[StateQuantity, ...]


def declared(law: str, parameters: object, inputs: object, states: object) -> Declared:
    """Check what came with a decorator."""
    values = _pairs(law, "parameters", parameters, "value")
    given = _mapping(law, "parameters", parameters, "")
    return Declared(
        tuple(Parameter(*entry, shared=isinstance(given[entry[0]], Shared)) for entry in values),
        declared_inputs(law, inputs),
        tuple(StateQuantity(*entry) for entry in _pairs(law, "states", states, "start value")),
    )


def declared_inputs(law: str, inputs: object) -> tuple[Quantity, ...]:
    """Check inputs: a unit for each name."""
    found = []
    for name, unit in _mapping(law, "inputs", inputs, '{"rudder": "rad"}').items():
        dimension(f"{law}: inputs[{name!r}]", unit)
        found.append(Quantity(name, unit))
    return tuple(found)


def _pairs(law: str, what: str, given: object, number: str) -> list[tuple[str, str, float]]:
    found = []
    for name, pair in _mapping(law, what, given, '{"area": (0.02, "m^2")}').items():
        where = f"{law}: {what}[{name!r}]"
        if not isinstance(pair, tuple | list) or len(pair) != 2:
            raise InputError(
                f'{where}: got {_check.shown(pair)}; give ({number}, unit), such as (0.02, "m^2")'
            )
        value, unit = pair
        dimension(where, unit)
        found.append((name, unit, to_si(where, value, unit)))
    return found


def _mapping(law: str, what: str, given: object, example: str) -> Mapping[str, Any]:
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise InputError(f"{law}: {what}: got {_check.shown(given)}; give a dictionary such as {example}")
    for name in given:
        check_name(f"{law}: {what}", name)
    return given


def check_name(where: str, name: object) -> None:
    """Names are read as attributes, p.area, and set as arguments, fin(area=0.03)."""
    fits = isinstance(name, str) and name.isidentifier() and not keyword.iskeyword(name)
    if not fits or str(name).startswith("_"):
        raise InputError(f"{where}: got the name {_check.shown(name)}; give a word of letters, digits and _")
    if name == "name":
        raise InputError(f'{where}: "name" is the name of the law itself; choose another word')
