"""Laws of users: exact derivatives, the motion of built-in forces, the same bits everywhere."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

import freebody as fb

from .scenes import BODY, START, motion_gap

Array = NDArray[np.float64]
Numbers = Sequence[Any]
# Chain rules of some ten steps multiplied in another order, on numbers of order one to ten, and a solution
# with the inertia matrix and back.
EXACT = 1e-12
DIGITS, STEP = 50, "1e-18"  # central differences err by STEP^2

X, Y = np.array([-2.0, -1.0, 0.5, 1.0, 2.5]), np.array([-1.5, 0.0, 0.5, 2.0])
VALUES = np.sin(1.3 * X)
GRID = np.cos(X[:, None] + 0.7 * Y) + 0.2 * Y**2
LINEAR, CUBIC = fb.Table(X, VALUES), fb.Table(X, VALUES, "cubic")
LINEAR_2, CUBIC_2 = fb.Table((X, Y), GRID), fb.Table((X, Y), GRID, "cubic")


@fb.force(
    parameters={"k": (0.8, "N s^2/m^2"), "lag": (0.5, "s")},
    inputs={"rudder": "rad"},
    states={"servo": (0.0, "rad")},
)
def functions(s: Any, p: Any) -> Any:
    v, w = s.velocity_body, s.angular_velocity_body
    speed = np.linalg.norm(v)
    angle = np.arctan2(v[1], v[0]) + np.clip(s.states.servo, -0.4, 0.4)
    size = p.k * speed * np.hypot(v[1], v[2])
    down = s.world_from_body.T @ np.stack([0.0, 0.0, 1.0])
    force = size * np.stack([-np.cos(angle), np.sin(angle), 0.0]) + np.where(w[2] > 0.0, 3.0, -1.0) * down
    rate = np.tanh(s.inputs.rudder - s.states.servo) * np.exp(-0.1 * s.time) / p.lag
    return fb.wrench(force, 0.2 * np.cross(w, force), at=(-1.0, 0.2, 0.1)), {"servo": rate}


@fb.force
def tables(s: Any) -> Any:
    v, w = s.velocity_body, s.angular_velocity_body
    force = np.stack([LINEAR(v[0]), CUBIC(v[1] * w[2]), LINEAR_2(v[2], w[0])])
    moment = np.stack([CUBIC_2(v[0], v[1]), np.interp(s.position_world[2], X, VALUES), 0.0])
    return fb.wrench(force=force * s.mass, moment=moment)


def norm(v: Numbers) -> Any:
    return mp.sqrt(sum(x * x for x in v))


def cross(a: Numbers, b: Numbers) -> list[Any]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def at(r: Numbers, f: Numbers, moment: Numbers) -> list[Any]:
    return [*f, *(a + b for a, b in zip(moment, cross(r, f), strict=True))]


def functions_by_hand(t: Any, x: Numbers, u: Numbers) -> list[Any]:
    """`functions` in the chart "zyx", on mpmath's numbers."""
    v, w, servo = x[6:9], x[9:12], x[12]
    _, theta, phi = x[3:6]
    down = [-mp.sin(theta), mp.cos(theta) * mp.sin(phi), mp.cos(theta) * mp.cos(phi)]
    angle = mp.atan2(v[1], v[0]) + min(max(servo, mp.mpf("-0.4")), mp.mpf("0.4"))
    size = mp.mpf(0.8) * norm(v) * norm(v[1:])
    push = [-size * mp.cos(angle), size * mp.sin(angle), 0]
    force = [a + (3 if w[2] > 0 else -1) * b for a, b in zip(push, down, strict=True)]
    moment = [mp.mpf(0.2) * c for c in cross(w, force)]
    rate = mp.tanh(u[0] - servo) * mp.exp(-mp.mpf(0.1) * t) / mp.mpf(0.5)
    return [*at([-1, mp.mpf(0.2), mp.mpf(0.1)], force, moment), rate]


def hats(x: Any, nodes: Array) -> list[Any]:
    """The piecewise linear functions that are one at one node and zero at the others; held outside."""
    x = min(max(x, mp.mpf(nodes[0])), mp.mpf(nodes[-1]))
    k = max(i for i in range(len(nodes) - 1) if nodes[i] <= x)
    share = (x - mp.mpf(nodes[k])) / (mp.mpf(nodes[k + 1]) - mp.mpf(nodes[k]))
    return [1 - share if i == k else share if i == k + 1 else mp.mpf(0) for i in range(len(nodes))]


def cardinals(x: Any, nodes: Array) -> list[Any]:
    """The splines that are one at one node and zero at the others, by SciPy's coefficients."""
    x = min(max(x, mp.mpf(nodes[0])), mp.mpf(nodes[-1]))
    k = max(i for i in range(len(nodes) - 1) if nodes[i] <= x)
    spline = CubicSpline(nodes, np.eye(len(nodes)), bc_type="not-a-knot")
    return [
        mp.polyval([mp.mpf(c) for c in spline.c[:, k, i]], x - mp.mpf(nodes[k])) for i in range(len(nodes))
    ]


def sum_of(weights: Numbers, values: Array) -> Any:
    return mp.fsum(w * mp.mpf(v) for w, v in zip(weights, values, strict=True))


def product_of(rows: Numbers, columns: Numbers) -> Any:
    return mp.fsum(a * sum_of(columns, row) for a, row in zip(rows, GRID, strict=True))


def tables_by_hand(t: Any, x: Numbers, u: Numbers) -> list[Any]:
    v, w, m = x[6:9], x[9:12], mp.mpf(BODY.mass)
    return [
        m * sum_of(hats(v[0], X), VALUES),
        m * sum_of(cardinals(v[1] * w[2], X), VALUES),
        m * product_of(hats(v[2], X), hats(w[0], Y)),
        product_of(cardinals(v[0], X), cardinals(v[1], Y)),
        sum_of(hats(x[2], X), VALUES),
        mp.mpf(0),
    ]


LAWS: dict[str, tuple[fb.Force, Callable[..., list[Any]]]] = {
    "functions": (functions, functions_by_hand),
    "tables": (tables, tables_by_hand),
}


def model_of(which: str) -> fb.Model:
    # An input wrench beside: a law that reads nothing would get one of its own, without it.
    return fb.Model(BODY, [LAWS[which][0], fb.InputWrench()], "zyx")


def points(model: fb.Model, rng: np.random.Generator, n: int) -> tuple[Array, Array, Array]:
    """Times, states and inputs; some of them outside the tables and beyond the stops."""
    x = rng.uniform(-2.0, 2.0, (n, model.n_states))
    x[:, 4] *= 0.5  # away from the singular second angle
    return rng.uniform(0.0, 5.0, n), x, rng.uniform(-1.0, 1.0, (n, model.n_inputs))


def agree(got: Array, wanted: Array) -> None:
    """Relative to the largest entry: those of a Jacobian are sums of products of many kinds."""
    assert got.shape == wanted.shape
    assert np.abs(got - wanted).max() <= EXACT * max(1.0, float(np.abs(wanted).max()))


def by_duals(which: str, t: float, x: Array, u: Array) -> Array:
    """The derivative of wrench and own rates by x and the law's input: what the law adds to the Jacobian."""
    model, own = model_of(which), model_of(which).n_states - 12
    a, b = model.jacobian(t, x, u)
    rest, _ = fb.Model(BODY, [fb.InputWrench()], "zyx").jacobian(t, x[:12], u[-6:])
    jacobian = np.hstack([a, b[:, : model.n_inputs - 6]])
    jacobian[:12, :12] -= rest
    assert not jacobian[:6].any()
    return np.vstack([BODY.spatial_inertia @ jacobian[6:12], jacobian[12 : 12 + own]])


@pytest.mark.parametrize("which", LAWS)
def test_jacobians_are_the_differences_of_the_law_by_hand(which: str, rng: np.random.Generator) -> None:
    law, by_hand = LAWS[which]
    model = model_of(which)
    n_x, n_u = model.n_states, len(law.inputs)
    for t, x, u in zip(*points(model, rng, 12), strict=True):
        wanted = np.empty((6 + len(law.states), n_x + n_u))
        with mp.workdps(DIGITS):
            h = mp.mpf(STEP)
            numbers = [mp.mpf(float(c)) for c in (*x, *u[:n_u])]
            for k in range(n_x + n_u):
                sides = []
                for sign in (1, -1):
                    moved = [c + sign * h if i == k else c for i, c in enumerate(numbers)]
                    sides.append(by_hand(mp.mpf(float(t)), moved[:n_x], moved[n_x:]))
                wanted[:, k] = [float((a - b) / (2 * h)) for a, b in zip(*sides, strict=True)]
        agree(by_duals(which, t, x, u), wanted)


@pytest.mark.parametrize("attitude", ["quaternion", "zyx", "zxz"])
@pytest.mark.parametrize("which", LAWS)
def test_jacobians_are_the_symbolic_derivative(which: str, attitude: str, rng: np.random.Generator) -> None:
    for form in ("quasi_velocity", "generalized"):
        model = fb.Model(BODY, [fb.UniformGravity(), LAWS[which][0]], attitude, form)  # type: ignore[arg-type]
        equations = fb.equations("3.2", model=model)
        derived = [equations.jacobian(by) for by in ("x", "u")]
        for t, x, u in zip(*points(model, rng, 20), strict=True):
            if attitude == "quaternion":
                x[3:7] /= np.linalg.norm(x[3:7])
            else:
                x[4] = 0.9 + 0.2 * x[4]
            given = {"t": t, "x": x, "u": u}
            for e, dual in zip(derived, model.jacobian(t, x, u), strict=True):
                symbolic = e.evaluate(**{name: given[name] for name in e.arguments})["jacobian"]
                agree(dual, symbolic)


def test_jacobians_are_sympys_derivative_of_what_is_printed(rng: np.random.Generator) -> None:
    """Another differentiates f; where a clip or a choice has its corner, none of the points lies."""
    model = fb.Model(BODY, [fb.UniformGravity(), functions], "zyx")
    equations = fb.equations("3.2", model=model)
    space: dict[str, Any] = {}
    exec(equations.sympy("f"), space)
    symbols = {
        name: sp.Symbol(name, real=True) if names == (name,) else list(sp.symbols(names, real=True))
        for name, names in equations.arguments.items()
    }
    f = sp.Matrix(space["f"](*symbols.values()))
    derived = [f.jacobian(symbols[by]).tolist() for by in ("x", "u")]
    call = sp.lambdify(list(symbols.values()), derived, "math", cse=True)
    for t, x, u in zip(*points(model, rng, 20), strict=True):
        given = {"t": t, "x": x, "u": u}
        for wanted, dual in zip(
            call(*(given[name] for name in symbols)), model.jacobian(t, x, u), strict=True
        ):
            agree(dual, np.asarray(wanted, float))


@fb.force(parameters={"g": (9.80665, "m/s^2")})
def gravity(s: Any, p: Any) -> Any:
    return fb.wrench(force=s.mass * p.g * s.world_from_body[2], at=s.com)


@fb.force(parameters={"linear": (1.5, "N s/m"), "angular": (0.3, "N m s")})
def damping(s: Any, p: Any) -> Any:
    return fb.wrench(force=-p.linear * s.velocity_body, moment=-p.angular * s.angular_velocity_body)


@fb.force
def constant(s: Any) -> Any:
    return fb.wrench(force=np.array([3.0, -2.0, 1.0]), moment=np.array([0.1, 0.2, -0.1]), at=(0.3, 0.2, -0.1))


SAME: dict[str, tuple[fb.Force, fb.Force]] = {
    "gravity": (gravity, fb.UniformGravity()),
    "damping": (damping, fb.LinearDamping([1.5, 1.5, 1.5, 0.3, 0.3, 0.3])),
    "constant wrench": (
        constant,
        fb.ConstantWrench([3.0, -2.0, 1.0], [0.1, 0.2, -0.1], at=[0.3, 0.2, -0.1]),
    ),
}


@pytest.mark.parametrize("form", ["quasi_velocity", "generalized"])
@pytest.mark.parametrize("which", [*SAME, "all"])
def test_a_traced_force_moves_the_body_as_the_built_in_one(which: str, form: str) -> None:
    pairs = list(SAME.values()) if which == "all" else [SAME[which]]
    runs = []
    for forces in zip(*pairs, strict=True):
        model = fb.Model(BODY, forces, "quaternion", form)  # type: ignore[arg-type]
        runs.append(model.simulate(model.state(**START), (0.0, 10.0), rtol=1e-10, save_every=0.5))
    # Rounding of 1e-16 an evaluation, some thousand of them, and what the motion makes of it in ten seconds.
    assert motion_gap(*runs) < 1e-12
    assert runs[0].evaluations == runs[1].evaluations


@pytest.mark.parametrize("which", SAME)
def test_its_wrench_is_the_built_in_one(which: str, rng: np.random.Generator) -> None:
    traced, built_in = (fb.Model(BODY, [force]) for force in SAME[which])
    for _ in range(20):
        x = traced.state(**START) + rng.normal(size=13)
        x[3:7] /= np.linalg.norm(x[3:7])
        wanted = built_in.wrench(0.3, x)
        # A few products.
        np.testing.assert_allclose(traced.wrench(0.3, x), wanted, rtol=0, atol=1e-14 * np.abs(wanted).max())


TRAVELLER = """
import pickle, sys
model, law, t, x, u = pickle.load(sys.stdin.buffer)
run = model.simulate(x, (0.0, 2.0), inputs=u, save_every=0.25)
same = pickle.loads(pickle.dumps(law))
sys.stdout.buffer.write(pickle.dumps((
    law, same == law and hash(same) == hash(law),
    model.derivative(t, x, u), *model.jacobian(t, x, u), run.x,
)))
"""


@fb.control(parameters={"gain": (0.5, "s")}, inputs={"course": "rad"})
def pilot(s: Any, p: Any) -> Any:
    return {"rudder": s.inputs.course - p.gain * s.angular_velocity_body[2]}


@pytest.mark.parametrize("law", [functions, tables, pilot])
def test_laws_travel_to_where_their_source_is_not(law: Any, tmp_path: Path) -> None:
    control = law if law is pilot else None
    forces = [fb.UniformGravity(), functions if law is pilot else law]
    model = fb.Model(BODY, forces, control=control)
    x = model.state(**START)
    u = np.full(model.n_inputs, 0.2)
    environment = {**os.environ, "PYTHONPATH": str(Path(fb.__file__).parents[1]), "PYTHONHASHSEED": "7"}
    done = subprocess.run(
        [sys.executable, "-c", TRAVELLER],
        input=pickle.dumps((model, law, 0.3, x, u)),
        capture_output=True,
        check=True,
        cwd=tmp_path,
        env=environment,
    )
    back, whole, rate, a, b, path = pickle.loads(done.stdout)
    assert whole
    assert back == law
    assert hash(back) == hash(law)
    here = model.simulate(x, (0.0, 2.0), inputs=u, save_every=0.25)
    wanted = (model.derivative(0.3, x, u), *model.jacobian(0.3, x, u), here.x)
    for got, mine in zip((rate, a, b, path), wanted, strict=True):
        assert got.tobytes() == mine.tobytes()
