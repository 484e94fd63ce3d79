"""Figures of many runs: how results spread, go together, settle and depend on what was dispersed.

Datasets are those of `freebody.statistics`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse

from freebody import statistics
from freebody._check import Array
from freebody.errors import InputError
from freebody.statistics import Column, Interval, Precision

from .style import BLACK, BLUE, GREEN, GREY, RED, STYLE, blank

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["convergence", "correlations", "histogram", "scatter", "sensitivity"]

PLAIN: dict[Any, Any] = {
    **STYLE,
    "axes.xmargin": 0.02,
    "axes.axisbelow": True,
    "legend.frameon": True,
    "legend.edgecolor": "none",
}
QUANTILES = {0.05: GREEN, 0.5: BLACK, 0.95: GREEN, 0.9973: RED}

_POINTS = 20_000  # of a scatter: more are a blot, and a large file
_LOOKS = 60  # run counts of a convergence
_BARS = 20


def histogram(dataset: xr.Dataset, name: str | Column, confidence: float = 0.95) -> Figure:
    """How a column spreads, with quantiles; the band of each is its confidence interval."""
    about = statistics.column(dataset, name)
    values = _values(dataset, about)
    with rc_context(PLAIN):
        drawing = blank(8.0, 4.5)
        axes = drawing.subplots()
        # Freedman and Diaconis' width, within what can be seen.
        bins = int(np.clip(len(np.histogram_bin_edges(values, "fd")), 10, 120)) if np.ptp(values) else 1
        axes.hist(values, bins, color=BLUE, alpha=0.55, linewidth=0)
        for probability, colour in QUANTILES.items():
            found = statistics.quantile_interval(values, probability, confidence)
            low, high = np.clip([found.low, found.high], values.min(), values.max())
            axes.axvspan(low, high, color=colour, alpha=0.18, linewidth=0)
            axes.axvline(found.value, color=colour, label=f"{100 * probability:g} %: {_between(found)}")
        axes.set(title=f"{about.name} of {len(values)} runs", xlabel=about.label, ylabel="runs")
        axes.margins(x=0.0)
        axes.legend(title=f"quantiles, {100 * confidence:g} % intervals", alignment="left")
    return drawing


def scatter(dataset: xr.Dataset, x: str | Column, y: str | Column) -> Figure:
    """Two columns over each other, such as points of impact, with the ellipses of their covariance.

    The ellipses are 1, 2 and 3 sigma; the legend counts how many runs lie inside each.
    """
    across, up = statistics.column(dataset, x), statistics.column(dataset, y)
    values = statistics.gather(statistics.independent(dataset), [across, up])
    values = values[np.isfinite(values).all(axis=1)]
    found = statistics.Moments(2).add(values)
    if found.count < 3 or not np.linalg.eigvalsh(found.covariance)[0] > 0.0:
        raise InputError(f"{across.key}, {up.key}: too few runs, or they do not spread; nothing to draw")
    deviations = values - found.mean
    distance = np.einsum("ri,ri->r", deviations, np.linalg.solve(found.covariance, deviations.T).T)
    sizes, axes_of = np.linalg.eigh(found.covariance)
    angle = float(np.degrees(np.arctan2(axes_of[1, 1], axes_of[0, 1])))
    with rc_context(PLAIN):
        drawing = blank(7.0, 6.0)
        axes = drawing.subplots()
        shown = values[:_POINTS]
        size = float(np.clip(12_000 / len(shown), 2.0, 12.0))
        axes.scatter(*shown.T, s=size, color=BLUE, alpha=0.35, linewidth=0, rasterized=True)
        for sigma, colour in ((1, GREEN), (2, BLACK), (3, RED)):
            width, height = 2 * sigma * np.sqrt(sizes[::-1])
            inside = 100 * np.mean(distance <= sigma**2)
            ellipse = Ellipse((found.mean[0], found.mean[1]), width, height, angle=angle, fill=False)
            ellipse.set(edgecolor=colour, linewidth=1.4, label=f"{sigma}σ: {inside:.3g} % inside")
            axes.add_patch(ellipse)
        axes.plot(*found.mean, "+", color=BLACK, markersize=10, label="mean")
        axes.set(xlabel=across.label, ylabel=up.label)
        axes.set_title(f"{up.name} over {across.name}, {found.count} runs")
        if across.unit == up.unit:
            axes.set_aspect("equal", adjustable="datalim")
        axes.legend(loc="best")
    return drawing


def correlations(dataset: xr.Dataset, names: Sequence[str | Column]) -> Figure:
    """The correlation of each column with each."""
    columns = [statistics.column(dataset, name) for name in names]
    matrix = statistics.moments(statistics.independent(dataset), columns).correlation
    side = 2.6 + 0.55 * len(columns)
    with rc_context({**PLAIN, "axes.grid": False, "axes.spines.left": False, "axes.spines.bottom": False}):
        drawing = blank(side + 0.9, side)
        axes = drawing.subplots()
        picture = axes.imshow(matrix, cmap=_RED_BLUE, vmin=-1, vmax=1)
        labels, places = [column.name for column in columns], range(len(columns))
        axes.set_xticks(places, labels, rotation=40, ha="right", rotation_mode="anchor")
        axes.set_yticks(places, labels)
        axes.tick_params(length=0)
        for (i, j), value in np.ndenumerate(matrix):
            if np.isfinite(value):
                colour = "white" if abs(value) > 0.6 else BLACK
                axes.text(j, i, f"{value:z.2f}", ha="center", va="center", color=colour, fontsize=8)
        drawing.colorbar(picture, ax=axes, shrink=0.8, label="correlation")
        axes.set_title("Correlations")
    return drawing


def convergence(dataset: xr.Dataset, precision: Precision) -> Figure:
    """A statistic of the first n runs over n, with its interval and, shaded, the precision wanted."""
    runs = dataset.sizes["run"]
    counts = np.unique(np.geomspace(min(20, runs), runs, _LOOKS).astype(int))
    name = statistics.column(dataset, precision.column)
    precise = replace(precision, column=name.key)
    found = [precise.estimate(dataset.isel(run=slice(0, int(n)))) for n in counts]
    known = np.isfinite([interval.half_width for interval in found])
    last = precise.judge(dataset)
    with rc_context(PLAIN):
        drawing = blank(8.0, 4.5)
        axes = drawing.subplots()
        end = last.interval.value
        wanted = (end - last.wanted, end + last.wanted)
        axes.axhspan(*wanted, color=GREEN, alpha=0.15, linewidth=0, label=f"wanted: ±{last.wanted:.3g}")
        low, high = (np.array([getattr(i, side) for i in found]) for side in ("low", "high"))
        band = f"{100 * precision.confidence:g} % interval"
        axes.fill_between(counts, low, high, where=known, color=BLUE, alpha=0.2, linewidth=0, label=band)
        axes.plot(counts, [interval.value for interval in found], color=BLUE, label="estimate")
        axes.set_ylim(end - _room(end - low[known], last.wanted), end + _room(high[known] - end, last.wanted))
        axes.set(xscale="log", xlabel="runs", ylabel=name.label)
        if known.any():  # an estimate without an interval says nothing
            axes.set_xlim(left=counts[known][0])
        if precision.statistic == "probability":
            axes.set_ylabel("probability")
        axes.set_title(f"{precision.description}: {_between(last.interval)}")
        axes.legend(loc="best")
    return drawing


def sensitivity(dataset: xr.Dataset, result: str | Column, confidence: float = 0.95) -> Figure:
    """What moves a result: Sobol indices where the runs were drawn for them, else rank correlations."""
    about = statistics.column(dataset, result)
    if statistics.is_paired(dataset):
        indices = statistics.sobol(dataset, about, confidence)
        names = [index.factor for index in indices]
        groups = {
            "total": [index.total for index in indices],
            "first order": [index.first for index in indices],
        }
        what, limits = "share of the variance", (0.0, 1.0)
    else:
        found = statistics.correlations(dataset, about, confidence)
        names = [c.quantity.name for c in found]
        groups = {
            "partial rank correlation": [c.partial or c.spearman for c in found],
            "Pearson correlation": [c.pearson for c in found],
        }
        what, limits = "correlation", (-1.0, 1.0)
    if not names:
        raise InputError(f"{about.key}: nothing was dispersed, or the runs are too few; nothing to draw")
    with rc_context(PLAIN):
        drawing = blank(8.0, 1.5 + 0.42 * min(len(names), _BARS))
        axes = drawing.subplots()
        _bars(axes, names[:_BARS], {name: group[:_BARS] for name, group in groups.items()})
        ends = [end for group in groups.values() for i in group[:_BARS] for end in (i.low, i.high)]
        axes.set_xlim(min(limits[0], *ends), max(limits[1], *ends))
        axes.set_title(f"What moves {about.name}")
        axes.set_xlabel(f"{what}, {100 * confidence:g} % intervals")
    return drawing


def _bars(axes: Axes, names: Sequence[str], groups: dict[str, list[Interval]]) -> None:
    places, height = np.arange(len(names)), 0.8 / len(groups)
    for i, ((label, group), colour) in enumerate(zip(groups.items(), (BLUE, GREY), strict=True)):
        at = places + (i - (len(groups) - 1) / 2) * height
        values = np.array([interval.value for interval in group])
        ends = np.array([(interval.low, interval.high) for interval in group]).T
        axes.barh(at, values, 0.9 * height, color=colour, alpha=0.75, label=label)
        axes.hlines(at, *ends, color=BLACK, linewidth=1.0)
    axes.axvline(0.0, color=BLACK, linewidth=0.8)
    axes.set_yticks(places, names)
    axes.grid(axis="y", visible=False)
    axes.invert_yaxis()
    axes.legend(loc="best")


def _values(dataset: xr.Dataset, about: Column) -> Array:
    values = statistics.gather(statistics.independent(dataset), [about])[:, 0]
    values = values[np.isfinite(values)]
    if len(values) == 0:
        raise InputError(f"{about.key}: no run has a value; nothing to draw")
    return values


def _room(distances: Array, wanted: float) -> float:
    """What shows most distances: the first few runs know so little that they would hide the rest."""
    return 1.3 * max([wanted, *np.quantile(distances, [0.9] if len(distances) else [])]) or 1.0


def _between(interval: Interval) -> str:
    return f"{interval.value:.4g} ({interval.low:.4g} to {interval.high:.4g})"


_RED_BLUE = LinearSegmentedColormap.from_list("correlation", [RED, "white", BLUE])
