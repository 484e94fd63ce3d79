"""Aerodynamic elements as they are called: wrong arguments, dispersible parameters, tables that are left."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import Aerodynamics, AirData, Drag, Lookup
from freebody.environment import Environment

AIR = Environment()
LINE = fb.Table([-0.2, 0.2], [-1.0, 1.0])
BODY = fb.RigidBody(10.0, inertia_about_com=np.eye(3))


def law(coefficients: Any, **options: Any) -> Aerodynamics:
    return Aerodynamics(AIR, 2.0, 3.0, 0.5, coefficients, **options)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: law({"CD": 0.1}), "'CD' is none in these axes; did you mean 'CX'|known are"),
        (lambda: law({"CX": {"apha": 1.0}}), "'apha' is no variable; did you mean 'alpha'"),
        (lambda: law({"CX": {"alpha*beta": 1.0}}), "cannot read 'alpha\\*beta'"),
        (lambda: law({"CX": {"0": {"alpha": 1.0}}}), "a slope is no mapping again"),
        (lambda: law({"CX": {"0": [0.1, 0.2]}}), "give their sum"),
        (lambda: law({"CX": "0.1"}), "CX: '0'"),
        (lambda: law([0.1]), "give them by name"),
        (lambda: law({"CX": Lookup(LINE, "elevator")}), "'elevator' is no variable"),
        (lambda: law({"CX": lambda a: [a.alpha, a.beta]}), "give one number"),
        (lambda: law(lambda a: a.alpha), "return them by name"),
        (lambda: law(lambda a: {"CD": a.alpha}), "none in these axes"),
        (lambda: law({"CX": lambda a: a.controls.elevator}), "elevator"),
        (lambda: law({}, axes="flow"), "axes: got 'flow'"),
        (lambda: law({}, controls={"mach": "1"}), "means something else"),
        (lambda: law({}, controls={"elevator": "deg"}), "is none of its symbols here"),
        (lambda: law({}, reference_point=[0.0, 0.0]), "reference_point: got shape"),
        (lambda: law({}, body_from_aero=2.0 * np.eye(3)), "body_from_aero"),
        (lambda: Aerodynamics(AIR, -2.0, 3.0, 0.5, {}), "reference_area"),
        (lambda: Aerodynamics("air", 2.0, 3.0, 0.5, {}), "environment: got 'air'"),  # type: ignore[arg-type]
        (lambda: Drag(AIR, 0.1, "0.5"), "coefficient"),  # type: ignore[arg-type]
        (lambda: Lookup(LINE), "got 0 names, none; the table is a function of 1"),
        (lambda: Lookup(LINE, "alpha", "beta"), "got 2 names"),
        (lambda: Lookup(fb.Table(([0, 1], [0, 1]), np.eye(2)), "mach", "mach"), "name each variable once"),
        (lambda: Lookup([1.0], "alpha"), "give a freebody.Table"),  # type: ignore[arg-type]
        (lambda: Lookup(fb.Table([0, 1], [0, 1], "hold"), "mach", extrapolate=True), "only linear tables"),
    ],
)
def test_wrong_arguments_are_told(make: Any, words: str) -> None:
    with pytest.raises(fb.InputError, match=words):
        make()


def test_one_function_for_all_coefficients_is_the_same_law() -> None:
    """The products are written in the order in which the mapping makes them."""
    table = Lookup(LINE, "alpha")

    def all_in_one(a: AirData) -> dict[str, Any]:
        return {"CZ": -5.0 * a.alpha, "Cm": LINE(a.alpha) * a.controls.elevator}

    by_name = {"CZ": {"0": lambda a: -5.0 * a.alpha}, "Cm": {"elevator": table}}
    models = [fb.Model(BODY, [law(each, controls={"elevator": "rad"})]) for each in (all_in_one, by_name)]
    x = models[0].state(velocity_body=[20.0, 1.0, 2.0], angular_velocity_body=[0.1, 0.2, 0.3])
    first, second = (model.wrench(0.0, x, [0.1]) for model in models)
    assert first == pytest.approx(second, rel=1e-14)


def test_parameters_scale_shift_and_replace() -> None:
    given = law({"CX": {"0": -0.1, "alpha^2": 0.4}, "Cm": Lookup(LINE, "alpha")}, name="wing")
    assert {"CX_0", "CX_alpha2", "CX_factor", "CX_offset", "Cm_factor", "Cm_offset"} < given.parameters.keys()

    def wrench(**values: Any) -> Any:
        model = fb.Model(BODY, [given(**values)])
        return model.wrench(0.0, model.state(velocity_body=[20.0, 0.0, 2.0]))

    pressure = 0.5 * 1.225 * (20.0**2 + 2.0**2) * 2.0
    base = wrench()
    assert wrench(CX_factor=2.0)[0] == pytest.approx(2.0 * base[0], rel=1e-14)
    assert wrench(CX_0=-0.3)[0] - base[0] == pytest.approx(-0.2 * pressure, rel=1e-13)
    assert wrench(Cm_offset=0.01)[4] - base[4] == pytest.approx(0.01 * pressure * 0.5, rel=1e-12)
    assert wrench(reference_area=4.0) == pytest.approx(2.0 * base, rel=1e-14)
    assert wrench(reference_z=0.3)[4] - base[4] == pytest.approx(0.3 * base[0], rel=1e-12)


def test_tables_hold_their_border_or_go_on() -> None:
    held, on = (Lookup(LINE, "alpha", extrapolate=which) for which in (False, True))
    assert (held({"alpha": 0.3}), on({"alpha": 0.3})) == (1.0, pytest.approx(1.5, rel=1e-13))
    x, y = np.array([0.0, 1.0, 3.0]), np.array([-1.0, 2.0])
    corner = fb.Table((x, y), np.add.outer(x**2, 2.0 * y) + np.outer(x, y))
    beyond = Lookup(corner, "mach", "beta", extrapolate=True)
    # Bilinear in the last cell: 4 m - 3 + 2 b + m b.
    for m, b in ((4.0, 3.0), (3.5, -2.0), (2.0, 5.0)):
        assert beyond({"mach": m, "beta": b}) == pytest.approx(4.0 * m - 3.0 + 2.0 * b + m * b, rel=1e-12)


def test_tables_of_three_and_four_variables() -> None:
    """Multilinear in their cells, and beyond them when they go on."""
    rng = np.random.default_rng(5)
    axes = [
        np.array([-0.5, 0.0, 0.5]),
        np.array([0.0, 0.4]),
        np.array([-0.3, 0.1, 0.3]),
        np.array([0.0, 9e3]),
    ]
    names = ("alpha", "mach", "elevator", "altitude")
    for n in (3, 4):
        values = rng.normal(size=[len(axis) for axis in axes[:n]])
        table = fb.Table(tuple(axes[:n]), values)
        given = law({"CZ": Lookup(table, *names[:n])}, controls={"elevator": "rad"})
        model = fb.Model(BODY, [given])
        x = model.state([0.0, 0.0, -3000.0], velocity_body=[80.0, 0.0, 16.0])
        at = (np.arctan2(16.0, 80.0), np.hypot(16.0, 80.0) / 340.294, 0.2, 3000.0)
        pressure = 0.5 * 1.225 * (16.0**2 + 80.0**2) * 2.0
        assert model.wrench(0.0, x, [0.2])[2] == pytest.approx(pressure * table(*at[:n]), rel=1e-12)
        beyond = Lookup(table, *names[:n], extrapolate=True)
        line = [beyond({**dict(zip(names, at, strict=True)), "mach": m}) for m in (0.3, 0.4, 1.4)]
        assert line[2] - line[1] == pytest.approx(10.0 * (line[1] - line[0]), rel=1e-9)


def test_leaving_a_table_is_said_in_the_outcome() -> None:
    """A body that pitches: alpha rises through 0.2, the border of the table."""
    slow = fb.Table([0.0, 0.5], [-0.01, -0.02])
    coefficients = {"CZ": Lookup(LINE, "alpha"), "CX": Lookup(slow, "mach", extrapolate=True)}
    given = law(coefficients, name="wing")(reference_area=0.02)
    held, goes_on = "which hold their border values", "which go on along their border cells"
    alpha_left = f"alpha leaves -0.2 to 0.2 rad of the tables of CZ, {held}"
    assert [notice.message for notice in given.notices] == [
        f"mach leaves 0 to 0.5 of the tables of CX, {goes_on}",
        alpha_left,
    ]
    model = fb.Model(BODY, [given])
    x0 = model.state(velocity_body=[20.0, 0.0, 0.0], angular_velocity_body=[0.0, 0.5, 0.0])
    run = model.simulate(x0, (0.0, 1.0), save_every=0.01)
    assert run.outcome.ok
    (seen,) = run.outcome.notices
    assert (seen.law, seen.message) == ("wing", alpha_left)
    assert alpha_left in run.outcome.message
    alpha = np.arctan2(run.velocity_body[:, 2], run.velocity_body[:, 0])
    # Between samples 0.01 s apart alpha is straight to 1e-5.
    assert np.interp(seen.time, run.t, alpha) == pytest.approx(0.2, abs=1e-5)


def test_a_table_of_drag_that_is_left_from_the_start() -> None:
    drag = Drag(AIR, 0.01, fb.Table([0.1, 0.5], [0.4, 0.5]))
    model = fb.Model(BODY, [drag])
    run = model.simulate(model.state(velocity_body=[10.0, 0.0, 0.0]), (0.0, 0.1))
    (seen,) = run.outcome.notices
    assert seen.from_start
    assert "mach leaves 0.1 to 0.5 of the tables of drag" in seen.message
    assert run.x[-1, 7] == pytest.approx(
        10.0 / (1.0 + 0.5 * 1.225 * 0.01 * 0.4 * 10.0 * 0.1 / 10.0), rel=1e-9
    )
