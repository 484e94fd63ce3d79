"""What a DAVE-ML file defines: header, variables, functions, check data."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from freebody.dave_ml.lookup import GriddedFunction
from freebody.dave_ml.mathml import Expression

__all__ = ["Author", "Definitions", "Function", "Header", "Reference", "Shot", "Signal", "Variable"]


class Author(NamedTuple):
    """Who wrote a file."""

    name: str
    organization: str


class Reference(NamedTuple):
    """A document that a file cites."""

    id: str
    author: str
    title: str
    date: str
    accession: str
    link: str


@dataclass(frozen=True)
class Header:
    """What a file says of itself; what it does not say is empty."""

    name: str
    authors: tuple[Author, ...]
    date: str
    version: str
    description: str
    references: tuple[Reference, ...]


@dataclass(frozen=True)
class Variable:
    """A quantity of a model.

    Attributes
    ----------
    name, id
        Its name, a standard one if `standard`, and the word by which the file itself refers to it (varID).
    units
        As the file writes them, "ft_s".
    role
        "input", "constant", "computed" by a calculation or "tabulated" by a function.
    output
        Whether it is a result of the model.
    initial, minimum, maximum
        The value of a constant, or of an input that is not given; the limits of the value.
    line
        Where it stands.
    """

    name: str
    id: str
    units: str
    role: str
    output: bool
    description: str = ""
    symbol: str = ""
    sign: str = ""
    axis_system: str = ""
    standard: bool = False
    initial: float | None = None
    minimum: float | None = None
    maximum: float | None = None
    expression: Expression | None = None
    line: int = 0


@dataclass(frozen=True)
class Function:
    """A table that gives the variable `dependent` from the variables `independents`."""

    name: str
    independents: tuple[str, ...]
    dependent: str
    table: GriddedFunction
    line: int


class Signal(NamedTuple):
    """A value in check data: of a variable, by name or ID, in the variable's units."""

    variable: str
    value: float
    tolerance: float | None


@dataclass(frozen=True)
class Shot:
    """One check case: the inputs, and what the model must give."""

    name: str
    inputs: tuple[Signal, ...]
    internals: tuple[Signal, ...]
    outputs: tuple[Signal, ...]


@dataclass(frozen=True)
class Definitions:
    """All that a file says."""

    file: str
    header: Header
    variables: tuple[Variable, ...]
    functions: tuple[Function, ...]
    shots: tuple[Shot, ...]
