"""A body with drag in an environment, and what it feels of it."""

from typing import Any

import numpy as np

import freebody as fb
from freebody.elements import TurbulencePath
from freebody.environment import Environment
from freebody.tracing import ForceLaw

BODY = fb.RigidBody(20.0, com=[0.1, 0.02, -0.05], inertia_about_com=np.diag([0.6, 1.1, 1.4]))
POINT = np.array([0.3, -0.1, 0.2])


def drag(environment: Environment, name: str = "drag", size: float = 0.1) -> ForceLaw:
    """Against the velocity relative to the medium, at a point off the mass centre."""

    @fb.force(
        parameters={"area": (size, "m^2"), **environment.parameters},
        inputs=environment.inputs,
        notices=environment.notices,
        name=name,
    )
    def law(s: Any, p: Any) -> Any:
        flow = environment.flow(s, p, POINT)
        pressure = 0.5 * flow.air.density * np.linalg.norm(flow.velocity)
        turning = -0.2 * flow.angular_velocity
        return fb.wrench(force=-p.area * pressure * flow.velocity, moment=1.0 * turning, at=POINT)

    return law


def model(environment: Environment, *others: fb.Force, **options: Any) -> fb.Model:
    """With gravity and drag, and the path that turbulence reads."""
    path = [TurbulencePath(environment)] if "air_path" in environment.inputs else []
    return fb.Model(BODY, [fb.UniformGravity(), drag(environment), *path, *others], **options)
