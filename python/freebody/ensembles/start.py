"""Initial states of many runs, in the chart of their model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from freebody import forms
from freebody._check import Array
from freebody.ensembles.rotations import nearest_angles, product, rotation_of_vector, turned

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Start"]


class Start:
    """A state of a model, from which those of the runs depart.

    What is not dispersed keeps its components in body axes: an attitude that is dispersed turns the body with
    its velocity, unless a velocity in world axes is dispersed beside it.

    Attributes
    ----------
    x0
        (n_states,).
    nominal
        Position and velocities by the names of their quantities, (3,) each.
    """

    def __init__(self, model: Model, x0: Array) -> None:
        self.model, self.x0 = model, x0
        position, quaternion, twist = model.motion(x0[None])
        self._quaternion = quaternion
        velocity, turn = twist[:, :3], twist[:, 3:]
        rotation = forms.rotation_from_quaternion(quaternion)
        self.nominal: Mapping[str, Array] = {
            "position": position[0],
            "velocity_body": velocity[0],
            "velocity_world": turned(rotation, velocity)[0],
            "angular_velocity_body": turn[0],
            "angular_velocity_world": turned(rotation, turn)[0],
        }

    def states(self, values: Mapping[str, Array], n: int) -> Array:
        """The states (n, n_states) of runs, of draws (n, k) by the names of quantities."""
        model, x = self.model, np.tile(self.x0, (n, 1))
        if "position" in values:
            x[:, :3] = values["position"]
        for name, place in model.auxiliary.items():
            if name in values:
                x[:, place] = values[name][:, 0]
        quaternion = np.tile(self._quaternion, (n, 1))
        if "attitude" in values:
            quaternion = product(quaternion, rotation_of_vector(values["attitude"]))
        rotation = forms.rotation_from_quaternion(quaternion)
        width = 4 if model.attitude == "quaternion" else 3
        if "attitude" in values:
            x[:, 3 : 3 + width] = self._orientation(quaternion, rotation)
        slow, turn = (self._in_body_axes(stem, values, rotation) for stem in ("velocity", "angular_velocity"))
        rates = model.form == "generalized"
        if slow is not None:
            x[:, 3 + width : 6 + width] = turned(rotation, slow) if rates else slow
        if turn is not None:
            end = 6 + 2 * width if rates else 9 + width
            x[:, 6 + width : end] = self._rates(x[:, 3 : 3 + width], turn) if rates else turn
        return x

    def _orientation(self, quaternion: Array, rotation: Array) -> Array:
        if self.model.attitude == "quaternion":
            return quaternion
        return nearest_angles(rotation, self.model.attitude, self.x0[3:6])

    def _in_body_axes(self, stem: str, values: Mapping[str, Array], rotation: Array) -> Array | None:
        """A velocity (n, 3) in body axes where the state must be told anew."""
        if f"{stem}_body" in values:
            return values[f"{stem}_body"]
        if f"{stem}_world" in values:
            return turned(np.swapaxes(rotation, 1, 2), values[f"{stem}_world"])
        if "attitude" in values and self.model.form == "generalized":
            return np.tile(self.nominal[f"{stem}_body"], (len(rotation), 1))
        return None

    def _rates(self, orientation: Array, turn: Array) -> Array:
        if self.model.attitude == "quaternion":
            return forms.quaternion_rate(orientation, turn)
        return turned(forms.rate_matrix_body_inverse(orientation, self.model.attitude), turn)
