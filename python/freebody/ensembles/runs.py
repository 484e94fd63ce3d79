"""What the runs of an ensemble gave."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from freebody import _core
from freebody._check import Array
from freebody.simulation import GOOD_ENDS, OUTCOMES, Settings, Trajectory, Watched

if TYPE_CHECKING:
    import xarray

    from freebody.ensembles.ensemble import Ensemble

__all__ = ["Chunk", "Runs", "chunk_of"]

Chunk: TypeAlias = dict[str, NDArray[Any]]
"""Arrays of some runs by the names of `layout.variables`, run first."""


def chunk_of(
    result: _core.EnsembleResult,
    dispersed: Array,
    settings: Settings,
    watch: Watched,
    at_start: Array | None,
) -> Chunk:
    """What one call of the core gave; `at_start` has the values of the notices at the start, (n, k)."""
    known = len(watch.events)
    counts = result.counts
    chunk: Chunk = {
        "outcome": result.outcomes,
        "end_time": result.end_times,
        "final_state": result.end_states,
        "dispersed": dispersed,
        "steps": counts[:, 0],
        "rejected": counts[:, 1],
        "culprit": result.culprits,
    }
    if settings.times is not None:
        chunk["samples"] = result.samples
    if watch.outputs:
        chunk["outputs"] = result.outputs
    if watch.events:
        chunk["stopped_by"] = result.stopped_by
        chunk["event_time"] = result.event_times[:, :known]
        chunk["event_count"] = result.event_counts[:, :known]
        chunk["event_state"] = result.event_states[:, :known]
    if at_start is not None:
        chunk["notice_time"] = np.where(at_start < 0.0, settings.span[0], result.event_times[:, known:])
    return chunk


class Runs:
    """The runs of an ensemble, in memory.

    Attributes
    ----------
    ensemble, settings
        What was run, and how it was integrated.
    chunk
        Everything that came, arrays by name.
    """

    def __init__(self, ensemble: Ensemble, settings: Settings, chunk: Chunk) -> None:
        self.ensemble, self.settings, self.chunk = ensemble, settings, chunk

    @property
    def outcome(self) -> NDArray[np.uint8]:
        """How each run ended, (n,): the place in `freebody.simulation.OUTCOMES`."""
        return self.chunk["outcome"]

    @property
    def status(self) -> NDArray[np.str_]:
        """The same in words, (n,)."""
        return np.array(OUTCOMES)[self.outcome]

    @property
    def ok(self) -> NDArray[np.bool_]:
        """Whether each run reached its end, or an event that ends it, (n,)."""
        return self.outcome < len(GOOD_ENDS)

    @property
    def end_time(self) -> Array:
        """The last time that each run reached, (n,) s."""
        return self.chunk["end_time"]

    @property
    def final(self) -> Array:
        """The state there, (n, n_states)."""
        return self.chunk["final_state"]

    @property
    def t(self) -> Array | None:
        """The times of the samples, (s,) s; None where none were asked for."""
        return self.settings.times

    @property
    def samples(self) -> Array | None:
        """The states at these times, (n, s, n_states), NaN where a run had ended."""
        return self.chunk.get("samples")

    @property
    def outputs(self) -> dict[str, Array]:
        """What the outputs of the runs are, (n,) each, by name."""
        names = [output.name for output in self.ensemble.outputs]
        return dict(zip(names, self.chunk["outputs"].T, strict=True)) if names else {}

    @property
    def event_times(self) -> dict[str, Array]:
        """When each event came first, (n,) s each, by name; NaN where it did not."""
        names = [event.name for event in self.ensemble.events]
        return dict(zip(names, self.chunk["event_time"].T, strict=True)) if names else {}

    @property
    def notice_times(self) -> dict[str, Array]:
        """From when on each notice held first, (n,) s each, by its message; NaN where it did not."""
        messages = self.ensemble.notices
        return dict(zip(messages, self.chunk["notice_time"].T, strict=True)) if messages else {}

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the columns of `dispersed`."""
        return self.ensemble.names

    @property
    def dispersed(self) -> Array:
        """The dispersed values, (n, len(names))."""
        return self.chunk["dispersed"]

    def trajectory(self, r: int, **options: Any) -> Trajectory:
        """Run r alone, integrated alike; `options` of `Model.simulate` beside, save_every above all."""
        settings = self.settings
        rtol, atol = settings.tolerance
        own = {"method": settings.method, "rtol": rtol, "atol": atol, "step": settings.step}
        own["max_steps"] = settings.max_steps
        if settings.times is not None and "save_every" not in options:
            own["save_at"] = settings.times
        return self.ensemble.trajectory(r, settings.span, **(own | options))

    def to_xarray(self) -> xarray.Dataset:
        """All of it as a labelled dataset with units (extra `data`)."""
        from freebody.ensembles.layout import to_dataset  # noqa: PLC0415  (an extra: who asks needs xarray)

        return to_dataset(self.ensemble, self.settings, self.chunk)

    def __len__(self) -> int:
        return len(self.outcome)

    def __repr__(self) -> str:
        counts = np.bincount(self.outcome, minlength=len(OUTCOMES))
        ended = ", ".join(f"{k} {word}" for word, k in zip(OUTCOMES, counts, strict=True) if k)
        return f"<Runs of {self.ensemble.base.name!r}: {ended}>"
