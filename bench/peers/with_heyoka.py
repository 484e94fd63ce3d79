"""heyoka: Taylor's method and compiled functions, through LLVM; batches of eight lanes."""
# pyright: reportMissingImports=false

import copy
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import heyoka as hy
import numpy as np

import case
import symbolic
import truth
from way import Nothing, Way, difference

LANES = 8
# heyoka's step follows from the order alone, and the order from the tolerance.
ORDERS = {order: float(np.exp(-2.0 * (order - 1.5))) for order in range(6, 21)}


class Heyoka(Nothing):
    name = "heyoka"
    runs = case.RUNS

    def __init__(self) -> None:
        self.version = hy.__version__
        self.states = hy.make_vars(*(f"x{i}" for i in range(case.STATES)))
        self.inputs = hy.make_vars(*(f"u{i}" for i in range(case.INPUTS)))
        self.numbers = [float(n) for n in symbolic.body_numbers(case.nominal()[1])[:, 0]]
        self.rates = symbolic.rates(tuple(self.states), tuple(self.numbers), symbolic.WRENCH)
        wrench = tuple(u + w for u, w in zip(self.inputs, symbolic.WRENCH, strict=True))
        driven = symbolic.rates(tuple(self.states), tuple(self.numbers), wrench)
        arguments = [*self.states, *self.inputs]
        self.partials = [hy.diff(rate, a) for rate in driven for a in arguments]
        self.varying = [k for k, p in enumerate(self.partials) if len(hy.get_variables(p))]
        self.built: dict[tuple[str, float], Any] = {}

    def _compiled(self, functions: Iterable, lanes: int) -> hy.cfunc:
        return hy.cfunc(list(functions), self.states, batch_size=lanes, fast_math=True)

    def derivative(self) -> Iterable[Way]:
        x, out = truth.start(), np.empty(case.STATES)
        names = {"f": self._compiled(self.rates, 1), "x": x, "out": out}
        right = truth.derivative(x[:, None])[:, 0]
        yield Way("cfunc", "f(x, outputs=out)", names, difference(right, lambda: out))

    def derivatives(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        hy.set_nthreads(threads)
        out = np.empty_like(x)
        names = {"f": self._compiled(self.rates, LANES), "x": x, "out": out}
        error = difference(truth.derivative(x), lambda: out)
        yield Way("cfunc, 8 lanes", "f(x, outputs=out)", names, error, x.shape[1])

    def jacobian(self) -> Iterable[Way]:
        x, out = truth.start(), np.empty(len(self.partials))
        names = {"f": self._compiled(self.partials, 1), "x": x, "out": out}
        yield Way("cfunc", "f(x, outputs=out)", names, difference(truth.jacobian().ravel(), lambda: out))

    def jacobians(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        hy.set_nthreads(threads)
        right = truth.jacobians(x[:, :CHECKED]).reshape(-1, min(CHECKED, x.shape[1]))
        for label, chosen in (("dense", list(range(len(self.partials)))), ("what varies", self.varying)):
            out = np.empty((len(chosen), x.shape[1]))
            names = {"f": self._compiled([self.partials[k] for k in chosen], LANES), "x": x, "out": out}
            error = difference(right[chosen], lambda out=out: out[:, :CHECKED])
            yield Way(
                f"cfunc, 8 lanes, {label}", "f(x, outputs=out)", names, error, x.shape[1], label != "dense"
            )

    def _system(self, numbers: list) -> list:
        rates = symbolic.rates(tuple(self.states), tuple(numbers), symbolic.WRENCH)
        return list(zip(self.states, rates, strict=True))

    def methods(self) -> Mapping[str, Iterable[float]]:
        return {"taylor": ORDERS.values()}

    def trajectory(self, method: str, tolerance: float) -> Way:
        x = truth.start()
        key = ("one", tolerance)
        if key not in self.built:
            self.built[key] = hy.taylor_adaptive(self._system(self.numbers), x, tol=tolerance, fast_math=True)
        ta = self.built[key]
        statement = "ta.time = 0.0; ta.state[:] = x; ta.propagate_until(10.0)"
        return Way(method, statement, {"ta": ta, "x": x}, difference(truth.nominal(), lambda: ta.state))

    def ensembles(self) -> Mapping[str, Iterable[float]]:
        return {"taylor, 8 lanes": ORDERS.values()}

    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way:
        x, bodies = case.dispersed(runs)
        blocks = [slice(i, i + LANES) for i in range(0, runs, LANES)]
        states = [np.ascontiguousarray(x[:, b]) for b in blocks]
        numbers = symbolic.body_numbers(bodies)
        numbers = [np.ascontiguousarray(numbers[:, b]) for b in blocks]
        out = np.empty_like(x)
        key = ("lanes", tolerance)
        if key not in self.built:
            system = self._system([hy.par[i] for i in range(symbolic.BODY)])
            self.built[key] = hy.taylor_adaptive_batch(system, states[0], pars=numbers[0], tol=tolerance)
        workers = [copy.copy(self.built[key]) for _ in range(threads)]

        def work(which: int) -> None:
            ta = workers[which]
            state, par = ta.state, ta.pars
            for k in range(which, len(blocks), threads):
                ta.set_time(0.0)
                state[:], par[:] = states[k], numbers[k]
                ta.propagate_until(10.0)
                out[:, blocks[k]] = state

        def run() -> None:
            if threads == 1:
                work(0)
            else:
                with ThreadPoolExecutor(threads) as pool:
                    list(pool.map(work, range(threads)))

        error = difference(truth.ensemble()[:, :runs], lambda: out)
        return Way(method, "run()", {"run": run}, error, runs)


CHECKED = 100
