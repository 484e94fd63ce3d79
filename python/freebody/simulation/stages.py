"""Runs in stages: where one ends the body is exchanged, and the motion goes on."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.errors import InputError
from freebody.simulation.inputs import InputTable
from freebody.simulation.outcome import told
from freebody.simulation.settings import checked_settings
from freebody.simulation.staged import Separation, StagedTrajectory
from freebody.simulation.trajectory import Trajectory
from freebody.tracing import EventLaw, OutputLaw

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Stage", "simulate_stages"]

_NONE = (0.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Stage:
    """A part of a run with a body of its own.

    Attributes
    ----------
    model
        What moves in this stage.
    until
        What ends it: a terminal event, which may read what this model has, or a time, s, on the clock of the
        run. Without it the stage lasts to the end of the run, as only the last one may.
    origin, rotation
        Where the frame of this body sits in that of the body before: its origin in the old axes, (3,) m, and
        the old axes from the new ones, (3, 3). The same frame when omitted.
    velocity_increment, angular_velocity_increment
        What the separation gives this body, (3,) m/s at its origin and rad/s, in its body axes.
    states
        Auxiliary states at its start, by name. Others go on if the stage before has them, by the same name,
        and else have the start values of their laws.
    inputs, events, outputs
        Of `Model.simulate`, in this stage. A terminal event among these ends the whole run.
    """

    model: Model
    until: EventLaw | float | None = None
    origin: ArrayLike = _NONE
    rotation: ArrayLike | None = None
    velocity_increment: ArrayLike = _NONE
    angular_velocity_increment: ArrayLike = _NONE
    states: Mapping[str, float] = field(default_factory=dict)
    inputs: ArrayLike | InputTable | None = None
    events: Iterable[EventLaw] = ()
    outputs: Iterable[OutputLaw] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.model, _core.Model):
            raise InputError(f"model: got {_check.shown(self.model)}; give a freebody.Model")
        if isinstance(self.until, EventLaw):
            if not self.until.terminal:
                raise InputError(
                    f"until: {self.until.name!r} is an event that ends nothing; give terminal=True"
                )
        elif self.until is not None:
            object.__setattr__(self, "until", _check.number("until", self.until))
        for name in ("origin", "velocity_increment", "angular_velocity_increment"):
            object.__setattr__(self, name, _check.vector(name, getattr(self, name), 3))
        turn = np.eye(3) if self.rotation is None else _check.rotation("rotation", self.rotation)
        object.__setattr__(self, "rotation", turn)
        for name, kind in (("events", EventLaw), ("outputs", OutputLaw)):
            object.__setattr__(self, name, _laws(name, getattr(self, name), kind))
        if not isinstance(self.states, Mapping):
            raise InputError(f"states: got {_check.shown(self.states)}; give values by name")

    def _separates(self) -> bool:
        """Whether it says anything of the separation at its start."""
        increments = (self.origin, self.velocity_increment, self.angular_velocity_increment)
        return any(np.any(x) for x in increments) or not np.array_equal(self.rotation, np.eye(3))  # type: ignore

    def start(self, before: Model, x: Array) -> Array:
        """The state in which this stage begins, where the one before ends in x."""
        position, quaternion, twist = (part[0] for part in before.motion(x[None]))
        world_from_old = Attitude.quaternion(quaternion).as_rotation()
        turn, origin = np.asarray(self.rotation), np.asarray(self.origin)
        velocity = turn.T @ (twist[:3] + np.cross(twist[3:], origin))
        new = self.model.auxiliary
        kept = {name: float(x[place]) for name, place in before.auxiliary.items() if name in new}
        return self.model.state(
            position + world_from_old @ origin,
            Attitude.rotation(world_from_old @ turn),
            velocity_body=velocity + self.velocity_increment,
            angular_velocity_body=turn.T @ twist[3:] + self.angular_velocity_increment,
            states=kept | dict(self.states),
        )


def simulate_stages(
    stages: Iterable[Stage],
    x0: ArrayLike,
    t_span: tuple[float, float],
    *,
    save_every: float | None = None,
    save_at: ArrayLike | None = None,
    max_steps: int = 10_000_000,
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> StagedTrajectory:
    """Simulate one stage after another: at the end of each the body is exchanged and its motion goes on.

    Position, attitude and twist of the origin go on, seen from the frame of the next body; see `Stage`. A
    stage whose time is over when it begins is left out. Ensembles run one model in all their lanes: runs in
    stages that differ are simulated one by one.

    Parameters
    ----------
    stages
        In their order.
    x0
        State of the first model at the start.
    t_span
        Start and end of the whole run, s. It ends earlier where the last stage does.
    save_every, save_at
        Of `Model.simulate`, for the whole run; starts and ends of stages are samples, too.
    max_steps
        Of all stages together.
    options
        Others of `Model.simulate`, for every stage: method, rtol, atol, step.

    Raises
    ------
    InputError
        A stage that nothing ends before the last one; times that do not rise.
    """
    checked = _checked(stages)
    given = {key: value for key, value in options.items() if key not in ("method", "rtol", "atol", "step")}
    if given:
        raise InputError(
            f"{next(iter(given))}: no option of runs in stages; inputs and events are those of a Stage"
        )
    settings = checked_settings(t_span, save=(save_every, save_at), max_steps=max_steps, **options)
    (t, t1), x = settings.span, _check.vector("x0", x0, checked[0].model.n_states)
    runs: list[Trajectory] = []
    separations: list[Separation] = []
    for number, stage in enumerate(checked):
        if number > 0:
            before = checked[number - 1].model
            after = stage.start(before, x)
            separations.append(Separation(t, number, x, after, before, stage.model))
            x = after
        end = min(t1, stage.until) if isinstance(stage.until, float) else t1
        if not t < end:
            continue
        own = (stage.until,) if isinstance(stage.until, EventLaw) else ()
        run = stage.model.simulate(
            x,
            (t, end),
            save_at=_times(settings.times, t, end),
            inputs=stage.inputs,
            events=(*own, *stage.events),
            outputs=stage.outputs,
            max_steps=max(1, max_steps - sum(r.steps + r.rejected_steps for r in runs)),
            progress=_told(progress, (t, end), settings.span),
            **options,
        )
        _close(run, stage)
        runs.append(run)
        t, x = run.outcome.time, run.outcome.state
        by_event = own and run.outcome.event == own[0].name
        by_time = run.outcome.status == "reached_end" and end < t1
        if not (by_event or by_time):
            break
    if not runs:
        raise InputError(f"t_span: begins at {t} s, where all stages have ended")
    where = f"stage {len(separations) + 1} of {len(checked)} ({checked[len(separations)].model.name!r}): "
    notices = tuple(notice for run in runs for notice in run.outcome.notices)
    last = runs[-1].outcome
    ending = last.message.removesuffix(told(last.notices))
    outcome = replace(last, message=where + ending + told(notices), notices=notices)
    return StagedTrajectory(tuple(runs), tuple(separations), outcome)


def _laws(name: str, given: Any, kind: type) -> tuple[Any, ...]:
    found = tuple(given) if isinstance(given, Iterable) else (given,)
    for law in found:
        if not isinstance(law, kind):
            one = name.removesuffix("s")
            raise InputError(f"{name}: got {_check.shown(law)}; give a list of {name} made by @fb.{one}")
    return found


def _checked(stages: Iterable[Stage]) -> tuple[Stage, ...]:
    found = tuple(stages)
    if not found or not all(isinstance(stage, Stage) for stage in found):
        raise InputError(
            f"stages: got {_check.shown(stages)}; give a list of freebody.Stage(model, until=...)"
        )
    if found[0]._separates() or found[0].states:
        raise InputError(
            "stages[0]: a frame, an increment or states belong to a separation, and none is before the first "
            "stage; say them in x0"
        )
    for i, stage in enumerate(found[:-1]):
        if stage.until is None:
            raise InputError(f"stages[{i}]: nothing ends it; give until=, a terminal event or a time")
    times = [stage.until for stage in found if isinstance(stage.until, float)]
    if any(b <= a for a, b in pairwise(times)):
        raise InputError(f"stages: end at {times} s; times must rise")
    return found


def _times(wanted: Array | None, t0: float, t1: float) -> Array | None:
    """The samples of a stage: its ends, and what is wanted between them."""
    if wanted is None:
        return None
    return np.concatenate([[t0], wanted[(wanted > t0) & (wanted < t1)], [t1]])


def _close(run: Trajectory, stage: Stage) -> None:
    """Add the end as a sample where an event made it."""
    outcome = run.outcome
    if outcome.status == "event" and run.t[-1] < outcome.time:
        at = [outcome.time]
        u = stage.inputs.at(at) if isinstance(stage.inputs, InputTable) else run.u[-1:]
        run.t, run.x, run.u = np.append(run.t, at), np.vstack([run.x, outcome.state]), np.vstack([run.u, u])


def _told(
    progress: Callable[[float], object] | None, own: tuple[float, float], whole: tuple[float, float]
) -> Callable[[float], object] | None:
    if progress is None:
        return None
    (a, b), (t0, t1) = own, whole
    return lambda part: progress((a + part * (b - a) - t0) / (t1 - t0))
