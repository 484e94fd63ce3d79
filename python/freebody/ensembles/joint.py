"""Distributions of several numbers at once: correlated, chosen from a list, or read from a file."""

from __future__ import annotations

import csv
import difflib
import hashlib
from collections.abc import Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.ensembles.distributions import LEAST, Distribution, special
from freebody.errors import InputError

__all__ = ["Discrete", "FromFile", "MultivariateNormal", "Samples"]


class MultivariateNormal(Distribution):
    """Normal numbers with a covariance.

    Parameters
    ----------
    mean
        (k,).
    covariance
        (k, k), symmetric; it may be singular, not negative.
    """

    def __init__(self, mean: ArrayLike, covariance: ArrayLike) -> None:
        self.mean = _check.series("mean", mean)
        self.size = k = len(self.mean)
        self.covariance = _check.vector("covariance", covariance, k, k)
        self._factor = _root(self.covariance)

    def dimensions(self, size: int) -> int:
        return len(self.mean)

    def draw(self, u: Array, first: int, size: int) -> Array:
        z = special().ndtri(u)
        # Column by column: a product of matrices may round a run in company as it does not alone.
        x = np.tile(self.mean, (len(u), 1))
        for column, weights in zip(z.T, self._factor.T, strict=True):
            x += column[:, None] * weights
        return x

    def bounds(self, size: int) -> tuple[Array, Array]:
        reach = np.abs(self._factor).sum(axis=1) * -special().ndtri(LEAST)
        return self.mean - reach, self.mean + reach

    def moments(self) -> tuple[Any, Any]:
        return self.mean, np.sqrt(np.diag(self.covariance))

    def __repr__(self) -> str:
        return f"MultivariateNormal(mean={self.mean.tolist()}, covariance={self.covariance.tolist()})"


class Discrete(Distribution):
    """One of several values.

    Parameters
    ----------
    values
        (m,) numbers, or (m, k) vectors that stay together.
    weights
        (m,) not negative, in any proportion; alike when omitted.
    """

    def __init__(self, values: ArrayLike, weights: ArrayLike | None = None) -> None:
        self.values = _check.series("values", values) if np.ndim(values) < 2 else _table(values)
        self.size = self.values.shape[1] if self.values.ndim == 2 else None
        m = len(self.values)
        self.weights = _check.vector("weights", np.ones(m) if weights is None else weights, m)
        if (self.weights < 0.0).any() or not self.weights.any():
            raise InputError(
                f"weights: got {_check.shown(weights)}; none may be negative, one must be positive"
            )
        shares = np.cumsum(self.weights / self.weights.max())
        self._shares = shares / shares[-1]

    def dimensions(self, size: int) -> int:
        return size if self.size is None else 1

    def draw(self, u: Array, first: int, size: int) -> Array:
        chosen = np.searchsorted(self._shares, u, side="right")
        return self.values[chosen if self.size is None else chosen[:, 0]]

    def bounds(self, size: int) -> tuple[Array, Array]:
        possible = self.values[self.weights > 0.0]
        low, high = possible.min(axis=0), possible.max(axis=0)
        return np.broadcast_to(low, (size,)), np.broadcast_to(high, (size,))

    def moments(self) -> tuple[Any, Any]:
        shares = self.weights / self.weights.sum()
        mean = shares @ self.values
        return mean, np.sqrt(shares @ (self.values - mean) ** 2)

    def __repr__(self) -> str:
        return f"Discrete(values={self.values.tolist()}, weights={self.weights.tolist()})"


class Samples(Distribution):
    """Values that are given: row r is that of run r.

    Parameters
    ----------
    values
        (rows, k), or (rows,) for one number.
    """

    def __init__(self, values: ArrayLike) -> None:
        self.values = _check.series("values", values)[:, None] if np.ndim(values) < 2 else _table(values)
        self.size = self.values.shape[1]

    def dimensions(self, size: int) -> int:
        return 0

    def draw(self, u: Array, first: int, size: int) -> Array:
        return self.values[first : first + len(u)]

    def bounds(self, size: int) -> tuple[Array, Array]:
        return self.values.min(axis=0), self.values.max(axis=0)

    def moments(self) -> tuple[Any, Any]:
        return self.values.mean(axis=0), self.values.std(axis=0)

    def __repr__(self) -> str:
        return f"Samples({self._content()})"

    def _content(self) -> str:
        """Which values these are, for records of a campaign."""
        digest = hashlib.sha256(np.ascontiguousarray(self.values).tobytes()).hexdigest()
        return f"{' x '.join(map(str, self.values.shape))} values, sha256 {digest[:16]}"


class FromFile(Samples):
    """Values from a CSV file with a line of headings: row r is that of run r.

    Parameters
    ----------
    path
        The file; it is read at once.
    columns
        The heading of each number, one or several.
    """

    def __init__(self, path: str | PathLike[str], columns: str | Sequence[str]) -> None:
        self.path = fspath(path)
        self.columns = (columns,) if isinstance(columns, str) else tuple(columns)
        super().__init__(_read(Path(self.path), self.columns))

    def __repr__(self) -> str:
        return f"FromFile({self.path!r}, {list(self.columns)!r}: {self._content()})"


def _table(values: ArrayLike) -> Array:
    return _check.columns("values", values, len(np.asarray(values)))


def _root(covariance: Array) -> Array:
    """L with L Lᵀ the covariance."""
    largest = np.abs(covariance).max()
    if np.abs(covariance - covariance.T).max() > 1e-9 * largest:
        raise InputError("covariance: it is not symmetric; entries (i, j) and (j, i) must be the same")
    try:
        return np.asarray(np.linalg.cholesky(covariance), np.float64)
    except np.linalg.LinAlgError:
        # The symmetric root, of which there is one; eigenvectors alone may come with either sign.
        values, axes = np.linalg.eigh(covariance)
    if values[0] < -1e-9 * largest:
        raise InputError(
            f"covariance: its least eigenvalue is {values[0]:.6g}; no numbers have a negative variance: "
            "check the signs, and that correlations lie within -1 and 1"
        )
    return (axes * np.sqrt(np.maximum(values, 0.0))) @ axes.T


def _read(path: Path, columns: tuple[str, ...]) -> Array:
    try:
        with path.open(newline="", encoding="utf-8") as stream:
            rows = csv.DictReader(stream)
            headings = [] if rows.fieldnames is None else [h.strip() for h in rows.fieldnames]
            rows.fieldnames = headings
            for column in columns:
                if column not in headings:
                    near = difflib.get_close_matches(str(column), headings, 1)
                    hint = f", did you mean {near[0]!r}?" if near else ""
                    known = ", ".join(map(repr, headings))
                    raise InputError(f"columns: {path} has no {column!r}; it has {known}{hint}")
            table = [_numbers(path, rows.line_num, row, columns) for row in rows]
    except (OSError, UnicodeDecodeError) as fault:
        why = fault.strerror if isinstance(fault, OSError) else "it is no text"
        raise InputError(f"path: cannot read {path}: {why}") from None
    if not table:
        raise InputError(f"path: {path} has no rows under its headings; give one for each run")
    return np.array(table)


def _numbers(path: Path, line: int, row: dict[str, str | None], columns: tuple[str, ...]) -> list[float]:
    numbers = []
    for column in columns:
        try:
            numbers.append(float(row[column] or ""))
        except ValueError:
            raise InputError(f"{path}:{line}: {column}: got {row[column]!r}; give a number") from None
    return numbers
