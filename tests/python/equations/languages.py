"""Printed code, run as its readers would run it."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable, Mapping
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import casadi as ca
import jax
import numpy as np
import sympy as sp
from numpy.typing import NDArray
from sympy.functions.elementary.piecewise import ExprCondPair

import freebody as fb

Array = NDArray[np.float64]
Results = list[Array]
Run = Callable[["fb.Equations", Mapping[str, Array]], Results]
"""Arguments (n, ...) by name to results (n, ...) in order."""

# Of two functions of the same text, as of one form in two charts that it does not read, GCC makes one, and
# then warns that the arguments of one are not those of the other: -fno-ipa-icf.
C_FLAGS = ("-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-fno-ipa-icf", "-shared", "-fPIC")


def function(code: str, name: str, **names: object) -> Callable[..., Any]:
    """The function that printed Python code defines."""
    space = dict(names)
    exec(compile(code, name, "exec"), space)
    return space[name]  # type: ignore[return-value]


def _columns(equations: fb.Equations, given: Mapping[str, Array]) -> list[Array]:
    """Each argument with the points last."""
    return [np.moveaxis(given[name], 0, -1) for name in equations.arguments]


def _points_first(equations: fb.Equations, results: Any, n: int) -> Results:
    results = results if isinstance(results, tuple) else (results,)
    return [
        np.moveaxis(np.broadcast_to(np.asarray(r).reshape(*shape, -1), (*shape, n)), -1, 0)
        for shape, r in zip(equations.results.values(), results, strict=True)
    ]


def _length(given: Mapping[str, Array]) -> int:
    return len(next(iter(given.values())))


def run_graph(equations: fb.Equations, given: Mapping[str, Array]) -> Results:
    """Not printed at all."""
    return list(equations.evaluate(**given).values())


def run_numpy(equations: fb.Equations, given: Mapping[str, Array]) -> Results:
    f = function(equations.numpy("f"), "f")
    return _points_first(equations, f(*_columns(equations, given)), _length(given))


def run_jax(equations: fb.Equations, given: Mapping[str, Array]) -> Results:
    """In doubles: JAX's own default is single precision."""
    with jax.enable_x64(True):
        f = function(equations.jax("f"), "f")
        columns = [jax.numpy.asarray(a) for a in _columns(equations, given)]
        return _points_first(equations, f(*columns), _length(given))


def run_casadi(equations: fb.Equations, given: Mapping[str, Array]) -> Results:
    """On CasADi's symbols, made a function and mapped over the points."""
    symbols = [ca.SX.sym(name, len(s)) for name, s in equations.arguments.items()]
    results = function(equations.casadi("f"), "f")(*symbols)
    results = results if isinstance(results, tuple) else (results,)
    f = ca.Function("f", symbols, [r.T.reshape((-1, 1)) for r in results])  # CasADi's order is by columns
    n = _length(given)
    columns = [a.reshape(-1, n) for a in _columns(equations, given)]
    return _points_first(equations, tuple(r.full() for r in f.map(n).call(columns)), n)


def sympy_results(equations: fb.Equations) -> tuple[list[Any], list[sp.Matrix]]:
    """SymPy's symbols of the arguments, and what the printed function makes of them."""
    symbols = [
        sp.Symbol(argument, real=True) if names == (argument,) else sp.symbols(names, real=True)
        for argument, names in equations.arguments.items()
    ]
    results = function(equations.sympy("f"), "f")(*symbols)
    return symbols, list(results) if isinstance(results, tuple) else [results]


@cache
def _operation(kind: Any, arguments: int) -> Callable[..., Any]:
    symbols = sp.symbols(f"a:{arguments}")
    with sp.evaluate(False):
        return sp.lambdify(symbols, kind(*symbols), "numpy")


def _value(x: Any, known: dict[Any, Any]) -> Any:
    if x not in known:
        parts = [] if x.is_Atom else [_value(part, known) for part in x.args]
        if isinstance(x, ExprCondPair):
            known[x] = tuple(parts)
        elif isinstance(x, sp.Piecewise):
            (otherwise, _), *others = reversed(parts)
            known[x] = otherwise
            for value, condition in others:
                known[x] = np.where(condition, value, known[x])
        else:
            known[x] = _operation(x.func, len(parts))(*parts) if parts else float(x)
    return known[x]


def run_sympy(equations: fb.Equations, given: Mapping[str, Array]) -> Results:
    """On SymPy's symbols; SymPy's own NumPy code then computes what came of it.

    `lambdify` of a whole result takes seconds, for it does not use that the same parts occur in it a thousand
    times; here each kind of operation is lambdified once and each part computed once.
    """
    symbols, results = sympy_results(equations)
    known: dict[Any, Any] = {sp.true: True}
    for group, (name, names) in zip(symbols, equations.arguments.items(), strict=True):
        known |= {group: given[name]} if names == (name,) else dict(zip(group, given[name].T, strict=True))
    n = _length(given)
    stacked = [np.stack([np.broadcast_to(_value(x, known), n) for x in entries]) for entries in results]
    return _points_first(equations, tuple(stacked), n)


class Library:
    """C functions, compiled into one library as their readers' compiler would, where no warning may come.

    The compiler runs beside the tests until the first function is called.
    """

    def __init__(self, folder: Path, functions: Mapping[str, fb.Equations]) -> None:
        source, self._made = folder / "equations.c", folder / "equations.so"
        source.write_text("\n".join(e.c(name) for name, e in functions.items()))
        self._functions = dict(functions)
        command = ["cc", *C_FLAGS, str(source), "-o", str(self._made), "-lm"]
        self._compiler = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)

    @cached_property
    def _library(self) -> ctypes.CDLL:
        _, warnings = self._compiler.communicate()
        assert (self._compiler.returncode, warnings) == (0, ""), warnings[:2000]
        return ctypes.CDLL(str(self._made))

    def close(self) -> None:
        """Wait for the compiler of a library that no test has asked for."""
        if self._compiler.returncode is None:
            self._compiler.communicate()

    def run(self, name: str, given: Mapping[str, Array]) -> Results:
        equations = self._functions[name]
        f = self._library[name]
        f.restype = None
        vector = np.ctypeslib.ndpointer(np.float64, flags="C_CONTIGUOUS")
        shapes = list(equations.results.values())
        f.argtypes = [
            *(ctypes.c_double if given[a].ndim == 1 else vector for a in equations.arguments),
            *(vector for _ in shapes),
        ]
        n = _length(given)
        # What the function does not write stays nan.
        out = [np.full((n, *shape), np.nan) for shape in shapes]
        arguments = [np.ascontiguousarray(given[a]) for a in equations.arguments]
        for k in range(n):
            f(*(a[k] for a in arguments), *(o[k] for o in out))
        return out


PYTHONIC: dict[str, Run] = {
    "numpy": run_numpy,
    "jax": run_jax,
    "casadi": run_casadi,
    "sympy": run_sympy,
}
