"""How the runs were drawn, and what that means for statistics of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from freebody._check import Array
from freebody.errors import InputError

from .columns import Column, all_columns, every_run

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Pages", "independent", "is_paired", "notes", "pages", "refuse_pairs"]

_NOTES = {
    "latin_hypercube": (
        "a Latin hypercube: means and probabilities are known better than these intervals say, as a rule; "
        "they are made for independent runs",
    ),
    "sobol": (
        "a scrambled Sobol sequence: estimates are better than these intervals say, as a rule, but nothing "
        "guarantees it; they are made for independent runs",
    ),
    "saltelli": (
        "a design for Sobol indices: below, all but those stand on its base samples A and B alone, a "
        "scrambled Sobol sequence; the intervals are made for independent runs",
    ),
}


class Pages(NamedTuple):
    """A result at the base samples A (n,) and B (n,), and at A with one factor from B (k, n)."""

    factors: tuple[str, ...]
    a: Array
    b: Array
    ab: Array


def notes(dataset: xr.Dataset) -> tuple[str, ...]:
    """What must be said of intervals from these runs; nothing if they are independent."""
    return _NOTES.get(_sampling(dataset), ())


def is_paired(dataset: xr.Dataset) -> bool:
    """Whether runs repeat numbers of each other, as those for Sobol indices do."""
    return _sampling(dataset) == "saltelli"


def refuse_pairs(dataset: xr.Dataset) -> None:
    """Raises `InputError` for runs that a stopping rule cannot go by."""
    if is_paired(dataset):
        raise InputError(
            "precision: these runs were drawn for Sobol indices and repeat each other's numbers; "
            'use sampling="random"'
        )


def independent(dataset: xr.Dataset) -> xr.Dataset:
    """The runs without those that repeat numbers of others: of a design for Sobol indices, A and B."""
    if not is_paired(dataset):
        return dataset
    place = np.arange(dataset.sizes["run"]) % (group := len(_factors(dataset)) + 2)
    return dataset.isel(run=np.flatnonzero((place == 0) | (place == group - 1)))


def pages(dataset: xr.Dataset, column: Column) -> Pages:
    """A result by the pages of a design for Sobol indices.

    Runs stand in groups: A, then A with the first factor from B, with the second, ..., then B. A group with a
    run that ended badly or has no value is left out.
    """
    if not is_paired(dataset):
        raise InputError(
            f'sampling: got {_sampling(dataset)} runs; Sobol indices need runs drawn with sampling="saltelli"'
        )
    factors = _factors(dataset)
    group = len(factors) + 2
    _check_groups(dataset, group)
    values = every_run(dataset, column)
    groups = values[: len(values) // group * group].reshape(-1, group)
    groups = groups[np.isfinite(groups).all(axis=1)]
    return Pages(factors, groups[:, 0], groups[:, -1], groups[:, 1:-1].T)


def _check_groups(dataset: xr.Dataset, group: int) -> None:
    """Check on the first group that it differs from A in one factor at a time."""
    first = np.asarray(dataset["dispersed"].isel(run=slice(0, group)).values)
    number = _factor_numbers(dataset)
    # What stays is the same number; what comes from B may be, too, where few values are possible.
    stays = np.isclose(first[1:-1], first[0], rtol=1e-9, atol=0.0, equal_nan=True)
    if len(first) < group or not stays[np.arange(group - 2)[:, None] != number].all():
        raise InputError(
            f"runs: not in groups of {group}, A, A with one factor from B after the other, B; Sobol indices "
            "need the runs in the order in which they were drawn"
        )


def _factor_numbers(dataset: xr.Dataset) -> NDArray[np.int64]:
    """The number of the factor that each dispersed quantity belongs to: what is dispersed jointly."""
    if "quantity_factor" in dataset.coords:
        return np.asarray(dataset["quantity_factor"].values, dtype=np.int64)
    return np.arange(dataset.sizes["quantity"])


def _sampling(dataset: xr.Dataset) -> str:
    return str(dataset.attrs.get("sampling", "random"))


def _factors(dataset: xr.Dataset) -> tuple[str, ...]:
    """The names of the factors."""
    names = [quantity.name for quantity in all_columns(dataset, "dispersed")]
    number = _factor_numbers(dataset)
    joint = [[n for n, own in zip(names, number, strict=True) if own == f] for f in range(number.max() + 1)]
    return tuple(", ".join(group) for group in joint)
