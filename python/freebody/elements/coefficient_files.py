"""Files of the coefficients of gravity fields."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, NoReturn, TextIO

import numpy as np

from freebody._check import Array
from freebody.errors import InputError

__all__ = ["GravityField", "read_field"]


class GravityField(NamedTuple):
    """What a file says of a gravity field.

    Attributes
    ----------
    mu, radius
        Gravitational parameter, m³/s², and reference radius, m; none where the file does not say.
    C, S
        Fully normalised coefficients (degree + 1, degree + 1) by degree and order.
    """

    mu: float | None
    radius: float | None
    C: Array
    S: Array


def read_field(path: Path, degree: int | None) -> GravityField:
    """The field up to a degree, or whole.

    Raises
    ------
    InputError
        If the file is none that is known, or is damaged; with its line.
    """
    if path.suffix.lower() not in (".gfc", ".csv"):
        raise InputError(f"path: got {path}; give an ICGEM file (.gfc) or a table of n, m, C, S (.csv)")
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            return _Reader(path, degree, file).read(path.suffix.lower() == ".gfc")
    except OSError as fault:
        raise InputError(f"path: cannot read {path} ({fault})") from None


class _Header(NamedTuple):
    """What stands before the coefficients; `plain`: that they are not normalised."""

    mu: float | None
    radius: float | None
    plain: bool


class _Reader:
    """A file under way."""

    def __init__(self, path: Path, degree: int | None, file: TextIO) -> None:
        self.path, self.degree, self.file = path, degree, file
        self.line = 0

    def lines(self) -> Iterator[str]:
        for text in self.file:
            self.line += 1
            if text.strip():
                yield text.strip()

    def fault(self, what: str) -> NoReturn:
        raise InputError(f"{self.path}, line {self.line}: {what}")

    def number(self, text: str) -> float:
        try:
            # Fortran writes D for the exponent.
            value = float(text.replace("D", "e").replace("d", "e"))
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            self.fault(f"got {text!r}; a finite number is wanted")
        return value

    def read(self, icgem: bool) -> GravityField:
        header = self.header() if icgem else _Header(None, None, False)
        found: dict[tuple[int, int], tuple[float, float]] = {}
        for n, m, c, s in self.icgem() if icgem else self.table():
            if (n, m) in found:
                self.fault(f"degree {n}, order {m} comes twice")
            found[n, m] = c, s
        if not found:
            raise InputError(f"{self.path}: holds no coefficients")
        highest = max(n for n, _ in found)
        if self.degree is not None and self.degree > highest:
            raise InputError(f"degree: got {self.degree}; {self.path} ends at {highest}")
        size = (highest if self.degree is None else self.degree) + 1
        C, S = np.zeros((2, size, size))
        C[0, 0] = 1.0
        for (n, m), pair in found.items():
            if n < size:
                C[n, m], S[n, m] = np.divide(pair, _normalisation(n, m)) if header.plain else pair
        S[:, 0] = 0.0  # there is no sine of order zero, whatever some files write there
        return GravityField(header.mu, header.radius, C, S)

    def header(self) -> _Header:
        """The format is described by Barthelmes and Förste, The ICGEM-format (2011)."""
        mu = radius = None
        plain = False
        for text in self.lines():
            match text.split():
                case ["end_of_head", *_]:
                    return _Header(mu, radius, plain)
                case ["earth_gravity_constant" | "gravity_constant", value, *_]:
                    mu = self.number(value)
                case ["radius", value, *_]:
                    radius = self.number(value)
                case ["norm", norm, *_]:
                    if norm not in ("fully_normalized", "unnormalized"):
                        self.fault(f"norm is {norm!r}; known are fully_normalized and unnormalized")
                    plain = norm == "unnormalized"
        raise InputError(f"{self.path}: has no end_of_head; an ICGEM file is wanted")

    def icgem(self) -> Iterator[tuple[int, int, float, float]]:
        for text in self.lines():
            key, *values = text.split()
            if key != "gfc":
                self.fault(f"got {key!r}; known is gfc: coefficients that vary with time are not")
            yield self.row(values)

    def table(self) -> Iterator[tuple[int, int, float, float]]:
        headed = False
        for text in self.lines():
            values = [part.strip() for part in text.split(",")]
            if text.startswith("#"):
                continue
            if not headed and [v.lower() for v in values[:4]] == ["n", "m", "c", "s"]:
                headed = True
                continue
            headed = True
            yield self.row(values)

    def row(self, values: list[str]) -> tuple[int, int, float, float]:
        if len(values) < 4:
            self.fault("degree, order, C and S are wanted")
        if not (values[0].isdecimal() and values[1].isdecimal() and int(values[1]) <= int(values[0])):
            self.fault(
                f"got degree {values[0]}, order {values[1]}; whole numbers 0 ≤ order ≤ degree are wanted"
            )
        return int(values[0]), int(values[1]), self.number(values[2]), self.number(values[3])


def _normalisation(n: int, m: int) -> float:
    """What fully normalised functions are of plain ones."""
    factorials = math.lgamma(n - m + 1) - math.lgamma(n + m + 1)
    return math.sqrt((1.0 if m == 0 else 2.0) * (2 * n + 1)) * math.exp(0.5 * factorials)
