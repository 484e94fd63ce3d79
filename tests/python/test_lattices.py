"""Tables of three and of four variables: what SciPy computes, their slopes in laws, and what they refuse."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import RegularGridInterpolator

import freebody as fb
from freebody.errors import InputError
from freebody.tables import Table

AXES = (
    np.array([-1.0, 0.0, 0.5, 2.0]),
    np.array([0.0, 1.0, 4.0]),
    np.array([-2.0, 1.0]),
    np.array([0.0, 0.5, 1.0, 1.5, 3.0]),
)
BODY = fb.RigidBody(1.0, inertia_about_com=np.eye(3))


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1907)


def random_table(rng: np.random.Generator, n: int, **how: Any) -> Table:
    return Table(AXES[:n], rng.normal(size=tuple(map(len, AXES[:n]))), **how)


def points(rng: np.random.Generator, n: int, count: int = 200) -> np.ndarray:
    """Within the axes and around them."""
    return np.array([rng.uniform(a[0] - 1.0, a[-1] + 1.0, count) for a in AXES[:n]])


def clipped(at: np.ndarray) -> np.ndarray:
    return np.array([np.clip(x, a[0], a[-1]) for x, a in zip(at, AXES, strict=False)])


@pytest.mark.parametrize("n", [3, 4])
def test_linear_tables_are_those_of_scipy(rng: np.random.Generator, n: int) -> None:
    table, at = random_table(rng, n), points(rng, n)
    wanted = RegularGridInterpolator(AXES[:n], table.values)(clipped(at).T)
    # Sixteen products of numbers of order one.
    np.testing.assert_allclose(table(*at), wanted, rtol=0, atol=1e-14)


@pytest.mark.parametrize("n", [3, 4])
def test_held_tables_take_the_sample_below(rng: np.random.Generator, n: int) -> None:
    table, at = random_table(rng, n, interpolation="hold"), points(rng, n)
    below = [
        np.maximum(np.searchsorted(a, x, side="right") - 1, 0) for a, x in zip(AXES[:n], at, strict=True)
    ]
    np.testing.assert_array_equal(table(*at), table.values[tuple(below)])


def test_samples_that_do_not_vary_along_an_axis_are_a_table_of_the_others(rng: np.random.Generator) -> None:
    plane = Table(AXES[:2], rng.normal(size=(4, 3)))
    table = Table(AXES[:3], np.repeat(plane.values[..., None], 2, axis=2))
    x, y, z = points(rng, 3)
    np.testing.assert_allclose(table(x, y, z), plane(x, y), rtol=0, atol=1e-15)


@pytest.mark.parametrize("n", [3, 4])
def test_borders_hold_and_what_is_no_number_gives_none(rng: np.random.Generator, n: int) -> None:
    table, at = random_table(rng, n), points(rng, n)
    np.testing.assert_array_equal(table(*at), table(*clipped(at)))
    assert table(*[np.inf] * n) == table.values[(-1,) * n]
    assert table(*[-np.inf] * n) == table.values[(0,) * n]
    for k in range(n):
        nan = at.copy()
        nan[k] = np.nan
        assert np.isnan(table(*nan)).all()


def test_arguments_broadcast(rng: np.random.Generator) -> None:
    table = random_table(rng, 3)
    assert np.ndim(table(0.1, 0.2, 0.3)) == 0
    grid = table(np.zeros((3, 1)), np.ones((2, 1, 4)), 0.5)
    assert grid.shape == (2, 3, 4)
    assert (grid == table(0.0, 1.0, 0.5)).all()


@pytest.mark.parametrize("n", [3, 4])
def test_slopes_in_laws_are_differences_of_values(rng: np.random.Generator, n: int) -> None:
    """A force that is a table of velocities: its derivative by duals, inside cells and outside the axes."""
    table = random_table(rng, n)

    @fb.force
    def law(s: Any) -> Any:
        at = [*s.velocity_body, s.angular_velocity_body[0]][:n]
        return fb.wrench(force=[table(*at), 0.0, 0.0], moment=[0.0, 0.0, 0.0])

    model = fb.Model(BODY, [law])
    for at in points(rng, n, 40).T:
        x = model.state(velocity_body=at[:3], angular_velocity_body=[*at[3:], 0.0, 0.0, 0.0][:3])
        rate = model.derivative(0.0, x)
        assert rate[7] == table(*at) + np.cross(x[7:10], x[10:13])[0]
        by_state, _ = model.jacobian(0.0, x)
        gyroscopic = np.array([0.0, x[12], -x[11], 0.0])
        for k in range(n):
            # Within one cell a multilinear function is a line along each axis: central differences are exact
            # but for the rounding of values of order one over the step.
            h = 1e-5
            if np.abs(AXES[k] - at[k]).min() < h:
                continue
            step = h * np.eye(n)[k]
            wanted = (table(*(at + step)) - table(*(at - step))) / (2.0 * h)
            assert abs(by_state[7, 7 + k] - gyroscopic[k] - wanted) < 1e-9


def test_many_states_at_once_are_each_state_alone(rng: np.random.Generator) -> None:
    table = random_table(rng, 4)

    @fb.force
    def law(s: Any) -> Any:
        return fb.wrench(force=[table(*s.velocity_body, s.time), 0.0, 0.0])

    model = fb.Model(BODY, [law])
    x = np.array([model.state(velocity_body=at) for at in points(rng, 3, 37).T])
    t = rng.uniform(-1.0, 4.0, 37)
    together = model.derivative_batch(t, np.ascontiguousarray(x.T), np.zeros((model.n_inputs, 37)))
    alone = [model.derivative(*at) for at in zip(t, x, strict=True)]
    np.testing.assert_array_equal(together.T, alone)


@pytest.mark.parametrize("kind", ["linear", "hold"])
@pytest.mark.parametrize("n", [3, 4])
def test_they_are_values(rng: np.random.Generator, n: int, kind: Any) -> None:
    one = random_table(rng, n, interpolation=kind)
    for made in (one, one.core()):
        for other in (pickle.loads(pickle.dumps(made)), copy.copy(made)):
            assert other == made
            assert hash(other) == hash(made)
    assert Table(AXES[:n], one.values, kind) == one
    assert Table(AXES[:n], one.values + 1.0, kind) != one
    assert Table(AXES[:n], one.values, "hold" if kind == "linear" else "linear") != one
    assert repr(one).startswith("Table(4 x 3 x 2")


def test_laws_with_them_pickle(rng: np.random.Generator) -> None:
    table = random_table(rng, 4)

    def function(s: Any) -> Any:
        return fb.wrench(force=[table(*s.velocity_body, s.time), 0.0, 0.0])

    model = fb.Model(BODY, [fb.force(function)])
    again = pickle.loads(pickle.dumps(model))
    x = model.state(velocity_body=[0.2, 1.5, -0.3])
    np.testing.assert_array_equal(again.derivative(0.2, x), model.derivative(0.2, x))
    np.testing.assert_array_equal(again.jacobian(0.2, x)[0], model.jacobian(0.2, x)[0])


THREE = AXES[:3]
ZEROS = np.zeros((4, 3, 2))
WRONG: list[tuple[Any, Any, Any, str]] = [
    (THREE, ZEROS, "cubic", r"interpolation: got 'cubic' with 3 axes; a cubic table has one or two"),
    (THREE, ZEROS.T, "linear", r"values: got shape \(2, 3, 4\); allowed is \(4, 3, 2\)"),
    ((*AXES, [0.0]), ZEROS, "linear", r"x: got 5 axes; a table is a function of one variable to four"),
    ((*THREE[:2], [1.0, 0.0]), ZEROS, "linear", r"x\[2\]: 0.0 at index 1 is smaller than the one before"),
    ((*THREE[:2], [1.0, np.nan]), ZEROS, "hold", r"x\[2\]: got nan at index \(1,\)"),
    (([0.0, 0.0, 0.0, 1.0], *THREE[1:]), ZEROS, "linear", r"x\[0\]: 0.0 stands three times at index 2"),
    (THREE, np.where(ZEROS == 0.0, np.inf, 0.0), "linear", r"values: got inf at index \(0, 0, 0\)"),
    (([0.0, 1e-310], [0.0], [0.0]), [[[0.0]], [[1.0]]], "linear", r"the curve to sample 1 .* is too steep"),
]


@pytest.mark.parametrize(("x", "values", "kind", "message"), WRONG)
def test_samples_that_are_no_table_are_refused(x: Any, values: Any, kind: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Table(x, values, kind)


def test_arguments_that_are_none_are_refused() -> None:
    table = Table(THREE, ZEROS)
    with pytest.raises(InputError, match=r"table: got 2 arguments; it is a function of 3"):
        table(1.0, 2.0)
    with pytest.raises(InputError, match=r"argument 3: got 'a'"):
        table(1.0, 2.0, "a")
    with pytest.raises(InputError, match=r"shapes \(2,\) and \(3,\) and \(\) do not broadcast"):
        table(np.zeros(2), np.zeros(3), 0.0)
