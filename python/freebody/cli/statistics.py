"""`freebody statistics RUNS`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from freebody.errors import InputError

from .console import errors, output

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

    from freebody.statistics import Column, ResultTable

__all__ = ["print_table", "statistics"]

_FEW = 4  # results whose relations are printed unasked


def statistics(
    runs: Annotated[
        str, typer.Argument(metavar="RUNS", help="A store of runs (.zarr), or a netCDF file (.nc).")
    ],
    columns: Annotated[
        list[str] | None,
        typer.Option(
            "--column",
            "-c",
            metavar="NAME",
            help="A result to look at, more than once for more; by default "
            "outputs and times of events, or final states where there are none.",
        ),
    ] = None,
    scatter: Annotated[
        str | None, typer.Option(metavar="X,Y", help="Two columns to plot over each other.")
    ] = None,
    confidence: Annotated[float, typer.Option(help="Of the intervals.")] = 0.95,
    out: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="DIR", help="Folder for the tables (.csv) and figures (.png)."
        ),
    ] = None,
) -> None:
    """Say what a set of runs says: means, quantiles, correlations, sensitivities, and how surely."""
    # Each takes a second to import, which the other commands need not wait for.
    from freebody import statistics as stats  # noqa: PLC0415

    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
    pair = None if scatter is None else scatter.split(",")
    if pair is not None and (out is None or len(pair) != 2):
        raise InputError(f"--scatter: got {scatter!r}; give two columns, X,Y, and a folder with -o")
    with _open(runs) as dataset:
        waiting = dataset.sizes["run"] - sum(stats.outcomes(dataset).values())
        if waiting:
            errors.print(f"{waiting} of {dataset.sizes['run']} runs are not made yet", style="yellow")
        results = [stats.column(dataset, name) for name in columns] if columns else stats.results(dataset)
        for table in stats.overview(dataset, results, confidence):
            print_table(table)
            _save(table, out)
        short = columns or len(results) <= _FEW
        for table in stats.relations(dataset, results, confidence) if short or out is not None else ():
            if short:
                print_table(table)
            _save(table, out)
        if not short and out is None:
            told = f"covariances, correlations and sensitivities of {len(results)} results are long"
            output.print(f"{told}: choose results with -c NAME, or a folder with -o DIR", soft_wrap=True)
        if out is None:
            return
        from freebody import plots  # noqa: PLC0415

        for name, drawing in _figures(dataset, results, pair, confidence):
            plots.save(drawing, out / f"{_file_name(name)}.png")
    output.print(f"tables and figures in {out}", soft_wrap=True)


def _save(table: ResultTable, folder: Path | None) -> None:
    if folder is not None:
        table.save(folder / f"{_file_name(table.title)}.csv")


def print_table(table: ResultTable) -> None:
    """A table of statistics, with its title and notes."""
    headings, *rows = table.lines()
    output.print(table.title, style="bold")
    output.print(headings, style="italic", soft_wrap=True)
    for row in rows:
        output.print(row, soft_wrap=True)
    for line in table.notes:
        output.print(line, style="dim", soft_wrap=True)
    output.print()


def _open(path: str) -> xr.Dataset:
    """A store of runs, of which only what is asked for is read."""
    import xarray as xr  # noqa: PLC0415

    from freebody.campaigns import open_runs  # noqa: PLC0415

    if path.endswith(".nc"):
        found = xr.open_dataset(path, engine="h5netcdf")
    elif "://" in path or Path(path).is_dir():
        found = open_runs(path)
    else:
        raise InputError(f"{path}: no store of runs is there")
    if "outcome" not in found or "run" not in found.sizes:
        raise InputError(f"{path}: holds no runs of an ensemble")
    return found


def _figures(
    dataset: xr.Dataset, results: list[Column], pair: list[str] | None, confidence: float
) -> Iterator[tuple[str, Figure]]:
    from freebody.plots import ensembles  # noqa: PLC0415
    from freebody.statistics import all_columns, column, correlations  # noqa: PLC0415

    for result in results:
        yield f"histogram {result.key}", ensembles.histogram(dataset, result, confidence)
        if correlations(dataset, result, confidence, runs=1000):
            yield f"sensitivity {result.key}", ensembles.sensitivity(dataset, result, confidence)
    yield "correlations", ensembles.correlations(dataset, [*results, *all_columns(dataset, "dispersed")])
    if pair is not None:
        x, y = (column(dataset, name.strip()) for name in pair)
        yield f"scatter {x.key} {y.key}", ensembles.scatter(dataset, x, y)


def _file_name(words: str) -> str:
    return re.sub(r"[^\w.]+", "_", words).strip("_").lower()
