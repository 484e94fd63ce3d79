"""numbalsoda: LSODA in C++ and DOP853 in Fortran, called from loops that Numba compiles."""
# pyright: reportMissingImports=false, reportFunctionMemberAccess=false

from collections.abc import Iterable, Mapping
from importlib.metadata import version

import numba
import numpy as np
from numbalsoda import dop853, lsoda, lsoda_sig

import case
import symbolic
import truth
from way import Nothing, Way, decades, difference

_rates = numba.njit(symbolic.rates)


@numba.njit
def _law(x, p):
    state = (x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12])
    body = (
        *(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]),
        *(p[8], p[9], p[10], p[11], p[12], p[13], p[14], p[15]),
    )
    return _rates(state, body, symbolic.WRENCH)


@numba.cfunc(lsoda_sig)
def _right_hand_side(t, x, dx, p):
    rates = _law(x, p)
    for i in range(13):
        dx[i] = rates[i]


@numba.njit
def _derivative(x, p, out):
    rates = _law(x, p)
    for i in range(13):
        out[i] = rates[i]


@numba.njit(parallel=True)
def _derivatives(x, p, out):
    for k in numba.prange(x.shape[1]):
        rates = _law(x[:, k], p)
        for i in range(13):
            out[i, k] = rates[i]


def _loop(solver):
    """One run, and all runs one after another or in threads."""

    @numba.njit
    def one(address, x, p, tolerance):
        times = np.array([0.0, case.SECONDS])
        states, ok = solver(address, x, times, p, tolerance, tolerance, 1_000_000)
        return states[1] if ok else np.full(13, np.nan)

    @numba.njit(parallel=True)
    def every(address, x, p, tolerance, out):
        for k in numba.prange(len(x)):
            out[k] = one(address, x[k], p[k], tolerance)

    return one, every


class NumbaLsoda(Nothing):
    name = "numbalsoda"
    runs = 2000

    def __init__(self) -> None:
        self.version = version("numbalsoda")
        self.body = symbolic.body_numbers(case.nominal()[1])[:, 0].copy()
        self.solvers = {"dop853": _loop(dop853), "lsoda": _loop(lsoda)}

    def derivative(self) -> Iterable[Way]:
        x, out = truth.start(), np.empty(case.STATES)
        names = {"f": _derivative, "x": x, "p": self.body, "out": out}
        error = difference(truth.derivative(x[:, None])[:, 0], lambda: out)
        yield Way("Numba's law into an array", "f(x, p, out)", names, error)

    def derivatives(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        numba.set_num_threads(threads)
        out = np.empty_like(x)
        names = {"f": _derivatives, "x": x, "p": self.body, "out": out}
        error = difference(truth.derivative(x), lambda: out)
        yield Way("Numba's loop over its law", "f(x, p, out)", names, error, x.shape[1])

    def methods(self) -> Mapping[str, Iterable[float]]:
        return {"dop853": decades(-4, -16), "lsoda": decades(-6, -13)}

    def trajectory(self, method: str, tolerance: float) -> Way:
        x, final = truth.start(), np.empty(case.STATES)
        names = {"one": self.solvers[method][0], "address": _right_hand_side.address, "x": x, "final": final}
        names |= {"p": self.body, "tolerance": float(tolerance)}
        error = difference(truth.nominal(), lambda: final)
        return Way(method, "final[:] = one(address, x, p, tolerance)", names, error)

    def ensembles(self) -> Mapping[str, Iterable[float]]:
        return {"dop853": decades(-4, -16)}

    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way:
        x, bodies = case.dispersed(runs)
        p, out = symbolic.body_numbers(bodies).T.copy(), np.empty((runs, case.STATES))
        every = self.solvers[method][1]
        numba.set_num_threads(threads)
        names = {"every": every, "address": _right_hand_side.address, "x": x.T.copy(), "p": p, "out": out}
        error = difference(truth.ensemble()[:, :runs], lambda: out.T)
        statement = "every(address, x, p, tolerance, out)"
        return Way(method, statement, names | {"tolerance": float(tolerance)}, error, runs)
