"""Whole models: their equations are their derivative, the equations' Jacobians those by duals."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import casadi as ca
import jax
import numpy as np
import pytest

import freebody as fb

from . import languages
from .kernel import AGREE, POINTS, Array, Values, derivatives, disagreement, random_arguments
from .laws import BODY, fin, fuselage, hull, pilot, thrust, wing

PLAIN = [fb.UniformGravity(), fb.LinearDamping([1.0, 2.0, 3.0, 0.1, 0.2, 0.3])]
EVERY = [
    *PLAIN,
    fb.PointMassGravity(50.0, center=(2.0, 3.0, -8.0)),
    fb.QuadraticDamping([0.1, 0.2, 0.3, 0.01, 0.02, 0.03]),
    fb.ConstantWrench((3.0, -2.0, 1.0), (0.1, 0.2, -0.1), axes="world", at=(0.3, 0.2, -0.1)),
    fb.InputWrench(at=(0.1, 0.0, -0.2)),
    fin,
    thrust,
]
TABLES = [
    *EVERY,
    wing,
    fb.TabulatedWrench([0.0, 2.0, 2.0, 9.0], force=np.sin(np.arange(12.0)).reshape(4, 3)),
]
FLYING = [*PLAIN, fin, thrust]
# What is printed comes first.
LAWS: dict[str, tuple[list[fb.Force], fb.ControlLaw | None]] = {
    "no forces": ([], None),
    "gravity and damping": (PLAIN, None),
    "every force": (EVERY, None),
    "controlled": (FLYING, pilot),
    "tables of several variables": ([hull, fuselage], None),
    "tables": (TABLES, None),
}
PRINTED = [name for name in LAWS if name != "tables"]
CHARTS = [
    *((chart, "quasi_velocity") for chart in ("quaternion", "zyx", "zxz", "yzx")),
    *((chart, "generalized") for chart in ("quaternion", "zyx", "zxz", "yzx")),
]
PRINTED_IN = (("quaternion", "quasi_velocity"), ("zyx", "generalized"))


@cache
def model_of(which: str, chart: str, form: str) -> fb.Model:
    forces, control = LAWS[which]
    return fb.Model(BODY, forces, chart, form, control=control)  # type: ignore[arg-type]


@cache
def equations_of(which: str, chart: str, form: str) -> fb.Equations:
    return fb.equations("3.2", model=model_of(which, chart, form))


@cache
def points(which: str, chart: str, form: str) -> Values:
    model, rng = model_of(which, chart, form), np.random.default_rng(11)
    g = random_arguments(rng, chart, POINTS)
    rigid = g["x"]
    if form == "generalized":
        rates = g["q_dot"][:, 3:]
        if chart == "quaternion":
            # Rates that keep the length: half the product with (0, omega).
            rates = np.array([fb.forms.quaternion_rate(x[3:7], w) for x, w in zip(rigid, rates, strict=True)])
        rigid = np.hstack([rigid[:, :-6], g["q_dot"][:, :3], rates])
    more = rng.uniform(-0.5, 0.5, (POINTS, model.n_states - rigid.shape[1]))
    u = rng.uniform(-1.0, 1.0, (POINTS, model.n_inputs))
    return {"t": g["t"], "x": np.hstack([rigid, more]), "u": u}


def given(equations: fb.Equations, g: Values) -> Values:
    return {name: g[name] for name in equations.arguments}


def agree(got: Array, wanted: Array) -> None:
    """Each entry relative to itself, or to a hundredth of the largest: all are of order one."""
    scale = np.maximum(np.abs(wanted), 1e-2 * np.abs(wanted).max(axis=-1, keepdims=True))
    assert (np.abs(got - wanted) / scale).max() < AGREE


@pytest.mark.parametrize("which", LAWS)
@pytest.mark.parametrize(("chart", "form"), CHARTS)
def test_equations_are_the_models_derivative(which: str, chart: str, form: str) -> None:
    case = (which, chart, form)
    equations, g = equations_of(*case), points(*case)
    (got,) = languages.run_graph(equations, given(equations, g))
    wanted = derivatives(model_of(*case), g)
    agree(got, wanted)
    assert disagreement(got[:, :3], wanted[:, :3]) < AGREE


@pytest.mark.parametrize("language", languages.PYTHONIC)
@pytest.mark.parametrize("which", PRINTED)
def test_printed_equations_are_the_models_derivative(which: str, language: str) -> None:
    for chart, form in PRINTED_IN:
        equations, g = equations_of(which, chart, form), points(which, chart, form)
        (got,) = languages.PYTHONIC[language](equations, given(equations, g))
        agree(got, derivatives(model_of(which, chart, form), g))


def jacobians(which: str, chart: str, form: str) -> tuple[Array, Array]:
    """By duals, at every point."""
    model, g = model_of(which, chart, form), points(which, chart, form)
    pairs = [model.jacobian(*a) for a in zip(g["t"], g["x"], g["u"], strict=True)]
    return np.array([a for a, _ in pairs]), np.array([b for _, b in pairs])


@pytest.mark.parametrize("which", LAWS)
@pytest.mark.parametrize(("chart", "form"), CHARTS)
def test_jacobians_of_the_equations_are_those_by_duals(which: str, chart: str, form: str) -> None:
    case = (which, chart, form)
    equations, g = equations_of(*case), points(*case)
    for by, wanted in zip(("x", "u"), jacobians(*case), strict=True):
        (got,) = languages.run_graph(derived := equations.jacobian(by), given(derived, g))
        agree(got.reshape(POINTS, -1), wanted.reshape(POINTS, -1))


@pytest.mark.parametrize("language", ["numpy", "jax", "casadi"])
@pytest.mark.parametrize("which", PRINTED)
def test_printed_jacobians_are_those_by_duals(which: str, language: str) -> None:
    case = (which, "quaternion", "quasi_velocity")
    equations, g = equations_of(*case).jacobian("x"), points(*case)
    (got,) = languages.PYTHONIC[language](equations, given(equations, g))
    agree(got.reshape(POINTS, -1), jacobians(*case)[0].reshape(POINTS, -1))


def test_models_in_printed_c(tmp_path: Path) -> None:
    printed = {
        f"f_{i}": case for i, case in enumerate((which, *chart) for which in PRINTED for chart in PRINTED_IN)
    }
    functions = {name: equations_of(*case) for name, case in printed.items()}
    derived = {f"{name}_x": e.jacobian("x") for name, e in functions.items()}
    library = languages.Library(tmp_path, functions | derived)
    for name, case in printed.items():
        g = points(*case)
        (rate,) = library.run(name, given(functions[name], g))
        agree(rate, derivatives(model_of(*case), g))
        (jacobian,) = library.run(f"{name}_x", given(derived[f"{name}_x"], g))
        agree(jacobian.reshape(POINTS, -1), jacobians(*case)[0].reshape(POINTS, -1))


def test_jax_differentiates_what_is_printed_to_the_same() -> None:
    """A derivative by another, of the printed text, which knows nothing of ours."""
    case = ("controlled", "zyx", "quasi_velocity")
    equations, g = equations_of(*case), points(*case)
    names = list(equations.arguments)
    with jax.enable_x64(True):
        f = languages.function(equations.jax("f"), "f")
        derivative = jax.vmap(jax.jacfwd(f, names.index("x")))
        got = np.asarray(derivative(*(jax.numpy.asarray(g[name]) for name in names)))
    agree(got.reshape(POINTS, -1), jacobians(*case)[0].reshape(POINTS, -1))


@pytest.mark.parametrize("which", PRINTED)
def test_casadi_differentiates_what_is_printed_to_the_same(which: str) -> None:
    case = (which, "zyx", "quasi_velocity")
    equations, g = equations_of(*case), points(*case)
    names = list(equations.arguments)
    symbols = [ca.SX.sym(name, len(s)) for name, s in equations.arguments.items()]
    result = languages.function(equations.casadi("f"), "f")(*symbols)
    f = ca.Function("f", symbols, [ca.jacobian(result, symbols[names.index("x")])])
    got = np.array([f(*(g[name][k] for name in names)).full() for k in range(POINTS)])
    agree(got.reshape(POINTS, -1), jacobians(*case)[0].reshape(POINTS, -1))


def test_a_symbolic_body_in_a_model() -> None:
    model = model_of("every force", "zyx", "quasi_velocity")
    equations = fb.equations("3.2", model=model, body=fb.SymbolicBody())
    g = points("every force", "zyx", "quasi_velocity")
    tensor = BODY.inertia_about_origin[np.triu_indices(3)]
    body = np.tile([BODY.mass, *BODY.com, *tensor], (POINTS, 1))
    (rate,) = equations.evaluate(**g, body=body).values()
    agree(rate, derivatives(model, g))
