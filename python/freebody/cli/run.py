"""`freebody run MODEL.toml`."""

from __future__ import annotations

from importlib.metadata import version
from pathlib import Path
from typing import Annotated

import typer

from freebody.model_file import LoadedModel
from freebody.report import summary
from freebody.simulation import stages_of

from .check import ModelArgument, load, print_header
from .console import errors, output
from .progress import LongRunProgress

__all__ = ["run"]


def run(
    model: ModelArgument,
    out: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Data file, .nc or .csv; out/MODEL/MODEL.nc by default."
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Figure, .png, .svg or .pdf; beside the data by default."),
    ] = None,
    no_plot: Annotated[bool, typer.Option("--no-plot", help="Draw no figure.")] = False,
) -> None:
    """Simulate a model file, store and plot the run, say what it kept."""
    # Each takes a second to import, which the other commands need not wait for.
    from freebody import plots, results  # noqa: PLC0415

    loaded = load(model)
    data = out or _default_output(loaded)
    figure = None if no_plot else plot or data.with_suffix(".png")
    # What cannot be written is found out before the run, not after it.
    results.check_suffix(data)
    data.parent.mkdir(parents=True, exist_ok=True)
    if figure is not None:
        plots.check_suffix(figure)
        figure.parent.mkdir(parents=True, exist_ok=True)

    print_header(loaded)
    with LongRunProgress(errors) as progress:
        trajectory = loaded.simulate(progress=progress.update)

    written = {}
    points = loaded.output.points
    if len(trajectory) > 0:
        dataset = results.to_dataset(
            trajectory,
            points=points,
            tracks=[loaded.tracks(stage) for stage in stages_of(trajectory)],
            attributes=_attributes(loaded),
        )
        results.save(dataset, data)
        written["data"] = data
    if len(trajectory) > 1 and figure is not None:
        plots.save(plots.figure(trajectory, title=loaded.header.name, points=points), figure)
        written["plot"] = figure

    output.print(summary(trajectory))
    for what, path in written.items():
        output.print(f"{what:14}{path}", soft_wrap=True)
    if not trajectory.ok:
        errors.print(f"the run ended early: {trajectory.outcome.message}", style="bold red")
        raise typer.Exit(1)


def _attributes(loaded: LoadedModel) -> dict[str, str]:
    return {
        "title": loaded.header.name,
        "source": f"freebody {version('freebody')}",
        "references": "\n".join(loaded.header.sources),
        "model_file": loaded.text,
    }


def _default_output(loaded: LoadedModel) -> Path:
    stem = loaded.path.stem
    suffix = {"netcdf": ".nc", "csv": ".csv"}[loaded.output.format]
    return Path("out") / stem / f"{stem}{suffix}"
