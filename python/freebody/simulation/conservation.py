"""Which quantities a model keeps, and how well a run kept them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from freebody._check import Array
from freebody.forces import PointMassGravity, UniformGravity
from freebody.simulation.outcome import Conserved

if TYPE_CHECKING:
    from freebody.simulation.trajectory import Trajectory

__all__ = ["conserved"]


def conserved(run: Trajectory) -> list[Conserved]:
    """The laws that hold for the forces of a model; none that hold only by chance."""
    forces = run.model.forces
    if (
        len(run) == 0
        or np.any(run.u)
        or run.model.control is not None
        or not all(isinstance(f, UniformGravity | PointMassGravity) for f in forces)
    ):
        return []
    # A motion that left the range of doubles has no drift: it is shown as NaN.
    with np.errstate(over="ignore", invalid="ignore"):
        return list(_laws(run))


def _laws(run: Trajectory) -> Iterator[Conserved]:
    forces, body = run.model.forces, run.model.body
    linear, angular = run.momentum_world[:, :3], run.momentum_world[:, 3:]
    # Not as the difference of two moments about a far origin: it would be their rounding.
    spin = np.einsum("nij,jk,nk->ni", run.world_from_body, body.inertia_about_com, run.angular_velocity_body)
    if not any(isinstance(f, PointMassGravity) and f.gradient_torque for f in forces):
        # The torque of the gradient alone, without its small force, has no potential.
        yield _drift("energy", "J", run.energy, float(np.abs(run.kinetic_energy).max()))
    if not forces:
        # The momentum may be the small sum of what the origin does and what the mass centre does around it.
        origin = body.mass * float(np.linalg.norm(run.velocity_body, axis=1).max())
        yield _drift("momentum", "kg m/s", linear, max(origin, float(np.linalg.norm(linear[0]))))
        yield _drift("angular momentum about the mass centre", "kg m²/s", spin)
        return
    uniform = [f.acceleration * f.direction for f in forces if isinstance(f, UniformGravity)]
    masses = [f for f in forces if isinstance(f, PointMassGravity)]
    if not masses:
        down = np.sum(uniform, axis=0)
        if np.any(down):
            down = down / np.linalg.norm(down)
            level = linear - np.outer(linear @ down, down)
            yield _drift("level momentum", "kg m/s", level, float(np.linalg.norm(linear, axis=1).max()))
    if not any(f.gradient_torque for f in masses):
        yield _drift("angular momentum about the mass centre", "kg m²/s", spin)
    if len(masses) == 1 and not uniform and not masses[0].gradient_torque:
        about_center = angular - np.cross(masses[0].center, linear)
        yield _drift("angular momentum about the centre", "kg m²/s", about_center)


def _drift(name: str, unit: str, values: Array, reference: float | None = None) -> Conserved:
    """The deviation from the first value, relative to the largest size of the quantity."""
    rows = values.reshape(len(values), -1)
    size = float(np.linalg.norm(rows, axis=1).max()) if reference is None else reference
    deviation = np.linalg.norm(rows - rows[0], axis=1)
    return Conserved(name, unit, size, deviation / size if size > 0.0 else deviation)
