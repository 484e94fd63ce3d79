"""The derivative of a table, and how far inside its samples an argument is."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import freebody as fb
from freebody.errors import InputError
from freebody.tables import Table, TableInterpolation

X = np.array([-1.0, 0.0, 0.5, 2.0, 3.0, 3.25])
VALUES = np.array([0.3, -1.0, 2.0, 0.5, 0.7, -0.2])
KINDS: tuple[TableInterpolation, ...] = ("linear", "cubic", "hold")


def test_the_derivative_of_lines_holds() -> None:
    slope = Table(X, VALUES).derivative()
    at = np.linspace(-2.0, 4.0, 97)
    chords = np.diff(VALUES) / np.diff(X)
    wanted = np.concatenate([[0.0], chords, [0.0]])[np.searchsorted(X, at, side="right")]
    np.testing.assert_array_equal(slope(at), wanted)
    np.testing.assert_array_equal(slope.values, [*chords, 0.0])
    # As a table of its own: from the first sample on, zero before it.
    assert slope == Table([X[0], *X], [0.0, *chords, 0.0], "hold")
    assert not slope.derivative()(at).any()


def test_the_derivatives_of_a_spline_are_those_of_scipy() -> None:
    table, spline = Table(X, VALUES, "cubic"), CubicSpline(X, VALUES)
    at = np.linspace(X[0], X[-1], 200)[1:-1]
    for order in range(1, 4):
        table = table.derivative()
        # Two ways to solve one system; the third derivative is of order a hundred.
        np.testing.assert_allclose(table(at), spline(at, order), rtol=0, atol=1e-11)
        assert table.interpolation == "cubic"
        assert not table([-1.5, 3.25, 9.0]).any()
    assert not table.derivative()(at).any()
    assert not table.derivative().derivative()(at).any()


def test_jumps_and_steps_have_no_slope() -> None:
    jump = Table([0.0, 1.0, 1.0, 2.0], [0.0, 1.0, 5.0, 7.0]).derivative()
    np.testing.assert_array_equal(jump([-0.5, 0.0, 0.5, 1.0, 1.5, 2.0]), [0.0, 1.0, 1.0, 2.0, 2.0, 0.0])
    assert not Table(X, VALUES, "hold").derivative()(X).any()


@pytest.mark.parametrize("kind", KINDS)
def test_derivatives_are_values(kind: TableInterpolation) -> None:
    for one in (made := Table(X, VALUES, kind).derivative(), made.derivative()):
        for other in (
            pickle.loads(pickle.dumps(one)),
            copy.copy(one),
            pickle.loads(pickle.dumps(one.core())),
        ):
            assert (other if isinstance(other, Table) else one) == one
            assert hash(other) == hash(one) or not isinstance(other, Table)
        restored = pickle.loads(pickle.dumps(one))
        np.testing.assert_array_equal(restored(X + 0.1), one(X + 0.1))
    assert "derivative of order 2" in repr(made.derivative())


def test_the_rate_of_a_law_of_time_is_the_derivative() -> None:
    """A fuel mass and its rate by time."""
    mass = Table([0.0, 2.0, 5.0], [9.0, 3.0, 0.0])
    rate = mass.derivative()

    @fb.force
    def law(s: Any) -> Any:
        return fb.wrench(force=[mass(s.time), rate(s.time), 0.0])

    model = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [law])
    for t in (-1.0, 0.0, 1.0, 2.0, 4.0, 5.0, 7.0):
        np.testing.assert_array_equal(model.wrench(t, model.state())[:2], [mass(t), rate(t)])


def test_only_one_variable_has_a_derivative() -> None:
    with pytest.raises(InputError, match="a function of 2 variables"):
        Table((X, X), np.zeros((6, 6))).derivative()


def test_inside_is_the_smallest_margin() -> None:
    table = Table(([0.0, 2.0], [10.0, 12.0, 20.0]), np.zeros((2, 3)))
    assert table.inside(1.0, 15.0) == 0.5
    assert table.inside(0.5, 15.0) == 0.25
    assert table.inside(1.0, 19.0) == 0.1
    assert table.inside(2.0, 10.0) == 0.0
    assert table.inside(3.0, 15.0) == -0.5
    np.testing.assert_array_equal(table.inside([1.0, -1.0], 15.0), [0.5, -0.5])
    assert np.isnan(table.inside(np.nan, 15.0))
    with pytest.raises(InputError, match=r"table: got 1 arguments; it is a function of 2"):
        table.inside(1.0)


def test_inside_is_exact_at_the_borders() -> None:
    rng = np.random.default_rng(3)
    for low, high in np.sort(rng.normal(size=(200, 2)) * 10.0 ** rng.integers(-5, 6, (200, 1)), axis=1):
        table = Table([low, high], [0.0, 1.0])
        assert table.inside(low) == table.inside(high) == 0.0
        assert table.inside(np.nextafter(low, -np.inf)) < 0.0
        assert table.inside(np.nextafter(high, np.inf)) < 0.0
    assert Table([3.0], [1.0]).inside([2.5, 3.0, 3.5]).tolist() == [-0.5, 0.0, -0.5]


def test_inside_of_traced_values_is_that_of_their_values() -> None:
    table = Table((X, [0.0, 0.5, 4.0], [-1.0, 1.0]), np.zeros((6, 3, 2)))

    @fb.force
    def law(s: Any) -> Any:
        # Metres per second, radians per second and seconds.
        return fb.wrench(force=[table.inside(s.velocity_body[0], s.twist[3], s.time), 0.0, 0.0])

    model = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [law])
    for v, w, t in np.random.default_rng(4).uniform(-2.0, 5.0, (50, 3)):
        x = model.state(velocity_body=[v, 0.0, 0.0], angular_velocity_body=[w, 0.0, 0.0])
        assert model.wrench(t, x)[0] == table.inside(v, w, t)
