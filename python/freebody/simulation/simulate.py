"""From a model and a start to a trajectory."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody.errors import InputError
from freebody.simulation.inputs import InputTable, checked_inputs, core_table
from freebody.simulation.outcome import ChartChange, Notice, Outcome, Status, told
from freebody.simulation.settings import Method, checked_settings
from freebody.simulation.trajectory import Trajectory
from freebody.simulation.watching import Watched, watched
from freebody.tracing import EventLaw, OutputLaw

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["simulate"]


def simulate(
    model: Model,
    x0: ArrayLike,
    t_span: tuple[float, float],
    *,
    method: Method = "dop853",
    rtol: float = 1e-9,
    atol: float | None = None,
    step: float | None = None,
    save_every: float | None = None,
    save_at: ArrayLike | None = None,
    inputs: ArrayLike | InputTable | None = None,
    max_steps: int = 10_000_000,
    progress: Callable[[float], object] | None = None,
    events: Iterable[EventLaw] = (),
    outputs: Iterable[OutputLaw] = (),
) -> Trajectory:
    """Simulate a model; see `Model.simulate`."""
    start = _check.vector("x0", x0, model.n_states)
    settings = checked_settings(
        t_span, method, rtol=rtol, atol=atol, step=step, save=(save_every, save_at), max_steps=max_steps
    )
    if progress is not None and not callable(progress):
        raise InputError(f"progress: got {_check.shown(progress)}; give a function of the part done")
    watch = watched(model, events, outputs)
    constant, table = checked_inputs(inputs, model.n_inputs)

    options: dict[str, Any] = {
        "constant": constant,
        "table": None if table is None else core_table(table),
        "method": settings.method,
        "tolerance": settings.tolerance,
        "step": settings.step,
        "max_steps": settings.max_steps,
    }
    at_start: list[float] = []
    if watch.notices:
        still = (settings.span[0], settings.span[0])
        nothing = {"save_at": None, "progress": None, "events": []}
        at_start = _core.simulate(
            model, start, still, **options, **nothing, outputs=watch.core_notices
        ).outputs

    began = time.perf_counter()
    result = _core.simulate(
        model,
        start,
        settings.span,
        **options,
        save_at=settings.times,
        progress=progress,
        events=watch.core_events,
        outputs=watch.core_outputs,
    )
    wall_time = time.perf_counter() - began
    t, x = result.samples()
    if save_every is not None and result.status == "event" and t[-1] < result.end_time:
        t, x = np.append(t, result.end_time), np.vstack([x, result.end_state])
    if table is None:
        u = np.repeat(constant[None], len(t), axis=0)
    else:
        u = table.at(t) if len(t) else table.values[:0]
    changes = tuple(_change(model.attitude, *change) for change in result.chart_changes)
    return Trajectory(
        model,
        (t, x, u),
        _with_notices(
            _outcome(model, result, settings.span, watch), watch.told(settings.span[0], at_start, result)
        ),
        changes,
        result.counts,
        wall_time,
        watch.occurrences(result),
        watch.values(result),
    )


def _change(attitude: str, when: float, left: bool, distance: float) -> ChartChange:
    charts = (attitude, "quaternion") if left else ("quaternion", attitude)
    return ChartChange(when, *charts, distance)


def _with_notices(outcome: Outcome, notices: tuple[Notice, ...]) -> Outcome:
    if not notices:
        return outcome
    return replace(outcome, message=outcome.message + told(notices), notices=notices)


def _outcome(model: Model, result: _core.RunResult, span: tuple[float, float], watch: Watched) -> Outcome:
    status: Status = result.status  # type: ignore[assignment]
    t = result.end_time
    if status == "reached_end":
        return Outcome(status, t, result.end_state, f"reached the end at t = {t:g} s")
    law = None if result.force is None else model.acting_names[result.force]
    is_control = model.control is not None and result.force == len(model.acting_names) - 1
    event = None if result.event is None else watch.events[result.event].name
    where = f"at t = {t:.9g} of {span[1]:g} s"
    message = {
        "event": f"ended by the event '{event}' {where}",
        "step_too_small": f"the step became too small {where}; loosen rtol or atol, or look for a force that "
        "jumps there",
        "step_too_large": f"the iteration of gauss6 does not converge {where}; make the step smaller, or "
        "take rodas5p if a force is stiff",
        "step_limit": f"stopped by max_steps {where}; raise max_steps or loosen rtol",
        "non_finite": f"the derivative is not finite {where}; "
        + (
            f"{'control law' if is_control else 'force'} '{law}' made it so"
            if law
            else "the motion grew beyond all numbers"
        ),
    }[status]
    return Outcome(status, t, result.end_state, message, law, event)
