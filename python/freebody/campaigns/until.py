"""A campaign that ends as soon as its results are known well enough."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any

import xarray as xr

from freebody import statistics
from freebody.ensembles import Ensemble
from freebody.errors import InputError

from .identity import OPEN_ENDED
from .store import Store

if TYPE_CHECKING:
    from .stored_runs import StoredRuns

__all__ = ["campaign_until"]


def campaign_until(
    ensemble: Ensemble,
    precisions: statistics.Precision | Sequence[statistics.Precision],
    path: str | PathLike[str],
    t_span: tuple[float, float],
    *,
    start: int = 1000,
    growth: float = 1.5,
    chunk: int | None = None,
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> tuple[StoredRuns, statistics.Stopped]:
    """Runs of an ensemble into a store, until every precision is met or all of them are made.

    It looks at the first `start` runs, then at `growth` times as many, and so on, in whole chunks of the
    store: `chunk` runs, or `start` where a new store is made without. So it stops at the same run on one
    thread, on a cluster, and after any interruption; what a larger campaign has stored before is kept, and
    not looked at. `progress` is called with the part of all runs that is done; `options` are those of
    `Ensemble.campaign`.

    Returns
    -------
    The runs stored, and what was seen on the way.

    Raises
    ------
    InputError
        The sampling is one whose first points depend on how many follow.
    """
    if ensemble.sampling not in OPEN_ENDED:
        raise InputError(
            f"sampling: got {ensemble.sampling!r}, whose first runs depend on how many follow; to stop when "
            f"enough are made, use {' or '.join(map(repr, OPEN_ENDED))}"
        )
    there = Store(path).attributes() or {"n": 0, "chunk": chunk or start}
    stored: StoredRuns | None = None

    def ensure(runs: int) -> xr.Dataset:
        nonlocal stored
        wanted = _first(ensemble, max(runs, there["n"]))
        part = wanted.n / ensemble.n
        told = None if progress is None else lambda done, tell=progress: tell(part * done)
        stored = wanted.campaign(path, t_span, chunk=chunk or there["chunk"], progress=told, **options)
        return stored.to_xarray()

    stopped = statistics.run_until(
        ensure, precisions, start=start, limit=ensemble.n, growth=growth, multiple=there["chunk"]
    )
    assert stored is not None  # there is at least one look
    return stored, stopped


def _first(ensemble: Ensemble, n: int) -> Ensemble:
    """An ensemble of the same runs, but so many."""
    constants, table = ensemble.nominal_inputs
    return Ensemble(
        ensemble.base,
        ensemble.x0,
        ensemble.dispersions,
        n,
        ensemble.seed,
        ensemble.sampling,
        constants if table is None else table,
        ensemble.events,
        ensemble.outputs,
    )
