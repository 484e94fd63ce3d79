"""How the core tells that a run ended, and what happened on its way, in words."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from freebody import _core
from freebody.simulation.outcome import ChartChange, Outcome, Status, told
from freebody.simulation.watching import Watched

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["chart_changes_of", "outcome_of"]


def chart_changes_of(model: Model, result: _core.RunResult) -> tuple[ChartChange, ...]:
    """When a run in angles went on in another chart, and when it came back."""
    return tuple(_change(model.attitude, *change) for change in result.chart_changes)


def _change(attitude: str, when: float, left: bool, distance: float) -> ChartChange:
    charts = (attitude, "quaternion") if left else ("quaternion", attitude)
    return ChartChange(when, *charts, distance)


def outcome_of(
    model: Model, result: _core.RunResult, span: tuple[float, float], watch: Watched, at_start: list[float]
) -> Outcome:
    """How a run ended; `at_start` has the values of the notices at its start."""
    outcome = _without_notices(model, result, span, watch)
    notices = watch.told(span[0], at_start, result)
    if not notices:
        return outcome
    return replace(outcome, message=outcome.message + told(notices), notices=notices)


def _without_notices(
    model: Model, result: _core.RunResult, span: tuple[float, float], watch: Watched
) -> Outcome:
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
