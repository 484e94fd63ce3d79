"""What stands on the left of the equations besides the body: added mass, wheels, contents."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from freebody import _check, _core
from freebody._check import Array
from freebody.body import RigidBody
from freebody.errors import InputError
from freebody.interfaces import Force, Spin
from freebody.signals import Signals
from freebody.units import agree

__all__ = ["LeftSide", "left_side"]

LeftSide: TypeAlias = tuple[
    Array | None,
    list[tuple[tuple[float, float, float], float, int]],
    list[tuple[_core.Program, list[float], list[int], int]],
]


def left_side(body: RigidBody, forces: Sequence[Force], signals: Signals) -> LeftSide | None:
    """What forces put on the left, as the core takes it; None where there is nothing.

    Raises `InputError` for what is none, and where the mass matrix would not be positive definite.
    """
    added = [_added_mass(force) for force in forces if force.added_mass is not None]
    names = [state.name for state in signals.states]
    spins = [(spin, names.index(f"{f.name}.{_state(f, spin)}")) for f in forces for spin in f.spins]
    pairs = [(place, own) for place, force in enumerate(forces) for own in force.contents]
    if not (added or spins or pairs):
        return None
    total = np.sum(added, axis=0) if added else None
    _check_mass_matrix(body, total, [spin for spin, _ in spins])
    contents = [
        (*own.core(), places, place)
        for (place, own), places in zip(pairs, signals.contents_places, strict=True)
    ]
    return total, [(spin.axis, spin.inertia, place) for spin, place in spins], contents


def _added_mass(force: Force) -> Array:
    given = force.added_mass
    assert given is not None
    matrix = _check.vector(f"force {force.name!r}: added_mass", given, 6, 6)
    apart = np.abs(matrix - matrix.T)
    if apart.max() > 1e-9 * np.abs(matrix).max():
        i, j = np.unravel_index(int(apart.argmax()), (6, 6))
        raise InputError(
            f"force {force.name!r}: added_mass: entry ({i + 1}, {j + 1}) is {matrix[i, j]:g} and "
            f"({j + 1}, {i + 1}) is {matrix[j, i]:g}; the matrix of a kinetic energy is symmetric, about o1, "
            "in body axes, linear part first"
        )
    return matrix


def _state(force: Force, spin: Spin) -> str:
    """The name of the state of a wheel."""
    if not isinstance(spin, Spin):
        raise InputError(f"force {force.name!r}: spins: got {_check.shown(spin)}; give freebody.Spin(...)")
    units = {state.name: state.unit for state in force.states}
    if spin.state not in units:
        own = ", ".join(map(repr, units)) or "none"
        raise InputError(
            f"force {force.name!r}: a spin has the state {spin.state!r}, which the force has not; its states "
            f"are {own}"
        )
    if not agree(units[spin.state], "rad/s"):
        raise InputError(
            f"force {force.name!r}: the speed of a spin is in rad/s; the state {spin.state!r} is in "
            f"{units[spin.state]!r}"
        )
    return spin.state


def _check_mass_matrix(body: RigidBody, added: Array | None, spins: Sequence[Spin]) -> None:
    matrix = body.spatial_inertia.copy()
    if added is not None:
        matrix += added
    for spin in spins:
        matrix[3:, 3:] -= spin.inertia * np.outer(spin.axis, spin.axis)
    size = np.sqrt(np.abs(np.diag(body.spatial_inertia)))
    if np.linalg.eigvalsh(matrix / np.outer(size, size)).min() <= 0.0:
        what = " and ".join(
            ["with its added mass"] * (added is not None) + ["without its wheels' inertia"] * bool(spins)
        )
        raise InputError(
            f"body {body.name!r}: {what} the mass matrix is not positive definite: an added mass too "
            "far below zero, or a wheel that has more inertia about its axis than the body that it is part of"
        )
