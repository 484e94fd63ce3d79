"""Points of the unit hypercube, one for each run: random, Latin hypercube, Sobol, Saltelli.

Where a point stands depends on the seed and the number of the run alone, never on which runs are asked for.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.ensembles.distributions import LEAST
from freebody.errors import InputError

__all__ = ["Design", "Sampling", "checked_n"]

Sampling = Literal["random", "latin_hypercube", "sobol", "saltelli"]

_SAMPLINGS = ("random", "latin_hypercube", "sobol", "saltelli")
_NUMBERS = 4  # of 64 bits, in a block of Philox
_SOBOL_BITS = 32  # SciPy cannot skip points of more


@dataclass(frozen=True)
class Design:
    """Which points of the unit hypercube the runs are.

    Attributes
    ----------
    sampling
        "random": Philox (Salmon et al., Parallel random numbers: as easy as 1, 2, 3, SC11), each run from
        counters of its own. "latin_hypercube": SciPy's, kept whole, 8 n d bytes. "sobol": SciPy's, scrambled;
        n is best a power of two. "saltelli": Sobol points for Sobol indices, see `blocks`.
    seed
        0 to 2^64 - 1.
    n
        The number of runs.
    factors
        What is dispersed independently of all else: the names of the columns of the table of dispersed
        values, several where they are dispersed jointly.
    coordinates
        Of each factor, its coordinates of the hypercube.
    """

    sampling: Sampling
    seed: int
    n: int
    factors: tuple[tuple[str, ...], ...]
    coordinates: tuple[tuple[int, ...], ...]

    def __post_init__(self) -> None:
        _check.choice("sampling", self.sampling, _SAMPLINGS)
        group = self.group
        if self.n % group:
            few = self.n - self.n % group
            near = f"{few} or {few + group}" if few else f"{group}"
            raise InputError(
                f"n: got {self.n}; saltelli sampling of {len(self.factors)} independent factors takes groups "
                f"of {group} runs: give {near}, best {group} times a power of two"
            )

    @property
    def dimensions(self) -> int:
        """How many coordinates a point has."""
        return sum(map(len, self.coordinates))

    @property
    def group(self) -> int:
        """How many runs belong together: factors + 2 for saltelli, else 1."""
        return len(self.factors) + 2 if self.sampling == "saltelli" else 1

    def blocks(self, values: Array) -> tuple[Array, Array, Array]:
        """The values (n, ...) of all runs of a saltelli design, by what was exchanged.

        Runs stand in groups of factors + 2, as SALib orders them: a point A of the hypercube, then A with the
        coordinates of the first factor, the second, ... from another point B, then B.

        Returns
        -------
        A, B, AB
            (n / group, ...), (n / group, ...) and (n / group, factors, ...).
        """
        if self.sampling != "saltelli":
            raise InputError(f"sampling: blocks are those of saltelli, and this design is {self.sampling}")
        values = np.asarray(values)
        if len(values) != self.n:
            raise InputError(f"values: got {len(values)} rows; the design has {self.n} runs")
        groups = values.reshape(-1, self.group, *values.shape[1:])
        return groups[:, 0], groups[:, -1], groups[:, 1:-1]

    def points(self, first: int, count: int) -> Array:
        """The points (count, dimensions) of the runs from `first` on, within [2^-53, 1 - 2^-53]."""
        if not self.dimensions:
            return np.empty((count, 0))
        if self.sampling == "random":
            return self._random(first, count)
        if self.sampling == "sobol":
            return self._sobol(self.dimensions, first, count)
        if self.sampling == "latin_hypercube":
            return self._hypercube[first : first + count]
        return self._saltelli(first, count)

    def _random(self, first: int, count: int) -> Array:
        blocks = -(-self.dimensions // _NUMBERS)
        generator = np.random.Philox(key=self.seed, counter=first * blocks)
        raw = generator.random_raw(count * blocks * _NUMBERS).reshape(count, -1)[:, : self.dimensions]
        # The middles of 2^52 equal parts: neither 0 nor 1, and exact.
        return ((raw >> np.uint64(12)).astype(np.float64) + 0.5) * 2.0**-52

    def _sobol(self, dimensions: int, first: int, count: int) -> Array:
        engine = _qmc().Sobol(dimensions, bits=_SOBOL_BITS, rng=np.random.default_rng(self.seed))
        if first:
            engine.fast_forward(first)
        with warnings.catch_warnings():  # a part need not be a power of two
            warnings.simplefilter("ignore", UserWarning)
            return engine.random(count) + 0.5 ** (_SOBOL_BITS + 1)

    @cached_property
    def _hypercube(self) -> Array:
        engine = _qmc().LatinHypercube(self.dimensions, rng=np.random.default_rng(self.seed))
        return np.clip(engine.random(self.n), LEAST, 1.0 - LEAST)

    def _saltelli(self, first: int, count: int) -> Array:
        d, group = self.dimensions, self.group
        start, end = first // group, -(-(first + count) // group)
        pairs = self._sobol(2 * d, start, end - start)
        points = np.repeat(pairs[:, None, :d], group, axis=1)
        for i, coordinates in enumerate(self.coordinates, 1):
            points[:, i, coordinates] = pairs[:, d:][:, coordinates]
        points[:, -1] = pairs[:, d:]
        return points.reshape(-1, d)[first - start * group :][:count]

    def __getstate__(self) -> dict[str, Any]:
        """Without the hypercube, which is made again where it is wanted."""
        return {name: value for name, value in self.__dict__.items() if name != "_hypercube"}


def checked_n(n: int, seed: int) -> tuple[int, int]:
    """Check the number of runs and the seed."""
    whole = _check.number("seed", seed) if not isinstance(seed, int) else seed
    if isinstance(seed, bool) or whole != int(whole) or not 0 <= whole < 2**64:
        raise InputError(f"seed: got {_check.shown(seed)}; give a whole number from 0 to 2^64 - 1")
    return _check.count("n", n), int(whole)


def _qmc() -> Any:
    try:
        from scipy.stats import qmc  # noqa: PLC0415  (an extra, and slow to load)
    except ImportError:
        raise InputError("sampling: this one needs scipy: pip install 'freebody[ensemble]'") from None
    return qmc
