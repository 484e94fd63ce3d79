"""The store of a campaign: a Zarr group in a folder or at any URL that fsspec knows."""

from __future__ import annotations

import errno
import json
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from os import PathLike, fspath
from pathlib import Path
from typing import Any, cast

import numpy as np
import zarr
from numpy.typing import NDArray
from zarr.core.buffer import default_buffer_prototype
from zarr.core.sync import sync
from zarr.storage import FsspecStore, LocalStore

from freebody.errors import StoreError

from .layout import DONE, ROOT, Layout

__all__ = ["Store"]

# How zarr-python calls a file until it is whole.
_UNFINISHED = re.compile(r".*\.[0-9a-f]{32}\.partial")
_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


class Store:
    """Where a campaign's runs are.

    Every file is written whole or not at all, and a chunk of runs counts as done when its number of runs
    stands in the array `runs_done`, which is written after all its other arrays. So a campaign that is killed
    at any moment leaves a store that another one can go on with.
    """

    def __init__(self, path: str | PathLike[str]) -> None:
        self.path = fspath(path).removeprefix("file://")
        remote = "://" in self.path
        self.folder = None if remote else Path(self.path)
        self._store = FsspecStore.from_url(self.path) if remote else LocalStore(self.path)

    def __reduce__(self) -> tuple[type[Store], tuple[str]]:
        return Store, (self.path,)

    def attributes(self) -> dict[str, Any] | None:
        """What the store says of itself; None where there is none yet.

        Raises `StoreError` where something else stands.
        """
        root = self._get(ROOT)
        if root is None:
            if self.folder is not None and any(
                not _UNFINISHED.fullmatch(p.name) for p in _files(self.folder)
            ):
                raise StoreError(f"{self.path}: is there, and is no campaign; give another path")
            return None
        attributes = json.loads(root).get("attributes", {})
        if not {"n", "chunk"} <= attributes.keys():
            raise StoreError(f"{self.path}: is a Zarr store, and no campaign; give another path")
        return attributes

    def prepare(self, layout: Layout) -> None:
        """Makes the store, or makes it larger, or finishes what was killed while it did."""
        self.sweep()
        with self._writing():
            for key, document in layout.documents().items():
                if self._get(key) != document:
                    self._set(key, document)

    def pending(self, runs: int, chunk: int) -> list[int]:
        """The numbers of the chunks that are not done."""
        done = self.read(DONE)
        wanted = np.minimum(runs - chunk * np.arange(len(done)), chunk)
        return np.flatnonzero(done != wanted).tolist()

    def write(self, number: int, first: int, results: Mapping[str, Any]) -> None:
        """Stores the runs from `first` on, and then that this chunk is done."""
        group = zarr.open_group(self._store, mode="r+", zarr_format=3)
        count = len(next(iter(results.values())))
        with self._writing():
            for name, values in results.items():
                _array(group, name)[first : first + count] = values
            _array(group, DONE)[number] = count

    def names(self) -> list[str]:
        """Of its arrays."""
        return sorted(self._group().array_keys())

    def read(self, name: str) -> NDArray[Any]:
        """One of its arrays, all of it. Raises `KeyError` where there is none of this name."""
        return np.asarray(_array(self._group(), name)[...])

    def sweep(self) -> None:
        """Removes what killed processes have left half written."""
        if self.folder is not None:
            for path in _files(self.folder):
                if _UNFINISHED.fullmatch(path.name):
                    path.unlink(missing_ok=True)

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Keeps a second campaign of this machine from the same folder; ends with the process in any case.

        At a URL nothing is locked: two campaigns there write the same bytes.
        """
        if self.folder is None:
            yield
            return
        with self._writing():
            self.folder.mkdir(parents=True, exist_ok=True)
        with _lock(self.folder):
            yield

    @contextmanager
    def _writing(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            what = "the disk is full" if error.errno in _FULL else error.strerror or str(error)
            raise StoreError(
                f"{self.path}: {what}; the chunks stored so far are kept: free some space, or mend it, "
                "and start the same campaign again to go on"
            ) from error

    def _group(self) -> zarr.Group:
        return zarr.open_group(self._store, mode="r", zarr_format=3)

    def _get(self, key: str) -> bytes | None:
        value = sync(self._store.get(key, default_buffer_prototype()))
        return None if value is None else value.to_bytes()

    def _set(self, key: str, value: bytes) -> None:
        sync(self._store.set(key, default_buffer_prototype().buffer.from_bytes(value)))


def _array(group: zarr.Group, name: str) -> zarr.Array:
    return cast(zarr.Array, group[name])


def _files(folder: Path) -> list[Path]:
    return [path for path in folder.rglob("*") if path.is_file()] if folder.exists() else []


@contextmanager
def _lock(folder: Path) -> Iterator[None]:
    """An advisory lock on the folder itself: no file of its own, gone when the process is gone."""
    try:
        import fcntl  # noqa: PLC0415  (Windows has none)
    except ImportError:
        yield
        return
    import os  # noqa: PLC0415

    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(handle)
        raise StoreError(
            f"{folder}: another campaign is writing to it; wait until it ends, or give another path"
        ) from None
    except OSError:
        pass  # file systems without locks: two campaigns write the same bytes
    try:
        yield
    finally:
        os.close(handle)
