"""Distributions of one number, or of several that are independent.

Each is a quantile function: it takes points of the unit hypercube, so that random, Latin hypercube and Sobol
points are one way. Parameters are numbers, which serve a quantity of any size, or vectors (k,).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

import numpy as np

from freebody import _check
from freebody._check import Array
from freebody.errors import InputError

__all__ = [
    "LEAST",
    "Distribution",
    "Independent",
    "LogNormal",
    "Normal",
    "Parameter",
    "TruncatedNormal",
    "Uniform",
    "special",
]

LEAST = 2.0**-53
"""Points of the hypercube lie within [LEAST, 1 - LEAST]: a normal draw within 8.21 standard deviations."""

Parameter: TypeAlias = float | Sequence[float] | Array


def special() -> Any:
    """scipy.special (extra `ensemble`): only who disperses needs it."""
    try:
        import scipy.special  # noqa: PLC0415
    except ImportError:
        raise InputError("distributions need scipy: pip install 'freebody[ensemble]'") from None
    return scipy.special


class Distribution(ABC):
    """How a quantity is dispersed.

    Attributes
    ----------
    size
        How many numbers one draw has; None where it serves a quantity of any size, its numbers independent.
    """

    size: int | None

    @abstractmethod
    def dimensions(self, size: int) -> int:
        """How many coordinates of the unit hypercube a draw of `size` numbers takes."""

    @abstractmethod
    def draw(self, u: Array, first: int, size: int) -> Array:
        """The draws (n, size) of the runs from `first` on at points (n, dimensions) of the hypercube."""

    @abstractmethod
    def bounds(self, size: int) -> tuple[Array, Array]:
        """The least and the largest value that a draw can have, (size,) each."""

    @abstractmethod
    def moments(self) -> tuple[Any, Any]:
        """Mean and standard deviation, numbers or (k,)."""


class Independent(Distribution):
    """Numbers that are independent of each other, each with a rising quantile function."""

    def __post_init__(self) -> None:
        lengths = {}
        for field in fields(self):  # pyright: ignore[reportArgumentType]
            value = _parameter(field.name, getattr(self, field.name))
            object.__setattr__(self, field.name, value)
            if isinstance(value, tuple):
                lengths[field.name] = len(value)
        if len(set(lengths.values())) > 1:
            came = " and ".join(f"{name} ({k},)" for name, k in lengths.items())
            raise InputError(f"{type(self).__name__}: got {came}; give vectors of one length, or numbers")
        object.__setattr__(self, "size", next(iter(lengths.values()), None))
        self._check()

    @abstractmethod
    def _check(self) -> None: ...

    @abstractmethod
    def quantile(self, u: Array) -> Array:
        """The values (n, k) below which a draw lies with probabilities (n, k)."""

    def dimensions(self, size: int) -> int:
        return size

    def draw(self, u: Array, first: int, size: int) -> Array:
        return self.quantile(u)

    def bounds(self, size: int) -> tuple[Array, Array]:
        with np.errstate(over="ignore"):  # refused by who asks
            low, high = self.quantile(np.array([[LEAST] * size, [1.0 - LEAST] * size]))
        return low, high


@dataclass(frozen=True)
class Normal(Independent):
    """The normal distribution.

    Parameters
    ----------
    mean, sd
        In the unit of what is dispersed: numbers, or vectors (k,) with one for each of its components, which
        are independent; so with all distributions of this file.
    """

    mean: Parameter
    sd: Parameter

    def _check(self) -> None:
        _positive("sd", self.sd)

    def quantile(self, u: Array) -> Array:
        return np.add(self.mean, np.multiply(self.sd, special().ndtri(u)))

    def moments(self) -> tuple[Any, Any]:
        return _full(self.mean, self.sd)


@dataclass(frozen=True)
class TruncatedNormal(Independent):
    """The normal distribution between two bounds, accurate however far out in its tails they lie.

    Parameters
    ----------
    mean, sd
        Before the bounds; `moments` has those between them.
    low, high
        One of them may be infinite.
    """

    mean: Parameter
    sd: Parameter
    low: Parameter
    high: Parameter

    def _check(self) -> None:
        _positive("sd", self.sd)
        _ordered(self.low, self.high)

    def _standard(self) -> tuple[Array, Array]:
        """The bounds in standard deviations from the mean."""
        low, high = (np.subtract(bound, self.mean) / self.sd for bound in (self.low, self.high))
        return low, high

    def quantile(self, u: Array) -> Array:
        sf = special()
        low, high = self._standard()
        # In the lower tail, where logarithms of probabilities tell all: what lies above is turned over.
        over = low + high > 0.0
        near, far = np.where(over, -low, high), np.where(over, -high, low)
        part = np.where(over, 1.0 - u, u)
        top = sf.log_ndtr(near)
        z = sf.ndtri_exp(np.minimum(top + np.log(part + (1.0 - part) * np.exp(sf.log_ndtr(far) - top)), 0.0))
        x = np.add(self.mean, np.multiply(self.sd, np.where(over, -z, z)))
        return np.clip(x, self.low, self.high)

    def moments(self) -> tuple[Any, Any]:
        from scipy.stats import truncnorm  # noqa: PLC0415  (slow to load)

        low, high = self._standard()
        mean, variance = truncnorm.stats(low, high, loc=self.mean, scale=self.sd, moments="mv")
        return mean[()], np.sqrt(variance)[()]


@dataclass(frozen=True)
class Uniform(Independent):
    """Every value between two bounds alike."""

    low: Parameter
    high: Parameter

    def _check(self) -> None:
        _finite("low", self.low)
        _finite("high", self.high)
        _ordered(self.low, self.high)

    def quantile(self, u: Array) -> Array:
        # As a mean of the two: bounds of opposite signs at the edge of doubles have no difference.
        return np.clip(np.multiply(self.low, 1.0 - u) + np.multiply(self.high, u), self.low, self.high)

    def moments(self) -> tuple[Any, Any]:
        low, high = _full(self.low, self.high)
        return (low + high) / 2.0, (high - low) / np.sqrt(12.0)


@dataclass(frozen=True)
class LogNormal(Independent):
    """Positive values whose logarithm is normal.

    Parameters
    ----------
    median, sigma
        Draws are median exp(sigma z) with z standard normal; sigma 0.1 is about ten percent.
    """

    median: Parameter
    sigma: Parameter

    def _check(self) -> None:
        _positive("median", self.median)
        _positive("sigma", self.sigma)

    def quantile(self, u: Array) -> Array:
        return np.multiply(self.median, np.exp(np.multiply(self.sigma, special().ndtri(u))))

    def moments(self) -> tuple[Any, Any]:
        median, sigma = _full(self.median, self.sigma)
        mean = median * np.exp(sigma**2 / 2.0)
        return mean, mean * np.sqrt(np.expm1(sigma**2))


def _parameter(name: str, value: Parameter) -> float | tuple[float, ...]:
    """A number, or a vector as a tuple, so that distributions compare, hash and print."""
    infinite = name in ("low", "high")
    array = _check.numbers(name, value, *_shape(name, value))
    if np.isnan(array).any() or not (infinite or np.isfinite(array).all()):
        raise InputError(f"{name}: got {_check.shown(value)}; every number must be finite")
    return float(array) if array.ndim == 0 else tuple(array.tolist())


def _shape(name: str, value: Parameter) -> tuple[int, ...]:
    try:
        shape = np.shape(value)
    except Exception:  # told by the check of the numbers
        shape = ()
    if len(shape) > 1 or shape == (0,):
        raise InputError(f"{name}: got shape {shape}; give one number, or a vector (k,)")
    return shape


def _full(*parameters: Parameter) -> tuple[Any, ...]:
    """Parameters of one shape."""
    return tuple(array[()] for array in np.broadcast_arrays(*map(np.asarray, parameters)))


def _positive(name: str, value: Parameter) -> None:
    if not np.all(np.greater(value, 0.0)):
        raise InputError(f"{name}: got {value}; it must be positive; leave out what is not dispersed")


def _finite(name: str, value: Parameter) -> None:
    if not np.isfinite(value).all():
        raise InputError(f"{name}: got {value}; every number must be finite")


def _ordered(low: Parameter, high: Parameter) -> None:
    if not np.all(np.less(low, high)):
        raise InputError(f"low, high: got {low} and {high}; low must lie below high")
