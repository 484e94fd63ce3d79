"""Calculations in MathML content markup: read into trees, evaluated with numbers, arrays or traced values."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np

from freebody.dave_ml.operations import CONSTANTS, OPERATIONS, Operation
from freebody.dave_ml.xml_tree import Node

__all__ = ["Expression", "evaluate", "read_math", "references"]


class Number(NamedTuple):
    """A constant."""

    value: float


class Reference(NamedTuple):
    """The value of a variable."""

    variable: str
    line: int


class Apply(NamedTuple):
    """An operation and its arguments."""

    operation: str
    arguments: tuple[Expression, ...]


class Piecewise(NamedTuple):
    """The value of the first piece whose condition holds, or the last value."""

    pieces: tuple[tuple[Expression, Expression], ...]
    otherwise: Expression


Expression: TypeAlias = Number | Reference | Apply | Piecewise
Kind = Literal["number", "truth"]


def evaluate(expression: Expression, values: Mapping[str, Any]) -> Any:
    """The value of an expression, given those of the variables it refers to."""
    match expression:
        case Number(value):
            return np.float64(value)
        case Reference(variable):
            return values[variable]
        case Apply(operation, arguments):
            return OPERATIONS[operation].function(*(evaluate(a, values) for a in arguments))
        case Piecewise(pieces, otherwise):
            chosen = evaluate(otherwise, values)
            for value, condition in reversed(pieces):
                chosen = np.where(evaluate(condition, values), evaluate(value, values), chosen)
            return chosen


def references(expression: Expression) -> Iterator[Reference]:
    """The variables that an expression refers to."""
    match expression:
        case Reference():
            yield expression
        case Apply(_, arguments):
            for argument in arguments:
                yield from references(argument)
        case Piecewise(pieces, otherwise):
            for part in (*(part for piece in pieces for part in piece), otherwise):
                yield from references(part)


def read_math(calculation: Node, variable: str) -> Expression:
    """The expression of a <calculation>; its faults name the variable."""
    math_element = calculation.needed("math")
    content = _only(math_element, variable)
    if content.tag == "semantics":
        content = content.children[0] if content.children else _only(content, variable)
    return _as("number", *_Reader(variable).read(content))


def _only(node: Node, variable: str) -> Node:
    if len(node.children) != 1:
        raise node.error(f"<{node.tag}> has {len(node.children)} elements; give one expression", variable)
    return node.children[0]


def _as(wanted: Kind, expression: Expression, kind: Kind) -> Expression:
    """A condition counts as 1 or 0 where a number is needed, a number as true unless it is 0."""
    if kind == wanted:
        return expression
    return Apply("as number" if wanted == "number" else "as truth", (expression,))


class _Reader:
    """Reads the expressions of one variable, whose name its errors say."""

    def __init__(self, variable: str) -> None:
        self.variable = variable

    def read(self, node: Node) -> tuple[Expression, Kind]:
        readers: dict[str, Callable[[Node], tuple[Expression, Kind]]] = {
            "apply": self._apply,
            "ci": lambda node: (Reference(node.words(), node.line), "number"),
            "cn": lambda node: (Number(self._number(node)), "number"),
            "piecewise": lambda node: (self._piecewise(node), "number"),
        }
        if node.tag in readers:
            return readers[node.tag](node)
        if node.tag in CONSTANTS:
            return Number(CONSTANTS[node.tag]), "number"
        known = ", ".join(f"<{tag}>" for tag in (*readers, *CONSTANTS))
        raise node.error(
            f"<{node.tag}> is no expression that is read here; allowed are {known}", self.variable
        )

    def _number(self, node: Node) -> float:
        """<cn>, with <sep/> between two parts for types that have two."""
        parts, kind = node.text.split(), node.attributes.get("type", "real")
        wanted = {"real": 1, "integer": 1, "rational": 2, "e-notation": 2}
        if kind not in wanted or node.attributes.get("base", "10") != "10":
            raise node.error(
                f"<cn> of type {kind!r}, base {node.attributes.get('base', '10')}; allowed are "
                f"{', '.join(wanted)}, base 10",
                self.variable,
            )
        try:
            first, *rest = (float(part) for part in parts)
            if len(parts) == wanted[kind]:
                value = first / rest[0] if kind == "rational" else first * 10.0 ** sum(rest)
                if kind == "e-notation":
                    value = float(f"{parts[0]}e{parts[1]}")
                if math.isfinite(value):
                    return value
        except (ValueError, ZeroDivisionError):
            pass
        raise node.error(
            f"<cn> came with {node.words()!r}; give a finite number of type {kind}", self.variable
        )

    def _piecewise(self, node: Node) -> Piecewise:
        pieces = []
        for piece in node.all("piece"):
            if len(piece.children) != 2:
                raise piece.error(
                    f"<piece> has {len(piece.children)} elements; give value, condition", self.variable
                )
            value, condition = (self.read(child) for child in piece.children)
            pieces.append((_as("number", *value), _as("truth", *condition)))
        otherwise = node.child("otherwise")
        if otherwise is None or not pieces:
            raise node.error(
                "<piecewise> needs a <piece>, and an <otherwise> for where no piece holds",
                self.variable,
            )
        return Piecewise(tuple(pieces), _as("number", *self.read(_only(otherwise, self.variable))))

    def _apply(self, node: Node) -> tuple[Expression, Kind]:
        if len(node.children) == 1 and node.children[0].tag in ("piecewise", "apply", "ci", "cn"):
            return self.read(node.children[0])  # files wrap what needs no wrapping
        if not node.children:
            raise node.error("<apply> is empty; give an operator and its arguments", self.variable)
        head, *rest = node.children
        name, operation = self._operation(head)
        qualifiers = [child for child in rest if child.tag in ("degree", "logbase")]
        for i, qualifier in enumerate(qualifiers):
            if i > 0 or qualifier.tag != operation.qualifier:
                raise qualifier.error(f"<{name}> takes no <{qualifier.tag}>", self.variable)
        operands = [child for child in rest if child not in qualifiers]
        if not operation.least <= len(operands) <= operation.most:
            allowed = {1: "1", 2: f"{operation.least} to 2"}.get(operation.most, f"{operation.least} or more")
            allowed = f"{operation.least}" if operation.least == operation.most else allowed
            raise node.error(
                f"<{name}> came with {len(operands)} arguments; it takes {allowed}", self.variable
            )
        operands += [_only(qualifier, self.variable) for qualifier in qualifiers]
        arguments = tuple(_as(operation.takes, *self.read(operand)) for operand in operands)
        if name == "power" and arguments[1] == Number(0.5):
            return Apply("root", arguments[:1]), "number"
        return Apply(name, arguments), operation.gives

    def _operation(self, head: Node) -> tuple[str, Operation]:
        name = head.words() if head.tag == "csymbol" else head.tag
        if name in OPERATIONS and (head.tag == "csymbol") == (name == "atan2"):
            return name, OPERATIONS[name]
        came = f"<csymbol> {name!r}" if head.tag == "csymbol" else f"<{name}>"
        known = ", ".join(name for name in OPERATIONS if " " not in name and name != "atan2")
        raise head.error(f"{came} is no operator; allowed are {known}, and <csymbol> atan2", self.variable)
