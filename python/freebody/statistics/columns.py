"""Which numbers of the runs are looked at, and their values block by block.

A dataset of runs is what `Runs.to_xarray` gives and what the store of a campaign holds: `outcome` (run),
`outputs` (run, output), `event_time` (run, event), `final_state` (run, state), `dispersed` (run, quantity),
`end_time` (run). Only what is asked for is read, so that a store may be larger than the memory.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING

import numpy as np

from freebody._check import Array, shown
from freebody.errors import InputError
from freebody.simulation import GOOD_ENDS, OUTCOMES

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Column", "all_columns", "blocks", "column", "every_run", "gather", "outcomes", "results"]

BLOCK = 65_536  # runs read at once

# The variable and the dimension with its names, by the word before the colon.
_PLACES: Mapping[str, tuple[str, str]] = {
    "output": ("outputs", "output"),
    "event": ("event_time", "event"),
    "final": ("final_state", "state"),
    "dispersed": ("dispersed", "quantity"),
}


@dataclass(frozen=True)
class Column:
    """One number of each run."""

    kind: str
    name: str
    unit: str
    index: int

    @property
    def key(self) -> str:
        """Its full name: `output:miss`."""
        return f"{self.kind}:{self.name}" if self.kind in _PLACES else self.name

    @property
    def label(self) -> str:
        """Its name and unit for an axis."""
        return self.name if self.unit in {"", "1"} else f"{self.name} ({self.unit})"


def all_columns(dataset: xr.Dataset, *kinds: str) -> list[Column]:
    """Every column of these kinds: "output", "event", "final", "dispersed"; of all, if none is given."""
    found = []
    for kind in kinds or _PLACES:
        variable, dimension = _PLACES[kind]
        if variable not in dataset:
            continue
        names = [str(name) for name in dataset[dimension].values]
        unit = f"{dimension}_unit"
        known = [str(word) for word in dataset[unit].values] if unit in dataset.coords else [""] * len(names)
        units = ["s"] * len(names) if kind == "event" else known
        found += [Column(kind, n, u, i) for i, (n, u) in enumerate(zip(names, units, strict=True))]
    if not kinds and "end_time" in dataset:
        found.append(Column("end_time", "end_time", "s", 0))
    return found


def results(dataset: xr.Dataset) -> list[Column]:
    """What the runs were made for: outputs and times of events; final states where there are none."""
    return all_columns(dataset, "output", "event") or all_columns(dataset, "final")


def column(dataset: xr.Dataset, name: str | Column) -> Column:
    """The column of this name: `output:miss`, `event:apogee` (its first time), `final:position_x`,
    `dispersed:mass`, `end_time`; the first word may be left out where only one column has the name.

    Raises `InputError` for a name that is not there or not clear.
    """
    if isinstance(name, Column):
        return name
    everything = all_columns(dataset)
    named = [c for c in everything if name in (c.key, c.name)]
    exact = [c for c in named if c.key == name]
    if len(exact or named) == 1:
        return (exact or named)[0]
    if named:
        raise InputError(f"column: {shown(name)} is not clear; give one of {', '.join(c.key for c in named)}")
    words = {word for c in everything for word in (c.key, c.name)}
    near = get_close_matches(str(name), sorted(words), n=1)
    meant = f"did you mean {near[0]!r}?" if near else f"there are {', '.join(c.key for c in everything)}"
    raise InputError(f"column: the runs have no {shown(name)}; {meant}")


def outcomes(dataset: xr.Dataset) -> dict[str, int]:
    """How many runs ended how; what has not been run yet is left out."""
    counts = np.bincount(np.asarray(dataset["outcome"].values, dtype=np.int64), minlength=len(OUTCOMES))
    return {name: int(n) for name, n in zip(OUTCOMES, counts, strict=True) if name != "not_run"}


def blocks(dataset: xr.Dataset, columns: Sequence[Column], rows: int = BLOCK) -> Iterator[Array]:
    """The values (m, k) of the runs that ended well, in order, a few at a time; NaN where a run has none."""
    for first in range(0, dataset.sizes["run"], rows):
        part = dataset.isel(run=slice(first, first + rows))
        well = np.asarray(part["outcome"].values) < len(GOOD_ENDS)
        yield np.column_stack([_values(part, c)[well] for c in columns])


def gather(dataset: xr.Dataset, columns: Sequence[Column]) -> Array:
    """The values (n, k) of all runs that ended well."""
    return np.concatenate([np.empty((0, len(columns))), *blocks(dataset, columns)])


def every_run(dataset: xr.Dataset, column: Column) -> Array:
    """The value (n,) of each run, in order; NaN for one that ended badly or has none."""
    well = np.asarray(dataset["outcome"].values) < len(GOOD_ENDS)
    return np.where(well, _values(dataset, column), np.nan)


def _values(part: xr.Dataset, column: Column) -> Array:
    variable, dimension = _PLACES.get(column.kind, (column.kind, ""))
    chosen = part[variable].isel({dimension: column.index}) if dimension else part[variable]
    return np.asarray(chosen.values, dtype=np.float64)
