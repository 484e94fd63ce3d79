"""How a model is connected: what feeds its inputs, and what its results are."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any, NamedTuple

import numpy as np

from freebody import _check
from freebody.dave_ml.definitions import Variable
from freebody.dave_ml.model import DaveModel
from freebody.dave_ml.standard import QUANTITIES, RESULTS, AirData, Result
from freebody.dave_ml.units import Si, known_si, measures
from freebody.errors import InputError

__all__ = ["Mapped", "Range", "Wiring", "wire"]

Mapped = float | str | None


class Range(NamedTuple):
    """From where to where a variable has samples, in units of the file."""

    variable: str
    low: float
    high: float


class Wiring(NamedTuple):
    """What feeds each input that is needed, and which variable is which result, all by varID.

    Attributes
    ----------
    held
        Inputs at a fixed value, in units of the file.
    flow
        Inputs that flight gives: the standard name.
    inputs
        Inputs of the law: its name there, and its unit.
    results
        By standard name: the variable.
    """

    model: DaveModel
    held: Mapping[str, float]
    flow: Mapping[str, str]
    inputs: Mapping[str, tuple[str, str]]
    results: Mapping[str, str]

    def given(self, air: AirData, inputs: Any) -> dict[str, Any]:
        """The model's inputs, in units of the file."""
        found: dict[str, Any] = dict(self.held)
        for id, name in self.flow.items():
            found[id] = QUANTITIES[name.casefold()].value(air) / self._si(id).factor
        for id, (name, _) in self.inputs.items():
            found[id] = getattr(inputs, name) / self._si(id).factor
        return found

    def evaluate(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """The results by standard name, in SI."""
        values = self.model.evaluate(given, self.results.values())
        return {name: values[id] * self._si(id).factor for name, id in self.results.items()}

    def constant(self, name: str) -> float | None:
        """A result that depends on nothing, in SI; None where the model has none of this name."""
        id = self.results.get(name)
        if id is None:
            return None
        if any(self.model.variables[source].role == "input" for source in self.model.sources([id])):
            raise InputError(f"{self.model.file}: {name!r} depends on inputs; it must be constant")
        return float(self.model.evaluate({}, [id])[id]) * self._si(id).factor

    @property
    def law_inputs(self) -> dict[str, str]:
        """Name: unit."""
        return dict(self.inputs.values())

    def ranges(self) -> tuple[Range, ...]:
        """Where all tables of a variable act; beyond it one of them at least holds its border values."""
        sources = self.model.sources(self.results.values())
        found: dict[str, tuple[float, float]] = {}
        for function in self.model.definitions.functions:
            if function.dependent in sources:
                for id, axis in zip(function.independents, function.table.axes, strict=True):
                    ends, others = axis.held(), found.get(id, (-np.inf, np.inf))
                    found[id] = (max(ends[0], others[0]), min(ends[1], others[1]))
        ranges = (Range(id, *ends) for id, ends in found.items() if self._flown(id))
        return tuple(r for r in ranges if np.isfinite(r.low) or np.isfinite(r.high))

    def _flown(self, id: str) -> bool:
        """Whether a variable comes from the flight or an input, and not from held values alone."""
        return any(source in self.flow or source in self.inputs for source in self.model.sources([id]))

    def _si(self, id: str) -> Si:
        return known_si(self.model.file, self.model.variables[id])


def wire(model: DaveModel, mapping: Mapping[str, Mapped] | None, adjusted: Collection[str] = ()) -> Wiring:
    """Connect a model; results that are constant zeros are left out, unless they are adjusted."""
    zeros = (v.id for v in model.variables.values() if v.role == "constant" and v.initial == 0.0)
    said: dict[str, Mapped] = {id: None for id in zeros if id not in adjusted}
    said |= {model.variable(name).id: what for name, what in (mapping or {}).items()}
    results = {
        result.name: found.id for result in RESULTS if (found := _found(model, result, said)) is not None
    }
    held: dict[str, float] = {}
    flow: dict[str, str] = {}
    inputs: dict[str, tuple[str, str]] = {}
    sources = model.sources(results.values())
    for variable in model.inputs:
        if variable.id not in sources:
            continue
        what = said.get(variable.id, variable.name)
        if what is None:
            raise InputError(f"mapping[{variable.name!r}]: None leaves out results; this is an input")
        if not isinstance(what, str):
            held[variable.id] = _check.number(f"mapping[{variable.name!r}]", what)
        elif (quantity := QUANTITIES.get(what.casefold())) is not None:
            flow[variable.id] = quantity.name
            measures(model.file, variable, quantity.unit)
        else:
            word = what if variable.id in said or what.isidentifier() else variable.id
            unit = known_si(model.file, variable).unit
            other = next((u for w, u in inputs.values() if w == word), unit)
            if other != unit:
                raise InputError(
                    f"mapping: {word!r} feeds variables in {other!r} and in {unit!r}; give two names"
                )
            inputs[variable.id] = (word, unit)
    return Wiring(model, held, flow, inputs, results)


def _found(model: DaveModel, result: Result, said: Mapping[str, Mapped]) -> Variable | None:
    """The variable that is this result: the one that the mapping says, or that has a name of it."""
    names = {name.casefold() for name in (result.name, *result.aliases)}
    found = []
    for variable in model.variables.values():
        what = said.get(variable.id, variable.name) if variable.role != "input" else None
        if isinstance(what, str) and what.casefold() in names:
            found.append(variable)
        elif variable.role != "input" and variable.id in said and not _is_result(what):
            known = ", ".join(result.name for result in RESULTS)
            raise InputError(
                f"mapping[{variable.name!r}]: got {_check.shown(what)}; the variable is {variable.role} by "
                f"the model: give None to leave it out, or one of {known}"
            )
    if len(found) > 1:
        raise InputError(
            f"{model.file}: {' and '.join(v.id for v in found)} are {result.name} both; leave one out, "
            f"mapping={{{found[-1].id!r}: None}}"
        )
    if found:
        measures(model.file, found[0], result.unit)
    return found[0] if found else None


def _is_result(what: Mapped) -> bool:
    if what is None:
        return True
    names = {name.casefold() for result in RESULTS for name in (result.name, *result.aliases)}
    return isinstance(what, str) and what.casefold() in names
