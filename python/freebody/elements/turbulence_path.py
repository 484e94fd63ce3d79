"""The way of a body through the air."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.environment import Environment, checked_environment
from freebody.tracing import ForceLaw, wrench

__all__ = ["TurbulencePath"]


class TurbulencePath(ForceLaw):
    """The distance flown through the air, which turbulence and gusts read as the input "air_path".

    It exerts no force. Its state grows with the airspeed relative to the steady wind.

    Parameters
    ----------
    environment
        Whose air it is.
    at
        The point of the body, body axes from the origin, (3,) m.
    """

    publishes = ("air_path",)

    def __init__(
        self, environment: Environment, at: ArrayLike = (0.0, 0.0, 0.0), *, name: str = "turbulence"
    ) -> None:
        checked_environment(environment)
        point = _check.vector("at", at, 3)
        steady = environment.steady

        def air_path(s: Any, p: Any) -> Any:
            speed = np.linalg.norm(steady.flow(s, p, point).velocity)
            return wrench(force=np.zeros(3)), {"air_path": speed}

        super().__init__(
            air_path,
            parameters=steady.parameters,
            inputs=steady.inputs,
            states={"air_path": (0.0, "m")},
            name=name,
            notices=steady.notices,
        )
