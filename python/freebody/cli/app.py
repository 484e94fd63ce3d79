"""The commands' names, options and errors."""

from __future__ import annotations

import sys
from importlib.metadata import version
from typing import Annotated

import typer

from freebody.errors import FreebodyError

from .check import check
from .console import errors
from .ensemble import ensemble
from .equations import equations
from .run import run
from .statistics import statistics
from .verify import verify

__all__ = ["run_app"]

app = typer.Typer(
    help="Rigid-body dynamics about any body-fixed frame.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.command()(run)
app.command()(check)
app.command()(ensemble)
app.command()(equations)
app.command()(statistics)
app.command()(verify)


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"freebody {version('freebody')}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version.", callback=_print_version, is_eager=True)
    ] = False,
) -> None:
    pass


def run_app() -> None:
    """Runs the command of `sys.argv`; a refusal is one message, without a traceback, and exit status 2."""
    try:
        app()
    except (FreebodyError, OSError) as error:
        errors.print(f"error: {error}", soft_wrap=True)
        sys.exit(2)
