"""Sections that may be said in one word."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, get_args

from .fields import Section, did_you_mean
from .units import FieldError

__all__ = ["word_as_table"]


def word_as_table(what: str, sections: Iterable[type[Section]]) -> Callable[[Any], Any]:
    """A word is read as a table with that `type`; another is refused with those that are known."""
    words = [get_args(section.model_fields["type"].annotation)[0] for section in sections]

    def read(value: Any) -> Any:
        word = value.get("type") if isinstance(value, dict) else value
        if word not in words:
            came = "the key type is missing" if word is None else f"unknown {what} {word!r}"
            raise FieldError(came + did_you_mean(word, words))
        return value if isinstance(value, dict) else {"type": value}

    return read
