"""How two sides of an equation are held against each other, and how far apart they may be."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

# Against point masses: both sides sum some hundred products and solve with a random inertia matrix and chart,
# whose conditions multiply the rounding of 1e-16 by up to 1e3; a hundredfold margin. A wrong term is of order
# one.
POINT_MASSES = 1e-11
# Form against form: the same data multiplied in another order, without the oracle's sums.
FORMS = 1e-12
# The same products in nearly the same order: a few units in the last place.
ROUNDING = 1e-14


def assert_agree(got: ArrayLike, expected: ArrayLike, *terms: ArrayLike, within: float) -> None:
    """Check the largest difference, relative to the largest number in `expected` and `terms`."""
    got, expected = np.asarray(got), np.asarray(expected)
    assert got.shape == expected.shape
    scale = max(float(np.abs(np.asarray(x)).max()) for x in (expected, *terms))
    assert float(np.abs(got - expected).max()) <= within * scale


def apply(matrix: NDArray[np.float64], vector: NDArray[np.float64]) -> NDArray[np.float64]:
    """Matrix times vector over leading dimensions."""
    return np.einsum("...ij,...j->...i", matrix, vector)
