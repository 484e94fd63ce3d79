"""Faults of code that asks a traced value what it is: no value is known while a law is traced."""

from __future__ import annotations

import ast
import math

from freebody.errors import TraceError
from freebody.tracing.place import syntax_here
from freebody.tracing.trace import fault

__all__ = ["asked", "index_asked", "number_asked", "numbers_asked"]

_CHOOSE = "use np.where(condition, a, b): both are computed and one is chosen"
_STACK = (
    "np.array([...]) of traced values is an array of Python objects, on which NumPy compares by truth: "
    "build it with np.stack([...])"
)
_OF_CALLS = {
    "max": "use np.maximum(a, b)",
    "min": "use np.minimum(a, b)",
    "any": "use np.any(conditions)",
    "all": "use np.all(conditions)",
    "sorted": "a law has one order for all states; use np.maximum and np.minimum",
}
_OF_STATEMENTS = {
    ast.If: ("`if`", _CHOOSE),
    ast.IfExp: ("`if`", _CHOOSE),
    ast.While: ("`while`", "loop over a fixed range and use np.where(condition, a, b) inside"),
    ast.Assert: ("`assert`", "leave it out, and check parameters where you give them"),
}
_OF_MATH = {
    "asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2", "asinh": "arcsinh",
    "acosh": "arccosh", "atanh": "arctanh", "pow": "power", "fsum": "sum", "dist": "linalg.norm",
}  # fmt: skip


def asked() -> TraceError:
    """Code asks whether a traced value is true."""
    what, remedy = _truth()
    return fault(f"{what} depends on a traced value, which is not known yet", remedy)


def _truth() -> tuple[str, str]:
    node, parent = syntax_here() or (None, None)
    # The jump stands at the test, or at the whole statement.
    for outer in (node, parent):
        known = _of_syntax(outer, node)
        if known is not None:
            return known
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return f"{node.func.id}()", _OF_CALLS.get(node.func.id, _CHOOSE)
    if node is not None:
        return ast.unparse(node), _STACK
    return "the truth of a value", _CHOOSE


def _of_syntax(outer: ast.AST | None, node: ast.AST | None) -> tuple[str, str] | None:
    match outer:
        case ast.Compare(ops=[_, _, *_]):
            return "a chained comparison", "use np.logical_and(a < b, b < c)"
        case ast.UnaryOp(op=ast.Not()):
            return "`not`", "use np.logical_not(condition)"
        case ast.BoolOp(op=op):
            name = "and" if isinstance(op, ast.And) else "or"
            return f"`{name}`", f"use np.logical_{name}(a, b)"
        case ast.comprehension():
            return "`if` in a comprehension", _CHOOSE
        case ast.If() | ast.IfExp() | ast.While() | ast.Assert() if node in (outer, outer.test):
            return _OF_STATEMENTS[type(outer)]
    return None


def number_asked() -> TraceError:
    """Code asks for the number that a traced value is."""
    syntax = syntax_here()
    if syntax is not None and isinstance(syntax.node, ast.Subscript):
        return numbers_asked("numbers")
    if syntax is None or not isinstance(syntax.node, ast.Call):
        return numbers_asked("numbers")
    called = ast.unparse(syntax.node.func)
    name = called.rpartition(".")[2]
    what = f"{called}() needs a number, and a traced value is not known yet"
    if called in ("float", "int", "complex"):
        return fault(what, f"leave {called}() out" + (", or use np.floor" if called == "int" else ""))
    if hasattr(math, name) and not called.startswith(("np.", "numpy.")):
        return fault(what, f"use np.{_OF_MATH.get(name, name)}")
    return fault(
        what,
        "arrays of traced values are made with np.stack([...]), or with np.array([...]) without dtype; what "
        "other libraries do with numbers goes into fb.Table or fb.callback",
    )


def numbers_asked(dtype: object) -> TraceError:
    """Code writes a traced value into an array of numbers."""
    return fault(
        f"a traced value is written into an array of {dtype}",
        "build the array from its entries, np.stack([a, b, 0.0]), or start from np.zeros_like(traced)",
    )


def index_asked() -> TraceError:
    """Code uses a traced value as an index or a count."""
    syntax = syntax_here()
    if syntax is not None and isinstance(syntax.node, ast.Call):
        return fault(
            f"{ast.unparse(syntax.node.func)}() needs a count, and a traced value is not known yet",
            "loop over a fixed range and use np.where(condition, a, b) inside",
        )
    return fault(
        "a traced value is used as an index, and is not known yet",
        "use np.where(condition, a, b) to choose, fb.Table or np.interp to look up",
    )
