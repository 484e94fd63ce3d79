"""CasADi: expressions printed as C, compiled, and called through its buffers; integrators in C, or CVODES."""
# pyright: reportCallIssue=false, reportArgumentType=false, reportAttributeAccessIssue=false

import hashlib
import os
import subprocess
from collections.abc import Iterable, Mapping
from pathlib import Path

import casadi as ca
import numpy as np

import case
import symbolic
import truth
from way import Nothing, Way, decades, difference

FOLDER = Path(__file__).resolve().parents[2] / ".bench" / "casadi"
COMPILER = (os.environ.get("CC", "cc"), "-O3", "-march=native", "-fPIC", "-shared")
ADAMS = {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"}
CHECKED = 100


def compiled(function: "ca.Function") -> "ca.Function":
    """The function as compiled C, kept in a file from one bench to the next."""
    generator = ca.CodeGenerator("generated.c")
    generator.add(function)
    text = generator.dump()
    FOLDER.mkdir(parents=True, exist_ok=True)
    stem = FOLDER / hashlib.sha256(text.encode()).hexdigest()[:16]
    library = stem.with_suffix(".so")
    if not library.exists():
        stem.with_suffix(".c").write_text(text)
        subprocess.run([*COMPILER, "-o", library, stem.with_suffix(".c")], check=True)
    return ca.external(function.name(), str(library))


def buffered(function: "ca.Function", arguments: Mapping[int, np.ndarray], out: np.ndarray) -> dict:
    """Names for the statement `call()`: it reads the arguments and writes out."""
    buffer, call = function.buffer()
    for place, argument in arguments.items():
        buffer.set_arg(place, memoryview(argument))
    buffer.set_res(0, memoryview(out))
    return {"call": call, "buffer": buffer, "arguments": arguments}


class CasADi(Nothing):
    name = "CasADi"
    runs = 100

    def __init__(self) -> None:
        self.version = ca.__version__
        self.x, self.u, self.p = ca.SX.sym("x", 13), ca.SX.sym("u", 6), ca.SX.sym("p", symbolic.BODY)
        self.numbers = symbolic.body_numbers(case.nominal()[1])[:, 0].copy()
        x, fixed = tuple(ca.vertsplit(self.x)), tuple(float(n) for n in self.numbers)
        wrench = tuple(u + w for u, w in zip(ca.vertsplit(self.u), symbolic.WRENCH, strict=True))
        self.rates = ca.vertcat(*symbolic.rates(x, fixed, symbolic.WRENCH))
        driven = ca.vertcat(*symbolic.rates(x, fixed, wrench))
        self.partials = ca.jacobian(driven, ca.vertcat(self.x, self.u))
        self.law = ca.vertcat(*symbolic.rates(x, tuple(ca.vertsplit(self.p)), symbolic.WRENCH))

    def derivative(self) -> Iterable[Way]:
        x, out = truth.start(), np.empty(13)
        f = compiled(ca.Function("rates", [self.x], [self.rates]))
        right = truth.derivative(x[:, None])[:, 0]
        yield Way("C, buffer", "call()", buffered(f, {0: x}, out), difference(right, lambda: out))

    def _mapped(self, function: "ca.Function", n: int, threads: int) -> "ca.Function":
        """Over the columns of a matrix; a part of them in C for each thread."""
        part = compiled(function.map(n // threads))
        return part if threads == 1 else part.map(threads, "thread", threads)

    def derivatives(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        n = x.shape[1]
        states, out = x.T.copy(), np.empty((n, 13))
        f = self._mapped(ca.Function("rates", [self.x], [self.rates]), n, threads)
        error = difference(truth.derivative(x), lambda: out.T)
        yield Way("C, mapped", "call()", buffered(f, {0: states}, out), error, n)

    def jacobian(self) -> Iterable[Way]:
        x, u = truth.start(), np.zeros(6)
        for label, partials in (("dense", ca.densify(self.partials)), ("non-zeros", self.partials)):
            f = compiled(ca.Function("partials", [self.x, self.u], [partials]))
            rows, columns = f.sparsity_out(0).get_triplet()
            out = np.empty(f.nnz_out(0))
            error = difference(truth.jacobian()[rows, columns], lambda out=out: out)
            names = buffered(f, {0: x, 1: u}, out)
            yield Way(f"C, buffer, {label}", "call()", names, error, sparse=label != "dense")

    def jacobians(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        n = x.shape[1]
        states, u = x.T.copy(), np.zeros((n, 6))
        right = truth.jacobians(x[:, :CHECKED])
        for label, partials in (("dense", ca.densify(self.partials)), ("non-zeros", self.partials)):
            one = ca.Function("partials", [self.x, self.u], [partials])
            rows, columns = one.sparsity_out(0).get_triplet()
            out = np.empty((n, one.nnz_out(0)))
            names = buffered(self._mapped(one, n, threads), {0: states, 1: u}, out)
            error = difference(right[rows, columns], lambda out=out: out[:CHECKED].T)
            yield Way(f"C, mapped, {label}", "call()", names, error, n, label != "dense")

    def _integrator(self, method: str, tolerance: float) -> "ca.Function":
        equations = {"x": self.x, "p": self.p, "ode": self.law}
        span = (0.0, case.SECONDS)
        if method == "rk, C":
            options = {"number_of_finite_elements": round(case.SECONDS / tolerance), "simplify": True}
            return compiled(ca.integrator("run", "rk", equations, *span, options))
        options = {"abstol": tolerance, "reltol": tolerance, "max_num_steps": 1_000_000, **ADAMS}
        jit = {"jit": True, "compiler": "shell", "jit_options": {"flags": list(COMPILER[1:3])}}
        FOLDER.mkdir(parents=True, exist_ok=True)
        jit["jit_temp_suffix"] = True
        return ca.integrator("run", "cvodes", equations, *span, {**options, **jit})

    def methods(self) -> Mapping[str, Iterable[float]]:
        steps = [case.SECONDS / round(300 * 1.09**k) for k in range(52)]
        return {"rk, C": steps, "cvodes, adams": decades(-6, -14, 4)}

    def trajectory(self, method: str, tolerance: float) -> Way:
        x, final = truth.start(), np.empty(13)
        names = buffered(self._integrator(method, tolerance), {0: x, 2: self.numbers}, final)
        return Way(method, "call()", names, difference(truth.nominal(), lambda: final))

    def ensembles(self) -> Mapping[str, Iterable[float]]:
        return {"rk, C": self.methods()["rk, C"]}

    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way:
        x, bodies = case.dispersed(runs)
        states, numbers = x.T.copy(), symbolic.body_numbers(bodies).T.copy()
        out = np.empty((runs, 13))
        one = self._integrator(method, tolerance)
        every = one.map(runs) if threads == 1 else one.map(runs, "thread", threads)
        names = buffered(every, {0: states, 2: numbers}, out)
        return Way(method, "call()", names, difference(truth.ensemble()[:, :runs], lambda: out.T), runs)
