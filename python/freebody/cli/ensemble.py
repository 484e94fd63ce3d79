"""`freebody ensemble MODEL.toml`."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, get_args

import typer

from freebody.ensembles import Sampling
from freebody.errors import InputError
from freebody.model_file import LoadedModel
from freebody.report import ensemble_summary

from .check import ModelArgument, load, print_header
from .console import errors, output
from .laws import laws_of
from .progress import CampaignProgress
from .statistics import print_table

if TYPE_CHECKING:
    from freebody.statistics import Precision

__all__ = ["ensemble"]

INTERRUPTED = 130  # as shells report SIGINT


def ensemble(
    model: ModelArgument,
    n: Annotated[int | None, typer.Option("-n", min=1, help="Number of runs.")] = None,
    seed: Annotated[int | None, typer.Option(min=0, help="The same seed gives the same runs.")] = None,
    out: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="STORE",
            help="Folder or URL of the store; out/MODEL/MODEL.zarr by default.",
        ),
    ] = None,
    chunk: Annotated[int | None, typer.Option(min=1, help="Runs stored at a time.")] = None,
    threads: Annotated[int | None, typer.Option(min=1, help="One for each core by default.")] = None,
    sampling: Annotated[
        str | None, typer.Option(help="random, latin_hypercube, sobol or saltelli.", show_default=False)
    ] = None,
    cluster: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="A Dask scheduler, tcp://host:port, does the runs.")
    ] = None,
    until: Annotated[
        list[str] | None,
        typer.Option(
            metavar="RULE",
            help="End as soon as this is known so well: 'miss:mean:0.5', 'miss:q0.99:1%', 'miss:p>3:0.01'; "
            "more than once for more. -n is the most runs then.",
        ),
    ] = None,
    laws: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Python file whose events and outputs are watched; it is executed."
        ),
    ] = None,
) -> None:
    """Do the runs of a dispersed model file; started again, go on where it was."""
    loaded = load(model)
    watched = {} if laws is None else laws_of(laws)
    runs = loaded.ensemble(n, seed=seed, sampling=_sampling(sampling), **watched)
    store = out or str(Path("out") / loaded.path.stem / f"{loaded.path.stem}.zarr")
    print_header(loaded)
    output.print(f"{runs.n} runs, seed {runs.seed}, {runs.sampling} sampling, into {store}", soft_wrap=True)
    options: dict[str, Any] = loaded.campaign_options | ({} if chunk is None else {"chunk": chunk})
    options |= {"threads": threads, "attributes": _attributes(loaded)}
    rules = _rules(until or [])
    with _interruptible(store), _client(cluster) as client, CampaignProgress(errors, runs.n) as progress:
        options |= {"client": client, "progress": progress.update}
        if rules:
            from freebody.campaigns import campaign_until  # noqa: PLC0415  (an extra, and slow to load)

            stored, stopped = campaign_until(runs, rules, store, loaded.t_span, **options)
        else:
            stored, stopped = runs.campaign(store, loaded.t_span, **options), None
    output.print(ensemble_summary(stored))
    if stopped is not None:
        print_table(stopped.table())
    output.print(f"more: freebody statistics {store}", soft_wrap=True)


def _rules(words: list[str]) -> list[Precision]:
    if not words:
        return []
    from freebody.statistics import parse_precision  # noqa: PLC0415  (an extra, and slow to load)

    return [parse_precision(word) for word in words]


def _sampling(word: str | None) -> Any:
    if word is not None and word not in get_args(Sampling):
        raise InputError(f"--sampling: got {word!r}; allowed are {', '.join(get_args(Sampling))}")
    return word


@contextmanager
def _interruptible(store: str) -> Iterator[None]:
    try:
        yield
    except KeyboardInterrupt:
        errors.print(f"interrupted; what is done is in {store}: the same command goes on", soft_wrap=True)
        raise typer.Exit(INTERRUPTED) from None


@contextmanager
def _client(address: str | None) -> Iterator[Any]:
    if address is None:
        yield None
        return
    from freebody.campaigns import connected  # noqa: PLC0415  (an extra: only a cluster needs it)

    with connected(address) as client:
        yield client


def _attributes(loaded: LoadedModel) -> dict[str, str]:
    return {
        "title": loaded.header.name,
        "references": "\n".join(loaded.header.sources),
        "model_file": loaded.text,
    }
