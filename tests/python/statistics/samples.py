"""Runs as `Runs.to_xarray` labels them, drawn from known distributions."""

import numpy as np
import xarray as xr

REACHED, EVENT, NON_FINITE, NOT_RUN = 0, 1, 4, 6


def runs(n=2000, seed=1):
    """Linear in normal quantities and noise: drift = 3 wind + 4 (mass - 12.5) / 0.3 + noise, a variance of
    9 + 16 + 1; miss = |drift|; the event occurs in the runs with positive drift."""
    rng = np.random.default_rng(seed)
    wind, mass, noise = rng.normal(size=(3, n))
    drift = 3 * wind + 4 * mass + noise
    return dataset(
        outputs={"miss": (np.abs(drift), "m"), "drift": (drift, "m")},
        dispersed={"mass": (12.5 + 0.3 * mass, "kg"), "wind": (wind, "m/s")},
        events={"crossing": np.where(drift > 0, 5 + 0.1 * drift, np.nan)},
    )


def dataset(outputs, dispersed, events=None, outcome=None, **attributes):
    """Columns by name, each (values, unit); times of events by name."""
    n = len(next(iter(outputs.values()))[0])
    arrays = {
        "outcome": ("run", np.zeros(n, np.uint8) if outcome is None else outcome),
        "end_time": ("run", np.full(n, 10.0)),
        "final_state": (("run", "state"), np.zeros((n, 2))),
    }
    labels = {"state": ["position_x", "position_y"], "state_unit": ("state", ["m", "m"])}
    for variable, dimension, columns in (
        ("outputs", "output", outputs),
        ("dispersed", "quantity", dispersed),
    ):
        arrays[variable] = (("run", dimension), np.column_stack([values for values, _ in columns.values()]))
        labels[dimension] = list(columns)
        labels[f"{dimension}_unit"] = (dimension, [unit for _, unit in columns.values()])
    if events:
        arrays["event_time"] = (("run", "event"), np.column_stack(list(events.values())))
        labels["event"] = list(events)
    return xr.Dataset(arrays, labels, {"sampling": "random", **attributes})


def ended(data, outcome, *where):
    """The same, where some runs ended otherwise, with nothing but NaN to show for it."""
    changed = data.copy(deep=True)
    changed["outcome"][list(where)] = outcome
    changed["outputs"][list(where)] = np.nan
    return changed
