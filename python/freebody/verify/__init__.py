"""What can be checked against numbers from outside: the paper's identities and published cases."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from freebody.errors import InputError

from . import jeod, nesc, paper, toutatis
from .residual import Residual

__all__ = ["Residual", "run_all"]

CASES: dict[str, Callable[[], Iterator[Residual]]] = {
    "paper": paper.cases,
    "nesc_02": nesc.case_02,
    "jeod_9a": lambda: jeod.run("9A"),
    "jeod_9b": lambda: jeod.run("9B"),
    "jeod_9c": lambda: jeod.run("9C"),
    "toutatis": toutatis.cases,
}


def run_all(only: str | None = None) -> Iterator[Residual]:
    """The residuals of every case, or of those whose name starts with `only`.

    Raises `InputError` if there is no such case.
    """
    names = [name for name in CASES if name.startswith((only or "").lower())]
    if not names:
        raise InputError(f"no case is named {only!r}; the cases are {', '.join(CASES)}")
    for name in names:
        yield from CASES[name]()
