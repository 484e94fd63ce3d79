"""Bodies that are known in part: the same equations with numbers put in, and shorter ones."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

import freebody as fb
from freebody.equations import OperationCount, SymbolicBody

from . import languages
from .kernel import AGREE, KERNELS, POINTS, disagreement, forms_in, random_arguments

MASS, COM = 2.5, (0.3, -0.2, 0.4)
NUMBERS = {"m": MASS, "x_c": COM[0], "y_c": COM[1], "z_c": COM[2], "A": 1.2, "B": 1.6, "C": 0.9} | {
    "I_xx": 1.2,
    "I_xy": 0.1,
    "I_xz": -0.2,
    "I_yy": 1.5,
    "I_yz": 0.3,
    "I_zz": 0.9,
}
FULL = np.array([[1.2, 0.1, -0.2], [0.1, 1.5, 0.3], [-0.2, 0.3, 0.9]])
NAMES = (("I_xx", "I_xy", "I_xz"), ("I_xy", "I_yy", "I_yz"), ("I_xz", "I_yz", "I_zz"))
AXIS = (0.0, 0.0, COM[2])
# About the origin a tensor must be that of a body: FULL about the mass centre, moved.
MOVED = fb.RigidBody(MASS, AXIS, inertia_about_com=FULL)
MOVED_DIAGONAL = fb.RigidBody(MASS, AXIS, inertia_about_origin=np.diag([1.9, 2.1, 0.9]))


class Known(NamedTuple):
    """A body in symbols, and the same in numbers."""

    symbolic: SymbolicBody | fb.RigidBody
    numeric: fb.RigidBody
    numbers: dict[str, float]


BODIES = {
    "numbers": Known(MOVED, MOVED, {}),
    "tensor about the mass centre": Known(
        SymbolicBody(inertia_about_com=NAMES), fb.RigidBody(MASS, COM, inertia_about_com=FULL), NUMBERS
    ),
    "mass centre on an axis": Known(SymbolicBody(com=(0, 0, "z_c"), inertia_about_com=NAMES), MOVED, NUMBERS),
    "on an axis, about the origin": Known(
        SymbolicBody(com=(0, 0, "z_c"), inertia_about_origin=("A", "B", "C")),
        MOVED_DIAGONAL,
        NUMBERS | {"A": 1.9, "B": 2.1, "C": 0.9},
    ),
    "centred": Known(
        SymbolicBody(com=(0, 0, 0), inertia_about_com=NAMES),
        fb.RigidBody(MASS, inertia_about_com=FULL),
        NUMBERS,
    ),
    "centred, about the origin": Known(
        SymbolicBody(com=(0, 0, 0), inertia_about_origin=NAMES),
        fb.RigidBody(MASS, inertia_about_com=FULL),
        NUMBERS,
    ),
    "diagonal": Known(
        SymbolicBody(com=(0, 0, 0), inertia_about_com=("A", "B", "C")),
        fb.RigidBody(MASS, inertia_about_com=np.diag([1.2, 1.6, 0.9])),
        NUMBERS,
    ),
    "symmetric": Known(
        SymbolicBody(com=(0, 0, 0), inertia_about_com=("A", "A", "C")),
        fb.RigidBody(MASS, inertia_about_com=np.diag([1.2, 1.2, 0.9])),
        NUMBERS,
    ),
    "half in numbers": Known(
        SymbolicBody(MASS, (0.3, "y_c", 0.4), inertia_about_com=(("A", 0.1, 0), (0.1, 1.5, 0), (0, 0, "C"))),
        fb.RigidBody(MASS, COM, inertia_about_com=[[1.2, 0.1, 0], [0.1, 1.5, 0], [0, 0, 0.9]]),
        NUMBERS,
    ),
}
CHARTS = ("quaternion", "zyx", "zxz")
FORMS = [(chart, form) for chart in CHARTS for form in forms_in(chart)]


@cache
def printed(form: str, chart: str, which: str) -> fb.Equations:
    return fb.equations(form, None if form in ("1.8", "1.11") else chart, BODIES[which].symbolic)


def check(form: str, chart: str, which: str, run: languages.Run) -> None:
    equations, known = printed(form, chart, which), BODIES[which]
    g = random_arguments(np.random.default_rng(7), chart, POINTS)
    if "body" in equations.arguments:
        body = [known.numbers[name] for name in equations.arguments["body"]]
        g["body"] = np.tile(body, (POINTS, 1))
    got = run(equations, {name: g[name] for name in equations.arguments})
    assert max(map(disagreement, got, KERNELS[form](known.numeric, g, chart))) < AGREE


@pytest.mark.parametrize("which", BODIES)
@pytest.mark.parametrize(("chart", "form"), FORMS)
def test_a_body_known_in_part_moves_as_the_kernels(chart: str, form: str, which: str) -> None:
    check(form, chart, which, languages.run_graph)
    check(form, chart, which, languages.run_numpy)


def test_printed_c_of_a_body_known_in_part(tmp_path: Path) -> None:
    names = {
        f"f_{i}": (form, "zyx", which)
        for i, (form, which) in enumerate((form, which) for form in forms_in("zyx") for which in BODIES)
    }
    library = languages.Library(tmp_path, {name: printed(*case) for name, case in names.items()})
    for name, case in names.items():
        check(*case, lambda _, given, name=name: library.run(name, given))


def test_only_symbols_are_arguments() -> None:
    assert "body" not in printed("2.10", "zyx", "numbers").arguments
    assert printed("2.10", "zyx", "symmetric").arguments["body"] == ("m", "A", "C")
    assert printed("2.10", "zyx", "half in numbers").arguments["body"] == ("y_c", "A", "C")


def count(form: str, angles: str, body: SymbolicBody) -> OperationCount:
    return fb.equations(form, angles, body).operation_count


# From what is known least to what is known most.
STRUCTURES = {
    "mass centre": [
        SymbolicBody(),
        SymbolicBody(com=(0, 0, "z_c")),
        SymbolicBody(com=(0, 0, 0)),
    ],
    "tensor": [
        SymbolicBody(com=(0, 0, 0)),
        SymbolicBody(com=(0, 0, 0), inertia_about_com=("A", "B", "C")),
        SymbolicBody(com=(0, 0, 0), inertia_about_com=("A", "A", "C")),
    ],
}


@pytest.mark.parametrize("angles", ["zyx", "zxz", "yzx"])
@pytest.mark.parametrize("form", ["1.8", "1.11", "2.7", "2.8", "2.10", "2.11", "2.12", "3.1", "3.2"])
@pytest.mark.parametrize("of", STRUCTURES)
def test_what_is_known_makes_equations_shorter(of: str, form: str, angles: str) -> None:
    counts = [count(form, angles, body) for body in STRUCTURES[of]]
    shared = [c.shared for c in counts]
    assert shared[0] > shared[1] > shared[2]
    # Written out, the solution for the rates is not always shorter, for its determinant is no product then.
    written_out = [c.written_out for c in counts]
    assert written_out[0] >= written_out[1] >= written_out[2]
