"""The tables of a set of runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from freebody._check import Array

from .columns import Column, all_columns, blocks, column, gather, outcomes, results
from .design import independent, is_paired, notes
from .intervals import (
    Interval,
    mean_interval,
    probability_interval,
    quantile_interval,
    runs_needed,
    tolerance_bounds,
)
from .moments import Moments, moments
from .sensitivity import RANKED, correlations, sobol
from .table import Cell, ResultTable

if TYPE_CHECKING:
    import xarray as xr

__all__ = [
    "QUANTILES",
    "TOLERANCE",
    "correlation_table",
    "covariance_table",
    "endings",
    "events",
    "overview",
    "quantiles",
    "relations",
    "sensitivities",
    "sobol_table",
    "spread",
    "summary",
    "tolerances",
]

QUANTILES = (0.0027, 0.05, 0.5, 0.95, 0.9973)
TOLERANCE = (0.9973, 0.90)
"""What dispersion analyses bound by custom: 99.73 % with 90 % confidence."""

_ENDS = ("low", "high")
_SHARE = "z.3f"  # of what lies between -1 and 1 and is not known better
_GATHERED = 16_000_000  # numbers of the columns read at once: 128 MB
_MATRIX = 13  # columns that a table of each with each can hold and still be read: one state


def summary(
    dataset: xr.Dataset, columns: Sequence[str | Column] | None = None, confidence: float = 0.95
) -> list[ResultTable]:
    """Every table that the runs allow: how they ended, events, mean and spread, quantiles with tolerance
    bounds, covariances and correlations of the results, and what each result is sensitive to.

    `columns` are the results: outputs and times of events by default, final states where there are none.
    """
    return [*overview(dataset, columns, confidence), *relations(dataset, columns, confidence)]


def overview(
    dataset: xr.Dataset, columns: Sequence[str | Column] | None = None, confidence: float = 0.95
) -> list[ResultTable]:
    """The tables of a summary that have a row or a few for each column."""
    chosen = _chosen(dataset, columns)
    tables = [endings(dataset, confidence)]
    if all_columns(dataset, "event"):
        tables.append(events(dataset, confidence))
    tables.append(spread(dataset, chosen, confidence))
    tables.append(spread(dataset, all_columns(dataset, "dispersed"), confidence, title="What was dispersed"))
    tables += [quantiles(dataset, chosen, confidence=confidence), tolerances(dataset, chosen)]
    return [table for table in tables if table.rows]


def relations(
    dataset: xr.Dataset, columns: Sequence[str | Column] | None = None, confidence: float = 0.95
) -> list[ResultTable]:
    """Its other tables, longer ones: of each result with each, and of each with all that was dispersed."""
    chosen = _chosen(dataset, columns)
    tables: list[ResultTable] = []
    if 1 < len(chosen) <= _MATRIX:
        tables += [covariance_table(dataset, chosen), correlation_table(dataset, chosen)]
    for result in chosen:
        tables.append(sensitivities(dataset, result, confidence))
        if is_paired(dataset):
            tables.append(sobol_table(dataset, result, confidence))
    return [table for table in tables if table.rows]


def _chosen(dataset: xr.Dataset, columns: Sequence[str | Column] | None) -> list[Column]:
    return results(dataset) if columns is None else [column(dataset, name) for name in columns]


def endings(dataset: xr.Dataset, confidence: float = 0.95) -> ResultTable:
    """How many runs ended how, with Clopper and Pearson's interval of the probability."""
    counts = outcomes(dataset)
    total, well = sum(counts.values()), counts["reached_end"] + counts["event"]
    rows = [
        (name, n, *_ends(probability_interval(n, total, confidence)))
        for name, n in counts.items()
        if total > 0 and (n > 0 or name == "reached_end")
    ]
    badly = f"{total - well} of {total} runs ended badly; they are left out of every other table"
    told = (_told(confidence), *([badly] if total > well else []), *notes(dataset))
    return ResultTable("How the runs ended", ("outcome", "runs", "share", *_ENDS), tuple(rows), told)


def events(dataset: xr.Dataset, confidence: float = 0.95) -> ResultTable:
    """The probability that an event occurs in a run that ends well."""
    rows = []
    for chosen in all_columns(dataset, "event"):
        times = gather(independent(dataset), [chosen])[:, 0]
        if len(times):
            hits = int(np.count_nonzero(np.isfinite(times)))
            rows.append((chosen.name, hits, *_ends(probability_interval(hits, len(times), confidence))))
    headings = ("event", "runs", "probability", *_ENDS)
    return ResultTable("Events", headings, tuple(rows), (_told(confidence),))


def spread(
    dataset: xr.Dataset,
    columns: Sequence[str | Column],
    confidence: float = 0.95,
    title: str = "Mean and spread",
) -> ResultTable:
    """Mean with Student's interval, standard deviation, least and greatest value of each column."""
    chosen = [column(dataset, name) for name in columns]
    taken = [Moments(1) for _ in chosen]
    for block in blocks(independent(dataset), chosen):
        for one, values in zip(taken, block.T, strict=True):
            one.add(values)
    rows = []
    for one, about in zip(taken, chosen, strict=True):
        mean, sd = float(one.mean[0]), float(one.sd[0])
        numbers: tuple[Cell, ...] = (None,) * 6
        if one.count > 0:
            of_mean = _ends(mean_interval(mean, sd, one.count, confidence))
            numbers = (*of_mean, _known(sd), float(one.least[0]), float(one.greatest[0]))
        rows.append((about.key, about.unit, one.count, *numbers))
    headings = ("column", "unit", "runs", "mean", *_ENDS, "sd", "least", "greatest")
    return ResultTable(title, headings, tuple(rows), (_told(confidence, " of the mean"),))


def quantiles(
    dataset: xr.Dataset,
    columns: Sequence[str | Column],
    probabilities: Sequence[float] = QUANTILES,
    confidence: float = 0.95,
) -> ResultTable:
    """Quantiles, each between two order statistics."""
    rows = [
        (about.key, about.unit, probability, *_ends(quantile_interval(values, probability, confidence)))
        for about, values in _finite(dataset, columns)
        for probability in probabilities
    ]
    headings = ("column", "unit", "probability", "quantile", *_ENDS)
    return ResultTable("Quantiles", headings, tuple(rows), (_told(confidence),))


def tolerances(
    dataset: xr.Dataset,
    columns: Sequence[str | Column],
    probability: float = TOLERANCE[0],
    confidence: float = TOLERANCE[1],
) -> ResultTable:
    """What a part of all runs stays above, and what it stays below, each with a confidence (Wilks)."""
    rows = [
        (about.key, about.unit, len(values), *tolerance_bounds(values, probability, confidence))
        for about, values in _finite(dataset, columns)
    ]
    least = runs_needed(probability, confidence)
    return ResultTable(
        "Tolerance bounds",
        ("column", "unit", "runs", "above", "below"),
        tuple(rows),
        (
            f"{100 * probability:g} % of runs lie above, or below, with {100 * confidence:g} % confidence",
            *((f"such a bound needs {least} runs",) if any(row[2] < least for row in rows) else ()),
        ),
    )


def covariance_table(dataset: xr.Dataset, columns: Sequence[str | Column]) -> ResultTable:
    """Covariance of each column with each, in the product of their units."""
    chosen = [column(dataset, name) for name in columns]
    taken = moments(independent(dataset), chosen)
    return _matrix("Covariances", chosen, taken.covariance, taken.missing)


def correlation_table(dataset: xr.Dataset, columns: Sequence[str | Column]) -> ResultTable:
    """Pearson's correlation of each column with each."""
    chosen = [column(dataset, name) for name in columns]
    taken = moments(independent(dataset), chosen)
    return _matrix("Correlations", chosen, taken.correlation, taken.missing, _SHARE)


def _matrix(
    title: str, columns: Sequence[Column], matrix: Array, missing: int, format: str = ".6g"
) -> ResultTable:
    rows = [(of.key, *(_known(value) for value in line)) for of, line in zip(columns, matrix, strict=True)]
    told = (f"{missing} runs without a value in some column are left out",) if missing else ()
    return ResultTable(title, ("", *(of.key for of in columns)), tuple(rows), told, format)


def sensitivities(dataset: xr.Dataset, result: str | Column, confidence: float = 0.95) -> ResultTable:
    """How a result goes with each dispersed quantity, strongest first."""
    about = column(dataset, result)
    rows = [
        (
            c.quantity.name,
            *(_ends(c.partial) if c.partial else (None,) * 3),
            *_ends(c.spearman),
            *_ends(c.pearson),
        )
        for c in correlations(dataset, about, confidence)
    ]
    told = [_told(confidence), "partial: of ranks, what the other quantities explain taken away"]
    if dataset.sizes["run"] > RANKED:
        told.append(f"from the first {RANKED} runs")
    title = f"Sensitivity of {about.key}: correlations"
    headings = ("quantity", *_with_ends("partial"), *_with_ends("Spearman"), *_with_ends("Pearson"))
    return ResultTable(title, headings, tuple(rows), tuple(told), _SHARE)


def sobol_table(dataset: xr.Dataset, result: str | Column, confidence: float = 0.95) -> ResultTable:
    """Shares of a result's variance by factors, largest first."""
    about = column(dataset, result)
    found = sobol(dataset, about, confidence)
    rows = [(index.factor, *_ends(index.first), *_ends(index.total)) for index in found]
    told = [f"{_told(confidence)}, by bootstrap over {found[0].first.count} base samples"] if found else []
    title = f"Sensitivity of {about.key}: Sobol indices"
    headings = ("factor", *_with_ends("first"), *_with_ends("total"))
    return ResultTable(title, headings, tuple(rows), tuple(told), _SHARE)


def _finite(dataset: xr.Dataset, columns: Sequence[str | Column]) -> Iterator[tuple[Column, Array]]:
    """Each column with its values, as many columns read at once as memory should hold."""
    chosen = [column(dataset, name) for name in columns]
    runs = independent(dataset)
    at_once = max(1, _GATHERED // max(1, runs.sizes["run"]))
    for first in range(0, len(chosen), at_once):
        group = chosen[first : first + at_once]
        for about, values in zip(group, gather(runs, group).T, strict=True):
            finite = values[np.isfinite(values)]
            if len(finite) > 0:
                yield about, finite


def _with_ends(word: str) -> tuple[str, ...]:
    return word, *(f"{word} {end}" for end in _ENDS)


def _ends(interval: Interval) -> tuple[Cell, Cell, Cell]:
    return interval.value, _known(interval.low), _known(interval.high)


def _told(confidence: float, of_what: str = "") -> str:
    return f"low, high: the {100 * confidence:g} % confidence interval{of_what}"


def _known(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
