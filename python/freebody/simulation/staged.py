"""What came of a run in stages."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from freebody._check import Array
from freebody.simulation.outcome import ChartChange, Outcome
from freebody.simulation.trajectory import Trajectory
from freebody.simulation.watching import Occurrence

if TYPE_CHECKING:
    import xarray

    from freebody.model import Model

__all__ = ["Separation", "StagedTrajectory", "stages_of"]


def stages_of(run: Trajectory | StagedTrajectory) -> tuple[Trajectory, ...]:
    """The stages of a run; a run in one body is its only one."""
    return run.stages if isinstance(run, StagedTrajectory) else (run,)


@dataclass(frozen=True)
class Separation:
    """Where one stage ended and the next began.

    Attributes
    ----------
    time
        s.
    stage
        The number of the stage that begins, from 0.
    before, after
        The last state of the model before, and the first one of the model that goes on.
    model_before, model_after
        These models.
    """

    time: float
    stage: int
    before: Array
    after: Array
    model_before: Model
    model_after: Model


class StagedTrajectory:
    """The stages of a run. What it has of a `Trajectory` is that of its stages, one after another.

    At a separation a time stands twice: before it and after it. Where stages have frames of their own,
    origin and axes are those of the stage.

    Attributes
    ----------
    stages
        The trajectories of the stages that were run.
    separations
        Where the body was exchanged.
    outcome
        How the run ended; `event`, where one ended the last stage or the whole run.
    """

    def __init__(
        self, stages: tuple[Trajectory, ...], separations: tuple[Separation, ...], outcome: Outcome
    ) -> None:
        self.stages, self.separations, self.outcome = stages, separations, outcome

    @property
    def ok(self) -> bool:
        """Whether the run reached its end, or an event that ends it."""
        return self.outcome.ok

    @property
    def events(self) -> tuple[Occurrence, ...]:
        """The events of all stages, those that ended them too, in the order of their times."""
        return tuple(event for stage in self.stages for event in stage.events)

    @property
    def steps(self) -> int:
        """Accepted steps of all stages."""
        return sum(stage.steps for stage in self.stages)

    @property
    def rejected_steps(self) -> int:
        """Rejected steps of all stages."""
        return sum(stage.rejected_steps for stage in self.stages)

    @property
    def evaluations(self) -> int:
        """Evaluations of the derivatives of all stages."""
        return sum(stage.evaluations for stage in self.stages)

    @property
    def wall_time(self) -> float:
        """Of all stages, s."""
        return sum(stage.wall_time for stage in self.stages)

    @property
    def chart_changes(self) -> tuple[ChartChange, ...]:
        """When a stage in angles went on in another chart, and when it came back."""
        return tuple(change for stage in self.stages for change in stage.chart_changes)

    def joined(self, name: str) -> Array:
        """Any array of the trajectories by its name, of all stages one after another."""
        return np.concatenate([getattr(stage, name) for stage in self.stages])

    @property
    def t(self) -> Array:
        """Times, (n,) s."""
        return self.joined("t")

    @property
    def position_world(self) -> Array:
        """Position of the body origin, world axes, (n, 3) m."""
        return self.joined("position_world")

    @property
    def quaternion(self) -> Array:
        """Attitude as unit quaternions (w, x, y, z), world from body, (n, 4); in stages of one frame
        continuous in sign.
        """
        parts: list[Array] = []
        for stage in self.stages:
            part = stage.quaternion
            turned = len(part) and parts and len(parts[-1]) and part[0] @ parts[-1][-1] < 0.0
            parts.append(-part if turned else part)
        return np.concatenate(parts)

    @property
    def world_from_body(self) -> Array:
        """Attitude as rotation matrices, (n, 3, 3)."""
        return self.joined("world_from_body")

    @property
    def velocity_body(self) -> Array:
        """Velocity of the body origin, body axes, (n, 3) m/s."""
        return self.joined("velocity_body")

    @property
    def velocity_world(self) -> Array:
        """Velocity of the body origin, world axes, (n, 3) m/s."""
        return self.joined("velocity_world")

    @property
    def angular_velocity_body(self) -> Array:
        """Angular velocity, body axes, (n, 3) rad/s."""
        return self.joined("angular_velocity_body")

    @property
    def angular_velocity_world(self) -> Array:
        """Angular velocity, world axes, (n, 3) rad/s."""
        return self.joined("angular_velocity_world")

    @property
    def com_position_world(self) -> Array:
        """Position of the mass centre, world axes, (n, 3) m."""
        return self.joined("com_position_world")

    @property
    def com_velocity_world(self) -> Array:
        """Velocity of the material point at the mass centre, world axes, (n, 3) m/s."""
        return self.joined("com_velocity_world")

    @property
    def kinetic_energy(self) -> Array:
        """(n,) J."""
        return self.joined("kinetic_energy")

    @property
    def potential_energy(self) -> Array:
        """Of the forces that have one, (n,) J."""
        return self.joined("potential_energy")

    @property
    def energy(self) -> Array:
        """Kinetic plus potential, (n,) J."""
        return self.joined("energy")

    def angles(self, sequence: str | None = None) -> Array:
        """Attitude as angles of a sequence, (n, 3) rad; see `Trajectory.angles`."""
        return np.concatenate([stage.angles(sequence) for stage in self.stages])

    def point(self, at: ArrayLike) -> Array:
        """Path of the point `at` of each stage, its body axes, world axes, (n, 3) m."""
        return np.concatenate([stage.point(at) for stage in self.stages])

    def to_xarray(self) -> xarray.Dataset:
        """The stages as one labelled dataset with units (extra `data`)."""
        from freebody.results import to_dataset  # noqa: PLC0415  (an extra: only who asks needs xarray)

        return to_dataset(self)

    @property
    def mass(self) -> Array:
        """Of the body with what it carries, (n,) kg."""
        return self.joined("mass")

    def __len__(self) -> int:
        return sum(len(stage) for stage in self.stages)

    def __repr__(self) -> str:
        names = ", ".join(repr(stage.model.name) for stage in self.stages)
        return f"<StagedTrajectory of {names}: {len(self)} samples, {self.outcome.status}>"
