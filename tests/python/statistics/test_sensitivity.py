"""Correlations of known Gaussians, Sobol indices of functions that have closed forms."""

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

from freebody import statistics
from freebody.errors import InputError
from python.statistics.samples import NON_FINITE, dataset, ended, runs

# Ishigami and Homma (1990) with a = 7, b = 0.1: variance and its parts in closed form.
A, B = 7.0, 0.1
BY_X1 = 0.5 * (1 + B * np.pi**4 / 5) ** 2
BY_X2 = A**2 / 8
BY_X1_X3 = B**2 * np.pi**8 * (1 / 18 - 1 / 50)
VARIANCE = BY_X1 + BY_X2 + BY_X1_X3
FIRST = np.array([BY_X1, BY_X2, 0.0]) / VARIANCE
TOTAL = np.array([BY_X1 + BY_X1_X3, BY_X2, BY_X1_X3]) / VARIANCE


def ishigami(x):
    return np.sin(x[..., 0]) + A * np.sin(x[..., 1]) ** 2 + B * x[..., 2] ** 4 * np.sin(x[..., 0])


def saltelli(n=2048, seed=1):
    """Points in groups: A, A with each factor from B, B."""
    pairs = (2 * qmc.Sobol(6, rng=seed).random(n) - 1) * np.pi
    groups = np.repeat(pairs[:, None, :3], 5, axis=1)
    for i in range(3):
        groups[:, i + 1, i] = pairs[:, 3 + i]
    groups[:, 4] = pairs[:, 3:]
    return groups


def saltelli_runs():
    points = saltelli().reshape(-1, 3)
    quantities = {f"x{i + 1}": (points[:, i], "1") for i in range(3)}
    return dataset({"y": (ishigami(points), "m")}, quantities, sampling="saltelli")


def test_sobol_indices_are_those_of_the_closed_form():
    found = {index.factor: index for index in statistics.sobol(saltelli_runs(), "y", confidence=0.999)}
    assert list(found) == ["x1", "x2", "x3"]
    for i, index in enumerate(found.values()):
        assert index.first.low <= FIRST[i] <= index.first.high
        assert index.total.low <= TOTAL[i] <= index.total.high
        # The error of 2048 base samples is some 0.02 for random ones, and less for a Sobol sequence.
        assert abs(index.first.value - FIRST[i]) < 0.02
        assert abs(index.total.value - TOTAL[i]) < 0.02


def test_sobol_indices_are_scipys():
    values = ishigami(saltelli())
    a, b, ab = values[:, 0], values[:, -1], values[:, 1:-1].T
    expected = stats.sobol_indices(func={"f_A": a[None], "f_B": b[None], "f_AB": ab[:, None]}, n=len(a))
    found = statistics.sobol_indices(a, b, ab)
    # The same sums in another order.
    np.testing.assert_allclose([f.value for f, _ in found], expected.first_order, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose([t.value for _, t in found], expected.total_order, rtol=1e-10, atol=1e-12)


def test_bootstrap_intervals_hold_the_closed_form():
    """Of a linear function of two normal numbers, whose shares are 0.36 and 0.64, first and total."""
    repetitions, confidence = 200, 0.9
    rng = np.random.default_rng(4)
    held = np.zeros((2, 2))
    for _ in range(repetitions):
        a, b = rng.normal(size=(2, 200, 2))
        ab = np.stack([np.where(np.arange(2) == i, b, a) for i in range(2)])
        weights = np.array([0.6, 0.8])
        found = statistics.sobol_indices(a @ weights, b @ weights, ab @ weights, confidence)
        for i, pair in enumerate(found):
            held[i] += [interval.low <= weights[i] ** 2 <= interval.high for interval in pair]
    # Percentile intervals of 200 base samples lack three hundredths; four deviations of the count.
    least = confidence - 0.03
    assert (held >= repetitions * least - 4 * np.sqrt(repetitions * least * (1 - least))).all()


def test_the_same_seed_gives_the_same_intervals():
    data = saltelli_runs()
    assert statistics.sobol(data, "y") == statistics.sobol(data, "y")
    assert statistics.sobol(data, "y", seed=1) != statistics.sobol(data, "y")


def test_a_group_with_a_bad_run_is_left_out_whole():
    found = statistics.sobol(ended(saltelli_runs(), NON_FINITE, 3, 4, 501), "y")
    values = np.delete(ishigami(saltelli()), [0, 100], axis=0)
    expected = statistics.sobol_indices(values[:, 0], values[:, -1], values[:, 1:-1].T)
    assert found[0].first.count == 2046
    assert [index.total for index in found] == [total for _, total in expected]


def test_what_is_dispersed_jointly_is_one_factor():
    points = saltelli()[:, [0, 1, 2, 4]]
    points[:, 2, 2] = points[:, 3, 2]  # the second factor is x2 and x3
    flat = points.reshape(-1, 3)
    quantities = {f"x{i + 1}": (flat[:, i], "1") for i in range(3)}
    data = dataset({"y": (ishigami(flat), "m")}, quantities, sampling="saltelli")
    data = data.assign_coords(quantity_factor=("quantity", [0, 1, 1]))
    found = {index.factor: index for index in statistics.sobol(data, "y")}
    assert set(found) == {"x1", "x2, x3"}
    joint = (BY_X2 + BY_X1_X3) / VARIANCE
    assert abs(found["x2, x3"].total.value - joint) < 0.02  # as above


def test_other_statistics_stand_on_the_independent_runs():
    data = saltelli_runs()
    x = statistics.gather(statistics.independent(data), statistics.all_columns(data, "dispersed"))
    assert len(np.unique(x[:, 0])) == len(x) == 2 * 2048
    assert statistics.independent(runs(10)).sizes["run"] == 10


def test_a_result_that_does_not_vary_depends_on_nothing():
    found = statistics.sobol_indices(np.full(8, 0.1), np.full(8, 0.1), np.full((2, 8), 0.1))
    assert {interval.value for pair in found for interval in pair} == {0.0}


def test_runs_drawn_otherwise_have_no_sobol_indices():
    with pytest.raises(InputError, match="got random runs; Sobol indices need"):
        statistics.sobol(runs(10), "miss")


def test_runs_in_another_order_are_refused():
    made = saltelli_runs()
    with pytest.raises(InputError, match="not in groups of 5"):
        statistics.sobol(made.isel(run=slice(1, None)), "y")
    with pytest.raises(InputError, match="not in groups of 5"):
        statistics.sobol(made.isel(run=slice(0, 4)), "y")


def test_wrong_shapes_are_refused():
    with pytest.raises(InputError, match=r"a, b, ab: got shapes \(4,\), \(4,\), \(2, 3\)"):
        statistics.sobol_indices(np.ones(4), np.ones(4), np.ones((2, 3)))


def test_correlations_of_known_gaussians():
    """drift = 3 wind + 4 mass' + noise: of ranks, normal numbers have 6/pi asin(r/2)."""
    found = {c.quantity.name: c for c in statistics.correlations(runs(20_000), "drift", 0.999)}
    assert list(found) == ["mass", "wind"]
    r = {"mass": 4 / np.sqrt(26), "wind": 3 / np.sqrt(26)}
    spearman = {name: 6 / np.pi * np.arcsin(value / 2) for name, value in r.items()}
    partial = {
        name: spearman[name] / np.sqrt(1 - spearman[other] ** 2)
        for name, other in (("mass", "wind"), ("wind", "mass"))
    }
    for name, of in found.items():
        assert of.pearson.low <= r[name] <= of.pearson.high
        assert of.spearman.low <= spearman[name] <= of.spearman.high
        assert of.partial is not None
        assert of.partial.low <= partial[name] <= of.partial.high


def test_partial_correlations_are_those_of_residuals():
    data = runs(300)
    values = np.column_stack([data["outputs"].values[:, 1], data["dispersed"].values])
    drift, mass, wind = stats.rankdata(values, axis=0).T
    other = np.column_stack([np.ones(300), wind])
    left = [column - other @ np.linalg.lstsq(other, column)[0] for column in (drift, mass)]
    found = statistics.correlations(data, "drift")[0]
    assert found.quantity.name == "mass"
    assert found.partial is not None
    # Two solutions of one linear system whose condition is some ten.
    np.testing.assert_allclose(found.partial.value, np.corrcoef(*left)[0, 1], rtol=1e-11)


def test_quantities_that_say_the_same_have_no_partial_correlation():
    data = runs(100)
    data["dispersed"][:, 0] = 2 * data["dispersed"][:, 1]
    assert [c.partial for c in statistics.correlations(data, "drift")] == [None, None]


def test_what_does_not_vary_is_left_out():
    data = runs(100)
    data["dispersed"][:, 0] = 1.0
    assert [c.quantity.name for c in statistics.correlations(data, "drift")] == ["wind"]
    data["outputs"][:] = 1.0
    assert statistics.correlations(data, "drift") == []
