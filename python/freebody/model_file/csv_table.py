"""Columns of a CSV file beside the model file, by the names and units of their headings."""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping

import numpy as np

from freebody._check import Array

from .fields import did_you_mean
from .problems import Source
from .units import FieldError, to_si

__all__ = ["read_columns", "read_wrench"]

_WRENCH = {"time": "s"}
_WRENCH |= {f"{kind}_{axis}": unit for kind, unit in (("force", "N"), ("moment", "N m")) for axis in "xyz"}
_HEADING = re.compile(r"\s*(\w+)\s*(?:\[(.*)\])?\s*")


def read_columns(
    name: str, key: str, source: Source, units: Mapping[str, str], needed: tuple[str, ...]
) -> dict[str, Array]:
    """The columns in SI, of the file `name`, taken relative to the model file.

    `units` has the columns that there may be with their units of SI; a heading may have another,
    `altitude [ft]`. Raises `ModelFileError` at `key`.
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
    found = {}
    for heading, column in zip(headings, columns, strict=True):
        match = _HEADING.fullmatch(heading)
        if match is None or match[1] not in units:
            raise source.error(key, f"{path}: unknown column {heading!r}{did_you_mean(heading, units)}")
        try:
            found[match[1]] = column * to_si(f"1 {match[2]}", units[match[1]], ()) if match[2] else column
        except FieldError as error:
            raise source.error(key, f"{path}: column {heading!r}: {error}") from None
    for wanted in needed:
        if wanted not in found:
            raise source.error(key, f"{path} has no column {wanted!r}")
    return found


def read_wrench(name: str, key: str, source: Source) -> dict[str, Array]:
    """times, force and moment: of `force_x` ... `moment_z` those that are missing are zero."""
    table = read_columns(name, key, source, _WRENCH, ("time",))
    zero = np.zeros_like(table["time"])
    wrench = {
        kind: np.column_stack([table.get(f"{kind}_{axis}", zero) for axis in "xyz"])
        for kind in ("force", "moment")
    }
    return {"times": table["time"], **wrench}
