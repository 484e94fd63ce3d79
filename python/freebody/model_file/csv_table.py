"""The table of a tabulated wrench from a CSV file: columns by name, units in brackets."""

from __future__ import annotations

import csv
import re

import numpy as np
from numpy.typing import NDArray

from .fields import did_you_mean
from .problems import Source
from .units import FieldError, to_si

__all__ = ["read_table"]

_UNITS = {"time": "s"}
_UNITS |= {f"{kind}_{axis}": unit for kind, unit in (("force", "N"), ("moment", "N m")) for axis in "xyz"}
_HEADING = re.compile(r"\s*(\w+)\s*(?:\[(.*)\])?\s*")


def read_table(name: str, key: str, source: Source) -> dict[str, NDArray[np.float64]]:
    """times, force and moment in SI from the CSV file `name`, taken relative to the model file.

    Columns are `time` and any of `force_x` ... `moment_z`, each with a unit if it is not SI: `time [h]`.
    A column that is missing is zero. Raises `ModelFileError` at `key`.
    """
    path = source.path.parent / name
    try:
        with path.open(newline="", encoding="utf-8") as stream:
            headings, *rows = [row for row in csv.reader(stream) if row]
        columns = np.array(rows, dtype=float).reshape(-1, len(headings)).T
    except OSError as error:
        raise source.error(key, f"cannot read {path}: {error.strerror}") from None
    except ValueError as error:
        raise source.error(key, f"{path} is no table of numbers under a line of headings: {error}") from None
    if not rows:
        raise source.error(key, f"{path} has headings but no rows")
    table = {}
    for heading, column in zip(headings, columns, strict=True):
        match = _HEADING.fullmatch(heading)
        if match is None or match[1] not in _UNITS:
            raise source.error(key, f"{path}: unknown column {heading!r}{did_you_mean(heading, _UNITS)}")
        try:
            table[match[1]] = column * to_si(f"1 {match[2] or _UNITS[match[1]]}", _UNITS[match[1]], ())
        except FieldError as error:
            raise source.error(key, f"{path}: column {heading!r}: {error}") from None
    if "time" not in table:
        raise source.error(key, f"{path} has no column 'time'")
    zero = np.zeros_like(table["time"])
    wrench = {
        kind: np.column_stack([table.get(f"{kind}_{axis}", zero) for axis in "xyz"])
        for kind in ("force", "moment")
    }
    return {"times": table["time"], **wrench}
