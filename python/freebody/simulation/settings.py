"""How runs are integrated: what simulations and ensembles are told alike."""

from __future__ import annotations

import sys
from math import inf, isfinite
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["FIXED_STEP", "METHODS", "Method", "Settings", "checked_settings"]

Method = Literal["dop853", "vern8", "vern9", "dp54", "rk4", "rodas5p", "gauss6"]
METHODS: tuple[str, ...] = get_args(Method)
FIXED_STEP = ("rk4", "gauss6")

# Below this no step can be judged by its error in double precision.
_LEAST_RTOL = 1e-14
_LEAST_ATOL = sys.float_info.min


class Settings(NamedTuple):
    """How runs are integrated, checked; as the core takes it.

    Attributes
    ----------
    span
        Start and end, s.
    method
        Of `Model.simulate`.
    tolerance
        rtol and atol.
    step
        The fixed step, or the first one, s; None leaves it to the method.
    times
        Of samples, (n,) s; None where none are asked for.
    max_steps
        Accepted and rejected.
    """

    span: tuple[float, float]
    method: Method
    tolerance: tuple[float, float]
    step: float | None
    times: Array | None
    max_steps: int


def checked_settings(
    t_span: tuple[float, float],
    method: Method = "dop853",
    *,
    rtol: float = 1e-9,
    atol: float | None = None,
    step: float | None = None,
    save: tuple[float | None, ArrayLike | None] = (None, None),
    max_steps: int = 10_000_000,
) -> Settings:
    """Check the settings of a run; `save` are save_every and save_at."""
    span = _span(t_span)
    _check.choice("method", method, METHODS)
    tolerance = _tolerance(rtol, atol)
    if step is None and method in FIXED_STEP:
        raise InputError(f"step: {method} has a fixed step; give its size in s")
    first = None if step is None else _check.number("step", step, positive=True)
    every, at = save
    times = _sample_times(span, every, at)
    return Settings(span, method, tolerance, first, times, _check.count("max_steps", max_steps))


def _span(t_span: tuple[float, float]) -> tuple[float, float]:
    if type(t_span) is tuple and len(t_span) == 2:  # the usual case, without the questions of the others
        t0, t1 = t_span
        if type(t0) is float and type(t1) is float and t0 < t1 and isfinite(t1 - t0):
            return t_span
    t0, t1 = _check.vector("t_span", t_span, 2).tolist()
    if not t1 > t0:
        raise InputError(f"t_span: got ({t0}, {t1}) s; the end must lie after the start")
    if t1 - t0 == inf:
        raise InputError(f"t_span: got ({t0}, {t1}) s; the time between them is too long for doubles")
    return t0, t1


def _tolerance(rtol: float, atol: float | None) -> tuple[float, float]:
    if type(rtol) is float and _LEAST_RTOL <= rtol < 1.0:
        relative = rtol
    else:
        relative = _check.number("rtol", rtol, positive=True)
        if not _LEAST_RTOL <= relative < 1.0:
            raise InputError(f"rtol: got {rtol}; allowed is from {_LEAST_RTOL} to below 1")
    if type(atol) is float and _LEAST_ATOL <= atol < inf:
        return relative, atol
    # The floor for vectors near zero: far below anything that a vector of the motion is, yet not zero.
    absolute = 1e-3 * relative if atol is None else _check.number("atol", atol)
    if absolute < 0.0:
        raise InputError(f"atol: got {atol}; allowed is 0 or more")
    return relative, max(absolute, _LEAST_ATOL)


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
    times = _core.rising(save_at, t0, t1)
    if times is None:
        times = _core.rising(_check.series("save_at", save_at), t0, t1)
    if times is None:
        raise InputError(f"save_at: the times must rise and lie within the span, {t0} to {t1} s")
    return times
