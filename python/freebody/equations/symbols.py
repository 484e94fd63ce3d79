"""Symbols: their names in code and in formulas, and the vectors that they make."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable
from typing import NamedTuple

from freebody import _core
from freebody.errors import InputError

__all__ = ["Group", "Symbols", "angle_names", "checked_name", "identifier"]

_GREEK = """
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi
    psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega
"""
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
_TEMPORARY = re.compile(r"t\d+\Z")
_TAKEN = """
    auto break case char const continue default do double else enum extern float for goto if inline int long
    register restrict return short signed sizeof static struct switch typedef union unsigned void volatile
    while sin cos tan asin acos atan atan2 sinh cosh tanh exp log pow sqrt fabs floor main NAN INFINITY size_t
    left right jacobian given out column n l np jnp ca sp
"""


class Group(NamedTuple):
    """Symbols that are one argument of a printed function."""

    name: str
    ids: tuple[int, ...]
    symbols: tuple[str, ...]
    units: tuple[str, ...]
    meaning: str
    scalar: bool = False

    def only(self, used: set[int]) -> Group:
        """Those of its symbols that are used."""
        kept = [i for i, expression in enumerate(self.ids) if expression in used]
        ids, symbols, units = (tuple(of[i] for i in kept) for of in (self.ids, self.symbols, self.units))
        return self._replace(ids=ids, symbols=symbols, units=units)


class Symbols:
    """The symbols of a graph, made group by group."""

    def __init__(self, graph: _core.Graph) -> None:
        self.graph = graph
        self.groups: list[Group] = []

    def named_by_users(
        self, name: str, given: Iterable[str], units: Iterable[str], meaning: str
    ) -> list[int]:
        """New symbols of names that need not fit: "fin.servo", or one that is taken, become identifiers."""
        taken = {s for g in self.groups for s in g.symbols}
        names: list[str] = []
        for text in given:
            made = identifier(text)
            while made in taken or made in names or not _is_free(made):
                made = f"{name}_{made}"
            names.append(made)
        return self.group(name, names, units, meaning)

    def group(
        self, name: str, symbols: Iterable[str], units: Iterable[str], meaning: str, *, scalar: bool = False
    ) -> list[int]:
        """New symbols; the numbers of their expressions."""
        names = tuple(symbols)
        ids = tuple(self.graph.symbol(s, latex_of(s)) for s in names)
        self.groups.append(Group(name, ids, names, tuple(units), meaning, scalar))
        return list(ids)


def angle_names(angles: str) -> list[str]:
    """phi, theta, psi for turns about x, y, z; numbered where an axis comes twice. Konoplev, section 4."""
    stems = {"x": "phi", "y": "theta", "z": "psi"}
    twice = angles[0] == angles[2]
    return [
        stems[axis] + (f"_{1 if i == 0 else 2}" if twice and i != 1 else "") for i, axis in enumerate(angles)
    ]


def _is_free(name: str) -> bool:
    """Whether a symbol may bear a name in every language."""
    if not _IDENTIFIER.match(name) or _TEMPORARY.match(name) or name.endswith("_"):
        return False
    return name not in _TAKEN.split() and not keyword.iskeyword(name)


def checked_name(field: str, name: str) -> str:
    """Check that a symbol's name can stand in every language."""
    if not _is_free(name):
        raise InputError(
            f"{field}: {name!r} cannot be the name of a symbol in code; give letters, digits and underscores "
            'that start with a letter and are no word of C or Python, such as "J_xx"'
        )
    return name


def identifier(name: str) -> str:
    """A name made of what is no identifier, such as "fin.servo"."""
    made = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_") or "symbol"
    return made if made[0].isalpha() else f"n_{made}"


def latex_of(name: str) -> str:
    """A name in LaTeX: derivatives as dots, what follows an underscore as an index."""
    for ending, dots in (("_ddot", r"\ddot"), ("_dot", r"\dot")):
        if name.endswith(ending):
            stem, _, index = name.removesuffix(ending).partition("_")
            dotted = f"{dots}{{{_letter(stem)}}}"
            return f"{dotted}_{{{_index(index)}}}" if index else dotted
    stem, _, index = name.partition("_")
    return f"{_letter(stem)}_{{{_index(index)}}}" if index else _letter(stem)


def _letter(stem: str) -> str:
    if stem in _GREEK.split():
        return f"\\{stem}"
    return stem if len(stem) == 1 else rf"\mathrm{{{stem}}}"


def _index(index: str) -> str:
    text = index.replace("_", r"\_")
    return text if len(index.replace("_", "")) <= 2 else rf"\mathrm{{{text}}}"
