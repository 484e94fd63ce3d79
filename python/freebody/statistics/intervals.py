"""Estimates with confidence intervals, from independent runs.

Sources: Hahn and Meeker, Statistical Intervals (1991), chapter 5 for quantiles and tolerance bounds (order
statistics: no distribution is assumed); Wilks (1941) for the number of runs; Clopper and Pearson (1934) for
probabilities; Bonett and Wright (2000) for rank correlations.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy import special

from freebody._check import Array, choice, count, number, shown
from freebody.errors import InputError

__all__ = [
    "Interval",
    "ToleranceBounds",
    "correlation_interval",
    "mean_interval",
    "probability_interval",
    "quantile_interval",
    "runs_needed",
    "tolerance_bounds",
]


@dataclass(frozen=True)
class Interval:
    """An estimate and the interval that holds the true value with this confidence; infinite where the runs
    are too few to say."""

    value: float
    low: float
    high: float
    confidence: float
    count: int

    @property
    def half_width(self) -> float:
        """The larger distance from the estimate to an end."""
        width = max(self.high - self.value, self.value - self.low)
        return width if np.isfinite(width) else np.inf


class ToleranceBounds(NamedTuple):
    """Each of its own, not both at once; None where the runs are too few."""

    lower: float | None
    upper: float | None


def mean_interval(mean: float, sd: float, n: int, confidence: float = 0.95) -> Interval:
    """Student's interval of a mean; near enough for any distribution with a variance once n is large."""
    confidence = fraction("confidence", confidence)
    if n < 2:
        return Interval(mean, -np.inf, np.inf, confidence, n)
    half = float(special.stdtrit(n - 1, 0.5 + confidence / 2)) * sd / np.sqrt(n)
    return Interval(mean, mean - half, mean + half, confidence, n)


def probability_interval(hits: int, n: int, confidence: float = 0.95) -> Interval:
    """Clopper and Pearson's interval of a probability, of which `hits` of `n` runs speak: never too short."""
    confidence = fraction("confidence", confidence)
    if not 0 <= hits <= count("n", n):
        raise InputError(f"hits: got {shown(hits)}; of {n} runs there can be 0 to {n}")
    tail = (1 - confidence) / 2
    low = special.betaincinv(hits, n - hits + 1, tail) if hits > 0 else 0.0
    high = special.betaincinv(hits + 1, n - hits, 1 - tail) if hits < n else 1.0
    return Interval(hits / n, float(low), float(high), confidence, int(n))


def quantile_interval(values: ArrayLike, probability: float, confidence: float = 0.95) -> Interval:
    """A quantile of values (n,) between two of their order statistics, with equal tails.

    An end is infinite where even the least or the greatest value bounds the quantile with less confidence.
    """
    data = sample(values)
    probability, confidence = fraction("probability", probability), fraction("confidence", confidence)
    n, sure = len(data), (1 + confidence) / 2
    below, above = n + 1 - _rank(n, 1 - probability, sure), _rank(n, probability, sure)
    data.partition(np.array([rank - 1 for rank in (below, above) if 1 <= rank <= n], dtype=np.intp))
    return Interval(
        float(np.quantile(data, probability, method="median_unbiased")),
        float(data[below - 1]) if below >= 1 else -np.inf,
        float(data[above - 1]) if above <= n else np.inf,
        confidence,
        n,
    )


def tolerance_bounds(values: ArrayLike, probability: float, confidence: float) -> ToleranceBounds:
    """One-sided bounds: with this confidence, the probability lies below `upper`, or above `lower`."""
    data = np.sort(sample(values))
    n = len(data)
    rank = _rank(n, fraction("probability", probability), fraction("confidence", confidence))
    return ToleranceBounds(*((float(data[n - rank]), float(data[rank - 1])) if rank <= n else (None, None)))


def runs_needed(probability: float, confidence: float, sides: int = 1) -> int:
    """The fewest runs whose greatest value bounds this probability from above with this confidence (Wilks).

    With `sides=2`: whose least and greatest value hold this probability between them.
    """
    probability, confidence = fraction("probability", probability), fraction("confidence", confidence)
    if sides not in (1, 2):
        raise InputError(f"sides: got {shown(sides)}; give 1 or 2")

    def enough(n: int) -> bool:
        # At least `sides` of n runs fall into what is left of the probability.
        return float(special.bdtrc(sides - 1, n, 1 - probability)) >= confidence

    high = sides
    while not enough(high):
        high *= 2
    low = high // 2
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if enough(middle) else (middle, high)
    return high


def correlation_interval(
    value: float, n: int, confidence: float = 0.95, *, given: int = 0, method: str = "pearson"
) -> Interval:
    """Fisher's interval of a correlation, of which `given` other columns were taken away.

    `method="rank"` widens it as Bonett and Wright do for Spearman's.
    """
    value, confidence = float(value), fraction("confidence", confidence)
    choice("method", method, ("pearson", "rank"))
    free = n - 3 - given
    if free < 1 or not np.isfinite(value):
        return Interval(value, -1.0, 1.0, confidence, n)
    widening = 1 + value**2 / 2 if method == "rank" else 1.0
    half = float(special.ndtri(0.5 + confidence / 2)) * np.sqrt(widening / free)
    with np.errstate(divide="ignore"):  # a correlation of one stays one
        center = np.arctanh(value)
    return Interval(value, float(np.tanh(center - half)), float(np.tanh(center + half)), confidence, n)


def sample(values: ArrayLike) -> Array:
    """Values (n,) that are all finite, at least one; a copy."""
    data = np.array(values, dtype=np.float64)
    if data.ndim != 1 or len(data) == 0 or not np.isfinite(data).all():
        raise InputError(f"values: got {shown(values)}; give at least one number, all finite, shape (n,)")
    return data


def fraction(name: str, value: float) -> float:
    """Check a number between 0 and 1, neither of which is allowed."""
    checked = number(name, value)
    if not 0.0 < checked < 1.0:
        raise InputError(f"{name}: got {shown(value)}; give a number between 0 and 1 (0.95 is 95 %)")
    return checked


def _rank(n: int, probability: float, confidence: float) -> int:
    """The least r such that the r-th of n values in order lies at or above the quantile with this confidence:
    that at most r - 1 values lie under it. n + 1 where even the greatest does not."""
    low, high = 0, n + 1
    while high - low > 1:
        middle = (low + high) // 2
        if special.bdtr(middle - 1, n, probability) >= confidence:
            high = middle
        else:
            low = middle
    return high
