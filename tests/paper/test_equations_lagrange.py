"""Form (2.10) as printed, against Lagrange's equations that SymPy differentiates by itself.

The kinetic energy is written down here by hand, from elementary rotations, and nothing of freebody is in it.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import pytest
import sympy as sp

import freebody as fb
from freebody.equations import SymbolicBody

POINTS = 20


def turn(axis: str, angle: sp.Expr) -> sp.Matrix:
    """The rotation about a coordinate axis that takes body components to world components."""
    c, s = sp.cos(angle), sp.sin(angle)
    return {
        "x": sp.Matrix([[1, 0, 0], [0, c, -s], [0, s, c]]),
        "y": sp.Matrix([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
        "z": sp.Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
    }[axis]


class Symbols(NamedTuple):
    """Coordinates, their rates and second rates, wrench, and the body's numbers, each a list of symbols."""

    q: list[sp.Symbol]
    q_dot: list[sp.Symbol]
    q_ddot: list[sp.Symbol]
    wrench: list[sp.Symbol]
    body: list[sp.Symbol]


SYMBOLS = Symbols(
    *(list(sp.symbols(f"{name}:{n}", real=True)) for name, n in zip("qvafb", (6, 6, 6, 6, 10), strict=True))
)


class Sides(NamedTuple):
    left: list[sp.Expr]
    right: list[sp.Expr]


def body_frame(angles: str) -> tuple[sp.Matrix, sp.Matrix]:
    """The rotation, and the axes of the three turns in body axes as columns."""
    turns = [turn(axis, angle) for axis, angle in zip(angles, SYMBOLS.q[3:], strict=True)]
    units = [sp.eye(3)[:, "xyz".index(axis)] for axis in angles]
    first, second, third = turns
    columns = [third.T * second.T * units[0], third.T * units[1], units[2]]
    return first * second * third, sp.Matrix.hstack(*columns)


def by_sympy(angles: str, values: Mapping[sp.Symbol, sp.Expr | int] | None = None) -> Sides:
    """d/dt dT/dq_dot - dT/dq, and the generalized forces of a wrench about the origin by virtual work."""
    q, q_dot, q_ddot, wrench, body = SYMBOLS
    m, com = body[0], sp.Matrix(body[1:4])
    xx, xy, xz, yy, yz, zz = body[4:]
    tensor = sp.Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    rotation, axes = body_frame(angles)
    # A particle at r moves with o_dot + C (omega x r); its sums are m, m r_c and the tensor.
    coupling = -m * rotation * com.hat() * axes
    mass = sp.Matrix(sp.BlockMatrix([[m * sp.eye(3), coupling], [coupling.T, axes.T * tensor * axes]]))
    mass = mass.subs(dict(values or {}))
    rates = sp.Matrix(q_dot)
    energy = (rates.T * mass * rates)[0] / 2
    left = []
    for i in range(6):
        momentum = energy.diff(q_dot[i])
        change = sum(momentum.diff(q[j]) * q_dot[j] + momentum.diff(q_dot[j]) * q_ddot[j] for j in range(6))
        left.append(change - energy.diff(q[i]))
    force, moment = sp.Matrix(wrench[:3]), sp.Matrix(wrench[3:])
    return Sides(left, [*(rotation * force), *(axes.T * moment)])


def printed(angles: str, body: SymbolicBody | None, numbers: list[sp.Symbol]) -> Sides:
    """Ours, on the same symbols."""
    equations = fb.equations("2.10", angles, body)
    assert list(equations.arguments) == ["q", "q_dot", "q_ddot", "wrench", "body"]
    space: dict[str, Any] = {}
    exec(equations.sympy("lagrange"), space)
    return Sides(*(list(side) for side in space["lagrange"](*SYMBOLS[:4], numbers)))


@cache
def points() -> list[np.ndarray]:
    """Random values of all symbols; the second angle away from every singularity."""
    rng = np.random.default_rng(1788)
    columns = [rng.normal(size=(POINTS, len(group))) for group in SYMBOLS]
    columns[0][:, 3:] = rng.uniform(0.3, 1.2, (POINTS, 3))
    return columns


def numbers(sides: Sides) -> list[np.ndarray]:
    """Both sides at the random points: (points, 6) each."""
    values = sp.lambdify(SYMBOLS, list(sides), "numpy")(*(column.T for column in points()))
    return [np.stack([np.broadcast_to(x, POINTS) for x in side], axis=1) for side in values]


@pytest.mark.parametrize("angles", fb.forms.SEQUENCES)
def test_2_10_as_printed_is_lagranges_equation(angles: str) -> None:
    ours = numbers(printed(angles, None, SYMBOLS.body))
    for got, wanted in zip(ours, numbers(by_sympy(angles)), strict=True):
        # Sums of some hundred products of order one; forces and moments each against their length.
        for block in (slice(0, 3), slice(3, 6)):
            scale = np.linalg.norm(wanted[:, block], axis=1, keepdims=True)
            assert (np.abs(got - wanted)[:, block] / scale).max() < 1e-12


def reduced(expression: sp.Expr) -> Any:
    """The remainder that sin^2 + cos^2 = 1 leaves of a polynomial in sines and cosines: zero is zero."""
    pairs = [sp.symbols(f"s{i} c{i}") for i in range(3)]
    for angle, (s, c) in zip(SYMBOLS.q[3:], pairs, strict=True):
        expression = expression.subs({sp.sin(angle): s, sp.cos(angle): c})
    circles = [s**2 + c**2 - 1 for s, c in pairs]
    return sp.reduced(sp.expand(expression), circles, *(x for pair in pairs for x in pair))[1]


@pytest.mark.parametrize("angles", ["zyx", "yzx", "zxz"])
def test_2_10_of_a_diagonal_centred_body_is_lagranges_symbol_by_symbol(angles: str) -> None:
    m, *com = SYMBOLS.body[:4]
    xx, xy, xz, yy, yz, zz = SYMBOLS.body[4:]
    body = SymbolicBody(com=(0, 0, 0), inertia_about_com=("A", "B", "C"))
    ours = printed(angles, body, [m, xx, yy, zz])
    theirs = by_sympy(angles, dict.fromkeys([*com, xy, xz, yz], 0))
    for got, wanted in zip([*ours.left, *ours.right], [*theirs.left, *theirs.right], strict=True):
        assert wanted != 0
        assert reduced(got - wanted) == 0
