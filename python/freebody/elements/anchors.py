"""Points of the world that lines hang on, at rest or moved by inputs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.tracing.declaration import check_name

__all__ = ["Anchor", "anchored"]


class Anchor(NamedTuple):
    """A point of the world.

    Attributes
    ----------
    fixed
        World axes, (3,) m, or `None` where inputs say it.
    names
        Of the inputs of the position and of the velocity.
    """

    fixed: Any
    names: tuple[str, ...]

    @property
    def inputs(self) -> Mapping[str, str]:
        return {n: "m" if i < 3 else "m/s" for i, n in enumerate(self.names)}

    def line(self, s: Any, point: Any) -> tuple[Any, Any]:
        """From the anchor to a point of the body, and its rate, world axes, (3,) each."""
        turn = s.world_from_body
        position = s.position_world + turn @ point
        velocity = turn @ (s.velocity_body + np.cross(s.angular_velocity_body, point))
        if self.fixed is not None:
            return position - self.fixed, velocity
        read = [s.inputs[n] for n in self.names]
        return position - np.stack(read[:3]), velocity - np.stack(read[3:])


def anchored(name: str, given: ArrayLike | str) -> Anchor:
    """Check an anchor: a point, or the name of one that inputs move."""
    if isinstance(given, str):
        check_name(name, given)
        positions = tuple(f"{given}_{axis}" for axis in "xyz")
        return Anchor(None, (*positions, *(f"{given}_velocity_{axis}" for axis in "xyz")))
    return Anchor(_check.vector(name, given, 3), ())
