"""Chunks as tasks of a Dask cluster (extra `cluster`)."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from freebody.errors import InputError, StoreError

from .task import Task

__all__ = ["connected", "on_cluster"]

# Of a chunk whose worker could not reach the store; chunks of lost workers are given to others besides.
_RETRIES = 3


def on_cluster(client: Any, task: Task, numbers: list[int]) -> Iterator[int]:
    """Does the chunks on the workers of a client; yields how many runs each one had, in any order.

    Workers write what they compute themselves: only these counts come back.
    """
    from distributed import KilledWorker, as_completed  # noqa: PLC0415

    # A result of its own, so that the scheduler holds the ensemble once and gives it to new workers, too.
    common = client.submit(_itself, task, pure=False)
    futures = client.map(_do, numbers, task=common, pure=False, retries=_RETRIES)
    try:
        for _, count in as_completed(futures, with_results=True):
            yield count
    except KilledWorker as error:
        raise StoreError(
            f"{task.store.path}: a chunk took one worker after another down; the chunks stored so far are "
            "kept: look at the workers' logs, memory above all (a smaller chunk needs less of it when a new "
            f"store is begun), and start the same campaign again to go on ({error})"
        ) from error
    finally:
        client.cancel(futures)


def _itself(task: Task) -> Task:
    return task


def _do(number: int, task: Task) -> int:
    return task.do(number)


@contextmanager
def connected(address: str, patience: float = 10.0) -> Iterator[Any]:
    """A client of the scheduler at `address`, "tcp://host:port", which has so many s to answer."""
    try:
        from distributed import Client  # noqa: PLC0415
    except ImportError:
        raise InputError("a cluster needs distributed: pip install 'freebody[cluster]'") from None
    try:
        client = Client(address, timeout=patience)
    except (OSError, ValueError) as error:
        raise InputError(
            f"cluster: no scheduler answers at {address!r} ({error}); give its address, such as tcp://host:8786"
        ) from None
    with client:
        yield client
