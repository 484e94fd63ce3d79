"""How the medium meets a point of the body, along a run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.environment.atmosphere import Air
from freebody.errors import InputError
from freebody.tracing.declaration import declared
from freebody.tracing.law import Output, traced
from freebody.tracing.scalar import as_scalar
from freebody.tracing.situation import LAYOUT

if TYPE_CHECKING:
    from freebody.environment.environment import Environment
    from freebody.simulation import Trajectory

__all__ = ["FlowAlong", "flow_along"]


class FlowAlong:
    """The flow at n samples.

    Attributes
    ----------
    velocity_body, angular_velocity_body
        Of the body relative to the medium at the point, body axes, (n, 3) m/s and rad/s.
    air
        The state of the medium there, (n,) each.
    """

    def __init__(self, columns: Array) -> None:
        self.velocity_body, self.angular_velocity_body = columns[:, :3], columns[:, 3:6]
        self.air = Air(*columns[:, 6:].T)

    @property
    def airspeed(self) -> Array:
        """(n,) m/s."""
        return np.linalg.norm(self.velocity_body, axis=-1)

    @property
    def angle_of_attack(self) -> Array:
        """arctan(w/u), (n,) rad in (-π, π]; 0 at rest."""
        return np.arctan2(self.velocity_body[:, 2], self.velocity_body[:, 0])

    @property
    def sideslip(self) -> Array:
        """arcsin(v/V), (n,) rad; 0 at rest."""
        u, v, w = self.velocity_body.T
        return np.arctan2(v, np.hypot(u, w))

    @property
    def mach(self) -> Array:
        """(n,)."""
        return self.airspeed / self.air.speed_of_sound

    @property
    def dynamic_pressure(self) -> Array:
        """(n,) Pa."""
        return 0.5 * self.air.density * self.airspeed**2


def flow_along(environment: Environment, run: Trajectory, point: Array) -> FlowAlong:
    """The flow of the environment at a material point, body axes from the origin, (3,) m."""

    def flow(s: Any, p: Any) -> Any:
        here = environment.flow(s, p, at=point)
        return [*here.velocity, *here.angular_velocity, *here.air]

    what = declared("flow", environment.parameters, environment.inputs, None)
    program, _ = traced("flow", flow, what, lambda given: Output([as_scalar(x) for x in given]))
    motion = {
        "time": run.t,
        "position_world": run.position_world,
        "world_from_body": run.world_from_body,
        "twist": np.concatenate([run.velocity_body, run.angular_velocity_body], axis=1),
    }
    n = len(run.t)
    # The flow depends on the motion alone, not on masses.
    columns = [motion.get(name, np.zeros((n, *shape))).reshape(n, -1) for name, shape, _ in LAYOUT]
    columns += [_signal(run, quantity.name)[:, None] for quantity in what.inputs]
    given = np.ascontiguousarray(np.concatenate(columns, axis=1))
    return FlowAlong(program.run([p.value for p in what.parameters], given))


def _signal(run: Trajectory, name: str) -> Array:
    """What laws read as the input `name`: of u, of the control law, or a state that another law publishes."""
    if name in run.model.input_names:
        return run.u[:, run.model.input_names.index(name)]
    if name in run.model.command_names:
        return run.commands[name]
    for state, values in run.states.items():
        if state.rpartition(".")[2] == name:
            return values
    raise InputError(f"environment: it reads {_check.shown(name)}, which the model of this run does not have")
