"""Which dispersed quantity moves a result how much: correlations and Sobol indices.

Sources: Saltelli et al., Computer Physics Communications 181 (2010), for the estimators of Sobol indices;
Marino et al., Journal of Theoretical Biology 254 (2008), for partial rank correlation.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike
from scipy import stats

from freebody._check import Array, shown
from freebody.errors import InputError

from .columns import Column, all_columns, column, gather
from .design import independent, pages
from .intervals import Interval, correlation_interval, fraction
from .moments import Moments

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Correlations", "SobolIndices", "correlations", "sobol", "sobol_indices"]

RANKED = 100_000  # runs: ranks need whole columns in memory, and this many know a correlation to 0.006
_RESAMPLES = 999


@dataclass(frozen=True)
class Correlations:
    """How a result goes with one quantity: linearly, by ranks, by ranks with the other quantities taken away.

    `partial` is None where the other quantities leave nothing of this one, or the runs are too few.
    """

    quantity: Column
    pearson: Interval
    spearman: Interval
    partial: Interval | None


@dataclass(frozen=True)
class SobolIndices:
    """Shares of a result's variance: `first`, by one factor alone; `total`, with all that it joins in."""

    factor: str
    first: Interval
    total: Interval


def correlations(
    dataset: xr.Dataset, result: str | Column, confidence: float = 0.95, runs: int = RANKED
) -> list[Correlations]:
    """The correlations of a column with every dispersed quantity that varies, strongest first.

    From the first `runs` runs that ended well and have a value.
    """
    chosen, quantities = column(dataset, result), all_columns(dataset, "dispersed")
    first = independent(dataset.isel(run=slice(0, runs)))
    values = gather(first, [chosen, *quantities])
    values = values[np.isfinite(values).all(axis=1)]
    n = len(values)
    if n < 4:
        return []
    varies = np.ptp(values, axis=0) > 0
    if not varies[0]:
        return []
    kept = [quantity for quantity, does in zip(quantities, varies[1:], strict=True) if does]
    values = values[:, varies]
    ranks = stats.rankdata(values, axis=0)
    linear = Moments(values.shape[1]).add(values).correlation[0, 1:]
    ranked = Moments(values.shape[1]).add(ranks).correlation
    partial = _partial(ranked)
    others = len(kept) - 1
    found = [
        Correlations(
            quantity,
            correlation_interval(linear[i], n, confidence),
            correlation_interval(ranked[0, i + 1], n, confidence, method="rank"),
            None
            if partial is None or n < others + 4
            else correlation_interval(partial[i], n, confidence, given=others, method="rank"),
        )
        for i, quantity in enumerate(kept)
    ]
    return sorted(found, key=lambda c: -abs((c.partial or c.spearman).value))


def sobol(
    dataset: xr.Dataset, result: str | Column, confidence: float = 0.95, seed: int = 0
) -> list[SobolIndices]:
    """The Sobol indices of a column of runs made with `sampling="saltelli"`, largest total first.

    A base sample of which any run ended badly or has no value is left out whole. Raises `InputError` for runs
    of another sampling.
    """
    design = pages(dataset, column(dataset, result))
    indices = sobol_indices(design.a, design.b, design.ab, confidence, seed)
    named = [SobolIndices(name, *both) for name, both in zip(design.factors, indices, strict=True)]
    return sorted(named, key=lambda index: -index.total.value)


def sobol_indices(
    a: ArrayLike, b: ArrayLike, ab: ArrayLike, confidence: float = 0.95, seed: int = 0
) -> list[tuple[Interval, Interval]]:
    """First and total order index of each factor, with percentile intervals of a bootstrap over base samples.

    `a`, `b` (n,): the result at the base samples A and B; `ab` (k, n): at A with factor i taken from B.
    """
    fraction("confidence", confidence)
    fa, fb, fab = (np.array(values, dtype=np.float64) for values in (a, b, ab))
    n = len(fa) if fa.ndim == 1 else 0
    if n < 2 or fb.shape != (n,) or fab.ndim != 2 or fab.shape[1] != n:
        raise InputError(
            f"a, b, ab: got shapes {fa.shape}, {fb.shape}, {fab.shape}; allowed are (n,), (n,), (k, n), n > 1"
        )
    if not all(np.isfinite(values).all() for values in (fa, fb, fab)):
        raise InputError(f"a, b, ab: every number must be finite; came {shown(a)}, {shown(b)}, {shown(ab)}")
    middle = np.concatenate([fa, fb]).mean()
    fa, fb, fab = fa - middle, fb - middle, fab - middle
    k = len(fab)
    # Every estimate is a ratio of means over base samples, so a resample needs the means of these alone.
    terms = np.column_stack([fa + fb, fa**2 + fb**2, *(fb * (fab - fa)), *((fa - fab) ** 2)])

    def shares(means: Array) -> Array:
        variance = means[..., 1] / 2 - (means[..., 0] / 2) ** 2
        with np.errstate(invalid="ignore", divide="ignore"):
            found = means[..., 2:] / variance[..., None]
        found[..., k:] /= 2
        return np.where(np.isfinite(found), found, 0.0)

    estimate = shares(terms.mean(axis=0))
    resampled = shares(_resampled_means(terms, seed))
    tail = (1 - confidence) / 2
    low, high = np.quantile(resampled, [tail, 1 - tail], axis=0)
    rows = np.stack([estimate, low, high], axis=1).tolist()
    intervals = [Interval(value, least, most, confidence, n) for value, least, most in rows]
    return list(zip(intervals[:k], intervals[k:], strict=True))


def _partial(correlation: Array) -> Array | None:
    """Of the first column with each other one, given the rest; None where these are not independent."""
    if np.linalg.cond(correlation) > 1e10:
        return None
    inverse = np.linalg.inv(correlation)
    return np.clip(-inverse[0, 1:] / np.sqrt(inverse[0, 0] * np.diag(inverse)[1:]), -1.0, 1.0)


def _resampled_means(terms: Array, seed: int) -> Array:
    """Means (resamples, k) of rows (n, k) drawn with replacement."""
    n, rng = len(terms), np.random.default_rng(seed)
    draws = (np.bincount(rng.integers(n, size=n), minlength=n) for _ in range(_RESAMPLES))
    return np.stack([often @ terms / n for often in draws])
