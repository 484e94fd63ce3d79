"""What forces, control laws and contents are to a model: what they read, move, set and carry."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import InputError

__all__ = ["Contents", "Control", "Force", "Quantity", "Spin", "StateQuantity"]


class Quantity(NamedTuple):
    """A number that a law reads or sets; the unit is "" where it is not known."""

    name: str
    unit: str


class StateQuantity(NamedTuple):
    """A number that a law itself moves, and its value at the start."""

    name: str
    unit: str
    initial: float


@dataclass(frozen=True)
class Spin:
    """A symmetric wheel that turns about an axis of the body; its mass is part of the body.

    Attributes
    ----------
    axis
        Body axes, (3,); kept at length one.
    inertia
        About the axis, kg m².
    state
        The name of that state of its law which is the speed relative to the body, rad/s.
    """

    axis: tuple[float, float, float]
    inertia: float
    state: str

    def __post_init__(self) -> None:
        axis = _check.vector("axis", self.axis, 3)
        length = float(np.linalg.norm(axis))
        if not length > 0.0:
            raise InputError("axis: got the zero vector; give the direction of the wheel's axis, body axes")
        object.__setattr__(self, "axis", tuple((axis / length).tolist()))
        object.__setattr__(self, "inertia", _check.number("inertia", self.inertia, positive=True))
        if not isinstance(self.state, str):
            raise InputError(f"state: got {_check.shown(self.state)}; give the name of a state of the law")


class Contents(ABC):
    """What a body carries besides itself, fuel above all: mass properties that change.

    Attributes
    ----------
    inputs
        What it reads: inputs of u, and states that laws publish.
    """

    name: str
    inputs: tuple[Quantity, ...] = ()

    @abstractmethod
    def core(self) -> tuple[_core.Program, list[float]]:
        """Its program and the values of its parameters."""


class Force(ABC):
    """A force element: a name, and how the core sees it.

    Attributes
    ----------
    inputs, states
        What it reads from u, and its own states.
    publishes
        Those of its states that other laws read as inputs, by the names of the states alone.
    added_mass
        (6, 6), symmetric, about o1 in body axes, linear part first: added to the mass matrix. All else that
        comes with it is part of the wrench.
    spins
        Wheels: the kernel takes their inertia about the axes out of the mass matrix, and a·ω* from the rates
        of their speeds. With the torque τ of a motor the law gives the rate τ/J and the moment
        -a τ - ω × a J Ω.
    contents
        What the body carries with it; joined with the body wherever its mass properties are asked for.
    notices
        Events, made by `freebody.notice`, of which the outcome of every run says when they came to pass.
    """

    inputs: tuple[Quantity, ...] = ()
    states: tuple[StateQuantity, ...] = ()
    publishes: tuple[str, ...] = ()
    added_mass: Array | None = None
    spins: tuple[Spin, ...] = ()
    contents: tuple[Contents, ...] = ()
    notices: tuple[Any, ...] = ()

    def __init__(self, name: str | None) -> None:
        self.name = type(self).__name__ if name is None else _check.label("name", name)

    @abstractmethod
    def core(self) -> _core.Force:
        """The element of the core."""

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name!r}>"


class Control(ABC):
    """A control law u = k(t, x): what it commands are inputs of the forces.

    Attributes
    ----------
    commands
        The inputs that it sets.
    inputs, states
        What it reads from u itself, references above all, and its own states.
    """

    commands: tuple[Quantity, ...] = ()
    inputs: tuple[Quantity, ...] = ()
    states: tuple[StateQuantity, ...] = ()

    def __init__(self, name: str | None) -> None:
        self.name = type(self).__name__ if name is None else _check.label("name", name)

    @abstractmethod
    def core(self) -> _core.Control:
        """The law of the core."""

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name!r}>"
