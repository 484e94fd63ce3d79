"""An ensemble of any size into a store: chunk by chunk, here or on a cluster, on after any interruption."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from os import PathLike
from typing import Any

from freebody import _check
from freebody.ensembles import Ensemble
from freebody.ensembles.layout import attributes as described
from freebody.errors import InputError, StoreError
from freebody.simulation import Settings

from .cluster import on_cluster
from .identity import check_same, fingerprints
from .layout import Layout, bytes_of_a_run
from .store import Store
from .stored_runs import StoredRuns
from .task import Task

__all__ = ["run_campaign"]

# A chunk is what an interruption costs, and what is in memory at once.
_MOST_RUNS = 10_000
_MOST_BYTES = 2**26


def run_campaign(
    ensemble: Ensemble,
    path: str | PathLike[str],
    settings: Settings,
    *,
    chunk: int | None = None,
    threads: int | None = None,
    client: Any = None,
    attributes: Mapping[str, str] | None = None,
    progress: Callable[[float], object] | None = None,
) -> StoredRuns:
    """Does what is not done yet of a campaign; see `Ensemble.campaign`."""
    if client is not None and ensemble.base.compiled:
        raise InputError("client: what fb.compile made stays on this machine; give the model it was made of")
    store = Store(path)
    n = ensemble.n
    with store.locked():
        layout = _layout(store, ensemble, settings, chunk, attributes or {})
        store.prepare(layout)
        if client is not None and threads is None:
            threads = 1  # a worker runs as many chunks at once as it has threads
        task = Task(ensemble, settings, store, layout.chunk, threads)
        pending = store.pending(n, layout.chunk)
        done = n - sum(map(task.count, pending))
        tell = _nothing if progress is None else lambda runs: progress(runs / n)
        tell(done)
        for count in (
            _here(task, pending, done, tell) if client is None else on_cluster(client, task, pending)
        ):
            done += count
            tell(done)
        store.sweep()
    return StoredRuns(ensemble, settings, store)


def _layout(
    store: Store, ensemble: Ensemble, settings: Settings, chunk: int | None, attributes: Mapping[str, str]
) -> Layout:
    """That of the store if there is one, once it is found to be of this campaign."""
    own = {**described(ensemble, settings), **attributes, **fingerprints(ensemble, settings)}
    stored = store.attributes()
    if stored is not None:
        check_same(store.path, stored, own)
        if chunk not in (None, stored["chunk"]):
            raise StoreError(f"{store.path}: has chunks of {stored['chunk']} runs; leave chunk out to go on")
        # What it says of itself stays, also where comments of a model file have been edited since.
        return Layout(ensemble, settings, stored["chunk"], stored)
    if chunk is None:
        chunk = min(_MOST_RUNS, max(1, _MOST_BYTES // bytes_of_a_run(ensemble, settings)))
    return Layout(ensemble, settings, _check.count("chunk", chunk), own)


def _here(task: Task, numbers: list[int], done: int, tell: Callable[[int], object]) -> Iterator[int]:
    for number in numbers:
        before = done
        count = task.do(number, lambda runs, before=before: tell(before + runs))
        done += count
        yield count


def _nothing(runs: int) -> None:
    pass
