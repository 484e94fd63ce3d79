"""The runs of a campaign, read from its store when they are asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, cast

import xarray as xr
from numpy.typing import NDArray

from freebody.ensembles import Chunk, Ensemble, Runs
from freebody.simulation import Settings

from .store import Store

if TYPE_CHECKING:
    from os import PathLike

__all__ = ["StoredRuns", "open_runs"]


class StoredRuns(Runs):
    """The runs of a campaign: what is asked for is read from the store, nothing is kept.

    Attributes
    ----------
    path
        Of the store, for `open_runs` or `xarray.open_zarr`.
    """

    def __init__(self, ensemble: Ensemble, settings: Settings, store: Store) -> None:
        super().__init__(ensemble, settings, cast(Chunk, _Arrays(store)))
        self.path = store.path

    def to_xarray(self) -> xr.Dataset:
        """The store as a labelled dataset with units, whose arrays are read when they are used."""
        return open_runs(self.path)


def open_runs(path: str | PathLike[str]) -> xr.Dataset:
    """The store of a campaign, finished or not, as a labelled dataset; extra `ensemble`.

    Its arrays are read when they are used. Runs that are not done yet have the outcome "not_run".
    """
    return xr.open_zarr(Store(path).path, chunks=None)  # pyright: ignore[reportArgumentType]


class _Arrays(Mapping[str, NDArray[Any]]):
    def __init__(self, store: Store) -> None:
        self._store = store

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._store.read(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._store.names())

    def __len__(self) -> int:
        return len(self._store.names())
