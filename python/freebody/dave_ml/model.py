"""Models read from DAVE-ML files: functions of named inputs, of numbers, arrays or traced values."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.body import RigidBody
from freebody.dave_ml.check_data import CheckData, CheckRow
from freebody.dave_ml.definitions import Definitions, Function, Header, Shot, Variable
from freebody.dave_ml.mass import MassProperties, mass_properties
from freebody.dave_ml.mathml import evaluate, references
from freebody.dave_ml.read import read_dave_ml
from freebody.errors import InputError, ModelFileError
from freebody.tracing.lookup import is_traced

__all__ = ["DaveModel", "load_dave_ml"]


def load_dave_ml(path: str | PathLike[str]) -> DaveModel:
    """A model of a DAVE-ML file (ANSI/AIAA S-119-2011; version 2.0, 1.x as well).

    Raises
    ------
    ModelFileError
        What cannot be read, with file, line and varID: what came, and what is allowed. See docs/dave-ml.md.
    """
    return DaveModel(read_dave_ml(Path(path)))


class DaveModel:
    """A static model: outputs by name, from inputs by name, all in the units of the file.

        model = fb.load_dave_ml("F16_aero.dml")
        model(trueAirspeed=500.0, angleOfAttack=5.0, ...)["aeroBodyForceCoefficient_X"]

    It is called with numbers or arrays, which broadcast, or inside a law with traced values; then it is part
    of the law's program, derivatives and all.

    Attributes
    ----------
    header
        Authors, date, version, description and references.
    variables
        All of them, by varID.
    inputs, outputs
        Those that it takes and gives. An input with an initial value need not be given. Where a file marks
        no outputs, they are what is computed and used by nothing else.
    """

    def __init__(self, definitions: Definitions) -> None:
        self.definitions = definitions
        self.file = definitions.file
        self.header: Header = definitions.header
        self.variables: Mapping[str, Variable] = {v.id: v for v in definitions.variables}
        self._functions: dict[str, Function] = {f.dependent: f for f in definitions.functions}
        self._uses = {v.id: self._used_by(v) for v in definitions.variables}
        self._order = self._sorted()
        used = {id for uses in self._uses.values() for id in uses}
        self.inputs = tuple(v for v in definitions.variables if v.role == "input")
        results = [
            v for v in definitions.variables if v.role in ("computed", "tabulated") and v.id not in used
        ]
        marked = {v.id for v in definitions.variables if v.output} | {v.id for v in results}
        self.outputs = tuple(v for v in definitions.variables if v.id in marked)

    def __call__(self, values: Mapping[str, Any] | None = None, /, **more: Any) -> dict[str, Any]:
        """The outputs by name, given the inputs by name or varID, and other values for constants."""
        given = self.given({**(values or {}), **more})
        found = self.evaluate(given, [v.id for v in self.outputs])
        names = [v.name for v in self.outputs]
        return {v.name if names.count(v.name) == 1 else v.id: _bare(found[v.id]) for v in self.outputs}

    def variable(self, name: str) -> Variable:
        """The variable of this varID or name; a name that several have is no name."""
        if name in self.variables:
            return self.variables[name]
        named = [v for v in self.variables.values() if v.name == name]
        if len(named) == 1:
            return named[0]
        if named:
            raise InputError(
                f"{self.file}: several variables have the name {name!r}; give the varID, "
                f"{' or '.join(v.id for v in named)}"
            )
        known = [*self.variables, *(v.name for v in self.variables.values())]
        near = difflib.get_close_matches(name, known, n=1)
        inputs = ", ".join(v.name for v in self.inputs)
        raise InputError(
            f"{self.file}: {name!r} is no variable{f'; did you mean {near[0]!r}?' if near else ''} "
            f"(inputs: {inputs})"
        )

    def given(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Checked values by varID of what can be given: inputs and constants."""
        found: dict[str, Any] = {}
        for name, value in values.items():
            variable = self.variable(name)
            if variable.role not in ("input", "constant"):
                raise InputError(
                    f"{self.file}: {name!r} is {variable.role} by the model, and cannot be given"
                )
            if variable.id in found:
                raise InputError(f"{self.file}: {variable.name!r} came twice, by name and by varID")
            found[variable.id] = 1.0 * value if is_traced(value) else _numbers(name, value)
        return found

    def evaluate(self, given: Mapping[str, Any], wanted: Iterable[str]) -> dict[str, Any]:
        """The values of variables, by varID, and of all that they come from."""
        needed = self.sources(wanted)
        values: dict[str, Any] = {}
        with np.errstate(all="ignore"):  # what is not finite may stand in a piece that is not chosen
            for id in self._order:
                if id in needed:
                    values[id] = self._limited(self.variables[id], self._value(id, given, values))
        return values

    def sources(self, wanted: Iterable[str]) -> set[str]:
        """The variables, by varID, from which the wanted ones come, and these."""
        needed: set[str] = set()
        rest = list(wanted)
        while rest:
            id = rest.pop()
            if id not in needed:
                needed.add(id)
                rest += self._uses[id]
        return needed

    def mass_properties(
        self,
        values: Mapping[str, Any] | None = None,
        /,
        *,
        reference_point: ArrayLike = (0.0, 0.0, 0.0),
        body_from_model: ArrayLike | None = None,
    ) -> MassProperties:
        """Mass, mass centre and inertia of a model that gives them under standard names; SI, body axes.

        Parameters
        ----------
        values
            The inputs, as in a call of the model: numbers or, inside a law, traced values.
        reference_point, body_from_model
            As in `DaveAerodynamics`: from where the file counts the mass centre, and its axes.
        """
        return mass_properties(self, values or {}, reference_point, body_from_model)

    def rigid_body(
        self,
        values: Mapping[str, Any] | None = None,
        /,
        *,
        reference_point: ArrayLike = (0.0, 0.0, 0.0),
        body_from_model: ArrayLike | None = None,
        name: str | None = None,
    ) -> RigidBody:
        """The body of the mass properties at given inputs; see `mass_properties`."""
        found = mass_properties(self, values or {}, reference_point, body_from_model)
        label = (self.header.name or "body") if name is None else name
        return RigidBody(float(found.mass), found.com, inertia_about_com=found.inertia_about_com, name=label)

    def check(self) -> CheckData:
        """The residuals against the file's own check data."""
        return CheckData(tuple(row for shot in self.definitions.shots for row in self._check(shot)))

    def __repr__(self) -> str:
        counts = f"{len(self.inputs)} inputs, {len(self.outputs)} outputs"
        return f"<DaveModel {self.header.name or self.file!r}: {counts}>"

    def _value(self, id: str, given: Mapping[str, Any], values: Mapping[str, Any]) -> Any:
        variable = self.variables[id]
        if id in given:
            return given[id]
        if id in self._functions:
            function = self._functions[id]
            return function.table(*(values[argument] for argument in function.independents))
        if variable.expression is not None:
            return evaluate(variable.expression, values)
        if variable.initial is None:
            raise InputError(f"{self.file}: the input {variable.name!r} ({variable.units}) is missing")
        return np.float64(variable.initial)

    def _limited(self, variable: Variable, value: Any) -> Any:
        if variable.minimum is not None:
            value = np.maximum(value, variable.minimum)
        return value if variable.maximum is None else np.minimum(value, variable.maximum)

    def _check(self, shot: Shot) -> list[CheckRow]:
        given = {s.variable: np.float64(s.value) for s in shot.inputs if self._can_be_given(s.variable)}
        expected = [("internal", s) for s in shot.internals] + [("output", s) for s in shot.outputs]
        values = self.evaluate(given, [s.variable for _, s in expected])
        return [
            CheckRow(
                shot.name,
                kind,
                self.variables[s.variable].name if kind == "output" else s.variable,
                self.variables[s.variable].units,
                s.value,
                float(values[s.variable]),
                s.tolerance,
            )
            for kind, s in expected
        ]

    def _can_be_given(self, id: str) -> bool:
        return self.variables[id].role in ("input", "constant")

    def _used_by(self, variable: Variable) -> tuple[str, ...]:
        """What a variable comes from."""
        if variable.id in self._functions:
            return self._functions[variable.id].independents
        if variable.expression is None:
            return ()
        found = tuple(references(variable.expression))
        for reference in found:
            if reference.variable not in self.variables:
                raise ModelFileError(
                    f"<ci> refers to {reference.variable!r}, which is no varID of this file",
                    file=self.file,
                    line=reference.line,
                    key=variable.id,
                )
        return tuple(dict.fromkeys(reference.variable for reference in found))

    def _sorted(self) -> tuple[str, ...]:
        """All variables, each behind what it comes from."""
        order: dict[str, None] = {}
        for start in self.variables:
            path, pending = [start], [iter(self._uses[start])]
            while path:
                following = next((id for id in pending[-1] if id not in order), None)
                if following is None:
                    order[path.pop()] = None
                    pending.pop()
                elif following in path:
                    loop = " from ".join([*path[path.index(following) :], following])
                    raise ModelFileError(
                        f"comes from itself: {loop}; a static model has no loops",
                        file=self.file,
                        line=self.variables[following].line,
                        key=following,
                    )
                else:
                    path.append(following)
                    pending.append(iter(self._uses[following]))
        return tuple(order)


def _numbers(name: str, value: Any) -> Any:
    return _check.numbers(name, value, *np.shape(value))[()]


def _bare(value: Any) -> Any:
    """A value without what a law knows of its unit: the formulas of files mix units freely."""
    if is_traced(value):
        return 1.0 * value
    return value if np.ndim(value) else float(value)
