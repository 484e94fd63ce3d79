"""Figures as they are printed: how far numbers are from them, in units of their last digits."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

import numpy as np
from numpy.typing import ArrayLike

from freebody._check import Array

from .residual import Residual

__all__ = ["ROUNDED", "digits", "last_digits", "off_by"]

# Half a unit is what rounding leaves open; a five hundredth of it for a number that ends on a 5.
ROUNDED = 0.501


def last_digits(printed: Iterable[str]) -> Array:
    """What one unit of the last digit of each figure is worth."""
    return np.array([10.0 ** int(Decimal(text).as_tuple().exponent) for text in printed])


def off_by(got: ArrayLike, printed: str) -> Array:
    """Differences from figures, apart by spaces, in units of their last digits."""
    texts = printed.split()
    return np.abs(np.subtract(got, np.array(texts, dtype=float))) / last_digits(texts)


def digits(case: str, quantity: str, got: ArrayLike, printed: str, allowed: float = ROUNDED) -> Residual:
    """The largest of these differences."""
    return Residual(case, quantity, float(np.max(off_by(got, printed))), allowed, "last digit")
