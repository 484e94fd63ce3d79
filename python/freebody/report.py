"""Tables for people: what a model is, and how a run went."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from rich.table import Table
from rich.text import Text

from freebody.ensembles import Runs
from freebody.model import Model
from freebody.simulation import GOOD_ENDS, OUTCOMES, Trajectory

__all__ = ["describe_model", "ensemble_summary", "summary"]


# A tumbling body may change its chart a hundred times.
_CHANGES_TOLD = 6


def describe_model(model: Model, t_span: tuple[float, float]) -> Table:
    """Body, forces, state and time span of a model."""
    table = _two_columns()
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
    table.add_row("time", f"{_time(t_span[0])} to {_time(t_span[1])}")
    return table


def summary(run: Trajectory) -> Table:
    """How a run ended, what it kept, what it cost."""
    table = _two_columns()
    ending = Text(run.outcome.message, style="green" if run.ok else "bold red")
    table.add_row("outcome", ending)
    table.add_row(
        "samples", f"{len(run)}" + (f", {_time(run.t[0])} to {_time(run.t[-1])}" if len(run) else "")
    )
    if len(run):
        rates = np.rad2deg(np.linalg.norm(run.angular_velocity_body, axis=1))
        table.add_row("rates", f"|ω| {rates.min():.6g} to {rates.max():.6g} deg/s")
    for kept in run.conserved():
        if kept.reference > 0.0:  # a body that rests keeps nothing of note
            table.add_row("kept", f"{kept.name}: drift {kept.drift:.1e} of {kept.reference:.6g} {kept.unit}")
    if run.singularity_distance is not None and len(run):
        nearest = np.rad2deg(np.min(run.singularity_distance))
        table.add_row("singularity", f"the angles came within {nearest:.3g} deg of it")
    for change in run.chart_changes[:_CHANGES_TOLD]:
        table.add_row("chart change", f"{change.from_chart} to {change.to_chart} at {_time(change.time)}")
    if len(run.chart_changes) > _CHANGES_TOLD:
        table.add_row("", f"and {len(run.chart_changes) - _CHANGES_TOLD} more; all are in the data")
    table.add_row("work", f"{run.steps} steps, {run.rejected_steps} rejected, {run.evaluations} evaluations")
    table.add_row("wall time", f"{run.wall_time:.3g} s")
    return table


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
