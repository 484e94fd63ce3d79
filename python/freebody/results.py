"""Stores a run: netCDF (the default) or CSV.

netCDF is the default: it keeps names, units, axes and the model file's text with the numbers, and MATLAB,
Julia, R and Python read it (netCDF-4 is HDF5).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike

from freebody._check import Array
from freebody.environment import Track
from freebody.errors import InputError
from freebody.model import Model
from freebody.simulation import StagedTrajectory, Trajectory, stages_of

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
    run: Trajectory | StagedTrajectory,
    *,
    points: Mapping[str, ArrayLike] | None = None,
    tracks: Sequence[Mapping[str, Track]] | None = None,
    attributes: Mapping[str, str] | None = None,
) -> xr.Dataset:
    """The run as labelled arrays over `time`, SI and radians.

    `points` names material points (body axes, from o1) whose paths are added as `point_<name>`, `tracks`
    those that a planet sees, as `<name>_altitude` and so on, a mapping for each stage; `attributes` are
    added to the dataset's own. A run in stages is one dataset, in which `stage` says which one it was; what
    only some stages have is NaN in the others.
    """
    dataset = xr.Dataset(coords={"time": ("time", run.t, {"units": "s", "long_name": "time"})})
    stages = stages_of(run)
    seen = tracks or [{}] * len(stages)
    rows = [
        [*_variables(stage, points or {}, isinstance(run, StagedTrajectory)), *_seen(own)]
        for stage, own in zip(stages, seen, strict=True)
    ]
    for variable in rows[0] if len(rows) == 1 else _joined(rows):
        _add(dataset, variable)
    for stage in stages:
        for name, value in stage.outputs.items():
            unit = stage.output_units[name]
            dataset[f"output_{name}"] = ((), value, {"units": unit, "long_name": f"output {name}"})
    if run.events:
        _add_events(dataset, run)
    if isinstance(run, StagedTrajectory):
        _add_stages(dataset, run)
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


def _seen(tracks: Mapping[str, Track]) -> Iterator[Variable]:
    for name, track in tracks.items():
        for row in track.rows():
            yield Variable(f"{name}_{row.name}", *row[1:])


def _joined(rows: list[list[Variable]]) -> Iterator[Variable]:
    """The variables of all stages one after another."""
    lengths = [len(own[0].values) for own in rows]
    found = [{variable.name: variable for variable in own} for own in rows]
    for name, first in {name: variable for own in reversed(found) for name, variable in own.items()}.items():
        gap = [np.full((n, *first.values.shape[1:]), np.nan) for n in lengths]
        parts = [own[name].values if name in own else gap[i] for i, own in enumerate(found)]
        yield first._replace(values=np.concatenate(parts))


def _variables(run: Trajectory, points: Mapping[str, ArrayLike], staged: bool) -> Iterator[Variable]:
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
    if staged or np.any(run.mass != run.mass[:1]):
        yield Variable("mass", run.mass, None, "kg", "mass of the body with what it carries")
        yield Variable("com", run.com, AXES, "m", "its mass centre from o1, body axes")
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


def _add_events(dataset: xr.Dataset, run: Trajectory | StagedTrajectory) -> None:
    seen = [(event, stage.model) for stage in stages_of(run) for event in stage.events]
    _add_state_labels(dataset, run)
    dataset.coords["event"] = ("occurrence", [event.name for event, _ in seen])
    times = [event.time for event, _ in seen]
    dataset["event_time"] = ("occurrence", times, {"units": "s", "long_name": "time of the event"})
    states = [_labelled(dataset, model, event.state) for event, model in seen]
    _add_states(dataset, "event_state", "occurrence", states, "state at the event")


def _add_stages(dataset: xr.Dataset, run: StagedTrajectory) -> None:
    """Which stage it was, as a flag of the CF conventions, and the states at the separations."""
    number = np.concatenate([np.full(len(stage), i) for i, stage in enumerate(run.stages, 1)])
    names = [stage.model.name for stage in run.stages]
    meaning = "; ".join(f"{i}: {name}" for i, name in enumerate(names, 1))
    words = " ".join("_".join(name.split()) for name in names)
    flags = {"flag_values": np.arange(1, len(names) + 1), "flag_meanings": words}
    dataset["stage"] = ("time", number, {"units": "1", "long_name": f"stage, {meaning}", **flags})
    if not run.separations:
        return
    _add_state_labels(dataset, run)
    times = [separation.time for separation in run.separations]
    dataset["separation_time"] = ("separation", times, {"units": "s", "long_name": "end of a stage"})
    for what, model in (("before", "stage that ends"), ("after", "stage that begins")):
        states = [
            _labelled(dataset, getattr(separation, f"model_{what}"), getattr(separation, what))
            for separation in run.separations
        ]
        _add_states(dataset, f"separation_{what}", "separation", states, f"state of the {model}")


def _add_state_labels(dataset: xr.Dataset, run: Trajectory | StagedTrajectory) -> None:
    units = {
        name: unit
        for stage in stages_of(run)
        for name, unit in zip(stage.state_names, stage.state_units, strict=True)
    }
    dataset.coords["state"] = list(units)
    dataset.coords["state_unit"] = ("state", list(units.values()))


def _labelled(dataset: xr.Dataset, model: Model, x: Array) -> Array:
    """A state of one stage among the names of all."""
    own = dict(zip(model.state_names, x, strict=True))
    return np.array([own.get(name, np.nan) for name in dataset.coords["state"].values])


def _add_states(dataset: xr.Dataset, name: str, over: str, states: list[Array], meaning: str) -> None:
    attributes = {"units": "those of state_unit", "long_name": meaning}
    dataset[name] = ((over, "state"), states, attributes)


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
