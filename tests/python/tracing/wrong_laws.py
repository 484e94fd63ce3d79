"""Wrong laws with what their error must say: of the line that ends in `# here`."""

import pickle
from collections.abc import Callable
from typing import Any, NamedTuple

import pytest

from freebody import TraceError
from freebody.tracing import ForceLaw

Law = Callable[..., Any]

DECLARED: dict[str, Any] = {
    "parameters": {"area": (0.02, "m^2"), "lag": (0.1, "s")},
    "inputs": {"rudder": "rad", "thrust": "N"},
}
WITH_STATE: dict[str, Any] = DECLARED | {"states": {"servo": (0.0, "rad")}}


class Case(NamedTuple):
    """A wrong law, words of what happened and of the remedy, and its declarations."""

    law: Law
    happened: str
    remedy: str
    declared: dict[str, Any]


class Cases(dict[str, Case]):
    """Cases by the names of their laws; called, it decorates a law."""

    def __call__(self, happened: str, remedy: str, **declared: Any) -> Callable[[Law], Law]:
        def add(law: Law) -> Law:
            self[law.__name__] = Case(law, happened, remedy, declared or DECLARED)
            return law

        return add


def check(wrong: Case) -> None:
    """The error names the function and the line, says what happened and what to write."""
    with pytest.raises(TraceError) as caught:
        ForceLaw(wrong.law, **wrong.declared)
    error, message = caught.value, str(caught.value)
    assert wrong.happened in message
    assert wrong.remedy in message
    assert error.function == wrong.law.__name__
    assert error.file == wrong.law.__code__.co_filename
    assert error.text is not None
    assert error.text.endswith("# here")
    assert message.startswith(f"{error.function}: {error.file}:{error.line}: ")
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.line) == (message, error.line)
