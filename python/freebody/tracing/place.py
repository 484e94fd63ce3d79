"""Where in a user's code the interpreter stands, and what it does there."""

from __future__ import annotations

import ast
import dis
import linecache
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from types import CodeType, FrameType, TracebackType
from typing import NamedTuple

import numpy as np

__all__ = ["Place", "definition", "here", "of_fault", "of_return", "syntax_here"]

_OURS_AND_NUMPYS = (Path(__file__).parents[1], Path(np.__file__).parent)
_NOT_THE_USERS = tuple(f"{folder}{os.sep}" for folder in _OURS_AND_NUMPYS)


class Place(NamedTuple):
    """A file, a line counted from 1, and what stands there."""

    file: str
    line: int
    text: str


def _place(file: str, line: int) -> Place:
    return Place(file, line, linecache.getline(file, line).strip())


def _is_the_users(code: CodeType) -> bool:
    return not code.co_filename.startswith(_NOT_THE_USERS)


def _user_frame() -> FrameType | None:
    frame: FrameType | None = sys._getframe(1)
    while frame is not None and not _is_the_users(frame.f_code):
        frame = frame.f_back
    return frame


def here() -> Place | None:
    """The innermost line that is neither ours nor NumPy's."""
    frame = _user_frame()
    return None if frame is None else _place(frame.f_code.co_filename, frame.f_lineno)


def of_fault(traceback: TracebackType | None, otherwise: Place) -> Place:
    """The innermost such line on the way of an exception."""
    found = otherwise
    while traceback is not None:
        if _is_the_users(traceback.tb_frame.f_code):
            found = _place(traceback.tb_frame.f_code.co_filename, traceback.tb_lineno)
        traceback = traceback.tb_next
    return found


def definition(code: CodeType) -> Place:
    """The line of `def`, below the decorators."""
    line = code.co_firstlineno
    while linecache.getline(code.co_filename, line).lstrip().startswith("@"):
        line += 1
    for later in range(line, line + 50):
        if linecache.getline(code.co_filename, later).lstrip().startswith(("def ", "async def ")):
            return _place(code.co_filename, later)
    return _place(code.co_filename, line)


def of_return(code: CodeType) -> Place:
    """The line of the only `return`, or that of `def` when there are several."""
    returns = [i for i in dis.get_instructions(code) if i.opname in ("RETURN_VALUE", "RETURN_CONST")]
    lines = {i.positions.lineno for i in returns if i.positions}
    line = lines.pop() if len(lines) == 1 else None
    return definition(code) if line is None else _place(code.co_filename, line)


class Syntax(NamedTuple):
    """A piece of syntax and what it stands in."""

    node: ast.AST
    parent: ast.AST | None


def syntax_here() -> Syntax | None:
    """The piece of syntax that the innermost user's frame works on; `None` when the source is not at hand."""
    frame = _user_frame()
    if frame is None:
        return None
    try:
        tree = ast.parse("".join(linecache.getlines(frame.f_code.co_filename)))
    except SyntaxError:
        return None
    position = list(frame.f_code.co_positions())[frame.f_lasti // 2]
    matches = [s for s in _walk(tree, None) if _position(s.node) == position]
    # Of pieces with the same text, `x` in a statement of `x` alone, the innermost is meant.
    return matches[-1] if matches else None


def _position(node: ast.AST) -> tuple[int | None, ...]:
    return tuple(getattr(node, key, None) for key in ("lineno", "end_lineno", "col_offset", "end_col_offset"))


def _walk(node: ast.AST, parent: ast.AST | None) -> Iterator[Syntax]:
    yield Syntax(node, parent)
    for child in ast.iter_child_nodes(node):
        yield from _walk(child, node)
