"""Notices: what the outcome of a run must say, written as Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from freebody import _check
from freebody.tracing.event_law import EventLaw
from freebody.tracing.force_law import Declarations

__all__ = ["NoticeLaw", "notice"]


class NoticeLaw(EventLaw):
    """An event that says that a law is used where it does not hold; see `notice`, which makes them.

    Attributes
    ----------
    message
        What is the matter, and what holds instead.
    """

    def __init__(
        self,
        message: str,
        function: Callable[..., Any],
        parameters: Declarations | None = None,
        inputs: Mapping[str, str] | None = None,
        name: str | None = None,
    ) -> None:
        self.message = _check.label("message", message)
        super().__init__(function, False, "falling", parameters, inputs, message if name is None else name)

    def _content(self) -> tuple[object, ...]:
        return (*super()._content(), self.message)


def notice(
    message: str,
    function: Callable[..., Any],
    *,
    parameters: Declarations | None = None,
    inputs: Mapping[str, str] | None = None,
    name: str | None = None,
) -> NoticeLaw:
    """Make a notice of a message and a function of the situation `s`, and of its parameters `p`.

    The function returns a number that is not negative where all is well. Forces carry notices as their
    attribute `notices`; every run of a model watches those of its forces, and its outcome says when a number
    became negative, or that it was so from the start. Traced as events are; see `event`.
    """
    return NoticeLaw(message, function, parameters, inputs, name)
