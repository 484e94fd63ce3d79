"""From [dispersions] to distributions, in the units of the model's quantities."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody import ensembles
from freebody.ensembles.quantities import Target, quantities, wanted
from freebody.ensembles.start import Start
from freebody.model import Model

from .dispersion_schema import AnyDistribution, FromFile
from .problems import Source
from .units import FieldError, Shape, to_si

__all__ = ["build_dispersions"]

KINDS = {
    "normal": ensembles.Normal,
    "truncated_normal": ensembles.TruncatedNormal,
    "uniform": ensembles.Uniform,
    "log_normal": ensembles.LogNormal,
    "multivariate_normal": ensembles.MultivariateNormal,
    "discrete": ensembles.Discrete,
}
APPLIED = {"value": lambda distribution: distribution, "offset": ensembles.Offset, "factor": ensembles.Factor}

# Keys whose numbers are no values of the quantity.
_PLAIN = ("sigma", "covariance", "weights")
_HEADING = re.compile(r".*\[(.*)\]\s*")


def build_dispersions(
    tables: Mapping[str, AnyDistribution], model: Model, x0: NDArray[np.float64], source: Source
) -> dict[str, ensembles.Dispersion]:
    """The distributions by the names of their quantities; refusals name the key they stand at."""
    if not tables:
        return {}
    known = list(quantities(model, Start(model, x0), np.zeros(model.n_inputs)))
    built = {}
    for name, table in tables.items():
        key = f"dispersions.{name}"
        with source.blame(key):
            target = wanted(name, known)
            if isinstance(table, FromFile):
                distribution = _from_file(table, target, key, source)
            else:
                distribution = KINDS[table.kind](**_numbers(table, target, key, source))
            built[name] = APPLIED[table.applied](distribution)
            model.ensemble(x0, {name: built[name]}, n=1)
    with source.blame("dispersions"):
        model.ensemble(x0, built, n=1)
    return built


def _numbers(table: Any, target: Target, key: str, source: Source) -> dict[str, Any]:
    """The numbers of a distribution, SI."""
    unit = _unit(target, table.applied)
    numbers: dict[str, Any] = {"low": -np.inf, "high": np.inf} if table.kind == "truncated_normal" else {}
    for name, value in table.given("kind", "applied").items():
        try:
            numbers[name] = to_si(
                value, "" if name in _PLAIN else unit, *_shapes(table.kind, name, target.size)
            )
        except FieldError as error:
            at = "".join(f"[{part}]" for part in error.at)
            raise source.error(f"{key}.{name}{at}", str(error)) from None
    return numbers


def _unit(target: Target, applied: str) -> str:
    """Of the values; empty for plain numbers, as where the numbers of a quantity differ in their units."""
    unit = target.units[0]
    return "" if applied == "factor" or unit == "1" or set(target.units) != {unit} else unit


def _shapes(kind: str, name: str, k: int) -> tuple[Shape, ...]:
    if kind == "multivariate_normal" and name == "mean":
        return ((k,),)
    if name == "covariance":
        return ((k, k),)
    if name == "weights":
        return ((None,),)
    if name == "values":
        return ((None,),) if k == 1 else ((None,), (None, k))
    return ((),) if k == 1 else ((), (k,))


def _from_file(table: FromFile, target: Target, key: str, source: Source) -> ensembles.Samples:
    distribution = ensembles.FromFile(source.path.parent / table.csv, table.columns)
    unit = _unit(target, table.applied)
    try:
        factors = [_factor(heading, unit) for heading in table.columns]
    except FieldError as error:
        raise source.error(f"{key}.columns", str(error)) from None
    if all(factor == 1.0 for factor in factors):
        return distribution
    return ensembles.Samples(distribution.values * np.array(factors))


def _factor(heading: str, unit: str) -> float:
    """From the unit of a heading to SI."""
    match = _HEADING.fullmatch(heading)
    return 1.0 if match is None else float(to_si(f"1 {match[1]}", unit, ()))
