"""Two sides of an equation and how far apart they may be."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freebody._check import Array

# Both sides are sums of some hundred products; the worst body and chart drawn amplify their rounding, 1e-16
# each, by less than 1e3. A wrong sign or a missing term is of order one.
AGAINST_POINT_MASSES = 1e-11
# Two forms share their data, so only the order of operations differs.
FORM_AGAINST_FORM = 1e-12


class Law(NamedTuple):
    """An equation by its number in the paper; the residual is relative to the largest of its terms."""

    number: str
    quantity: str
    got: Array
    expected: Array
    terms: tuple[Array, ...] = ()
    allowed: float = AGAINST_POINT_MASSES

    @property
    def residual(self) -> float:
        """The largest difference, relative to the largest number on the right or in `terms`."""
        scale = max(float(np.abs(x).max()) for x in (self.expected, *self.terms))
        return float(np.abs(self.got - self.expected).max()) / scale
