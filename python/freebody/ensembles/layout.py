"""How runs are labelled and stored: dimensions, coordinates, units, what it all is."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from freebody import _core
from freebody.ensembles.runs import Chunk
from freebody.simulation import OUTCOMES, Settings

if TYPE_CHECKING:
    from freebody.ensembles.ensemble import Ensemble
    from freebody.model import Model

__all__ = ["Variable", "attributes", "coordinates", "described", "to_dataset", "variables"]


class Variable(NamedTuple):
    """An array: its dimensions, the type of its numbers, what they are."""

    dims: tuple[str, ...]
    dtype: str
    attributes: dict[str, Any]


def variables(ensemble: Ensemble, settings: Settings) -> dict[str, Variable]:
    """The arrays that runs give, all of them run first."""
    flags = {"flag_values": list(range(len(OUTCOMES))), "flag_meanings": " ".join(OUTCOMES)}
    found = {
        "outcome": Variable(("run",), "uint8", {"long_name": "how the run ended", **flags}),
        "end_time": _number(("run",), "last time that the run reached", "s"),
        "final_state": _number(("run", "state"), "state there"),
        "dispersed": _number(("run", "quantity"), "dispersed value"),
        "steps": Variable(("run",), "uint64", {"long_name": "accepted steps"}),
        "rejected": Variable(("run",), "uint64", {"long_name": "rejected steps"}),
        "culprit": Variable(
            ("run",), "int16", {"long_name": "place of the law that was not finite, -1 where none was"}
        ),
    }
    if settings.times is not None:
        found["samples"] = _number(("run", "time", "state"), "state at a time, NaN where the run had ended")
    if ensemble.outputs:
        found["outputs"] = _number(("run", "output"), "output")
    if ensemble.events:
        found["stopped_by"] = Variable(
            ("run",), "int16", {"long_name": "place of the event that ended the run, -1 where none did"}
        )
        found["event_time"] = _number(
            ("run", "event"), "when the event came first, NaN where it did not", "s"
        )
        found["event_count"] = Variable(("run", "event"), "uint32", {"long_name": "how often the event came"})
        found["event_state"] = _number(("run", "event", "state"), "state when the event came first")
    if ensemble.notices:
        found["notice_time"] = _number(
            ("run", "notice"), "from when on a notice held first, NaN where it did not", "s"
        )
    return found


def _number(dims: tuple[str, ...], meaning: str, unit: str | None = None) -> Variable:
    return Variable(dims, "float64", {"long_name": meaning} | ({} if unit is None else {"units": unit}))


def coordinates(
    ensemble: Ensemble, settings: Settings
) -> dict[str, tuple[str, NDArray[Any], dict[str, Any]]]:
    """Names and units along the dimensions but `run`: by name the dimension, the labels, their attributes."""
    model = ensemble.base
    found: dict[str, tuple[str, NDArray[Any], dict[str, Any]]] = {}
    labels: dict[str, tuple[list[str], list[str]]] = {
        "state": (list(model.state_names), list(model.state_units)),
        "quantity": (list(ensemble.names), list(ensemble.units)),
    }
    if ensemble.outputs:
        labels["output"] = ([o.name for o in ensemble.outputs], [o.unit for o in ensemble.outputs])
    for dimension, (names, units) in labels.items():
        found[dimension] = (dimension, np.array(names), {})
        found[f"{dimension}_unit"] = (dimension, np.array(units), {"long_name": f"unit of the {dimension}"})
    nominal = {"long_name": "value of the quantity without dispersion"}
    found["nominal"] = ("quantity", ensemble.nominal, nominal)
    meaning = {"long_name": "number of the independent factor it belongs to, -1 where values were given"}
    found["quantity_factor"] = ("quantity", _factor_numbers(ensemble), meaning)
    if ensemble.events:
        found["event"] = ("event", np.array([event.name for event in ensemble.events]), {})
    if ensemble.notices:
        found["notice"] = ("notice", np.array(ensemble.notices), {})
    if settings.times is not None:
        found["time"] = ("time", settings.times, {"units": "s", "long_name": "time"})
    return found


def _factor_numbers(ensemble: Ensemble) -> NDArray[np.int64]:
    numbers = {column: i for i, factor in enumerate(ensemble.design.factors) for column in factor}
    return np.array([numbers.get(column, -1) for column in ensemble.names])


def attributes(ensemble: Ensemble, settings: Settings) -> dict[str, Any]:
    """What was run and how: with these and the version, run r can be repeated."""
    rtol, atol = settings.tolerance
    return {
        "title": f"ensemble of {ensemble.base.name}",
        "model": described(ensemble.base),
        "dispersions": json.dumps({name: repr(d) for name, d in ensemble.dispersions.items()}),
        "n": ensemble.n,
        "seed": str(ensemble.seed),
        "sampling": ensemble.sampling,
        "x0": json.dumps(ensemble.x0.tolist()),
        "start_time": settings.span[0],
        "stop_time": settings.span[1],
        "method": settings.method,
        "rtol": rtol,
        "atol": atol,
        "step": "chosen by the method" if settings.step is None else settings.step,
        "max_steps": settings.max_steps,
        "freebody_version": _core.__version__,
    }


def described(model: Model) -> str:
    """A model in JSON: its body, its forces with their numbers, its control law."""
    body = model.body
    return json.dumps(
        {
            "name": model.name,
            "attitude": model.attitude,
            "form": model.form,
            "body": {
                "name": body.name,
                "mass": body.mass,
                "com": body.com.tolist(),
                "inertia_about_com": body.inertia_about_com.tolist(),
            },
            "forces": [_law(force) for force in model.forces],
            "control": None if model.control is None else _law(model.control),
        },
        ensure_ascii=False,
    )


def _law(law: Any) -> dict[str, Any]:
    """The numbers of a law; a program of a law written in Python stays unsaid."""
    numbers = getattr(law, "parameters", None) or {
        name: value for name, value in vars(law).items() if not name.startswith("_") and name != "name"
    }
    plain = {name: np.asarray(value).tolist() for name, value in dict(numbers).items() if not callable(value)}
    return {"kind": type(law).__name__, "name": law.name} | plain


def to_dataset(ensemble: Ensemble, settings: Settings, chunk: Chunk) -> xr.Dataset:
    """Runs as a labelled dataset."""
    arrays = {
        name: (variable.dims, chunk[name], variable.attributes)
        for name, variable in variables(ensemble, settings).items()
    }
    run = {"run": np.arange(len(chunk["outcome"]))}
    return xr.Dataset(arrays, run | coordinates(ensemble, settings), attributes(ensemble, settings))
