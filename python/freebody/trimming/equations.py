"""The equations of steady flight, and their exact derivative."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError
from freebody.forces import UniformGravity
from freebody.model import Model
from freebody.tracing.situation import did_you_mean

__all__ = ["SteadyFlight", "named"]

_ATTACK = (0.05, 0.2, 0.4, 0.7)
_SHARES = (0.2, 0.5, 0.9)
_ANGLES = ("alpha", "beta", "roll", "pitch")


@dataclass(frozen=True)
class SteadyFlight:
    """What a trim asks for, as equations in the numbers z: four angles, inputs, auxiliary states.

    The model is in angles "zyx"; what is fixed are the inputs that are given.
    """

    model: Model
    airspeed: float
    height: float
    flight_path: float
    heading: float
    turn_rate: float
    pitch_rate: float
    roll: float | None
    sideslip: float | None
    fixed: Mapping[str, float]

    def __post_init__(self) -> None:
        for name in self.model.input_names:
            if name in _ANGLES:
                raise InputError(
                    f"model: its input {name!r} has the name of an angle that is sought; rename it"
                )

    @property
    def names(self) -> list[str]:
        sought = [name for name in self.model.input_names if name not in self.fixed]
        return [*_ANGLES, *sought, *(state.name for state in self.model.auxiliary_states)]

    def starts(self, guess: Mapping[str, float] | None, low: Array, high: Array) -> Iterator[Array]:
        """Where to start: at several angles of attack, and at several shares of what only pushes."""
        given = named("guess", guess, self.names)
        attack = (given["alpha"],) if "alpha" in given else _ATTACK
        pushing = [
            n for n, least, most in zip(self.names, low, high, strict=True) if 0.0 <= least < most < np.inf
        ]
        pushing = [name for name in pushing if name in self.model.input_names and name not in given]
        for share, alpha in product(_SHARES if pushing else _SHARES[:1], attack):
            inputs = {
                n: low[i] + share * (high[i] - low[i]) for i, n in enumerate(self.names) if n in pushing
            }
            yield self._settled(np.clip(self._start({**inputs, **given, "alpha": alpha}), low, high))

    def _start(self, given: Mapping[str, float]) -> Array:
        initial = {state.name: state.initial for state in self.model.auxiliary_states}
        initial |= {"pitch": given["alpha"] + self.flight_path, "beta": self.sideslip or 0.0}
        if self.roll is None and self.sideslip is None:
            initial["roll"] = np.arctan(self.turn_rate * self.airspeed / self.gravity)
        else:
            initial["roll"] = self.roll or 0.0
        return np.array([given.get(name, initial.get(name, 0.0)) for name in self.names])

    def _settled(self, z: Array) -> Array:
        """The auxiliary states that go with the inputs, by a few of Newton's steps."""
        n = len(self.model.auxiliary_states)
        for _ in range(20 if n else 0):
            own, rates = slice(len(z) - n, len(z)), slice(6, 6 + n)
            step = np.linalg.lstsq(self.jacobian(z)[rates, own], self.residual(z)[rates])[0]
            z = np.concatenate([z[:-n], z[-n:] - step])
            if not np.abs(step).max() > 1e-12:
                break
        return z

    def bounds(self, given: Mapping[str, tuple[float, float]] | None) -> tuple[Array, Array]:
        if not isinstance(given, Mapping | None):
            raise InputError(f"bounds: got {_check.shown(given)}; give (low, high) by name")
        names = self.names
        low, high = np.full(len(names), -np.inf), np.full(len(names), np.inf)
        for name, pair in (given or {}).items():
            _known("bounds", name, names)
            low[names.index(name)], high[names.index(name)] = _check.vector(f"bounds[{name!r}]", pair, 2)
        if not (low < high).all():
            raise InputError("bounds: the first must be smaller than the second")
        return low, high

    @property
    def gravity(self) -> float:
        """What coordinated turns lean against: that of the model, or the standard one."""
        found = [f.acceleration for f in self.model.forces if isinstance(f, UniformGravity)]
        return float(sum(found)) if found else 9.80665

    def motion(self, z: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        """The state, and how far the flight path and the lateral condition are missed; z may be complex."""
        (alpha, beta, roll, pitch), auxiliary = z[:4], z[len(z) - len(self.model.auxiliary_states) :]
        direction = np.array([np.cos(alpha) * np.cos(beta), np.sin(beta), np.sin(alpha) * np.cos(beta)])
        velocity = self.airspeed * direction
        rotation = _turn(2, self.heading) @ _turn(1, pitch) @ _turn(0, roll)
        down = rotation[2]
        omega = self.turn_rate * down + self.pitch_rate * np.array([0.0, np.cos(roll), -np.sin(roll)])
        com = np.asarray(self.model.body.com)
        x = np.concatenate(
            [
                np.array([0.0, 0.0, -self.height]) - rotation @ com,
                [self.heading, pitch, roll],
                velocity - np.cross(omega, com),
                omega,
                auxiliary,
            ]
        )
        if self.sideslip is not None:
            lateral = beta - self.sideslip
        elif self.roll is not None:
            lateral = roll - self.roll
        else:
            lateral = np.cross(omega, velocity)[1] - self.gravity * down[1]
        return x, np.array([down @ direction + np.sin(self.flight_path), lateral])

    def inputs(self, z: Array) -> Array:
        sought = dict(zip(self.names, z.tolist(), strict=True))
        return np.array([self.fixed.get(name, sought.get(name, 0.0)) for name in self.model.input_names])

    def residual(self, z: Array) -> Array:
        x, missed = self.motion(z)
        return np.concatenate([self.model.derivative(0.0, x, self.inputs(z))[6:], missed])

    def jacobian(self, z: Array) -> Array:
        x, _ = self.motion(z)
        by_x, by_u = self.model.jacobian(0.0, x, self.inputs(z))
        # The derivative of an analytic function is its imaginary part at an imaginary step, to rounding.
        steps = [self.motion(z + 1e-30j * unit) for unit in np.eye(len(z))]
        x_by_z = np.imag(np.column_stack([state for state, _ in steps])) * 1e30
        missed_by_z = np.imag(np.column_stack([missed for _, missed in steps])) * 1e30
        u_by_z = np.array([[float(u == name) for name in self.names] for u in self.model.input_names])
        u_by_z = u_by_z.reshape(-1, len(z))
        return np.vstack([(by_x @ x_by_z + by_u @ u_by_z)[6:], missed_by_z])

    def complaint(self, left: Array) -> str:
        labels = [f"{name}'" for name in self.model.state_names[6:]] + ["flight path", "lateral condition"]
        worst = [f"{labels[i]} {left[i]:.3g}" for i in np.argsort(-left)[:3] if left[i] > 0.0]
        return (
            f"no steady flight found; what remains is {', '.join(worst)} (SI); ask for another airspeed or "
            f"altitude, or start elsewhere: guess={{...}} may have {', '.join(self.names)}"
        )


def _turn(axis: int, angle: Any) -> NDArray[Any]:
    """The rotation about a coordinate axis, (3, 3)."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3, dtype=np.result_type(angle, float))
    matrix[i, i] = matrix[j, j] = np.cos(angle)
    matrix[i, j], matrix[j, i] = -np.sin(angle), np.sin(angle)
    return matrix


def named(what: str, given: object, known: Any) -> dict[str, float]:
    """Check numbers by name."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise InputError(f"{what}: got {_check.shown(given)}; give numbers by name")
    for name in given:
        _known(what, str(name), known)
    return {name: _check.number(f"{what}[{name!r}]", value) for name, value in given.items()}


def _known(what: str, name: str, known: Any) -> None:
    if name not in known:
        raise InputError(f"{what}: {name!r} is unknown; {did_you_mean(name, known)}")
