"""The exact Jacobians of (3.2) against differences of the derivative, in every chart and both states."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from freebody import forms
from freebody.attitude import Attitude
from freebody.forces import LinearDamping, UniformGravity
from freebody.model import Model
from freebody.verify.law import Array, Law
from freebody.verify.point_masses import Cloud, Motion

# Eighth-order differences: truncation (step / 0.45)^8, 0.45 rad from the singularity, and rounding
# 1e-16 / step come to 3e-11 at worst; a thirtyfold margin.
_STEP = 0.01
_WEIGHTS = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
_ALLOWED = 1e-9


def linearization(cloud: Cloud, rng: np.random.Generator) -> Iterator[Law]:
    """Both Jacobians of one body under gravity and damping, about one random state in each chart and form."""
    damping = LinearDamping(rng.uniform(0.1, 1.0, size=6))
    for attitude in (*forms.SEQUENCES, "quaternion"):
        motion = Motion.random(rng, "zyx" if attitude == "quaternion" else attitude)
        u = rng.normal(size=6)
        for form in ("quasi_velocity", "generalized"):
            model = Model(cloud.body, [UniformGravity(), damping], attitude=attitude, form=form)
            x = model.state(
                position=motion.position.value,
                attitude=Attitude.rotation(motion.rotation.value),
                velocity_body=motion.twist[:3],
                angular_velocity_body=motion.twist[3:],
            )
            by_state, by_input = model.jacobian(0.0, x, u)
            slopes = _differences(lambda x, model=model, u=u: model.derivative(0.0, x, u), x)
            yield Law("3.2", "Jacobian by the state", by_state, slopes, allowed=_ALLOWED)
            slopes = _differences(lambda u, model=model, x=x: model.derivative(0.0, x, u), u)
            yield Law("3.2", "Jacobian by the input", by_input, slopes, allowed=_ALLOWED)


def _differences(f: Callable[[Array], Array], at: Array) -> Array:
    columns = []
    for step in _STEP * np.eye(len(at)):
        sides = (w * (f(at + k * step) - f(at - k * step)) for k, w in enumerate(_WEIGHTS, start=1))
        columns.append(sum(sides, np.zeros_like(f(at))) / _STEP)
    return np.stack(columns, axis=-1)
