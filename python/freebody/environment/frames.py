"""The frame of an orbit: local vertical, local horizontal."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["OrbitFrame", "lvlh"]


class OrbitFrame(NamedTuple):
    """Axes of LVLH and how they turn.

    Attributes
    ----------
    world_from_lvlh
        (..., 3, 3); the columns are the axes.
    angular_velocity_world
        (..., 3) rad/s.
    """

    world_from_lvlh: Array
    angular_velocity_world: Array


def lvlh(position: ArrayLike, velocity: ArrayLike) -> OrbitFrame:
    """The frame with z towards the centre, y against the orbital momentum and x = y × z, near the velocity.

    Its rate is h/r², which is exact as long as no force has a component normal to the orbit.

    Parameters
    ----------
    position, velocity
        Relative to the centre, axes and motion inertial, (..., 3) m and m/s.

    Raises
    ------
    InputError
        Position and velocity are parallel: there is no orbital plane.
    """
    r, v = (_check.argument(n, x, 3).array for n, x in (("position", position), ("velocity", velocity)))
    momentum = np.cross(r, v)
    distance, size = (np.linalg.norm(x, axis=-1, keepdims=True) for x in (r, momentum))
    if not (size > 1e-12 * distance * np.linalg.norm(v, axis=-1, keepdims=True)).all():
        raise InputError("position, velocity: they are parallel, so that there is no orbital plane")
    z, y = -r / distance, -momentum / size
    return OrbitFrame(np.stack(np.broadcast_arrays(np.cross(y, z), y, z), axis=-1), momentum / distance**2)
