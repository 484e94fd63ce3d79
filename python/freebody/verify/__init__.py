"""What can be checked against numbers from outside: the paper's identities and published cases."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

from freebody.errors import InputError

from . import atmosphere, f16, jeod, marine, nesc, paper, toutatis, vehicles
from .residual import Residual

__all__ = ["CASES", "Case", "Residual", "run_all"]


class Case(NamedTuple):
    """What is compared, and the shipped model that it runs; one without says what it is."""

    residuals: Callable[[], Iterator[Residual]]
    model: str | None = None
    title: str = ""
    about: str = ""


CASES: dict[str, Case] = {
    "paper": Case(
        paper.cases,
        title="The paper's equations",
        about="Every numbered equation against eight point masses that are fixed in a body, in random "
        "motions and all twelve sequences of angles.",
    ),
    **{f"nesc_{n:02}": Case(partial(nesc.run, n), model) for n, model in nesc.MODELS.items()},
    **{f"jeod_{n.lower()}": Case(partial(jeod.run, n), f"jeod_{n.lower()}") for n in jeod.FINALS},
    "toutatis": Case(toutatis.cases, "toutatis"),
    "us76": Case(
        atmosphere.cases,
        title="U.S. Standard Atmosphere, 1976",
        about="Temperature, pressure and density against table I of NOAA-S/T 76-1562, at -5, 0, 5, 11, 20, "
        "32, 47, 51, 71, 80 and 86 km.",
    ),
    "f16": Case(f16.cases, "f16"),
    "remus_100": Case(marine.remus, "remus_100"),
    "otter": Case(marine.otter, "otter"),
    "gyrostat": Case(vehicles.gyrostat, "gyrostat"),
    "quadrotor": Case(vehicles.quadrotor, "quadrotor"),
    "two_stage_rocket": Case(vehicles.rocket, "two_stage_rocket"),
}


def run_all(only: str | None = None) -> Iterator[Residual]:
    """The residuals of every case, or of those whose name starts with `only`.

    Raises `InputError` if there is no such case.
    """
    names = [name for name in CASES if name.startswith((only or "").lower())]
    if not names:
        raise InputError(f"no case is named {only!r}; the cases are {', '.join(CASES)}")
    for name in names:
        yield from CASES[name].residuals()
