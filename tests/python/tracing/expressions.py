"""Expressions of NumPy, run on numbers and as traced laws."""

from collections.abc import Callable
from typing import Any

import numpy as np

from freebody.tracing import ControlLaw

N_SITUATION = 23
N_RANDOM = 50
MATRIX = np.array([[2.0, -1.0, 0.5], [0.0, 3.0, 1.0], [0.3, 0.2, 1.0]])

Expression = Callable[[Any, Any, Any, Any, Any], Any]
"""Of x, y: numbers; v, w: (3,); m: (3, 3); all traced and in [-2, 2]. Gives an array, or a list of such."""


def _arguments(numbers: Any) -> tuple[Any, Any, Any, Any, Any]:
    return numbers[0], numbers[1], numbers[2:5], numbers[5:8], numbers[8:17].reshape(3, 3)


def _flat(result: Any) -> list[Any]:
    parts = result if isinstance(result, list) else [result]
    return [number for part in parts for number in np.ravel(part)]


def check(expression: Expression) -> None:
    """A traced law computes what NumPy does."""

    def law(s: Any) -> dict[str, Any]:
        results = _flat(expression(*_arguments(np.stack(list(s.inputs.values())))))
        return {f"c{i}": number for i, number in enumerate(results)}

    numbers = np.random.default_rng(3).uniform(-2.0, 2.0, (N_RANDOM, 17))
    traced = ControlLaw(law, inputs={f"x{i}": "1" for i in range(17)})
    got = traced._program.run(np.zeros(0), np.hstack([np.zeros((N_RANDOM, N_SITUATION)), numbers]))
    wanted = np.array([_flat(expression(*_arguments(row))) for row in numbers], float)
    # Sums and products may round in another order, functions of the core in their last digits; results of
    # cancellation are as good as the largest number beside them.
    np.testing.assert_allclose(got, wanted, rtol=1e-13, atol=1e-13 * np.abs(wanted).max(initial=1e-300))
