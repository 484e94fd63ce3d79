"""Tables for people: what a model is, and how a run went."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike
from rich.table import Table
from rich.text import Text

from freebody.ensembles import Runs
from freebody.model import Model
from freebody.simulation import GOOD_ENDS, OUTCOMES, Stage, StagedTrajectory, Trajectory, stages_of
from freebody.tracing import EventLaw

__all__ = ["describe_model", "ensemble_summary", "summary"]


# A tumbling body may change its chart a hundred times, a bouncing one pass a height.
_CHANGES_TOLD = _EVENTS_TOLD = 6


def describe_model(
    model: Model,
    t_span: tuple[float, float],
    *,
    stages: Sequence[Stage] = (),
    events: Iterable[EventLaw] = (),
) -> Table:
    """Body, forces, state and time span of a model, or of all stages of a run; what it watches."""
    table = _two_columns()
    before = None
    for number, stage in enumerate(stages, 1):
        begins = "from the start"
        if before is not None:
            until = before.until
            begins = f"from {_time(until)} on" if isinstance(until, float) else f"when {_name(until)}"
        before = stage
        table.add_row(f"stage {number}", Text(f"{stage.model.name}, {begins}", style="bold"))
        _describe(table, stage.model)
    if not stages:
        _describe(table, model)
    watched = {law.name: law for stage in stages for law in stage.events} | {law.name: law for law in events}
    for i, law in enumerate(watched.values()):
        table.add_row("" if i else "events", law.name + (", ends the run" if law.terminal else ""))
    table.add_row("time", f"{_time(t_span[0])} to {_time(t_span[1])}")
    return table


def _name(until: EventLaw | float | None) -> str:
    return until.name if isinstance(until, EventLaw) else ""


def _describe(table: Table, model: Model) -> None:
    body = model.body
    table.add_row("body", f"{body.name}: {body.mass:.6g} kg, mass centre {_vector(body.com)} m")
    table.add_row("", f"principal moments {_vector(body.principal_moments)} kg m² about the mass centre")
    for i, force in enumerate(model.forces):
        table.add_row("" if i else "forces", f"{force.name} ({type(force).__name__})")
    if model.control is not None:
        commanded = ", ".join(model.command_names)
        table.add_row(
            "control", f"{model.control.name} ({type(model.control).__name__}) commands {commanded}"
        )
    table.add_row(
        "state", f"{len(model.state_names)} numbers: {model.attitude}, {model.form.replace('_', ' ')}"
    )


def summary(run: Trajectory | StagedTrajectory) -> Table:
    """How a run ended, what it kept, what it cost."""
    table = _two_columns()
    ending = Text(run.outcome.message, style="green" if run.ok else "bold red")
    table.add_row("outcome", ending)
    table.add_row(
        "samples", f"{len(run)}" + (f", {_time(run.t[0])} to {_time(run.t[-1])}" if len(run) else "")
    )
    if isinstance(run, StagedTrajectory):
        _say_stages(table, run)
    for event in run.events[:_EVENTS_TOLD]:
        table.add_row("event", f"{event.name} at {_time(event.time)}")
    if len(run.events) > _EVENTS_TOLD:
        table.add_row("", f"and {len(run.events) - _EVENTS_TOLD} more; all are in the data")
    if len(run):
        rates = np.rad2deg(np.linalg.norm(run.angular_velocity_body, axis=1))
        table.add_row("rates", f"|ω| {rates.min():.6g} to {rates.max():.6g} deg/s")
    for stage in stages_of(run):
        _say_kept(table, stage)
    for change in run.chart_changes[:_CHANGES_TOLD]:
        table.add_row("chart change", f"{change.from_chart} to {change.to_chart} at {_time(change.time)}")
    if len(run.chart_changes) > _CHANGES_TOLD:
        table.add_row("", f"and {len(run.chart_changes) - _CHANGES_TOLD} more; all are in the data")
    table.add_row("work", f"{run.steps} steps, {run.rejected_steps} rejected, {run.evaluations} evaluations")
    table.add_row("wall time", f"{run.wall_time:.3g} s")
    return table


def _say_stages(table: Table, run: StagedTrajectory) -> None:
    for number, stage in enumerate(run.stages, 1):
        speed = np.linalg.norm(stage.com_velocity_world, axis=1)
        table.add_row(
            f"stage {number}",
            f"{stage.model.name}: {_time(stage.t[0])} to {_time(stage.t[-1])}, {stage.mass[0]:.6g} to "
            f"{stage.mass[-1]:.6g} kg, {speed[0]:.6g} to {speed[-1]:.6g} m/s",
        )
    for separation in run.separations:
        model, x = separation.model_after, separation.after
        position, _, twist = (part[0] for part in model.motion(x[None]))
        table.add_row(
            "separation",
            f"of {model.name} at {_time(separation.time)}: origin at {_vector(position)} m, in its axes with "
            f"{_vector(twist[:3])} m/s and {_vector(np.rad2deg(twist[3:]))} deg/s",
        )


def _say_kept(table: Table, run: Trajectory) -> None:
    for kept in run.conserved():
        if kept.reference > 0.0:  # a body that rests keeps nothing of note
            table.add_row("kept", f"{kept.name}: drift {kept.drift:.1e} of {kept.reference:.6g} {kept.unit}")
    if run.singularity_distance is not None and len(run):
        nearest = np.rad2deg(np.min(run.singularity_distance))
        table.add_row("singularity", f"the angles came within {nearest:.3g} deg of it")


def ensemble_summary(runs: Runs) -> Table:
    """How the runs of an ensemble ended, how often events came."""
    table = _two_columns()
    n, counts = len(runs), np.bincount(runs.outcome, minlength=len(OUTCOMES))
    for word, count in zip(OUTCOMES, counts, strict=True):
        if count:
            style = "green" if word in GOOD_ENDS else "bold red"
            table.add_row(word.replace("_", " "), Text(f"{count} of {n} runs, {count / n:.3%}", style=style))
    for name, times in runs.event_times.items():
        came = times[np.isfinite(times)]
        span = f", first at {_time(came.min())} to {_time(came.max())}" if came.size else ""
        table.add_row(name, f"event in {came.size} of {n} runs{span}")
    for message, times in runs.notice_times.items():
        since = times[np.isfinite(times)]
        if since.size:
            table.add_row("notice", Text(f"{message}: in {since.size} of {n} runs", style="yellow"))
    return table


def _two_columns() -> Table:
    table = Table(box=None, show_header=False, pad_edge=False)
    table.add_column(style="bold", no_wrap=True, min_width=12)
    table.add_column(overflow="fold")
    return table


def _vector(values: ArrayLike) -> str:
    return "(" + ", ".join(f"{value:.6g}" for value in np.asarray(values)) + ")"


def _time(seconds: float) -> str:
    for least, scale, unit in ((172800.0, 86400.0, "day"), (7200.0, 3600.0, "h")):
        if abs(seconds) >= least:
            return f"{seconds / scale:.6g} {unit}"
    return f"{seconds:.6g} s"
