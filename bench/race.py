"""Fair timing: every way in turn, many short spells, the best of each; and tolerances that just suffice."""

import json
import time
import timeit
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from way import Program, Way

TUNED = Path(__file__).resolve().parents[1] / ".bench" / "tolerances.json"
SPELL = 0.005  # s, of one timing
SPELLS = 40


@dataclass(frozen=True)
class Result:
    """Seconds of one derivative, Jacobian or run; the error of its answer, and what was asked for."""

    program: str
    label: str
    seconds: float
    error: float
    tolerance: float | None = None
    runs: int = 1


def race(entries: Sequence[tuple[str, Way]], budget: float, threads: int = 1) -> list[Result]:
    """All ways interleaved, so that they share whatever else the machine does; budget: seconds for each.

    On one thread the processor's time counts: waiting for a processor is not theirs, a second thread is.
    """
    clock = time.process_time if threads == 1 else time.perf_counter
    timers = [timeit.Timer(way.statement, timer=clock, globals=dict(way.names)) for _, way in entries]
    numbers, best = [], []
    for timer in timers:
        timer.timeit(1)
        once = timer.timeit(1)
        numbers.append(max(1, round(SPELL / max(once, 1e-8))))
        best.append(once)
    spent = [0.0] * len(timers)
    for _ in range(SPELLS):
        for k, timer in enumerate(timers):
            if spent[k] < budget:
                seconds = timer.timeit(numbers[k])
                spent[k] += seconds
                best[k] = min(best[k], seconds / numbers[k])
    return [
        Result(name, way.label, seconds / way.count, way.error(), None, way.count)
        for (name, way), seconds in zip(entries, best, strict=True)
    ]


def error_of(way: Way) -> float:
    """After running it once."""
    timeit.timeit(way.statement, globals=dict(way.names), number=1)
    return way.error()


class Tuning:
    """The coarsest tolerance of a method that meets an error; kept for peers from one bench to the next."""

    def __init__(self) -> None:
        self.kept: dict[str, float] = json.loads(TUNED.read_text()) if TUNED.exists() else {}

    def way(self, program: Program, method: str, target: float, kind: str) -> tuple[float, Way] | None:
        """For one run or the ensemble; None if it does not get there."""
        ensemble = kind == "ensemble"

        def make(tolerance: float) -> Way:
            if ensemble:
                return program.ensemble(method, tolerance, program.runs, 1)
            return program.trajectory(method, tolerance)

        methods = program.ensembles() if ensemble else program.methods()
        key = f"{program.name} {program.version} {kind} {method} {target:.0e}"
        if key in self.kept:
            way = make(self.kept[key])
            if error_of(way) <= target:
                return self.kept[key], way
        found = _coarsest(methods[method], target, make)
        if found and program.name.partition(",")[0] != "freebody":
            self.kept[key] = float(found[0])
            TUNED.parent.mkdir(exist_ok=True)
            TUNED.write_text(json.dumps(self.kept, indent=0))
        return found


def _coarsest(tolerances: Iterable[float], target: float, make) -> tuple[float, Way] | None:
    """By halving, as though errors fell with the tolerance; then finer until it is met."""
    tolerances = list(tolerances)
    low, high = 0, len(tolerances)
    while low < high:
        middle = (low + high) // 2
        if error_of(make(tolerances[middle])) <= target:
            high = middle
        else:
            low = middle + 1
    for tolerance in tolerances[low:]:
        way = make(tolerance)
        if error_of(way) <= target:
            return tolerance, way
    return None
