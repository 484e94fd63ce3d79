"""From pydantic's errors to one `ModelFileError` that names file, line and key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from freebody.errors import InputError, ModelFileError

from .fields import did_you_mean
from .units import FieldError

__all__ = ["Source"]

_EXPECTED = {
    "string_type": "a string in quotes",
    "int_type": "a whole number",
    "bool_type": "true or false",
    "list_type": "an array (of tables: [[...]])",
    "dict_type": "a table",
}

_TAGS = {"type": "the kind of force", "kind": "the kind of distribution"}


@dataclass(frozen=True)
class Source:
    """A model file's path, data and the line of every key: what an error has to point at."""

    path: Path
    data: Mapping[str, Any]
    lines: Mapping[str, int]

    def error(self, key: str, message: str) -> ModelFileError:
        """The error for the key path `key`; a key that is not there has the line of its section."""
        place = key
        while place and place not in self.lines:
            place = place[: max(place.rfind("."), place.rfind("["), 0)]
        return ModelFileError(message, file=str(self.path), line=self.lines.get(place), key=key or None)

    def errors(self, error: ValidationError) -> ModelFileError:
        """The first fault, its message followed by the others, a line each."""
        found = [self.error(*self._fault(detail)) for detail in error.errors()]
        found.sort(key=lambda fault: fault.line or 0)
        first, *others = found
        message = "\n".join([str(first.args[0]), *map(str, others)])
        return ModelFileError(message, file=first.file, line=first.line, key=first.key)

    @contextmanager
    def blame(self, key: str) -> Iterator[None]:
        """Gives the library's own refusals the place in the file that they are about."""
        try:
            yield
        except InputError as error:
            raise self.error(key, str(error)) from error

    def _fault(self, detail: Any) -> tuple[str, str]:
        path, value = self._walk(detail["loc"])
        context = detail.get("ctx", {})
        cause = context.get("error")
        if isinstance(cause, FieldError):
            return _dotted(path + cause.at), str(cause)
        kind = detail["type"]
        if kind == "union_tag_invalid":
            known = [tag.strip(" '") for tag in context["expected_tags"].split(",")]
            word = context["tag"]
            tag = context["discriminator"].strip("'")
            return _dotted((*path, tag)), f"unknown word {word!r}{did_you_mean(word, known)}"
        if kind == "union_tag_not_found":
            tag = context["discriminator"].strip("'")
            return _dotted((*path, tag)), f"this key is missing: {_TAGS[tag]}"
        if kind in _EXPECTED:
            return _dotted(path), f"needs {_EXPECTED[kind]}; came {value!r}"
        return _dotted(path), detail["msg"]

    def _walk(self, loc: tuple[int | str, ...]) -> tuple[tuple[int | str, ...], Any]:
        """The part of pydantic's location that exists in the data, and its value; pydantic adds tags."""
        path: tuple[int | str, ...] = ()
        value: Any = self.data
        for part in loc:
            try:
                value = value[part]
            except (KeyError, IndexError, TypeError):
                continue
            path = (*path, part)
        return path, value


def _dotted(path: tuple[int | str, ...]) -> str:
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path).removeprefix(".")
