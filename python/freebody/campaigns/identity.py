"""What makes two campaigns one: a store is continued by the campaign that began it, and by no other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freebody.ensembles import Dispersion, Ensemble, Factor, FromFile, Offset, Samples
from freebody.errors import StoreError
from freebody.simulation import Settings

from .fingerprint import fingerprint

__all__ = ["OPEN_ENDED", "check_same", "fingerprints"]

# Samplings of which the first n points are the same, however many follow.
OPEN_ENDED = ("random", "sobol")

# Attributes of `freebody.ensembles.layout.attributes` that results depend on.
_TOLD = (
    "seed",
    "sampling",
    "method",
    "rtol",
    "atol",
    "step",
    "max_steps",
    "start_time",
    "stop_time",
    "freebody_version",
)


def fingerprints(ensemble: Ensemble, settings: Settings) -> dict[str, str]:
    """Everything else that the results depend on, as attributes of a store."""
    base = ensemble.base
    dispersions = {name: _values(given) for name, given in ensemble.dispersions.items()}
    parts = {
        "the model": (base, base.compiled),
        "the state at the start": ensemble.x0,
        "the dispersions": dispersions,
        "the inputs": ensemble.nominal_inputs,
        "the events": ensemble.events,
        "the outputs": ensemble.outputs,
        "the times of the samples": settings.times,
    }
    return {_key(part): fingerprint(content) for part, content in parts.items()}


def _key(part: str) -> str:
    return f"fingerprint of {part}"


def _values(given: Dispersion) -> Dispersion:
    """Without the path of a file, which may be written in several ways."""
    if isinstance(given, Offset | Factor):
        distribution = _values(given.distribution)
        return given if distribution is given.distribution else type(given)(distribution)  # type: ignore[arg-type]
    return Samples(given.values) if isinstance(given, FromFile) else given


def check_same(path: str, stored: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
    """Raises `StoreError`, which says what differs, unless the store is of the wanted campaign."""
    differing = [
        f"{key} is {stored.get(key)} there, {wanted[key]} here"
        for key in _TOLD
        if stored.get(key) != wanted[key]
    ]
    prefix = _key("")
    differing += [
        f"{key.removeprefix(prefix)} differ{'s' * (not key.endswith('s'))}"
        for key in wanted
        if key.startswith(prefix) and stored.get(key) != wanted[key]
    ]
    if differing:
        raise StoreError(
            f"{path}: holds another campaign: {'; '.join(differing)}. Give another path, or what this one "
            "was begun with"
        )
    there, here = stored["n"], wanted["n"]
    if there > here:
        raise StoreError(f"{path}: has {there} runs, {here} are asked for; ask for {there} or more")
    if there < here and wanted["sampling"] not in OPEN_ENDED:
        raise StoreError(
            f"{path}: has {there} runs, {here} are asked for; nothing can be added to {wanted['sampling']} "
            "samples: give another path, or begin with sampling 'random' or 'sobol'"
        )
