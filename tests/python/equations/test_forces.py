"""Forces in the equations: what acts is what the kernel's forces give; what is computed is its motion."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.elements import HarmonicGravity

from . import languages
from .kernel import AGREE, POINTS, Array, Values, derivatives, disagreement, random_arguments
from .laws import BODY, fin, fuselage, hull, thrust, wing

COEFFICIENTS = np.diag([1.0, 2.0, 3.0, 0.1, 0.2, 0.3]) + 0.05
FORCES: dict[str, list[fb.Force]] = {
    "uniform gravity": [fb.UniformGravity(9.81, direction=(0.6, 0.0, 0.8))],
    "point mass gravity": [fb.PointMassGravity(50.0, center=(2.0, 3.0, -8.0))],
    "point mass gravity without torque": [
        fb.PointMassGravity(50.0, center=(2.0, 3.0, -8.0), gradient_torque=False)
    ],
    "harmonic gravity": [
        HarmonicGravity(
            *(50.0, 1.0),
            C=np.tril(np.cos(np.arange(16.0)).reshape(4, 4)),
            S=np.tril(np.sin(np.arange(16.0)).reshape(4, 4)) * [0.0, 1.0, 1.0, 1.0],
            center=(2.0, 3.0, -8.0),
            rotation_rate=0.3,
            gradient_torque=True,
        )
    ],
    "linear damping": [fb.LinearDamping(COEFFICIENTS)],
    "quadratic damping": [fb.QuadraticDamping([0.1, 0.2, 0.3, 0.01, 0.02, 0.03])],
    "constant wrench": [fb.ConstantWrench((3.0, -2.0, 1.0), (0.1, 0.2, -0.1), at=(0.3, 0.2, -0.1))],
    "constant wrench in the world": [
        fb.ConstantWrench((1.0, 2.0, 3.0), (0.2, 0.1, 0.3), axes="world", at=(-0.2, 0.1, 0.4))
    ],
    "input wrench": [fb.InputWrench(at=(0.1, 0.0, -0.2))],
    "input wrench in the world": [fb.InputWrench(axes="world", at=(0.1, 0.0, -0.2))],
    "law of a user": [fin],
    "laws of users": [fin, thrust],
    "several": [fb.UniformGravity(), fb.LinearDamping(COEFFICIENTS), fb.InputWrench(), fin, thrust],
}
TABLES: dict[str, list[fb.Force]] = {
    "tabulated wrench": [
        fb.TabulatedWrench(
            [0.0, 2.0, 2.0, 5.0, 9.0],
            force=np.sin(np.arange(15.0)).reshape(5, 3),
            moment=np.cos(np.arange(15.0)).reshape(5, 3),
        )
    ],
    "wrench that is held": [
        fb.TabulatedWrench([0.0, 2.0, 5.0], force=np.sin(np.arange(9.0)).reshape(3, 3), interpolation="hold")
    ],
    "law with a table": [fb.UniformGravity(), wing, fin],
    "law with a table of two variables": [hull],
    "law with tables of three and of four variables": [fuselage],
}
ALL = FORCES | TABLES
CASES = [("1.8", "quaternion"), ("1.8", "zyx"), ("1.11", "quaternion"), ("1.11", "yzx")]
CASES += [(form, "zyx") for form in ("2.4", "2.7", "2.8", "2.9", "2.10", "2.11", "3.1")]
CASES += [("2.8", "zxz"), ("2.10", "zxz"), ("3.1", "yzx"), ("3.2", "quaternion"), ("3.2", "zxz")]
IN_CODE = [("1.8", "quaternion"), ("2.10", "zyx"), ("3.1", "yzx"), ("3.2", "zxz")]


@cache
def printed(form: str, chart: str, which: str) -> fb.Equations:
    return fb.equations(form, chart, BODY, ALL[which])


def arguments(equations: fb.Equations, chart: str) -> Values:
    """Random values; as many inputs and states as are asked for."""
    rng = np.random.default_rng(3)
    g = random_arguments(rng, chart, POINTS)
    g |= {"quaternion": g["x"][:, 3:7]}
    names = equations.arguments
    g |= {name: rng.uniform(-1.0, 1.0, (POINTS, len(names.get(name, ())))) for name in ("u", "states")}
    g["x"] = np.hstack([g["x"], g["states"]]) if not g["states"].size else g["x"]
    extra = len(names.get("x", ())) - g["x"].shape[1]
    if extra > 0:
        g["x"] = np.hstack([g["x"], rng.uniform(-1.0, 1.0, (POINTS, extra))])
    return g


def at_points(call: Callable[..., Array], g: Values, model: fb.Model, x: Array) -> Array:
    """The kernel's at every point; inputs that the equations do not ask for play no part, and are zero."""
    asked = g["u"].shape[1] == len(model.input_names)
    u = g["u"] if asked else np.zeros((POINTS, len(model.input_names)))
    return np.array([call(*given) for given in zip(g["t"], x, u, strict=True)])


def wanted(form: str, chart: str, which: str, g: Values) -> list[Array]:
    forces = ALL[which]
    rigid = 13 if chart == "quaternion" else 12
    quasi = fb.Model(BODY, forces, chart)
    if form == "3.2":
        return [derivatives(quasi, g)]
    if form in ("1.8", "1.11"):
        attitude = g["quaternion"] if chart == "quaternion" else g["alpha"]
        x = np.hstack([g["position"], attitude, g["twist"], g["states"]])
        if form == "1.11":
            return [at_points(quasi.derivative, g, quasi, x)[:, rigid - 6 : rigid]]
        left = fb.forms.inverse_dynamics(BODY, g["twist"], g["twist_rate"])
        return [left, at_points(quasi.wrench, g, quasi, x)]
    general = fb.Model(BODY, forces, chart, "generalized")
    x = np.hstack([g["q"], g["q_dot"], g["states"]])
    if form in ("2.4", "2.7", "2.9", "3.1"):
        rate = at_points(general.derivative, g, general, x)[:, :12]
        return [rate if form == "3.1" else rate[:, 6:]]
    wrench = at_points(general.wrench, g, general, x)
    motion = (g["q"], g["q_dot"], g["q_ddot"])
    if form == "2.8":
        m = fb.forms.generalized(BODY, *motion[:2], chart)
        left = np.einsum("nij,nj->ni", m.A1, motion[2]) + np.einsum("nij,nj->ni", m.B1, motion[1])
        return [left, wrench]
    left = fb.forms.lagrange_operator(BODY, *motion, chart)
    return [left, fb.forms.generalized_force(g["q"], wrench, chart)]


def check(form: str, chart: str, which: str, run: languages.Run) -> None:
    equations = printed(form, chart, which)
    g = arguments(equations, chart)
    got = run(equations, {name: g[name] for name in equations.arguments})
    wants = wanted(form, chart, which, g)
    for a, b in zip(got, wants, strict=True):
        rigid = b.shape[1] - b.shape[1] % 3 + (b.shape[1] == 13)
        assert disagreement(a[:, :rigid], b[:, :rigid]) < AGREE
        np.testing.assert_allclose(a[:, rigid:], b[:, rigid:], rtol=AGREE, atol=0)


@pytest.mark.parametrize("which", ALL)
@pytest.mark.parametrize(("form", "chart"), CASES)
def test_forces_act_as_in_the_kernel(form: str, chart: str, which: str) -> None:
    check(form, chart, which, languages.run_graph)


@pytest.mark.parametrize("language", languages.PYTHONIC)
@pytest.mark.parametrize("which", ALL)
def test_printed_forces_act_as_in_the_kernel(which: str, language: str) -> None:
    for form, chart in IN_CODE:
        check(form, chart, which, languages.PYTHONIC[language])


def test_forces_in_printed_c_act_as_in_the_kernel(tmp_path: Path) -> None:
    names = {
        f"f_{i}": (*case, which)
        for i, (case, which) in enumerate((case, which) for case in IN_CODE for which in ALL)
    }
    library = languages.Library(tmp_path, {name: printed(*case) for name, case in names.items()})
    for name, case in names.items():
        check(*case, lambda _, given, name=name: library.run(name, given))
