"""The look of all figures, and their files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from freebody.errors import InputError

__all__ = ["BLACK", "BLUE", "GREEN", "GREY", "RED", "STYLE", "SUFFIXES", "blank", "check_suffix", "save"]

SUFFIXES = (".png", ".svg", ".pdf")

# Okabe and Ito's colours, told apart by colour-blind readers too.
RED, GREEN, BLUE, BLACK, GREY = "#D55E00", "#009E73", "#0072B2", "#000000", "#8c8c8c"

STYLE: dict[Any, Any] = {
    "font.size": 9.0,
    "axes.titlesize": 10.0,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.grid": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.xmargin": 0.0,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.7,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "lines.linewidth": 1.2,
}


def blank(width: float, height: float) -> Figure:
    """An empty figure, in inches, that can be saved without a display."""
    drawing = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(drawing)
    return drawing


def save(drawing: Figure, path: Path) -> None:
    """Writes to `path` as its suffix says, at once or not at all. Raises `InputError` for another suffix."""
    check_suffix(path)
    unfinished = path.with_name(f".{path.name}.unfinished")
    try:
        drawing.savefig(unfinished, dpi=150, format=path.suffix[1:])
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def check_suffix(path: Path) -> None:
    """Raises `InputError` for a suffix that is no figure's."""
    if path.suffix not in SUFFIXES:
        raise InputError(
            f"{path}: the suffix says the figure's format: {', '.join(SUFFIXES)}; came {path.suffix!r}"
        )
