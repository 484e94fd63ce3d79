"""Aerodynamic coefficients: slopes times products of variables; slopes are numbers, tables or functions."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from freebody import _check
from freebody.elements.air_data import AirData
from freebody.elements.lookup import Lookup
from freebody.errors import InputError
from freebody.tracing.situation import did_you_mean

__all__ = ["Coefficient", "Coefficients", "Slope", "read_coefficients"]

Slope: TypeAlias = "float | Lookup | Callable[[AirData], Any] | Sequence[Slope]"
"""A number, a table, a function of the air data, or a sum of such."""
Coefficient: TypeAlias = "Slope | Mapping[str, Slope]"
"""{"0": slope, "alpha": slope, "alpha^2": slope, "alpha elevator": slope}: products of variables."""

_FACTOR = re.compile(r"([A-Za-z_]\w*)(?:\^([1-9]))?")


class _Term(NamedTuple):
    """slope × product of powers; a number is the parameter `slope` of the law."""

    slope: str | Lookup | Callable[[AirData], Any]
    powers: tuple[tuple[str, int], ...]


class Coefficients(NamedTuple):
    """What was read: the terms of each coefficient, and the numbers among their slopes."""

    terms: dict[str, list[_Term]]
    numbers: dict[str, float]

    def value(self, name: str, a: AirData, p: Any) -> Any:
        """A coefficient in a law with its parameters."""
        total: Any = 0.0
        for slope, powers in self.terms[name]:
            if isinstance(slope, str):
                product = p[slope]
            else:
                product = slope(a)
                if np.ndim(product) != 0:
                    raise InputError(
                        f"{name}: the function returned shape {np.shape(product)}; give one number"
                    )
            for variable, power in powers:
                product = product * a[variable] ** power
            total = total + product
        return total

    def ranges(self) -> dict[tuple[str, float, float, str], list[str]]:
        """The ranges of the tables, (variable, low, high, what holds beyond), and whose they are."""
        found: dict[tuple[str, float, float, str], list[str]] = {}
        for name, terms in self.terms.items():
            for slope, _ in terms:
                if not isinstance(slope, Lookup):
                    continue
                for variable, (low, high) in slope.ranges.items():
                    owners = found.setdefault((variable, low, high, slope.beyond), [])
                    owners.extend([name] if name not in owners else [])
        return found


def read_coefficients(
    given: Mapping[str, Coefficient], names: Sequence[str], variables: Sequence[str]
) -> Coefficients:
    """Check coefficients: which there may be, and of what."""
    for name in given:
        if name not in names:
            raise InputError(
                f"coefficients: {name!r} is none in these axes; {did_you_mean(str(name), names)}"
            )
    terms: dict[str, list[_Term]] = {}
    numbers: dict[str, float] = {}
    for name in (n for n in names if n in given):
        what = given[name]
        products = what if isinstance(what, Mapping) else {"0": what}
        terms[name] = []
        for product, slope in products.items():
            powers = _powers(name, product, variables)
            label = "_".join(
                [name, *(f"{v}{'' if n == 1 else n}" for v, n in powers)] if powers else [name, "0"]
            )
            for one in _slopes(f"{name}: {product!r}", slope, variables):
                if isinstance(one, float):
                    if label in numbers:
                        raise InputError(f"{name}: {product!r} has two numbers as slopes; give their sum")
                    numbers[label] = one
                    terms[name].append(_Term(label, powers))
                else:
                    terms[name].append(_Term(one, powers))
    return Coefficients(terms, numbers)


def _powers(name: str, product: object, variables: Sequence[str]) -> tuple[tuple[str, int], ...]:
    if product == "0":
        return ()
    words = product.split() if isinstance(product, str) else []
    matches = [_FACTOR.fullmatch(word) for word in words]
    if not words or None in matches:
        raise InputError(
            f'{name}: cannot read {_check.shown(product)}; write "0" for the constant term, or variables '
            'with spaces between, "alpha", "alpha^2", "alpha elevator"'
        )
    powers = tuple((m[1], int(m[2] or 1)) for m in matches if m is not None)
    for variable, _ in powers:
        _known(name, variable, variables)
    return powers


def _slopes(where: str, slope: Any, variables: Sequence[str]) -> list[Any]:
    if isinstance(slope, Lookup):
        for variable in slope.of:
            _known(where, variable, variables)
        return [slope]
    if isinstance(slope, list | tuple):
        return [one for each in slope for one in _slopes(where, each, variables)]
    if callable(slope):
        return [slope]
    if isinstance(slope, Mapping):
        raise InputError(f"{where}: got {_check.shown(slope)}; a slope is no mapping again")
    return [_check.number(where, slope)]


def _known(where: str, variable: str, variables: Sequence[str]) -> None:
    if variable not in variables:
        raise InputError(f"{where}: {variable!r} is no variable; {did_you_mean(variable, variables)}")
