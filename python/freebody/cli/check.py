"""`freebody check MODEL.toml`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.model_file import LoadedModel, load_model, shipped_model
from freebody.report import describe_model

from .console import output

__all__ = ["ModelArgument", "check", "load", "print_header"]

ModelArgument = Annotated[
    str, typer.Argument(metavar="MODEL", help="A model file, or the name of one that comes with freebody.")
]


def check(model: ModelArgument) -> None:
    """Validate a model file and say what it describes."""
    loaded = load(model)
    print_header(loaded)
    output.print(f"{loaded.path} is valid", style="green")


def load(model: str) -> LoadedModel:
    """The model file at a path, or the one of that name that comes with freebody."""
    path = Path(model)
    return load_model(path if path.exists() or path.suffix else shipped_model(model))


def print_header(loaded: LoadedModel) -> None:
    """The model file's name and what it describes."""
    output.print(loaded.header.name, style="bold")
    output.print(
        describe_model(
            loaded.model, loaded.t_span, stages=loaded.stages, events=loaded.options.get("events", ())
        )
    )
