"""Aerodynamic coefficients of a model file: numbers with units, tables inline or from CSV files, sums."""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping
from itertools import product
from typing import Any

import numpy as np

from freebody._check import Array
from freebody.elements import Lookup
from freebody.tables import Table

from .fields import did_you_mean
from .problems import Source
from .units import FieldError, to_si

__all__ = ["read_all", "read_slope"]

_UNITS = {"alpha": "rad", "beta": "rad", "altitude": "m", "airspeed": "m/s"}
_KEYS = ("of", "points", "values", "csv", "column", "interpolation", "extrapolate")
_HEADING = re.compile(r"\s*(\w+)\s*(?:\[(.*)\])?\s*")


def read_all(
    given: Mapping[str, Any], controls: Mapping[str, str], key: str, source: Source
) -> dict[str, Any]:
    """The coefficients as `Aerodynamics` takes them, SI. Raises `ModelFileError` at the key that is wrong."""
    units = _UNITS | {name: "" if unit == "1" else unit for name, unit in controls.items()}
    found: dict[str, Any] = {}
    for name, what in given.items():
        where = f"{key}.{name}"
        if isinstance(what, dict) and "of" not in what:
            found[name] = {
                term: read_slope(slope, _unit_of_slope(term, units), units, f"{where}.{term}", source)
                for term, slope in what.items()
            }
        else:
            found[name] = read_slope(what, "", units, where, source)
    return found


def read_slope(value: Any, unit: str, units: Mapping[str, str], key: str, source: Source) -> Any:
    """A number in `unit`, a table, or a list of such."""
    if isinstance(value, list):
        return [read_slope(item, unit, units, f"{key}[{i}]", source) for i, item in enumerate(value)]
    if isinstance(value, dict):
        return _table(value, units, key, source)
    return float(_numbers(value, unit, key, source))


def _unit_of_slope(term: str, units: Mapping[str, str]) -> str:
    """One over the units of a product of variables; that it can be read is checked by the element."""
    factors = [word.partition("^") for word in term.split()]
    known = [units[name] + (f"^{power}" if power else "") for name, _, power in factors if units.get(name)]
    if not known:
        return ""
    return f"1/{known[0]}" if known == [units["alpha"]] else f"1/({' '.join(known)})"


def _table(given: Mapping[str, Any], units: Mapping[str, str], key: str, source: Source) -> Lookup:
    for name in given:
        if name not in _KEYS:
            raise source.error(f"{key}.{name}", f"unknown key{did_you_mean(name, _KEYS)}")
    of = given.get("of")
    if not isinstance(of, list) or not of or not all(isinstance(name, str) for name in of):
        raise source.error(f"{key}.of", 'needs the names of the variables: of = ["alpha", "mach"]')
    if "csv" in given:
        for name in ("points", "values"):
            if name in given:
                raise source.error(f"{key}.{name}", "the csv has them; leave them out")
        points, values = _from_csv(given, of, units, f"{key}.csv", source)
    else:
        points, values = _inline(given, of, units, key, source)
    extrapolate = given.get("extrapolate", False)
    if not isinstance(extrapolate, bool):
        raise source.error(f"{key}.extrapolate", f"needs true or false; came {extrapolate!r}")
    with source.blame(key):
        axes = tuple(points) if len(points) > 1 else points[0]
        table = Table(axes, values, given.get("interpolation", "linear"))
        return Lookup(table, *of, extrapolate=extrapolate)


def _inline(
    given: Mapping[str, Any], of: list[str], units: Mapping[str, str], key: str, source: Source
) -> tuple[list[Array], Array]:
    for name in ("points", "values"):
        if name not in given:
            raise source.error(key, f"a table needs of, points and values, or of and csv; {name} is missing")
    lists = given["points"]
    if not isinstance(lists, list) or len(lists) != len(of):
        raise source.error(f"{key}.points", f"needs {len(of)} lists, one for each of {', '.join(of)}")
    points = [
        _numbers(axis, units.get(name, ""), f"{key}.points[{i}]", source, None)
        for i, (name, axis) in enumerate(zip(of, lists, strict=True))
    ]
    return points, _numbers(given["values"], "", f"{key}.values", source, *map(len, points))


def _from_csv(
    given: Mapping[str, Any], of: list[str], units: Mapping[str, str], key: str, source: Source
) -> tuple[list[Array], Array]:
    """A line for each point of the grid, in any order: the variables, and the value in `column`."""
    path = source.path.parent / str(given["csv"])
    column = given.get("column", "value")
    try:
        with path.open(newline="", encoding="utf-8") as stream:
            headings, *rows = [row for row in csv.reader(stream) if row]
        data = np.array(rows, dtype=float).reshape(-1, len(headings))
    except OSError as error:
        raise source.error(key, f"cannot read {path}: {error.strerror}") from None
    except ValueError as error:
        raise source.error(key, f"{path} is no table of numbers under a line of headings: {error}") from None
    columns: dict[str, Array] = {}
    for heading, numbers in zip(headings, data.T, strict=True):
        match = _HEADING.fullmatch(heading)
        if match is not None:
            unit = units.get(match[1], "")
            columns[match[1]] = numbers * _numbers(f"1 {match[2]}" if match[2] else 1.0, unit, key, source)
    for name in (*of, column):
        if name not in columns:
            raise source.error(key, f"{path} has no column {name!r}{did_you_mean(name, columns)}")
    points = [np.unique(columns[name]) for name in of]
    places = [np.searchsorted(axis, columns[name]) for axis, name in zip(points, of, strict=True)]
    values = np.full([len(axis) for axis in points], np.nan)
    values[tuple(places)] = columns[column]
    missing = [p for p in product(*map(range, values.shape)) if np.isnan(values[p])]
    if missing or len(data) != values.size:
        raise source.error(
            key,
            f"{path} needs one line for each of {' x '.join(map(str, values.shape))} points; has {len(data)}",
        )
    return points, values


def _numbers(value: Any, unit: str, key: str, source: Source, *shape: int | None) -> Any:
    try:
        return to_si(value, unit, shape)
    except FieldError as error:
        at = "".join(f"[{part}]" for part in error.at)
        raise source.error(f"{key}{at}", str(error)) from None
