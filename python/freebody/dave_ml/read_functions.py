"""Functions of a DAVE-ML file, with their breakpoints and tables."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TypeAlias

import numpy as np

from freebody._check import Array
from freebody.dave_ml.definitions import Function
from freebody.dave_ml.lookup import INTERPOLATIONS, Axis, GriddedFunction
from freebody.dave_ml.numbers import numbers, optional_number
from freebody.dave_ml.units import si
from freebody.dave_ml.xml_tree import Node

__all__ = ["read_functions"]

_SIDES = ("neither", "min", "max", "both")

Units: TypeAlias = Mapping[str, str]
"""Of the variables, by varID."""


def read_functions(root: Node, units: Units) -> tuple[Function, ...]:
    """The functions; `units` has all variables."""
    breakpoints = _identified(root.all("breakpointDef"), "bpID")
    definitions = [child for f in root.all("function") for d in f.all("functionDefn") for child in d.children]
    grids = _identified([*root.all("griddedTableDef"), *_of(definitions, "griddedTableDef")], "gtID")
    scatters = _identified([*root.all("ungriddedTableDef"), *_of(definitions, "ungriddedTableDef")], "utID")
    found: dict[str, Function] = {}
    for node in root.all("function"):
        function = _Reader(node, units, breakpoints, {"gtID": grids, "utID": scatters}).read()
        if function.dependent in found:
            raise node.error(
                f"the function of line {found[function.dependent].line} gives this variable already",
                function.dependent,
            )
        found[function.dependent] = function
    return tuple(found.values())


def _of(nodes: list[Node], tag: str) -> list[Node]:
    return [node for node in nodes if node.tag == tag]


def _identified(nodes: list[Node], key: str) -> dict[str, Node]:
    found: dict[str, Node] = {}
    for node in nodes:
        id = node.attributes.get(key)
        if id is None:  # nothing can refer to it
            continue
        if id in found:
            raise node.error(f"{key} {id!r} stands on line {found[id].line} already; give each its own")
        found[id] = node
    return found


class _Reader:
    """Reads one <function>; its errors say the function's name."""

    def __init__(
        self, node: Node, units: Units, breakpoints: dict[str, Node], tables: dict[str, dict[str, Node]]
    ) -> None:
        self.node, self.units, self.breakpoints, self.tables = node, units, breakpoints, tables
        self.name = node.attributes.get("name", "function")

    def read(self) -> Function:
        node = self.node
        points, references = node.all("independentVarPts"), node.all("independentVarRef")
        if bool(points) == bool(references):
            raise node.error(
                "needs <independentVarPts> or <independentVarRef> elements, of one kind", self.name
            )
        if points:
            dependent = node.needed("dependentVarPts")
            axes = [self._axis(point, numbers(point, self.name), point) for point in points]
            table = self._gridded(dependent, axes, numbers(dependent, self.name))
        else:
            dependent = node.needed("dependentVarRef")
            table = self._defined(references, dependent)
        return Function(
            self.name,
            tuple(self._variable(child) for child in (points or references)),
            self._variable(dependent),
            table,
            node.line,
        )

    def _variable(self, node: Node) -> str:
        id = node.attribute("varID")
        if id not in self.units:
            raise node.error(f"<{node.tag}> refers to {id!r}, which is no varID of this file", self.name)
        return id

    def _defined(self, references: list[Node], dependent: Node) -> GriddedFunction:
        """A function whose table stands apart: defined in it, or before and referred to."""
        definition = self.node.needed("functionDefn")
        table = definition.needed(
            "griddedTableRef", "griddedTableDef", "griddedTable",
            "ungriddedTableRef", "ungriddedTableDef", "ungriddedTable",
        )  # fmt: skip
        if table.tag.endswith("Ref"):
            key = "gtID" if table.tag.startswith("gridded") else "utID"
            if table.attribute(key) not in self.tables[key]:
                raise table.error(f"{key} {table.attribute(key)!r} is no table of this file", self.name)
            table = self.tables[key][table.attribute(key)]
        self._same_units(table, dependent)
        if table.tag.startswith("ungridded"):
            return self._ungridded(table, references)
        bound = table.needed("breakpointRefs").all("bpRef")
        if len(bound) != len(references):
            raise self.node.error(
                f"{len(references)} <independentVarRef> for a table of {len(bound)} breakpoint sets (line "
                f"{table.line}); give one for each",
                self.name,
            )
        axes = []
        for bp_ref, reference in zip(bound, references, strict=True):
            id = bp_ref.attribute("bpID")
            if id not in self.breakpoints:
                raise bp_ref.error(f"bpID {id!r} is no <breakpointDef> of this file", self.name)
            values = self.breakpoints[id].needed("bpVals")
            self._same_units(self.breakpoints[id], reference)
            axes.append(self._axis(reference, numbers(values, self.name), values))
        data = table.needed("dataTable")
        return self._gridded(data, axes, numbers(data, self.name))

    def _gridded(self, node: Node, axes: list[Axis], values: Array) -> GriddedFunction:
        shape = tuple(len(axis.breakpoints) for axis in axes)
        if len(values) != math.prod(shape):
            raise node.error(
                f"<{node.tag}> has {len(values)} numbers; the breakpoints need {' x '.join(map(str, shape))}",
                self.name,
            )
        return GriddedFunction(axes, values.reshape(shape))

    def _ungridded(self, table: Node, references: list[Node]) -> GriddedFunction:
        """Points in any order; of one variable they are a gridded table."""
        if len(references) != 1:
            raise table.error(
                f"an ungridded table of {len(references)} variables is not read; give a griddedTableDef",
                self.name,
            )
        points = table.all("dataPoint")
        rows = [numbers(point, self.name) for point in points]
        for point, row in zip(points, rows, strict=True):
            if len(row) != 2:
                raise point.error(
                    f"<dataPoint> has {len(row)} numbers; give the argument and the value", self.name
                )
        if not rows:
            raise table.error("has no <dataPoint>", self.name)
        data = np.array(sorted(rows, key=lambda row: row[0]))
        axis = self._axis(references[0], data[:, 0], table)
        return GriddedFunction([axis], data[:, 1])

    def _axis(self, node: Node, breakpoints: Array, where: Node) -> Axis:
        """What an <independentVarRef> or <independentVarPts> says, for breakpoints that stand at `where`."""
        back = np.flatnonzero(np.diff(breakpoints) <= 0.0) + 1
        if back.size:
            raise where.error(
                f"breakpoint {breakpoints[back[0]]:g} follows {breakpoints[back[0] - 1]:g}; they must rise",
                self.name,
            )
        interpolate = self._choice(node, "interpolate", "linear", (*INTERPOLATIONS, "quadraticSpline"))
        if interpolate == "quadraticSpline":
            raise node.error(
                "interpolate='quadraticSpline' is not read: the standard leaves open which of many it is; "
                f"allowed are {', '.join(INTERPOLATIONS)}",
                self.name,
            )
        extrapolate = self._choice(node, "extrapolate", "neither", _SIDES)
        low, high = (optional_number(node, end, self.name) for end in ("min", "max"))
        axis = Axis(
            breakpoints,
            interpolate,
            extrapolate,
            -math.inf if low is None else low,
            math.inf if high is None else high,
        )
        if axis.minimum > axis.maximum:
            raise node.error(f"min={axis.minimum:g} is above max={axis.maximum:g}", self.name)
        beyond = (axis.minimum < breakpoints[0] and extrapolate in ("min", "both")) or (
            axis.maximum > breakpoints[-1] and extrapolate in ("max", "both")
        )
        if interpolate == "cubicSpline" and beyond:
            raise node.error(f"extrapolate={extrapolate!r} is read with linear interpolation only", self.name)
        if interpolate == "linear" and beyond and len(breakpoints) < 2:
            raise node.error(f"extrapolate={extrapolate!r} needs two breakpoints", self.name)
        return axis

    def _choice(self, node: Node, attribute: str, default: str, allowed: tuple[str, ...]) -> str:
        word = node.attributes.get(attribute, default)
        if word not in allowed:
            raise node.error(f"{attribute}={word!r}; allowed are {', '.join(allowed)}", self.name)
        return word

    def _same_units(self, definition: Node, use: Node) -> None:
        """Breakpoints and tables may say their units; they are those of the variable."""
        said, own = definition.attributes.get("units", ""), self.units[self._variable(use)]
        of_definition, of_variable = si(said), si(own)
        if said and own and of_definition and of_variable and of_definition != of_variable:
            raise definition.error(
                f"<{definition.tag}> is in {said!r}, {use.attribute('varID')!r} in {own!r}; they must agree",
                self.name,
            )
