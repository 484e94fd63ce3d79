"""The gallery of the documentation: a page for each check case, and a table of all of them.

`gallery.py FOLDER` writes them: what happens and where the numbers come from, as the model file says it, the
residuals, the figure, and the file.
"""

import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib import rc_context

from freebody import plots
from freebody.environment import USStandard1976
from freebody.model_file import load_model, shipped_model
from freebody.plots.style import BLACK, BLUE, STYLE, blank
from freebody.verify import CASES, Case, Residual, atmosphere

HEADING = "| quantity | largest residual | allowed | unit |\n|---|---:|---:|---|"
OVERVIEW = (
    "| case | compared | nearest to its limit | residual | allowed | unit |\n|---|---:|---|---:|---:|---|"
)


def figures(residual: Residual) -> str:
    """Residual, what is allowed, and the unit, as cells."""
    return f"{residual.residual:.2g} | {residual.allowed:.2g} | {residual.unit}"


def table(residuals: Sequence[Residual]) -> str:
    """A line for each; the case stands before the quantity where there are several."""
    several = len({one.case for one in residuals}) > 1
    named = [f"{one.case}: {one.quantity}" if several else one.quantity for one in residuals]
    lines = [f"| {what} | {figures(one)} |" for what, one in zip(named, residuals, strict=True)]
    return "\n".join([HEADING, *lines])


def page(name: str, case: Case, residuals: Sequence[Residual], folder: Path) -> str:
    """The page of a case; its figure is written beside it."""
    compared = [f"`freebody verify --only {name}` makes this table:", table(residuals)]
    if case.model is None:
        picture = _profile(folder) if name == "us76" else ""
        return (
            "\n\n".join(part for part in [f"# {case.title}", case.about, *compared, picture] if part) + "\n"
        )
    loaded = load_model(shipped_model(case.model))
    figure = f"{name}.png"
    drawing = plots.figure(loaded.simulate(), title=loaded.header.name, points=loaded.output.points)
    plots.save(drawing, folder / figure)
    parts = [
        f"# {loaded.header.name}",
        loaded.header.description.strip(),
        *compared,
        f"`freebody run {case.model}` draws it:",
        f"![{loaded.header.name}]({figure})",
        "## Sources",
        "\n".join(f"- {source}" for source in loaded.header.sources),
        "## The model file",
        f"`models/{case.model}.toml`:",
        f"```toml\n{loaded.text.strip()}\n```",
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def _profile(folder: Path) -> str:
    """The standard atmosphere over altitude, with the figures that are printed."""
    altitude = np.linspace(-5e3, 86e3, 500)
    air = USStandard1976().at(altitude)
    rows = np.array([row.split() for row in atmosphere.PRINTED.strip().splitlines()], dtype=float)
    curves = {
        "temperature, K": (air.temperature, rows[:, 1]),
        "pressure, Pa": (air.pressure, 100.0 * rows[:, 2]),
        "density, kg/m³": (air.density, rows[:, 3]),
    }
    with rc_context(STYLE):
        drawing = blank(11.0, 4.5)
        panels = drawing.subplots(1, 3, sharey=True)
        for axes, (label, (values, printed)) in zip(panels, curves.items(), strict=True):
            axes.plot(values, altitude / 1e3, color=BLUE, label="freebody")
            axes.plot(printed, rows[:, 0] / 1e3, "o", color=BLACK, markersize=4, label="as printed")
            axes.set(xlabel=label, xscale="linear" if label.endswith("K") else "log")
        panels[0].set_ylabel("geometric altitude, km")
        panels[0].legend()
        plots.save(drawing, folder / "us76.png")
    return "![Temperature, pressure and density over altitude](us76.png)"


def line(name: str, title: str, residuals: Sequence[Residual]) -> str:
    """Of the table of all cases: the residual that comes nearest to what is allowed."""
    worst = max(residuals, key=lambda one: one.residual / one.allowed)
    what = f"{worst.case}: {worst.quantity}" if name == "paper" else worst.quantity
    return f"| [{title}](generated/{name}.md) | {len(residuals)} | {what} | {figures(worst)} |"


def main(folder: Path) -> None:
    """Write all pages, and the table that the gallery begins with."""
    folder.mkdir(parents=True, exist_ok=True)
    lines = [OVERVIEW]
    for name, case in CASES.items():
        residuals = list(case.residuals())
        text = page(name, case, residuals, folder)
        (folder / f"{name}.md").write_text(text)
        lines.append(line(name, text.partition("\n")[0].removeprefix("# "), residuals))
    (folder / "overview.txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
