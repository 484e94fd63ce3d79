"""From array-likes of any leading shape to rows of the core and back."""

from __future__ import annotations

import numpy as np

from freebody import _core
from freebody._check import Argument, Array
from freebody.errors import InputError, NonFiniteError, SingularChartError

# Nearer than this, or than one step of the angle's own doubles, it cannot be told from the singular one.
_SINGULAR = 1e-15


def checked_body(body: _core.RigidBody) -> _core.RigidBody:
    """Check that `body` is a rigid body."""
    if not isinstance(body, _core.RigidBody):
        raise InputError(f"body: got {type(body).__name__}; give a freebody.RigidBody")
    return body


def regular(alpha: Argument, angles: str) -> None:
    """Refuse angles at the singularity of their chart, where M0 has no inverse."""
    distance = evaluate("singularity_distance", (), alpha, angles=angles)
    second = alpha.array[..., 1]
    singular = distance < np.maximum(_SINGULAR, np.spacing(np.abs(second)))
    if singular.any():
        degrees = np.rad2deg(second[singular].flat[0])
        raise SingularChartError(
            f"{alpha.name}: the second angle of {angles!r} is {degrees:.12g} deg, where the first and third "
            "axes align and the angle rates do not exist; use another sequence or a quaternion"
        )


def orientation(q: Argument) -> Argument:
    """The angles in the generalized coordinates q = (o1, alpha)."""
    return Argument(q.name, q.array[..., 3:6], (3,))


def evaluate(
    name: str,
    item: tuple[int, ...],
    *arguments: Argument,
    angles: str | None = None,
    body: _core.RigidBody | None = None,
) -> Array:
    """Evaluate one form of the core on arguments whose leading dimensions broadcast."""
    try:
        batch = np.broadcast_shapes(*(a.batch for a in arguments))
    except ValueError:
        shapes = ", ".join(f"{a.name} {a.array.shape}" for a in arguments)
        raise InputError(f"leading dimensions do not broadcast: {shapes}") from None
    rows = [
        np.ascontiguousarray(np.broadcast_to(a.array, batch + a.item)).reshape(-1, int(np.prod(a.item)))
        for a in arguments
    ]
    result = _core.form(name, angles, body, rows)
    if not np.isfinite(result).all():
        fields = ", ".join(a.name for a in arguments)
        raise NonFiniteError(f"{name}: the result is not finite although {fields} are; they are too large")
    return result.reshape(batch + item)[()]
