"""Mean and covariance in one pass over blocks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import ArrayLike

from freebody._check import Array, count

from .columns import Column, blocks, column

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Moments", "moments"]


class Moments:
    """Count, mean (k,), least, greatest and covariance (k, k) of rows that come block by block.

    Blocks are joined by their means and the sums of products about them (Chan, Golub and LeVeque 1979), which
    loses no digits where the spread is small beside the mean. A row with a value that is not finite is left
    out and counted in `missing`.
    """

    def __init__(self, columns: int) -> None:
        k = count("columns", columns)
        self.count = 0
        self.missing = 0
        self.mean: Array = np.zeros(k)
        self.least: Array = np.full(k, np.inf)
        self.greatest: Array = np.full(k, -np.inf)
        self._products: Array = np.zeros((k, k))  # sums of products about the mean

    def add(self, rows: ArrayLike) -> Self:
        """Takes rows (m, k) in."""
        values = np.asarray(rows, dtype=np.float64).reshape(-1, len(self.mean))
        complete = np.isfinite(values).all(axis=1)
        block = Moments(len(self.mean))
        block.missing = int(np.count_nonzero(~complete))
        values = values[complete]
        if len(values) > 0:
            block.count = len(values)
            # The mean of the deviations takes back what rounding took from the first mean.
            rough = values.mean(axis=0)
            block.mean = rough + (values - rough).mean(axis=0)
            deviations = values - block.mean
            block._products = deviations.T @ deviations
            block.least, block.greatest = values.min(axis=0), values.max(axis=0)
        return self.merge(block)

    def merge(self, other: Moments) -> Self:
        """Takes in what another has taken in."""
        self.missing += other.missing
        if other.count == 0:
            return self
        total = self.count + other.count
        shift = other.mean - self.mean
        self._products += other._products + np.outer(shift, shift) * (self.count * other.count / total)
        self.mean = self.mean + shift * (other.count / total)
        self.least = np.minimum(self.least, other.least)
        self.greatest = np.maximum(self.greatest, other.greatest)
        self.count = total
        return self

    @property
    def covariance(self) -> Array:
        """Sample covariance (k, k), divisor n - 1; NaN for fewer than two rows."""
        if self.count < 2:
            return np.full_like(self._products, np.nan)
        return self._products / (self.count - 1)

    @property
    def sd(self) -> Array:
        """Sample standard deviation (k,)."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def correlation(self) -> Array:
        """Pearson correlation (k, k); NaN beside a column that does not vary."""
        with np.errstate(invalid="ignore", divide="ignore"):
            scaled = self.covariance / np.outer(self.sd, self.sd)
        varies = np.where(self.greatest > self.least, 1.0, np.nan)
        return np.clip(scaled, -1.0, 1.0) * np.outer(varies, varies)


def moments(dataset: xr.Dataset, columns: Sequence[str | Column]) -> Moments:
    """Moments of columns over the runs that ended well and have a value in each of them."""
    chosen = [column(dataset, name) for name in columns]
    result = Moments(len(chosen))
    for block in blocks(dataset, chosen):
        result.add(block)
    return result
