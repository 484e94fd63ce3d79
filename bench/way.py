"""What an adapter of a program hands over: statements to time, and how wrong their answers are."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

import numpy as np


@dataclass(frozen=True)
class Way:
    """One way of a program to do what is measured.

    The statement is run with the names, as a user would write it; `error` then tells the largest difference
    of what it gave from what is right. `count` is how many derivatives, Jacobians or runs it makes; sparse:
    only the entries of a Jacobian that are not always zero.
    """

    label: str
    statement: str
    names: Mapping[str, Any]
    error: Callable[[], float]
    count: int = 1
    sparse: bool = False


def difference(right: np.ndarray, given: Callable[[], np.ndarray]) -> Callable[[], float]:
    """The error of a way whose answer lies where `given` looks; what is not finite is wrong."""

    def error() -> float:
        largest = np.abs(given() - right).max()
        return float(largest) if np.isfinite(largest) else np.inf

    return error


class Program(Protocol):
    """freebody or a peer; what it cannot do, it answers with no ways and no methods.

    A method and a tolerance, or whatever number makes it finer when smaller, make a run. `runs` is how many
    runs of the ensemble are worth its time.
    """

    name: ClassVar[str]
    runs: ClassVar[int]
    version: str

    def derivative(self) -> Iterable[Way]: ...
    def derivatives(self, x: np.ndarray, threads: int) -> Iterable[Way]: ...
    def jacobian(self) -> Iterable[Way]: ...
    def jacobians(self, x: np.ndarray, threads: int) -> Iterable[Way]: ...
    def methods(self) -> Mapping[str, Iterable[float]]: ...
    def trajectory(self, method: str, tolerance: float) -> Way: ...
    def ensembles(self) -> Mapping[str, Iterable[float]]: ...
    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way: ...


class Nothing:
    """Cannot do any of it: adapters write over what they can."""

    name: ClassVar[str]
    runs: ClassVar[int] = 0
    version: str = ""

    def derivative(self) -> Iterable[Way]:
        return ()

    def derivatives(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        return ()

    def jacobian(self) -> Iterable[Way]:
        return ()

    def jacobians(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        return ()

    def methods(self) -> Mapping[str, Iterable[float]]:
        return {}

    def trajectory(self, method: str, tolerance: float) -> Way:
        raise NotImplementedError(method)

    def ensembles(self) -> Mapping[str, Iterable[float]]:
        return {}

    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way:
        raise NotImplementedError(method)


def decades(first: float, last: float, each: int = 8) -> np.ndarray:
    """Tolerances from 10**first down to 10**last."""
    return 10.0 ** np.linspace(first, last, round((first - last) * each) + 1)
