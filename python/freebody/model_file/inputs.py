"""From [inputs] to what the model reads: constants, and tables over time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from freebody._check import Array
from freebody.model import Model
from freebody.simulation import InputTable

from .fields import Choice, did_you_mean
from .problems import Source
from .units import FieldError, to_si

__all__ = ["build_inputs"]

_KEYS = ("times", "values", "interpolation")


class _Course(NamedTuple):
    """An input over time: straight lines between points; a time that stands twice is a jump."""

    times: Array
    values: Array

    def sides(self, t: float) -> tuple[float, float]:
        """The values just before and just behind a time."""
        first, behind = np.searchsorted(self.times, t, "left"), np.searchsorted(self.times, t, "right")
        if first == behind:
            value = float(np.interp(t, self.times, self.values))
            return value, value
        return float(self.values[first]), float(self.values[behind - 1])


def build_inputs(
    given: Mapping[str, Any], model: Model, source: Source, section: str = "inputs"
) -> Array | InputTable | None:
    """The inputs in the model's order and units; None where the file gives none.

    Raises `ModelFileError` at the key of an input that the model has not, or that is no number or table.
    """
    if not given:
        return None
    units = dict(zip(model.input_names, model.input_units, strict=True))
    courses: dict[str, _Course] = {}
    for name, value in given.items():
        key = f"{section}.{name}"
        if name not in units:
            hint = did_you_mean(name, units) if units else "; it has none"
            raise source.error(key, f"the model has no input {name!r}{hint}")
        courses[name] = _course(value, "" if units[name] == "1" else units[name], key, source)
    if all(len(course.times) == 1 for course in courses.values()):
        return np.array([courses[n].values[0] if n in courses else 0.0 for n in units])
    zero = _Course(np.zeros(1), np.zeros(1))
    every = [courses.get(name, zero) for name in units]
    tables = [course.times for course in every if len(course.times) > 1]
    times, rows = [], []
    for t in np.unique(np.concatenate(tables)):
        before, behind = zip(*(course.sides(t) for course in every), strict=True)
        for row in (before,) if before == behind else (before, behind):
            times.append(t)
            rows.append(row)
    with source.blame(section):
        return InputTable(times, rows)


def _course(value: Any, unit: str, key: str, source: Source) -> _Course:
    if not isinstance(value, dict):
        return _Course(np.zeros(1), np.atleast_1d(_numbers(value, unit, key, source)))
    for name in value:
        if name not in _KEYS:
            raise source.error(f"{key}.{name}", f"unknown key{did_you_mean(name, _KEYS)}")
    for name in _KEYS[:2]:
        if name not in value:
            raise source.error(key, f"needs a number, or a table with times and values; {name} is missing")
    times = _numbers(value["times"], "s", f"{key}.times", source, None)
    values = _numbers(value["values"], unit, f"{key}.values", source, None)
    kind = value.get("interpolation", "linear")
    try:
        Choice("linear", "hold").read(kind)
    except FieldError as error:
        raise source.error(f"{key}.interpolation", str(error)) from None
    if len(times) != len(values):
        raise source.error(key, f"needs as many values as times; came {len(values)} and {len(times)}")
    if np.any(np.diff(times) < 0.0) or np.any(times[2:] == times[:-2]):
        raise source.error(f"{key}.times", "must rise; a time that stands twice makes a jump")
    if kind == "hold":
        times, values = np.repeat(times, 2)[1:], np.repeat(values, 2)[:-1]
    return _Course(times, values)


def _numbers(value: Any, unit: str, key: str, source: Source, *shape: int | None) -> Any:
    try:
        return to_si(value, unit, shape)
    except FieldError as error:
        at = "".join(f"[{part}]" for part in error.at)
        raise source.error(f"{key}{at}", str(error)) from None
