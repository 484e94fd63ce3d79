"""How a run ended, and what happened on its way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from freebody._check import Array

__all__ = ["GOOD_ENDS", "OUTCOMES", "ChartChange", "Conserved", "Notice", "Outcome", "told"]

Status = Literal["reached_end", "event", "step_too_small", "step_limit", "non_finite", "step_too_large"]

OUTCOMES: tuple[str, ...] = (*get_args(Status), "not_run")
"""How a run can end, by the codes of ensembles; the last one stands for what is not done yet."""

GOOD_ENDS = OUTCOMES[:2]
"""Those of runs that reached their end, or an event that ends them: the first ones."""


@dataclass(frozen=True)
class Notice:
    """What a run must say: a table was left, a tank ran dry.

    Attributes
    ----------
    time
        From when on, s.
    law
        The name of the force that says it.
    message
        What is the matter, and what holds instead.
    from_start
        Whether it was so from the start.
    """

    time: float
    law: str
    message: str
    from_start: bool = False


def told(notices: tuple[Notice, ...]) -> str:
    """Notices as a part of a sentence, each once."""
    text = ""
    for notice in {n.message: n for n in reversed(notices)}.values():
        often = sum(n.message == notice.message for n in notices)
        when = "from the start" if notice.from_start else f"from {notice.time:.6g} s on"
        text = f"; {when}: {notice.message}" + (f" ({often} times)" if often > 1 else "") + text
    return text


@dataclass(frozen=True)
class Outcome:
    """How a run ended.

    Attributes
    ----------
    status
        "reached_end"; "event": a terminal event came to pass; "step_too_small": no step meets the tolerance;
        "step_too_large": the iteration of gauss6 does not converge; "step_limit": max_steps were done;
        "non_finite": the derivative is not a number.
    time, state
        The last ones that the run reached.
    message
        The same in a sentence, with what to change.
    force
        The name of the force or the control law that was not finite, if one was.
    event
        The name of the event that ended the run, if one did.
    notices
        What the forces have to say, in the order of the times; the message says it too.
    """

    status: Status
    time: float
    state: Array
    message: str
    force: str | None = None
    event: str | None = None
    notices: tuple[Notice, ...] = ()

    @property
    def ok(self) -> bool:
        """Whether the run reached its end, or an event that ends it."""
        return self.status in GOOD_ENDS


@dataclass(frozen=True)
class ChartChange:
    """A run in angles went on in another chart.

    Attributes
    ----------
    time
        When, s.
    from_chart, to_chart
        "quaternion" or an angle sequence.
    distance
        Of the angles asked for to their singularity, rad.
    """

    time: float
    from_chart: str
    to_chart: str
    distance: float


@dataclass(frozen=True)
class Conserved:
    """A quantity that a model keeps.

    Attributes
    ----------
    name, unit
        Which one.
    reference
        Its size, to which the drift relates.
    history
        Deviation from the value at the start at each sample, relative to the reference, (n,).
    """

    name: str
    unit: str
    reference: float
    history: Array

    @property
    def drift(self) -> float:
        """The largest deviation from the value at the start, relative to the reference."""
        return float(self.history.max())
