"""The work-precision picture of the documents: time of one run against its true error, for every method."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np

from race import race
from way import Program, Way

POINTS = 9
UNIT = ("freebody", "dop853", 1e-9)  # the time of one is this method's at this error
LEFT, RIGHT = 1e-13, 1e-2


def _ways(program: Program, method: str) -> list[Way]:
    tolerances = list(program.methods()[method])
    chosen = np.unique(np.linspace(0, len(tolerances) - 1, POINTS).round().astype(int))
    return [program.trajectory(method, tolerances[k]) for k in chosen]


def curves(programs: Sequence[Program]) -> dict[tuple[str, str], np.ndarray]:
    """(n, 2) of error and seconds for each method; the points of all methods are timed side by side."""
    ways = {(p.name, method): _ways(p, method) for p in programs for method in p.methods()}
    found: dict[tuple[str, str], list[tuple[float, float]]] = {key: [] for key in ways}
    for k in range(POINTS):
        there = {key: listed[k] for key, listed in ways.items() if k < len(listed)}
        for key, result in zip(there, race([(key[0], way) for key, way in there.items()], 0.05), strict=True):
            if LEFT < result.error < RIGHT:
                found[key].append((result.error, result.seconds))
    return {key: np.array(sorted(points)) for key, points in found.items() if points}


def draw(programs: Sequence[Program], path: Path) -> None:
    """Write the picture as SVG."""
    found = curves(programs)
    ours = found[UNIT[:2]]
    unit = np.exp(np.interp(np.log(UNIT[2]), np.log(ours[:, 0]), np.log(ours[:, 1])))
    with mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": "freebody", "font.size": 9}):
        figure, axes = plt.subplots(figsize=(7.5, 5.0))
        peers = [key for key in found if key[0] != UNIT[0]]
        for key, points in found.items():
            mine = key[0] == UNIT[0]
            style = {"color": "black", "lw": 1.8} if mine else {"color": f"C{peers.index(key)}", "ls": "--"}
            style["marker"] = "osD^vP*"[[k for k in found if (k[0] == UNIT[0]) == mine].index(key) % 7]
            label = f"{key[0]} {key[1]}"
            axes.loglog(points[:, 0], points[:, 1] / unit, ms=4, label=label, **style)
        axes.set_xlim(RIGHT, LEFT)
        axes.set_xlabel("true error after ten seconds (largest component, SI units)")
        axes.set_ylabel("time of a run")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=7, ncols=2)
        figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None}, bbox_inches="tight")
        plt.close(figure)
