"""One chunk of a campaign: what any machine needs to know to do it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freebody import _core
from freebody.ensembles import Ensemble
from freebody.ensembles.layout import variables
from freebody.errors import StoreError
from freebody.simulation import Settings

from .store import Store

__all__ = ["Task"]


@dataclass(frozen=True)
class Task:
    """What the chunks of a campaign have in common.

    Attributes
    ----------
    ensemble, settings
        What is run, and how.
    store
        Where the results go.
    chunk
        Runs in a chunk.
    threads
        For one chunk; one for each core when None.
    version
        Of freebody where the campaign was begun: another one may round otherwise.
    """

    ensemble: Ensemble
    settings: Settings
    store: Store
    chunk: int
    threads: int | None
    version: str = _core.__version__

    def count(self, number: int) -> int:
        """How many runs a chunk has; the last one may have fewer."""
        return min(self.chunk, self.ensemble.n - number * self.chunk)

    def do(self, number: int, progress: Callable[[int], object] | None = None) -> int:
        """Runs a chunk and stores it; the number of its runs."""
        if self.version != _core.__version__:
            raise StoreError(
                f"{self.store.path}: begun by freebody {self.version}, this worker has {_core.__version__}; "
                "install one version everywhere"
            )
        first, count = number * self.chunk, self.count(number)
        results = self.ensemble.chunk(first, count, self.settings, threads=self.threads, progress=progress)
        arrays = {name: results[name] for name in variables(self.ensemble, self.settings)}
        self.store.write(number, first, {"run": np.arange(first, first + count), **arrays})
        return count
