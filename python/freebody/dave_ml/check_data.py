"""The residuals of a model against the check data of its own file."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass

__all__ = ["CheckData", "CheckRow"]


@dataclass(frozen=True)
class CheckRow:
    """One value of one check case, in the units of the variable.

    Attributes
    ----------
    kind
        "output", or "internal" for a value in between, which files give to look for faults.
    tolerance
        The largest residual that the file allows, or None where it says none.
    """

    shot: str
    kind: str
    variable: str
    units: str
    expected: float
    got: float
    tolerance: float | None

    @property
    def residual(self) -> float:
        """The size of the difference."""
        return abs(self.got - self.expected)

    @property
    def ok(self) -> bool:
        """Whether the residual is within the tolerance, or finite where there is none."""
        return self.residual <= (sys.float_info.max if self.tolerance is None else self.tolerance)


@dataclass(frozen=True)
class CheckData:
    """The rows of all check cases; prints as a table of the largest residual of each variable."""

    rows: tuple[CheckRow, ...]

    @property
    def ok(self) -> bool:
        """Whether there are check data, and all are within their tolerances."""
        return bool(self.rows) and not self.failures

    @property
    def failures(self) -> tuple[CheckRow, ...]:
        """The rows beyond their tolerances."""
        return tuple(row for row in self.rows if not row.ok)

    def __iter__(self) -> Iterator[CheckRow]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    def __str__(self) -> str:
        if not self.rows:
            return "no check data"
        groups: dict[tuple[str, str], list[CheckRow]] = {}
        for row in self.rows:
            groups.setdefault((row.kind, row.variable), []).append(row)
        lines = [("kind", "variable", "cases", "largest residual", "tolerance", "")]
        for (kind, variable), rows in groups.items():
            worst = max(rows, key=lambda row: (not row.ok, row.residual))
            allowed = "-" if worst.tolerance is None else f"{worst.tolerance:.3g}"
            verdict = "ok" if all(row.ok for row in rows) else f"FAILS in {worst.shot!r}"
            lines.append(
                (kind, variable, str(len(rows)), f"{worst.residual:.3g} {worst.units}", allowed, verdict)
            )
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        return "\n".join(
            "  ".join(c.ljust(w) for c, w in zip(line, widths, strict=True)).rstrip() for line in lines
        )
