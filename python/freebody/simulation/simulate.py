"""From a model and a start to a trajectory."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody.errors import InputError
from freebody.simulation.inputs import InputTable, core_table
from freebody.simulation.settings import Method, checked_settings
from freebody.simulation.trajectory import Trajectory
from freebody.simulation.watching import watched
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
    """Simulate from a state.

    A run in angles that comes near their singularity goes on in quaternions and comes back; its samples
    stay in the angles asked for.

    Parameters
    ----------
    x0
        State at the start, (n_states,); see `state`.
    t_span
        Start and end, s.
    method
        "dop853", "dp54": Dormand-Prince 8(5,3) and 5(4), adaptive. "rk4": classical, fixed step. (Hairer,
        Nørsett, Wanner, Solving ODEs I, 2nd ed., II.1, II.5.) "vern8", "vern9": fewer evaluations,
        adaptive (Verner, Numer. Algorithms 53, 2010). "rodas5p": for stiff forces, adaptive
        (Steinebach, BIT 63, 2023). "gauss6": fixed step, keeps the energy of free motion (Hairer, Lubich,
        Wanner, Geometric Numerical Integration, 2nd ed., IV.2).
    rtol, atol
        Error allowed to one step: of each vector of the state (position, velocity, ...) atol + rtol times
        its length, of the orientation rtol rad. atol is 1e-3 rtol when omitted, in SI units.
    step
        The fixed step of rk4 and gauss6, s; the first step of the others, which otherwise choose one.
    save_every, save_at
        Samples every so many s and at the end, or at given times (n,); every step when both are omitted.
    inputs
        Constant inputs (n_inputs,), or an `InputTable`; zero when omitted.
    max_steps
        Stop after so many steps, accepted and rejected.
    progress
        Called now and then with the part done, 0 to 1.
    events, outputs
        Made by `freebody.event` and `freebody.output`; see the trajectory's `events` and `outputs`.

    Returns
    -------
    Trajectory
        Whatever happens: how the run ended is its `outcome`.
    """
    settings = checked_settings(
        t_span, method, rtol=rtol, atol=atol, step=step, save=(save_every, save_at), max_steps=max_steps
    )
    if progress is not None and not callable(progress):
        raise InputError(f"progress: got {_check.shown(progress)}; give a function of the part done")
    watch = watched(model, events, outputs)
    table = None
    if isinstance(inputs, InputTable):
        inputs.check_width(model.n_inputs)
        inputs, table = None, inputs
    given = None if table is None else core_table(table)
    at_start: list[float] = []
    if watch.notices:
        t0, _ = settings.span
        still = settings._replace(span=(t0, t0), times=None)
        at_start = _core.simulate(model, x0, still, inputs, given, None, [], watch.core_notices).outputs

    result = _core.simulate(
        model, x0, settings, inputs, given, progress, watch.core_events, watch.core_outputs
    )
    run = Trajectory(model, result, settings.span, watch, at_start)
    if save_every is not None and result.status == "event" and run.t[-1] < result.end_time:
        run.t, run.x = np.append(run.t, result.end_time), np.vstack([run.x, result.end_state])
    if table is not None:
        run.u = table.at(run.t) if len(run) else table.values[:0]
    return run
