"""The kinds of value that the keys of a model file take, and the section they stand in."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, GetCoreSchemaHandler, model_validator
from pydantic_core import CoreSchema, core_schema

from .units import FieldError, Shape, to_si

__all__ = ["Choice", "OneOf", "Quantity", "Section", "did_you_mean"]


class Quantity:
    """An array of one of `shapes` in the SI `unit`, or a float where no shape is given; see `to_si`."""

    def __init__(self, unit: str, *shapes: Shape, positive: bool = False) -> None:
        self.unit, self.shapes, self.positive = unit, shapes or ((),), positive

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    def read(self, value: Any) -> NDArray[np.float64] | float:
        array = to_si(value, self.unit, *self.shapes)
        if self.positive and not np.all(array > 0):
            raise FieldError(f"must be positive; came {value!r}")
        return array if array.ndim else float(array)


class Choice:
    """One of a few words."""

    def __init__(self, *words: str) -> None:
        self.words = words

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    def read(self, value: Any) -> str:
        if value not in self.words:
            raise FieldError(f"unknown word {value!r}{did_you_mean(value, self.words)}")
        return value


class OneOf:
    """One of several sections, told by the word that each has under the key `tag`."""

    def __init__(self, tag: str, sections: Iterable[type[Section]]) -> None:
        self.tag, self.sections = tag, tuple(sections)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        words = {get_args(s.model_fields[self.tag].annotation)[0]: s for s in self.sections}
        schemas = {word: handler.generate_schema(section) for word, section in words.items()}
        return core_schema.tagged_union_schema(schemas, self.tag)


class Section(BaseModel):
    """A table of the model file: its fields are the keys it may have, each with its meaning."""

    model_config = ConfigDict(arbitrary_types_allowed=True, frozen=True, strict=True)

    @model_validator(mode="before")
    @classmethod
    def _check_keys(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            raise FieldError(f"needs a table with the keys {', '.join(cls.model_fields)}; came {data!r}")
        for key in data:
            if key not in cls.model_fields:
                raise FieldError(f"unknown key{did_you_mean(key, cls.model_fields)}", (key,))
        for key, field in cls.model_fields.items():
            if field.is_required() and key not in data:
                raise FieldError(f"this key is missing: {field.description}", (key,))
        return data

    def given(self, *exclude: str) -> dict[str, Any]:
        """The values that the file gives, by key; the library's defaults hold for the others."""
        return {key: getattr(self, key) for key in self.model_fields_set if key not in exclude}

    def exactly_one(self, *keys: str) -> None:
        """Raises unless the file gives exactly one of `keys`."""
        came = [key for key in keys if key in self.model_fields_set]
        if len(came) != 1:
            raise FieldError(f"needs exactly one of {', '.join(keys)}; came {' and '.join(came) or 'none'}")

    def at_most_one(self, *keys: str) -> None:
        """Raises if the file gives more than one of `keys`."""
        came = [key for key in keys if key in self.model_fields_set]
        if len(came) > 1:
            raise FieldError(f"takes one of {', '.join(keys)}; came {' and '.join(came)}")


def did_you_mean(word: Any, known: Iterable[str]) -> str:
    """`; did you mean ...?` where a known word is near, and what is known."""
    words = list(known)
    folded = {w.casefold(): w for w in words}
    near = difflib.get_close_matches(str(word).casefold(), folded, n=1, cutoff=0.6)
    return (f"; did you mean {folded[near[0]]!r}?" if near else "") + f" (known: {', '.join(words)})"
