"""The right answers of every measure, made once a bench."""

from functools import cache

import numpy as np

import case
import reference


@cache
def nominal() -> np.ndarray:
    """The state (13,) after ten seconds."""
    return reference.final_states(*case.nominal())[:, 0]


@cache
def ensemble() -> np.ndarray:
    """The states (13, 10 000) after ten seconds."""
    return reference.final_states(*case.dispersed())


@cache
def start() -> np.ndarray:
    """The state (13,) to begin with."""
    return case.nominal()[0][:, 0].copy()


def derivative(x: np.ndarray) -> np.ndarray:
    """(13, n) of the nominal body in states (13, n)."""
    _, body = case.nominal()
    return case.derivative(x, body, body.inverse_inertia())


@cache
def jacobian() -> np.ndarray:
    """(13, 19) at the beginning."""
    return case.jacobian(*case.nominal())


def jacobians(x: np.ndarray) -> np.ndarray:
    """(13, 19, n)."""
    _, body = case.nominal()
    return np.stack([case.jacobian(x[:, [i]], body) for i in range(x.shape[1])], axis=-1)
