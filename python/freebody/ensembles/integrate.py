"""The runs of an ensemble as the core does them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody import _core
from freebody._check import Array
from freebody.ensembles.draws import Draw
from freebody.ensembles.law_parameters import shared_name, with_shared
from freebody.ensembles.runs import Chunk, chunk_of
from freebody.simulation import InputTable, Settings, Watched, watched
from freebody.simulation.inputs import core_table

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["integrated", "joined", "rewatched"]


def integrated(
    model: Model,
    draw: Draw,
    table: InputTable | None,
    watch: Watched,
    settings: Settings,
    threads: int,
    progress: Callable[[int], object] | None,
) -> Chunk:
    """What the runs of a draw gave."""
    start, end = settings.span
    options: dict[str, Any] = {
        "bodies": draw.bodies,
        "parameters": draw.parameters,
        "constants": draw.inputs,
        "table": None if table is None else core_table(table),
        "method": settings.method,
        "tolerance": settings.tolerance,
        "step": settings.step,
        "max_steps": settings.max_steps,
        "threads": threads,
    }
    at_start = None
    if watch.notices:
        nothing = {"save_at": None, "events": [], "progress": None}
        at_start = _core.run_ensemble(
            model, draw.x0, (start, start), **options, **nothing, outputs=watch.core_notices
        ).outputs
    result = _core.run_ensemble(
        model,
        draw.x0,
        (start, end),
        **options,
        save_at=settings.times,
        events=watch.core_events,
        outputs=watch.core_outputs,
        progress=progress,
    )
    return chunk_of(result, draw.dispersed, settings, watch, at_start)


def joined(chunks: Sequence[Chunk]) -> Chunk:
    """Chunks one behind the other."""
    return {name: np.concatenate([chunk[name] for chunk in chunks]) for name in chunks[0]}


def rewatched(model: Model, watch: Watched, values: Mapping[str, Array]) -> Watched:
    """The events and outputs with the shared parameters of a run; as they are where they read none."""
    laws = (*watch.events, *watch.outputs)
    if not any(shared_name(name) in values for law in laws for name in law.shared):
        return watch
    return watched(
        model,
        [with_shared(law, values) for law in watch.events],
        [with_shared(law, values) for law in watch.outputs],
    )
