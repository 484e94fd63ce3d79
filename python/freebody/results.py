"""Stores a run: netCDF (the default) or CSV.

netCDF is the default: it keeps names, units, axes and the model file's text with the numbers, and MATLAB,
Julia, R and Python read it (netCDF-4 is HDF5).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike

from freebody._check import Array
from freebody.errors import InputError
from freebody.simulation import Trajectory

__all__ = ["check_suffix", "save", "to_dataset"]

AXES = ("axis", ("x", "y", "z"))
QUATERNION = ("quaternion_component", ("w", "x", "y", "z"))


class Variable(NamedTuple):
    """An array over time: its dimension and labels, or None for a scalar, its unit and its meaning."""

    name: str
    values: Array
    components: tuple[str, tuple[str, ...]] | None
    unit: str
    meaning: str


def to_dataset(
    run: Trajectory,
    *,
    points: Mapping[str, ArrayLike] | None = None,
    attributes: Mapping[str, str] | None = None,
) -> xr.Dataset:
    """The run as labelled arrays over `time`, SI and radians.

    `points` names material points (body axes, from o1) whose paths are added as `point_<name>`; `attributes`
    are added to the dataset's own.
    """
    dataset = xr.Dataset(coords={"time": ("time", run.t, {"units": "s", "long_name": "time"})})
    for variable in _variables(run, points or {}):
        _add(dataset, variable)
    for name, value in run.outputs.items():
        unit = run.output_units[name]
        dataset[f"output_{name}"] = ((), value, {"units": unit, "long_name": f"output {name}"})
    if run.events:
        _add_events(dataset, run)
    dataset.attrs = {
        **(attributes or {}),
        "outcome": run.outcome.status,
        "outcome_message": run.outcome.message,
        "steps": run.steps,
        "rejected_steps": run.rejected_steps,
        "evaluations": run.evaluations,
        "chart_changes": "; ".join(
            f"{change.time:.9g} s: {change.from_chart} to {change.to_chart}" for change in run.chart_changes
        ),
    }
    return dataset


def _variables(run: Trajectory, points: Mapping[str, ArrayLike]) -> Iterator[Variable]:
    linear, angular = run.momentum_world[:, :3], run.momentum_world[:, 3:]
    for row in (
        ("position_world", run.position_world, AXES, "m", "position of the origin o1, world axes"),
        ("velocity_world", run.velocity_world, AXES, "m s-1", "velocity of the origin o1, world axes"),
        ("velocity_body", run.velocity_body, AXES, "m s-1", "velocity of the origin o1, body axes"),
        ("com_position_world", run.com_position_world, AXES, "m", "position of the mass centre, world axes"),
        (
            "com_velocity_world",
            run.com_velocity_world,
            AXES,
            "m s-1",
            "velocity of the mass centre, world axes",
        ),
        ("quaternion", run.quaternion, QUATERNION, "1", "attitude, world from body, scalar first"),
        ("angular_velocity_body", run.angular_velocity_body, AXES, "rad s-1", "angular velocity, body axes"),
        (
            "angular_velocity_world",
            run.angular_velocity_world,
            AXES,
            "rad s-1",
            "angular velocity, world axes",
        ),
        ("linear_momentum_world", linear, AXES, "kg m s-1", "momentum, world axes"),
        (
            "angular_momentum_world",
            angular,
            AXES,
            "kg m2 s-1",
            "its moment about the world origin, world axes",
        ),
        ("kinetic_energy", run.kinetic_energy, None, "J", "kinetic energy"),
        ("potential_energy", run.potential_energy, None, "J", "potential energy of the forces that have one"),
        ("energy", run.energy, None, "J", "kinetic plus potential energy"),
    ):
        yield Variable(*row)
    sequence = "zyx" if run.model.attitude == "quaternion" else run.model.attitude
    components = (f"angle_{sequence}", tuple(f"{i}_{axis}" for i, axis in enumerate(sequence, 1)))
    meaning = f"attitude as intrinsic angles of the sequence {sequence}, world from body"
    yield Variable("angles", run.angles(sequence), components, "rad", meaning)
    if np.any(run.u):
        for name, values, unit in zip(run.model.input_names, run.u.T, run.model.input_units, strict=True):
            yield Variable(f"input_{name}", values, None, unit, f"input {name} of the model")
    for name, unit in zip(run.model.command_names, run.model.command_units, strict=True):
        yield Variable(f"command_{name}", run.commands[name], None, unit, f"input {name}, by the control law")
    for name, values in run.states.items():
        unit = run.state_units[run.state_names.index(name)]
        yield Variable(f"state_{name}", values, None, unit, f"auxiliary state {name}")
    for name, at in points.items():
        place = ", ".join(f"{value:g}" for value in np.asarray(at, dtype=float))
        meaning = f"path of the body's point ({place}) m, world axes"
        yield Variable(f"point_{name}", run.point(at), AXES, "m", meaning)


def _add(dataset: xr.Dataset, variable: Variable) -> None:
    dims: tuple[str, ...] = ("time",)
    if variable.components is not None:
        dimension, labels = variable.components
        dims = ("time", dimension)
        dataset.coords[dimension] = list(labels)
    dataset[variable.name] = (dims, variable.values, {"units": variable.unit, "long_name": variable.meaning})


def _add_events(dataset: xr.Dataset, run: Trajectory) -> None:
    dataset.coords["event"] = ("occurrence", [event.name for event in run.events])
    dataset.coords["state"] = list(run.state_names)
    dataset.coords["state_unit"] = ("state", list(run.state_units))
    times, states = [event.time for event in run.events], [event.state for event in run.events]
    dataset["event_time"] = ("occurrence", times, {"units": "s", "long_name": "time of the event"})
    meaning = {"units": "those of state_unit", "long_name": "state at the event"}
    dataset["event_state"] = (("occurrence", "state"), states, meaning)


def save(dataset: xr.Dataset, path: Path) -> None:
    """Writes to `path` as its suffix says, at once or not at all. Raises `InputError` for another suffix."""
    check_suffix(path)
    unfinished = path.with_name(f".{path.name}.unfinished")
    try:
        WRITERS[path.suffix](dataset, unfinished)
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def check_suffix(path: Path) -> None:
    """Raises `InputError` for a suffix that no data format has."""
    if path.suffix not in WRITERS:
        raise InputError(
            f"{path}: the suffix says the data format: {' or '.join(WRITERS)}; came {path.suffix!r}"
        )


def _write_netcdf(dataset: xr.Dataset, path: Path) -> None:
    dataset.to_netcdf(path, engine="h5netcdf")


def _write_csv(dataset: xr.Dataset, path: Path) -> None:
    """A column for each component over time, `name_component [unit]`, 17 digits."""
    headings, columns = ["time [s]"], [dataset["time"].values]
    for name, variable in dataset.data_vars.items():
        if "time" not in variable.dims:
            continue
        unit = variable.attrs["units"]
        if variable.ndim == 1:
            headings.append(f"{name} [{unit}]")
            columns.append(variable.values)
            continue
        labels = dataset[variable.dims[1]].values
        headings += [f"{name}_{label} [{unit}]" for label in labels]
        columns += list(variable.values.T)
    np.savetxt(
        path, np.column_stack(columns), fmt="%.17g", delimiter=",", header=",".join(headings), comments=""
    )


WRITERS: Mapping[str, Callable[[xr.Dataset, Path], None]] = {".nc": _write_netcdf, ".csv": _write_csv}
