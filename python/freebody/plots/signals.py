"""A panel of what a model reads and remembers."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from freebody._check import Array
from freebody.simulation import Trajectory

from .panels import lines
from .style import BLACK, BLUE, GREEN, GREY, RED

__all__ = ["draw_signals"]

_COLOURS = (BLUE, RED, GREEN, BLACK, GREY)


def draw_signals(axes: Axes, time: Array, run: Trajectory) -> bool:
    """The inputs that change, or else the auxiliary states: of one unit, which most of them have.

    False where there are none.
    """
    model = run.model
    inputs = dict(zip(model.input_names, run.u.T, strict=True))
    units = dict(
        zip((*model.input_names, *model.state_names), (*model.input_units, *model.state_units), strict=True)
    )
    for title, signals in (("Inputs", inputs), ("States of the forces", run.states)):
        moving = {name: values for name, values in signals.items() if np.ptp(values) > 0.0}
        if moving:
            found = [units[name] for name in moving]
            unit = max(found, key=found.count)
            drawn = [name for name in moving if units[name] == unit][: len(_COLOURS)]
            factor, shown = {"rad": (180.0 / np.pi, "deg")}.get(unit, (1.0, "" if unit == "1" else unit))
            columns = factor * np.column_stack([moving[name] for name in drawn])
            colours = _COLOURS[: len(drawn)]
            lines(axes, time, columns, dict(zip(drawn, colours, strict=True)))
            axes.legend(loc="best")
            axes.set(title=title, ylabel=shown)
            return True
    return False
