"""SciPy: solve_ivp over a right-hand side that Numba compiles."""
# pyright: reportMissingImports=false

from collections.abc import Iterable, Mapping

import numba
import numpy as np
import scipy
from scipy.integrate import solve_ivp

import case
import symbolic
import truth
from way import Nothing, Way, decades, difference

_rates = numba.njit(symbolic.rates)


@numba.njit
def _derivative(t: float, x: np.ndarray, body: tuple) -> np.ndarray:
    state = (x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11], x[12])
    return np.array(_rates(state, body, symbolic.WRENCH))


class SciPy(Nothing):
    name = "SciPy"
    runs = 10

    def __init__(self) -> None:
        self.version = scipy.__version__
        self.body = tuple(float(n) for n in symbolic.body_numbers(case.nominal()[1])[:, 0])

    def derivative(self) -> Iterable[Way]:
        x = truth.start()
        names = {"f": _derivative, "x": x, "body": self.body}
        right = truth.derivative(x[:, None])[:, 0]
        error = difference(right, lambda: _derivative(0.0, x, self.body))
        yield Way("Numba's function, a new array", "f(0.0, x, body)", names, error)

    def methods(self) -> Mapping[str, Iterable[float]]:
        return {"DOP853": decades(-4, -14, 4), "LSODA": decades(-6, -14, 4)}

    def trajectory(self, method: str, tolerance: float) -> Way:
        x, final = truth.start(), np.empty(case.STATES)

        def run() -> None:
            final[:] = self._final(method, tolerance, x, self.body)

        return Way(method, "run()", {"run": run}, difference(truth.nominal(), lambda: final))

    @staticmethod
    def _final(method: str, tolerance: float, x: np.ndarray, body: tuple) -> np.ndarray:
        span, relative = (0.0, case.SECONDS), max(tolerance, 3e-14)
        solution = solve_ivp(
            _derivative, span, x, method, (case.SECONDS,), args=(body,), rtol=relative, atol=tolerance
        )
        return solution.y[:, -1] if solution.success else np.full(case.STATES, np.nan)

    def ensembles(self) -> Mapping[str, Iterable[float]]:
        return {"DOP853": decades(-4, -14, 4)}

    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way:
        x, bodies = case.dispersed(runs)
        numbers = [tuple(column) for column in symbolic.body_numbers(bodies).T.tolist()]
        states, out = x.T.copy(), np.empty_like(x)

        def run() -> None:
            for k in range(runs):
                out[:, k] = self._final(method, tolerance, states[k], numbers[k])

        return Way(method, "run()", {"run": run}, difference(truth.ensemble()[:, :runs], lambda: out), runs)
