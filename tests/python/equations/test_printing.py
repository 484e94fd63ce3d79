"""Printed text: the same bytes for the same equations, names that do not collide, units in the comment."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.equations import SymbolicBody

from . import languages
from .laws import BODY, fin

# Every printer, of every kind of equations, as one text.
PRINT = """
import sys
sys.path.insert(0, {tests!r})
import freebody as fb
from freebody.equations import SymbolicBody
from python.equations.laws import BODY, fin, pilot, thrust

model = fb.Model(BODY, [fb.UniformGravity(), fin, thrust], "zyx", control=pilot)
every = [
    *(fb.equations(form, "zyx", simplify=way) for form in ("1.8", "2.8", "2.12") for way in (True, False)),
    fb.equations("2.10", "zxz", SymbolicBody(com=(0, 0, "z_c"), inertia_about_com=("A", "A", "C"))),
    fb.equations("christoffel_symbols", "yzx"),
    fb.equations("3.2", model=model),
    fb.equations("3.2", model=model).jacobian("x"),
]
for e in every:
    print(e.operation_count, e.latex(common=True), e.c(), e.numpy(), e.jax(), e.casadi(), e.sympy())
"""


def printed(seed: str) -> bytes:
    environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(sys.path)}
    tests = str(Path(__file__).parents[2])
    done = subprocess.run(
        [sys.executable, "-c", PRINT.format(tests=tests)], env=environment, capture_output=True, check=True
    )
    return done.stdout


def test_two_processes_print_the_same_bytes() -> None:
    first = printed("0")
    assert len(first) > 100_000
    assert printed("1") == first


@pytest.mark.parametrize("printer", ["latex", "c", "numpy", "jax", "casadi", "sympy"])
def test_one_process_prints_the_same_twice(printer: str) -> None:
    def text(simplify: bool) -> str:
        return getattr(fb.equations("2.8", "zyx", simplify=simplify), printer)()

    again = fb.equations("2.8", "zyx")
    assert getattr(again, printer)() == getattr(again, printer)() == text(True)
    assert text(False) == text(False)


def test_what_was_printed_before_changes_nothing() -> None:
    e = fb.equations("2.10", "zyx")
    first = e.c()
    e.latex()
    e.latex(common=True)
    assert e.operation_count == fb.equations("2.10", "zyx").operation_count
    assert e.c() == first


def test_a_symbol_may_have_the_name_of_a_result(tmp_path: Path) -> None:
    """Of a matrix, a rate, an argument or a function."""
    about = ("A", "B", "C")
    cases = {f"f_{name}": fb.equations(name, "zyx", SymbolicBody(inertia_about_com=about)) for name in "AB"}
    cases["f_C"] = fb.equations("C", "zyx")
    cases["f_q"] = fb.equations(
        "2.10", "zyx", SymbolicBody("q", ("x_com", "f", "wrench"), inertia_about_com=("A", "body", "C"))
    )
    cases["f_x_dot"] = fb.equations("3.1", "zyx")
    library = languages.Library(tmp_path, cases)
    for name, equations in cases.items():
        g = {n: 0.1 * (1.0 + np.arange(1.0, 1.0 + len(s)))[None] for n, s in equations.arguments.items()}
        wanted = languages.run_graph(equations, g)
        for got in (
            library.run(name, g),
            languages.run_numpy(equations, g),
            languages.run_casadi(equations, g),
        ):
            for a, b in zip(got, wanted, strict=True):
                np.testing.assert_allclose(a, b, rtol=1e-13, atol=1e-13)  # some roundings


def test_the_comment_states_order_frames_and_units() -> None:
    text = fb.equations("2.10", "zyx").c()
    comment = text[text.index("/*") : text.index("*/")]
    for part in (
        "Konoplev (2.10)",
        "angles zyx",
        "position of the body origin, world axes, and the angles",
        "x [m], y [m], z [m], psi [rad], theta [rad], phi [rad]",
        "x_dot [m/s]",
        "psi_ddot [rad/s^2]",
        "force and moment about the body origin, body axes",
        "F_x [N]",
        "M_z [N m]",
        "tensor about the origin, in body axes",
        "J_xz [kg m^2]",
        "left (6)",
        "right (6)",
    ):
        assert part in comment
    docstring = languages.function(fb.equations("2.10", "zyx").numpy("f"), "f").__doc__
    assert str(docstring).startswith("Konoplev (2.10)")


def test_balance_is_printed_as_equations() -> None:
    lines = fb.equations(
        "2.10", "zyx", SymbolicBody(com=(0, 0, 0), inertia_about_com=("A", "B", "C"))
    ).latex()
    body = lines.splitlines()[1:-1]
    assert lines.startswith("\\begin{align*}")
    assert len(body) == 6
    assert all(line.count("&=") == 1 for line in body)
    assert body[0].split("&=")[0].strip() in {r"m \ddot{x}", r"\ddot{x} m"}


def test_laws_and_models_print_their_names() -> None:
    model = fb.Model(BODY, [fb.UniformGravity(), fin])
    equations = fb.equations("3.2", model=model)
    assert equations.arguments["x"][-1] == "fin_servo"
    assert equations.arguments["u"] == ("rudder",)
    assert "rudder [rad]" in equations.c()
