"""Scalar equations and what can be printed of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.equations.symbols import Group, checked_name
from freebody.errors import InputError

__all__ = ["Equations", "OperationCount", "Result"]

_LONG = 200_000
"""Operations beyond which nobody reads an equation that is written out."""


class OperationCount(NamedTuple):
    """How many operations it takes to compute equations."""

    written_out: int
    """If every equation is written out in full."""
    shared: int
    """If what occurs several times is computed once."""


class Result(NamedTuple):
    """One result of the printed functions: a vector, or a matrix by rows."""

    name: str
    ids: tuple[int, ...]
    columns: int | None
    labels: tuple[str, ...]
    """How LaTeX calls the entries."""
    meaning: str


class Equations:
    """Scalar equations, made by `freebody.equations`.

    Two kinds: a balance, whose results are `left` and `right` and which says that they are equal, and a
    function, whose results are what is computed.

    The printed functions take one argument for each of `arguments`, in this order: a vector of the symbols
    named there (rows of an array in NumPy and JAX, which may have trailing dimensions), or one number.

    Attributes
    ----------
    form
        The paper's number, or the name of the matrix.
    title
        What the equations say, in one line.
    arguments
        Name of each argument, and the names of its symbols.
    """

    def __init__(
        self,
        graph: _core.Graph,
        form: str,
        title: str,
        groups: list[Group],
        results: list[Result],
        balance: bool,
    ) -> None:
        self._graph = graph
        self.form, self.title = form, title
        self._groups, self._results, self._balance = tuple(groups), tuple(results), balance

    @property
    def arguments(self) -> dict[str, tuple[str, ...]]:
        """Names of the symbols of each argument of the printed functions."""
        return {g.name: g.symbols for g in self._groups}

    @property
    def results(self) -> dict[str, tuple[int, ...]]:
        """Shape of each result of the printed functions."""
        return {r.name: _shape(r) for r in self._results}

    @property
    def operation_count(self) -> OperationCount:
        """Sums, products, quotients, roots, sines and so on, of all results together."""
        return OperationCount(int(self._count(shared=False)[0]), self._count(shared=True)[1])

    def latex(self, *, common: bool = False) -> str:
        """The equations for people to read, one a line, for LaTeX's align*; zero entries are left out.

        `common=True` lists first what occurs several times, as sigma_1 and so on.

        Raises
        ------
        InputError
            The equations are too long to be written out.
        """
        length = self._count(shared=common)[0]
        if not common and length > _LONG:
            raise InputError(
                f"equations {self.form}: {length:.3g} operations are too many to be written out; use "
                "latex(common=True)"
            )
        lines: list[tuple[str | int, int]]
        if self._balance:
            left, right = self._results
            lines = list(zip(left.ids, right.ids, strict=True))
        else:
            entries = [(n, i, r.columns) for r in self._results for n, i in zip(r.labels, r.ids, strict=True)]
            lines = [(n, i) for n, i, columns in entries if columns is None or self._graph.value(i) != 0.0]
        return self._graph.latex(lines, common)

    def _repr_latex_(self) -> str:
        """For notebooks; what is too long to be written out is listed by its common expressions."""
        return self.latex(common=self._count(shared=False)[0] > _LONG // 100)

    def c(self, name: str | None = None) -> str:
        """A function in C99: no dependency but math.h; its header comment states order, frames and units."""
        return self._code("c", name)

    def numpy(self, name: str | None = None) -> str:
        """A Python function over NumPy arrays."""
        return self._code("numpy", name)

    def jax(self, name: str | None = None) -> str:
        """A Python function over JAX arrays, which JAX can compile, batch and differentiate."""
        return self._code("jax", name)

    def casadi(self, name: str | None = None) -> str:
        """A Python function over CasADi's numbers and symbols."""
        return self._code("casadi", name)

    def sympy(self, name: str | None = None) -> str:
        """A Python function over SymPy's symbols and numbers."""
        return self._code("sympy", name)

    def block(self, name: str) -> tuple[str, int, int]:
        """A C function `void name(size_t n, const double *given, double *out)` over n columns.

        `given` holds n columns of each symbol of the arguments, one symbol after another, and `out` of each
        entry of the results. Also returns how many symbols and how many entries there are.
        """
        self._count(shared=True)
        given = [i for g in self._groups for i in g.ids]
        return self._graph.block(checked_name("name", name), given, self._ids()), len(given), len(self._ids())

    def evaluate(self, **arguments: ArrayLike) -> Mapping[str, Array]:
        """The results for numbers.

        Each of `arguments` as an array (..., n), or (...) for one number; leading dimensions broadcast.
        """
        given = self._given(arguments)
        batch = np.broadcast_shapes(*(a.shape[:-1] for a in given))
        rows = [np.broadcast_to(a, (*batch, a.shape[-1])).reshape(-1, a.shape[-1]) for a in given]
        program = self._graph.program([], [i for g in self._groups for i in g.ids], self._ids())
        out = program.run([], np.ascontiguousarray(np.hstack([np.empty((max(1, _size(batch)), 0)), *rows])))
        ends = np.cumsum([len(r.ids) for r in self._results])[:-1]
        parts = np.split(out, ends, axis=1)
        return {r.name: p.reshape(*batch, *_shape(r)) for r, p in zip(self._results, parts, strict=True)}

    def jacobian(self, by: str) -> Equations:
        """The exact derivatives of the result by the symbols of an argument, as a matrix.

        Of a balance, those of left minus right. Konoplev (3.2)
        """
        group = next((g for g in self._groups if g.name == by), None)
        if group is None:
            raise InputError(f"by: got {by!r}; allowed are {', '.join(self.arguments)}")
        if self._balance:
            left, right = self._results
            pairs = zip(left.ids, right.ids, strict=True)
            name, ids = "residual", [self._graph.binary("sub", a, b) for a, b in pairs]
        elif len(self._results) == 1 and self._results[0].columns is None:
            name, ids = self._results[0].name, list(self._results[0].ids)
        else:
            raise InputError(f"equations {self.form}: only vectors have a Jacobian here, not a matrix")
        entries = self._graph.jacobian(ids, list(group.ids))
        n = len(group.ids)
        labels = tuple(f"J_{{{i // n + 1},{i % n + 1}}}" for i in range(len(entries)))
        meaning = f"row i, column j: the derivative of entry i of {name} by entry j of {by}"
        result = Result("jacobian", tuple(entries), n, labels, meaning)
        title = f"derivatives of {name} by {by}; {self.title}"
        return Equations(self._graph, f"{self.form}, d/d{by}", title, list(self._groups), [result], False)

    def _ids(self) -> list[int]:
        return [i for r in self._results for i in r.ids]

    def _count(self, *, shared: bool) -> tuple[float, int]:
        """Makes the equations short in one of two senses, and says how long they are."""
        self._graph.settle(self._ids(), shared)
        return self._graph.operation_count(self._ids())

    def _given(self, arguments: dict[str, ArrayLike]) -> list[Array]:
        names = [g.name for g in self._groups]
        if set(arguments) != set(names):
            raise InputError(f"evaluate: got {sorted(arguments)}; the arguments are {names}")
        given = []
        for g in self._groups:
            if g.scalar:
                value = _check.argument(g.name, np.expand_dims(np.asarray(arguments[g.name]), -1), 1)
            else:
                value = _check.argument(g.name, arguments[g.name], len(g.ids))
            given.append(value.array)
        return given

    def _code(self, language: str, name: str | None) -> str:
        self._count(shared=True)
        default = "f_" + "".join(c if c.isalnum() else "_" for c in self.form)
        function = default if name is None else checked_name("name", name)
        groups = [(g.name, list(g.ids), g.scalar) for g in self._groups]
        outputs = [(r.name, list(r.ids), r.columns) for r in self._results]
        return self._graph.code(language, function, self._comment(), groups, outputs)

    def _comment(self) -> list[str]:
        lines = [self.title, "", "Arguments:"]
        for g in self._groups:
            symbols = ", ".join(f"{s} [{u}]" for s, u in zip(g.symbols, g.units, strict=True))
            lines += [f"  {g.name}: {g.meaning}:", f"    {symbols}"]
        lines.append("Results:")
        for r in self._results:
            shape = " x ".join(map(str, _shape(r)))
            lines.append(f"  {r.name} ({shape}): {r.meaning}")
        return lines

    def __repr__(self) -> str:
        return f"<Equations {self.form}: {self.title}; {self.operation_count.shared} operations>"


def _shape(result: Result) -> tuple[int, ...]:
    n = len(result.ids)
    return (n,) if result.columns is None else (n // result.columns, result.columns)


def _size(batch: tuple[int, ...]) -> int:
    return int(np.prod(batch, dtype=int))
