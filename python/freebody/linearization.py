"""Linearization along a computed motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.simulation import Trajectory

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Linearization", "linearize"]


@dataclass(frozen=True)
class Linearization:
    """δx' = A(t) δx + B(t) δu along a motion, at its samples. Konoplev (3.2).

    Attributes
    ----------
    t
        (n,) s.
    A, B
        ∂f/∂x (n, n_states, n_states) and ∂f/∂u (n, n_states, n_inputs), exact.
    """

    t: Array
    A: Array
    B: Array


def linearize(model: Model, run: Trajectory) -> Linearization:
    """See `Model.linearize`."""
    if not isinstance(run, Trajectory):
        raise InputError(f"run: got {_check.shown(run)}; give a Trajectory of this model")
    if (run.state_names, run.model.input_names) != (model.state_names, model.input_names):
        raise InputError(f"run: its states and inputs are those of {run.model!r}, not of {model!r}")
    if len(run) == 0:
        raise InputError("run: it has no samples")
    pairs = [model.jacobian(t, x, u) for t, x, u in zip(run.t.tolist(), run.x, run.u, strict=True)]
    return Linearization(run.t, np.array([a for a, _ in pairs]), np.array([b for _, b in pairs]))
