"""The state of a motion, from what people say of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.errors import InputError
from freebody.signals import given_states

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["state_of"]

Given = ArrayLike | None


def state_of(
    model: Model,
    position: ArrayLike,
    attitude: Attitude | None,
    twist: tuple[Given, Given, Given, Given],
    states: Mapping[str, float] | None,
) -> Array:
    """See `Model.state`; `twist` holds the velocity in body and in world axes, then the angular ones."""
    attitude = Attitude.identity() if attitude is None else attitude
    if not isinstance(attitude, Attitude):
        raise InputError(f"attitude: got {_check.shown(attitude)}; make one with Attitude.angles(...)")
    body_from_world = attitude.as_rotation().T
    velocity = _check.in_body_axes("velocity", *twist[:2], body_from_world)
    turn = _check.in_body_axes("angular_velocity", *twist[2:], body_from_world)
    angles = np.zeros(3) if model.attitude == "quaternion" else attitude.as_angles(model.attitude)
    x = model.state_of(
        _check.vector("position", position, 3),
        attitude.as_quaternion(),
        np.concatenate([velocity, turn]),
        angles,
    )
    if model.attitude != "quaternion":
        x[3:6] = angles
    values = {state.name: state.initial for state in model.auxiliary_states} | given_states(
        states, model.auxiliary
    )
    x[model.n_states - len(values) :] = list(values.values())
    return x
