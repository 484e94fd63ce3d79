"""`freebody verify`."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import asdict
from typing import Annotated

import typer
from rich.table import Table
from rich.text import Text

from freebody.verify import run_all
from freebody.verify.residual import Residual

from .console import output

__all__ = ["verify"]


def verify(
    only: Annotated[
        str | None, typer.Option(metavar="CASE", help="Only the cases whose name starts so, such as jeod.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON instead of a table.")] = False,
) -> None:
    """Re-run what can be checked and print the residuals; exit status 1 if one is too large."""
    found = list(run_all(only))
    if as_json:
        typer.echo(json.dumps([{**asdict(one), "passed": one.passed} for one in found], indent=2))
    else:
        output.print(_table(found))
        failed = sum(not one.passed for one in found)
        verdict = (
            f"{failed} of {len(found)} too large" if failed else f"all {len(found)} within what is allowed"
        )
        output.print(verdict, style="bold red" if failed else "green")
    if not all(one.passed for one in found):
        raise typer.Exit(1)


def _table(found: Iterable[Residual]) -> Table:
    table = Table(box=None, header_style="bold", pad_edge=False)
    for heading in ("case", "quantity"):
        table.add_column(heading, overflow="fold")
    for heading in ("largest residual", "allowed"):
        table.add_column(heading, justify="right", no_wrap=True)
    for heading in ("unit", "pass"):
        table.add_column(heading, no_wrap=True)
    for one in found:
        verdict = Text("yes", style="green") if one.passed else Text("NO", style="bold red")
        table.add_row(one.case, one.quantity, f"{one.residual:.2e}", f"{one.allowed:.2g}", one.unit, verdict)
    return table
