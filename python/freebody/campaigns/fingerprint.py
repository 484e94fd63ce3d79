"""A short text that two objects share when they are made of the same things.

Pickles do not serve: their bytes tell which parts were one object in memory, which differs between processes.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from types import BuiltinFunctionType, CodeType, FunctionType
from typing import Any

import numpy as np

__all__ = ["fingerprint"]


def fingerprint(thing: Any) -> str:
    """Of numbers, text, arrays, containers, functions and all that pickles: the same in every process."""
    digest = hashlib.sha256()
    _add(digest, thing, ())
    return digest.hexdigest()[:32]


def _add(digest: Any, thing: Any, around: tuple[int, ...]) -> None:
    if id(thing) in around:
        _tell(digest, f"cycle {len(around) - around.index(id(thing))}")
        return
    around = (*around, id(thing))
    kind, parts = _taken_apart(thing)
    _tell(digest, kind)
    _tell(digest, str(len(parts)))
    for part in parts:
        if isinstance(part, bytes):
            _tell(digest, part)
        else:
            _add(digest, part, around)


def _tell(digest: Any, text: str | bytes) -> None:
    data = text.encode() if isinstance(text, str) else text
    digest.update(len(data).to_bytes(8, "little") + data)


def _taken_apart(thing: Any) -> tuple[str, list[Any]]:
    """The kind of a thing and what it is made of: bytes, and things that are taken apart in turn."""
    match thing:
        case None | bool() | int() | str():
            kind, parts = type(thing).__name__, [str(thing).encode()]
        case float():
            kind, parts = "float", [thing.hex().encode()]
        case bytes():
            kind, parts = "bytes", [thing]
        case np.ndarray() | np.generic() if thing.dtype == object:
            kind, parts = f"array {thing.shape}", np.ravel(thing).tolist()
        case np.ndarray() | np.generic():
            kind, parts = f"array {thing.dtype.str} {thing.shape}", [np.ascontiguousarray(thing).tobytes()]
        case list() | tuple():
            kind, parts = _name(type(thing)), list(thing)
        case set() | frozenset():
            kind, parts = type(thing).__name__, sorted(fingerprint(item).encode() for item in thing)
        case Mapping():
            kind, parts = "mapping", [part for pair in thing.items() for part in pair]
        case type() | BuiltinFunctionType():
            kind, parts = "named", [_name(thing).encode()]
        case FunctionType():
            cells = [cell.cell_contents for cell in thing.__closure__ or ()]
            kind, parts = "function", [thing.__code__, cells, thing.__defaults__, thing.__kwdefaults__]
        case CodeType():
            kind, parts = "code", [thing.co_code, thing.co_names, thing.co_varnames, list(thing.co_consts)]
        case _:
            kind, parts = _object(thing)
    return kind, parts


def _object(thing: Any) -> tuple[str, list[Any]]:
    """By what pickle would make it of: a callable, its arguments, its state. Docstrings change no number."""
    reduced = thing.__reduce_ex__(2)
    if isinstance(reduced, str):
        return "named", [reduced.encode()]
    maker, arguments, state, *items = (*reduced, None, None)[:5]
    if isinstance(state, Mapping):
        state = {key: value for key, value in state.items() if key != "__doc__"}
    return "object", [maker, arguments, state, *(None if part is None else list(part) for part in items)]


def _name(thing: Any) -> str:
    return f"{thing.__module__}.{thing.__qualname__}"
