"""Tables: what SciPy computes, what arrays they take, and what they refuse."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline, RegularGridInterpolator

from freebody.errors import InputError
from freebody.tables import Table, TableInterpolation

X = np.array([-1.0, 0.0, 0.5, 2.0, 3.0, 3.25])
Y = np.array([0.0, 1.0, 1.5, 4.0])
KINDS: tuple[TableInterpolation, ...] = ("linear", "cubic", "hold")


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1906)


@pytest.fixture
def values(rng: np.random.Generator) -> np.ndarray:
    return rng.normal(size=(len(X), len(Y)))


@pytest.mark.parametrize("n", range(2, 7))
def test_a_cubic_table_is_the_spline_of_scipy(n: int, values: np.ndarray) -> None:
    table, at = Table(X[:n], values[:n, 0], "cubic"), np.linspace(-2.0, 4.0, 501)
    spline = CubicSpline(X[:n], values[:n, 0])(np.clip(at, X[0], X[n - 1]))
    # Two ways to solve one system for numbers of order ten.
    np.testing.assert_allclose(table(at), spline, rtol=0, atol=1e-13)


def test_a_cubic_grid_is_the_product_of_splines(values: np.ndarray) -> None:
    table = Table((X, Y), values, "cubic")
    x, y = np.linspace(-2.0, 4.0, 61), np.linspace(-1.0, 5.0, 53)
    rows = CubicSpline(X, values)(np.clip(x, X[0], X[-1]))
    product = CubicSpline(Y, rows, axis=1)(np.clip(y, Y[0], Y[-1]))
    # Values up to a hundred.
    np.testing.assert_allclose(table(x[:, None], y), product, rtol=0, atol=1e-12)


def test_linear_tables_are_those_of_numpy_and_scipy(rng: np.random.Generator, values: np.ndarray) -> None:
    x, y = rng.uniform(-2.0, 4.0, 200), rng.uniform(-1.0, 5.0, 200)
    line = Table(X, values[:, 0])(x)
    np.testing.assert_allclose(line, np.interp(x, X, values[:, 0]), rtol=0, atol=1e-14)
    inside = np.transpose([np.clip(x, X[0], X[-1]), np.clip(y, Y[0], Y[-1])])
    plane = RegularGridInterpolator((X, Y), values)(inside)
    np.testing.assert_allclose(Table((X, Y), values)(x, y), plane, rtol=0, atol=1e-14)


def test_hold_keeps_each_value_until_the_next() -> None:
    table = Table([0.0, 1.0, 2.0], [5.0, 6.0, 7.0], "hold")
    np.testing.assert_array_equal(table([-1.0, 0.0, 0.9, 1.0, 2.5]), [5.0, 5.0, 5.0, 6.0, 7.0])


def test_a_jump_takes_two_samples() -> None:
    table = Table([0.0, 1.0, 1.0, 2.0], [0.0, 1.0, 5.0, 5.0])
    np.testing.assert_array_equal(table([0.5, 1.0, 1.5]), [0.5, 5.0, 5.0])


def test_the_result_has_the_shape_that_the_arguments_broadcast_to(values: np.ndarray) -> None:
    line, plane = Table(X, values[:, 0], "cubic"), Table((X, Y), values, "cubic")
    assert isinstance(line(1), float)
    assert np.ndim(plane(1, np.float32(2.0))) == 0
    grid = plane(np.ones((3, 1)), np.zeros((2, 1, 4)))
    assert grid.shape == (2, 3, 4)
    assert (grid == plane(1.0, 0.0)).all()
    assert line(np.zeros((0, 2))).shape == (0, 2)
    strided = np.linspace(-1.0, 3.0, 20).reshape(4, 5).T
    np.testing.assert_array_equal(line(strided).T, line(strided.T.copy()))
    # No argument is refused for its size: a state that has run away must not end in an error here.
    np.testing.assert_array_equal(line([-np.inf, np.inf, np.nan]), [*values[[0, -1], 0], np.nan])


@pytest.mark.parametrize("kind", KINDS)
def test_tables_are_values(kind: TableInterpolation, values: np.ndarray) -> None:
    for make in (
        lambda v: Table(X, v[:, 0], kind),
        lambda v: Table((X, Y), v, kind),
        lambda v: Table(X, v[:, 0], kind).core(),
        lambda v: Table((X, Y), v, kind).core(),
    ):
        one = make(values)
        for other in (make(values.copy()), pickle.loads(pickle.dumps(one)), copy.copy(one)):
            assert other == one
            assert hash(other) == hash(one)
        assert make(values + 1.0) != one
        assert one != "table"
    assert Table(X, values[:, 0], kind) != Table((X, Y), values, kind)
    restored = pickle.loads(pickle.dumps(Table((X, Y), values, kind)))
    assert restored(0.3, 1.2) == Table((X, Y), values, kind)(0.3, 1.2)


def test_samples_are_copied() -> None:
    x, values = X.copy(), X.copy()
    table = Table(x, values)
    values[:] = 0.0
    assert table(2.0) == 2.0
    with pytest.raises(ValueError, match="read-only"):
        table.values[0] = 1.0


def test_a_traced_argument_answers_itself(values: np.ndarray) -> None:
    class Traced:
        def __freebody_lookup__(self, table: Table, arguments: tuple[object, ...]) -> object:
            return table, arguments

    line, plane, traced = Table(X, values[:, 0]), Table((X, Y), values), Traced()
    assert line(traced) == (line, (traced,))
    assert plane(1.0, traced) == (plane, (1.0, traced))


PAIR = (X, Y)
ZEROS = np.zeros((len(X), len(Y)))
WRONG: list[tuple[Any, Any, Any, str]] = [
    ([0.0, 1.0], [0.0, 1.0], "spline", r"interpolation: got 'spline'; allowed are 'linear', 'cubic', 'hold'"),
    ([0.0, 2.0, 1.0], np.zeros(3), "linear", r"x: 1.0 at index 2 is smaller than the one before; sort the x"),
    ([0.0, 1.0, 1.0, 1.0], np.zeros(4), "linear", r"x: 1.0 stands three times at index 3"),
    ([0.0, 1.0, 1.0], np.zeros(3), "cubic", r"x: 1.0 stands twice at index 2; a cubic table has no jumps"),
    ([0.0, np.nan], np.zeros(2), "linear", r"x: got nan at index \(1,\); every number must be finite"),
    ([], [], "linear", r"x: got an empty array"),
    ([0.0, 1.0], np.zeros(3), "linear", r"values: got shape \(3,\); allowed is \(2,\)"),
    (["a", "b"], np.zeros(2), "linear", r"x: got \['a', 'b'\] of dtype"),
    (PAIR, ZEROS.T, "linear", r"values: got shape \(4, 6\); allowed is \(6, 4\)"),
    (PAIR, np.where(ZEROS == 0.0, np.inf, 0.0), "linear", r"values: got inf at index \(0, 0\)"),
    ((X, Y[::-1]), ZEROS, "linear", r"x\[1\]: 1.5 at index 1 is smaller than the one before"),
    (([0.0, 0.0], Y), np.zeros((2, 4)), "cubic", r"x\[0\]: 0.0 stands twice at index 1"),
    ([0.0, 1e-310, 1.0], [0.0, 1.0, 2.0], "linear", r"values: the curve to sample 1 .* is too steep"),
    (
        [0.0, 1e-310, 1.0, 2.0],
        [0.0, 1.0, 2.0, 0.0],
        "cubic",
        r"values: the curve to sample 1 .* is too steep",
    ),
]


@pytest.mark.parametrize(("x", "values", "kind", "message"), WRONG)
def test_samples_that_are_no_table_are_refused(x: Any, values: Any, kind: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Table(x, values, kind)


def test_arguments_that_are_none_are_refused() -> None:
    line, plane = Table([0.0, 1.0], [0.0, 1.0]), Table(PAIR, ZEROS)
    with pytest.raises(InputError, match=r"table: got 2 arguments; it is a function of 1"):
        line(1.0, 2.0)
    with pytest.raises(InputError, match=r"argument 2: got 'a'"):
        plane(1.0, "a")
    with pytest.raises(InputError, match=r"table: shapes \(2,\) and \(3,\) do not broadcast"):
        plane(np.zeros(2), np.zeros(3))
