"""From a model and a start to a trajectory."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import InputError
from freebody.simulation.inputs import InputTable, constant_inputs
from freebody.simulation.outcome import ChartChange, Outcome, Status
from freebody.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Method", "simulate"]

Method = Literal["dop853", "dp54", "rk4"]

# Below this no step can be judged by its error in double precision.
_LEAST_RTOL = 1e-14


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
) -> Trajectory:
    """Simulate a model; see `Model.simulate`."""
    start = _check.vector("x0", x0, model.n_states)
    span = _span(t_span)
    _check.choice("method", method, ("dop853", "dp54", "rk4"))
    tolerance = _tolerance(rtol, atol)
    if step is None and method == "rk4":
        raise InputError("step: rk4 has a fixed step; give its size in s")
    first = None if step is None else _check.number("step", step, positive=True)
    times = _sample_times(span, save_every, save_at)
    limit = _check.count("max_steps", max_steps)
    if progress is not None and not callable(progress):
        raise InputError(f"progress: got {_check.shown(progress)}; give a function of the part done")
    table = inputs if isinstance(inputs, InputTable) else None
    if table is not None and table.values.shape[1] != model.n_inputs:
        raise InputError(
            f"inputs: the table has {table.values.shape[1]} columns; the model has {model.n_inputs}"
        )
    constant = constant_inputs(None if table else inputs, model.n_inputs)  # type: ignore[arg-type]

    began = time.perf_counter()
    result = _core.simulate(
        model,
        start,
        span,
        constant=constant,
        table=None if table is None else _core_table(table),
        save_at=times,
        method=method,
        tolerance=tolerance,
        step=first,
        max_steps=limit,
        progress=progress,
    )
    wall_time = time.perf_counter() - began
    t, x = result.samples()
    u = np.tile(constant, (len(t), 1)) if table is None else table.at(t) if len(t) else table.values[:0]
    changes = tuple(_change(model.attitude, *change) for change in result.chart_changes)
    return Trajectory(model, (t, x, u), _outcome(model, result, span), changes, result.counts, wall_time)


def _span(t_span: tuple[float, float]) -> tuple[float, float]:
    t0, t1 = _check.vector("t_span", t_span, 2).tolist()
    if not t1 > t0:
        raise InputError(f"t_span: got ({t0}, {t1}) s; the end must lie after the start")
    if t1 - t0 == float("inf"):
        raise InputError(f"t_span: got ({t0}, {t1}) s; the time between them is too long for doubles")
    return t0, t1


def _tolerance(rtol: float, atol: float | None) -> tuple[float, float]:
    relative = _check.number("rtol", rtol, positive=True)
    if not _LEAST_RTOL <= relative < 1.0:
        raise InputError(f"rtol: got {rtol}; allowed is from {_LEAST_RTOL} to below 1")
    # The floor for vectors near zero: far below anything that a vector of the motion is, yet not zero.
    absolute = 1e-3 * relative if atol is None else _check.number("atol", atol)
    if absolute < 0.0:
        raise InputError(f"atol: got {atol}; allowed is 0 or more")
    return relative, max(absolute, np.finfo(float).tiny)


def _sample_times(
    span: tuple[float, float], save_every: float | None, save_at: ArrayLike | None
) -> Array | None:
    """The times of the samples; None for every step."""
    t0, t1 = span
    if save_every is not None and save_at is not None:
        raise InputError("save_every, save_at: both came; give one of them")
    if save_every is not None:
        interval = _check.number("save_every", save_every, positive=True)
        count = (t1 - t0) / interval
        if count > 1e8:
            raise InputError(f"save_every: {interval} s makes {count:.3g} samples; allowed are up to 1e8")
        times = t0 + interval * np.arange(int(count * (1.0 + 1e-12)) + 1)
        # Start and end are always samples; a last interval that differs by rounding only is no interval.
        inside = times[1:][times[1:] < t1 - 1e-9 * interval]
        times = np.concatenate([[t0], inside, [t1]])
        if (np.diff(times) <= 0.0).any():
            raise InputError(f"save_every: {interval} s is less than doubles resolve between {t0} and {t1} s")
        return times
    if save_at is None:
        return None
    times = _check.series("save_at", save_at)
    if times[0] < t0 or times[-1] > t1 or (np.diff(times) <= 0.0).any():
        raise InputError(f"save_at: the times must rise and lie within the span, {t0} to {t1} s")
    return times


def _core_table(table: InputTable) -> tuple[Array, Array, bool]:
    return table.times, np.ascontiguousarray(table.values.T), table.interpolation == "hold"


def _change(attitude: str, when: float, left: bool, distance: float) -> ChartChange:
    charts = (attitude, "quaternion") if left else ("quaternion", attitude)
    return ChartChange(when, *charts, distance)


def _outcome(model: Model, result: _core.RunResult, span: tuple[float, float]) -> Outcome:
    status: Status = result.status  # type: ignore[assignment]
    t, end = result.end_time, span[1]
    law = None if result.force is None else model.acting_names[result.force]
    is_control = model.control is not None and result.force == len(model.acting_names) - 1
    message = {
        "reached_end": f"reached the end at t = {t:g} s",
        "step_too_small": f"the step became too small at t = {t:.9g} of {end:g} s; loosen rtol or atol, or "
        "look for a force that jumps there",
        "step_limit": f"stopped by max_steps at t = {t:.9g} of {end:g} s; raise max_steps or loosen rtol",
        "non_finite": f"the derivative is not finite at t = {t:.9g} of {end:g} s; "
        + (
            f"{'control law' if is_control else 'force'} '{law}' made it so"
            if law
            else "the motion grew beyond all numbers"
        ),
    }[status]
    return Outcome(status, t, result.end_state, message, law)
