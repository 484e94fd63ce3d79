"""What is measured, A to E of the case, for all programs; each gives rows of results."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

import case
from race import Result, Tuning, race
from way import Program, Way

TARGETS = (1e-6, 1e-9, 1e-12)
THREADS = os.cpu_count() or 1
SETS = (64, 1000, 100_000, 500_000)
TOLERATED = 1e-11  # of derivatives and Jacobians, whose largest component is of order ten


@dataclass(frozen=True)
class Row:
    """One measure on one thread or all: everybody's results, wrong ones left out."""

    name: str
    threads: int
    results: list[Result]
    goal: float | None = None
    failures: list[str] = field(default_factory=list)

    def best(self, program: str) -> Result | None:
        mine = [result for result in self.results if result.program == program]
        return min(mine, key=lambda result: result.seconds, default=None)


def _row(name: str, threads: int, results: Iterable[Result], target: float, goal: float | None = None) -> Row:
    right, failures = [], []
    for result in results:
        if result.error <= target:
            right.append(result)
        else:
            failures.append(f"{result.program}, {result.label}: wrong by {result.error:.1e}, so no time")
    return Row(name, threads, right, goal, failures)


Ways = Callable[[Program], Iterable[Way]]


def _simple(programs: Sequence[Program], name: str, threads: int, ways: Ways, goal: float | None) -> Row:
    entries = [(program.name, way) for program in programs for way in ways(program)]
    return _row(name, threads, race(entries, 0.5, threads), TOLERATED, goal)


def states(n: int) -> np.ndarray:
    """(13, n): the dispersed initial states, over and over."""
    return np.ascontiguousarray(case.dispersed()[0][:, np.arange(n) % case.RUNS])


def _full(ways: Iterable[Way]) -> Iterator[Way]:
    return (way for way in ways if not way.sparse)


def _non_zeros(program: Program, ways: Iterable[Way]) -> Iterator[Way]:
    """freebody gives full matrices at single states, and stands for itself with these."""
    ways = list(ways)
    alone = program.name == "freebody" and not any(way.sparse for way in ways)
    return (way for way in ways if way.sparse or alone)


def single(programs: Sequence[Program]) -> Iterator[Row]:
    """A, and E for one state."""
    yield _simple(programs, "A one derivative", 1, lambda p: p.derivative(), 1.0)
    yield _simple(programs, "E one Jacobian", 1, lambda p: _full(p.jacobian()), 2.0)
    yield _simple(programs, "E one Jacobian, non-zeros", 1, lambda p: _non_zeros(p, p.jacobian()), None)


def bulk(programs: Sequence[Program]) -> Iterator[Row]:
    """B and E over many states; threads are for what is large."""
    goals: dict[int, float | None] = {64: 5.0, 100_000: 1.2}
    for n in SETS:
        x = states(n)
        yield _simple(programs, f"B {n} derivatives", 1, lambda p: p.derivatives(x, 1), goals.get(n))  # noqa: B023
    for n in (64, 10_000):
        yield from _jacobians(programs, n, 1, 8.0)
    if THREADS > 1:
        x = states(SETS[-1])
        yield _simple(
            programs, f"B {SETS[-1]} derivatives", THREADS, lambda p: p.derivatives(x, THREADS), None
        )
        yield from _jacobians(programs, 10_000, THREADS, None)


def _jacobians(programs: Sequence[Program], n: int, threads: int, goal: float | None) -> Iterator[Row]:
    x, name = states(n), f"E {n} Jacobians"
    yield _simple(programs, name, threads, lambda p: _full(p.jacobians(x, threads)), goal)
    sparse = f"{name}, non-zeros"
    yield _simple(programs, sparse, threads, lambda p: _non_zeros(p, p.jacobians(x, threads)), None)


def trajectories(programs: Sequence[Program], tuning: Tuning) -> Iterator[Row]:
    """C: every method of every program, as coarse as the error allows."""
    for target, goal in zip(TARGETS, (1.2, 1.2, 1.0), strict=True):
        found = {
            (program.name, method): tuning.way(program, method, target, "trajectory")
            for program in programs
            for method in program.methods()
        }
        yield _tuned(f"C one run to {target:.0e}", 1, found, target, goal, 0.4)


def ensembles(programs: Sequence[Program], tuning: Tuning) -> Iterator[Row]:
    """D: on one thread and on all, at the tolerances that one thread found."""
    for target, goal in zip(TARGETS, (3.0, 2.5, 1.3), strict=True):
        pairs = [(program, method) for program in programs for method in program.ensembles()]
        found = {(p.name, method): tuning.way(p, method, target, "ensemble") for p, method in pairs}
        name = f"D ensemble to {target:.0e}"
        yield _tuned(name, 1, found, target, goal, 1.2)
        if THREADS > 1:
            threaded = {
                (p.name, method): (pair[0], p.ensemble(method, pair[0], p.runs, THREADS))
                for p, method in pairs
                if (pair := found[p.name, method])
            }
            yield _tuned(name, THREADS, threaded, target, None, 0.6)


def _tuned(
    name: str,
    threads: int,
    found: Mapping[tuple[str, str], tuple[float, Way] | None],
    target: float,
    goal: float | None,
    budget: float,
) -> Row:
    there = {key: pair for key, pair in found.items() if pair}
    results = race([(key[0], way) for key, (_, way) in there.items()], budget, threads)
    named = [
        Result(r.program, r.label, r.seconds, r.error, tolerance, r.runs)
        for r, (tolerance, _) in zip(results, there.values(), strict=True)
    ]
    row = _row(name, threads, named, target, goal)
    row.failures.extend(f"{p}, {m}: does not get there" for p, m in found if (p, m) not in there)
    return row
