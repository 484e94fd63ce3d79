"""The table on the terminal, and results.json."""

import json
from collections.abc import Sequence

import numpy as np

from measures import Row
from way import Program

OURS = "freebody"


def _time(seconds: float) -> str:
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:7.2f} {unit}"
    return f"{seconds * 1e9:7.1f} ns"


def show(row: Row) -> None:
    """Every way, fastest first, with what it was asked for and its error."""
    print(f"{row.name}, {_threads(row)}")
    ours = row.best(OURS)
    for result in sorted(row.results, key=lambda r: r.seconds):
        ratio = f"{result.seconds / ours.seconds:8.2f}" if ours else " " * 8
        asked = "" if result.tolerance is None else f", tolerance {result.tolerance:.1e}"
        fewer = f", {result.runs} runs" if row.name.startswith("D") else ""
        name = f"{result.program}: {result.label}"
        print(f"  {name:44}{_time(result.seconds)}{ratio}   error {result.error:.0e}{asked}{fewer}")
    for failure in row.failures:
        print(f"  {failure}")
    print(flush=True)


def _threads(row: Row) -> str:
    return "one thread" if row.threads == 1 else f"{row.threads} threads"


def peers_of(row: Row) -> dict[str, float]:
    """Their best time over our best, fastest first."""
    ours = row.best(OURS)
    names = dict.fromkeys(r.program for r in row.results if not r.program.startswith(OURS))
    times = {name: best.seconds for name in names if (best := row.best(name))}
    return {n: times[n] / ours.seconds for n in sorted(times, key=times.__getitem__)} if ours else {}


def summary(rows: Sequence[Row]) -> None:
    """A line a measure: the fastest peer's time over ours, and the goal."""
    print(f"{'':32}{'':10}{'ours':>10}{'ratio':>8}{'goal':>6}  fastest peer")
    for row in rows:
        ours, peers = row.best(OURS), peers_of(row)
        name, ratio = next(iter(peers.items()), ("none", float("nan")))
        mine = _time(ours.seconds) if ours else "none"
        goal = "" if row.goal is None else f"{row.goal:.1f}"
        print(f"{row.name:32}{_threads(row):10}{mine:>10}{ratio:8.2f}{goal:>6}  {name}")
        traced = row.best(f"{OURS}, damping traced")
        if traced and ours:
            print(
                f"{'  damping traced / built in':52}{traced.seconds / ours.seconds:8.2f}{'2.0':>6}  at most"
            )


def instruction_set() -> str:
    """The widest that NumPy sees on this machine."""
    found = np.show_config(mode="dicts")["SIMD Extensions"]["found"]  # type: ignore[index]
    return "AVX-512" if any("AVX512" in name for name in found) else ", ".join(found[-1:])


def ratios(rows: Sequence[Row], programs: Sequence[Program]) -> str:
    """JSON: a peer's time over ours, larger is better for us; no time of any machine."""
    measured: dict[str, dict[str, dict[str, float]]] = {}
    for row in rows:
        rounded = {name: float(f"{ratio:.3g}") for name, ratio in peers_of(row).items()}
        traced, ours = row.best(f"{OURS}, damping traced"), row.best(OURS)
        if traced and ours:
            rounded[traced.program] = float(f"{traced.seconds / ours.seconds:.3g}")
        measured.setdefault(row.name, {})["one thread" if row.threads == 1 else "all threads"] = rounded
    versions = {program.name: program.version for program in programs}
    content = {"instruction_set": instruction_set(), "versions": versions, "ratios": measured}
    return json.dumps(content, indent=2) + "\n"
