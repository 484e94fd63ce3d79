"""A quantity with its distribution: what runs get."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.ensembles.distributions import Distribution
from freebody.ensembles.joint import Discrete, MultivariateNormal, Samples
from freebody.ensembles.quantities import Target
from freebody.errors import InputError

__all__ = ["Dispersed", "Dispersion", "Factor", "Offset"]


@dataclass(frozen=True)
class Offset:
    """Draws are added to the nominal value."""

    distribution: Distribution

    def __post_init__(self) -> None:
        _checked(self.distribution, "distribution")


@dataclass(frozen=True)
class Factor:
    """The nominal value is multiplied with draws."""

    distribution: Distribution

    def __post_init__(self) -> None:
        _checked(self.distribution, "distribution")


Dispersion = Distribution | Offset | Factor


class Dispersed:
    """A quantity of a model with its distribution.

    Attributes
    ----------
    target
        The quantity.
    given
        The distribution as it came.
    dimensions
        How many coordinates of the unit hypercube it takes.
    """

    def __init__(self, target: Target, given: Dispersion) -> None:
        self.target, self.given = target, given
        self._where = f"dispersions[{target.name!r}]"
        if not isinstance(given, Dispersion):
            raise InputError(
                f"{self._where}: got {_check.shown(given)}; give a distribution, such as "
                "fb.Normal(mean, sd), or one in fb.Offset(...) or fb.Factor(...)"
            )
        self.distribution = given if isinstance(given, Distribution) else given.distribution
        k = target.size
        if self.distribution.size not in (None, k):
            raise InputError(
                f"{self._where}: got a distribution of {self.distribution.size} numbers; the quantity has "
                f"{k}: {', '.join(target.columns)}"
            )
        self.dimensions = self.distribution.dimensions(k)
        self._check_factor()
        self._check_bounds()

    @property
    def factors(self) -> tuple[tuple[str, ...], ...]:
        """What of it is independent of all else: names of columns that go together."""
        columns = self.target.columns
        if self.dimensions == 0:
            return ()
        joint = isinstance(self.distribution, MultivariateNormal) or self.dimensions < len(columns)
        return (columns,) if joint else tuple((column,) for column in columns)

    def values(self, u: Array, first: int) -> Array:
        """The values (n, k) of the runs from `first` on at points (n, dimensions) of the hypercube."""
        return self._applied(self.distribution.draw(u, first, self.target.size))

    def check_sampling(self, sampling: str, n: int) -> None:
        """Refuse what the sampling cannot do with given values."""
        if not isinstance(self.distribution, Samples):
            return
        if sampling == "saltelli":
            raise InputError(
                f"{self._where}: values that are given cannot be exchanged, as saltelli sampling does; "
                'give a distribution, or sampling="random"'
            )
        rows = len(self.distribution.values)
        if rows < n:
            raise InputError(
                f"{self._where}: it has values for {rows} runs, n is {n}; give n of up to {rows}"
            )

    def _applied(self, draws: Array) -> Array:
        if isinstance(self.given, Factor):
            return self.target.nominal * draws
        if isinstance(self.given, Offset):
            return self.target.nominal + draws
        return draws

    def _check_factor(self) -> None:
        if not isinstance(self.given, Factor):
            return
        if self.target.relative:
            raise InputError(
                f"{self._where}: draws are added to what is nominal already, a factor has nothing to "
                "multiply; give the distribution itself"
            )
        if not self.target.nominal.any():
            raise InputError(f"{self._where}: the nominal value is zero, whatever the factor; use fb.Offset")

    def _check_bounds(self) -> None:
        ends = [self._applied(end) for end in self.distribution.bounds(self.target.size)]
        low, high = np.minimum(*ends), np.maximum(*ends)
        wrong = np.flatnonzero(~(np.isfinite(low) & np.isfinite(high)))
        if wrong.size:
            column = self.target.columns[int(wrong[0])]
            raise InputError(f"{self._where}: {column} can leave the range of doubles; give a narrower one")
        if not self.target.positive or (low > 0.0).all():
            return
        i = int(np.argmin(low))
        raise InputError(
            f"{self._where}: {self.target.columns[i]} can become {low[i]:.6g} {self.target.units[i]}, and it "
            f"must be positive; {self._remedy()}"
        )

    def _remedy(self) -> str:
        if not (self.target.nominal > 0.0).all():
            return "the body is flat or a rod: disperse 'inertia' and 'principal_axes' instead"
        if isinstance(self.distribution, Samples | Discrete):
            return "leave out the values that are not"
        return "use fb.TruncatedNormal or fb.Uniform with a positive low, or fb.LogNormal"


def _checked(distribution: object, name: str) -> None:
    if not isinstance(distribution, Distribution):
        raise InputError(
            f"{name}: got {_check.shown(distribution)}; give a distribution, such as fb.Normal(mean, sd)"
        )
