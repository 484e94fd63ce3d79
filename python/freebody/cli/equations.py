"""`freebody equations MODEL.toml`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.equations import Equations
from freebody.equations import equations as equations_of
from freebody.errors import InputError

from .check import ModelArgument, load
from .console import errors

__all__ = ["equations"]


def equations(
    model: ModelArgument,
    form: Annotated[
        str,
        typer.Option(metavar="NUMBER", help="A form of the paper, such as 2.10, or a matrix, such as A1."),
    ] = "3.2",
    angles: Annotated[
        str | None,
        typer.Option(metavar="SEQUENCE", help="Angle sequence, such as zyx; the model's own by default."),
    ] = None,
    latex: Annotated[bool, typer.Option("--latex", help="LaTeX (the default).")] = False,
    c: Annotated[bool, typer.Option("--c", help="A function in C99.")] = False,
    numpy: Annotated[bool, typer.Option("--numpy", help="A Python function over NumPy.")] = False,
    jax: Annotated[bool, typer.Option("--jax", help="A Python function over JAX.")] = False,
    casadi: Annotated[bool, typer.Option("--casadi", help="A Python function over CasADi.")] = False,
    sympy: Annotated[bool, typer.Option("--sympy", help="A Python function over SymPy.")] = False,
    common: Annotated[
        bool, typer.Option("--common", help="List first what occurs several times (LaTeX).")
    ] = False,
    literal: Annotated[
        bool, typer.Option("--literal", help="Multiply the matrices as they stand, without simplifying.")
    ] = False,
    out: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="FILE", help="Where to write; the screen by default."),
    ] = None,
) -> None:
    """Print the scalar equations of a model file: its body with its numbers, and its forces."""
    flags = {"latex": latex, "c": c, "numpy": numpy, "jax": jax, "casadi": casadi, "sympy": sympy}
    wanted = [name for name, given in flags.items() if given] or ["latex"]
    if len(wanted) > 1:
        raise InputError(f"--{', --'.join(wanted)}: these came together; give one of them")
    loaded = load(model)
    made = equations_of(form, angles, model=loaded.model, simplify=not literal)
    text = _printed(made, wanted[0], common)
    if out is None:
        typer.echo(text, nl=False)
    else:
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(text)
        errors.print(f"{made.title}: {out}", style="green")


def _printed(made: Equations, language: str, common: bool) -> str:
    if language == "latex":
        return made.latex(common=common)
    if common:
        raise InputError("--common: only LaTeX lists common expressions; the others always name them")
    return getattr(made, language)()
