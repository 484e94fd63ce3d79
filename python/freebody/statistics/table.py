"""A table for people and for programs."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

__all__ = ["Cell", "ResultTable"]

Cell: TypeAlias = str | int | float | None


@dataclass(frozen=True)
class ResultTable:
    """Rows under headings. `str()` shows numbers by `format`, `to_rows()` gives them in full."""

    title: str
    headings: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    notes: tuple[str, ...] = ()
    format: str = ".6g"

    def to_rows(self) -> list[dict[str, Cell]]:
        """One dictionary a row, by heading: what `pandas.DataFrame` takes."""
        return [dict(zip(self.headings, row, strict=True)) for row in self.rows]

    def save(self, path: Path) -> None:
        """Writes a CSV file, 17 digits; what is not there is empty."""
        with path.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(self.headings)
            writer.writerows(["" if cell is None else cell for cell in row] for row in self.rows)

    def lines(self) -> list[str]:
        """Headings and rows in columns, numbers to the right; a dash where there is nothing."""
        cells = [list(self.headings), *([self._text(cell) for cell in row] for row in self.rows)]
        widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
        right = [
            any(isinstance(cell, int | float) for cell in column) for column in zip(*self.rows, strict=True)
        ]
        right = right or [False] * len(widths)
        return [
            "  ".join(
                cell.rjust(width) if number else cell.ljust(width)
                for cell, width, number in zip(row, widths, right, strict=True)
            ).rstrip()
            for row in cells
        ]

    def __str__(self) -> str:
        headings, *rows = self.lines()
        rule = "-" * max(map(len, (headings, *rows)))
        return "\n".join([self.title, headings, rule, *rows, *self.notes])

    def _text(self, cell: Cell) -> str:
        if cell is None:
            return "–"
        return format(cell, self.format) if isinstance(cell, float) else str(cell)
