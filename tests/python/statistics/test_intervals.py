"""An interval holds the truth as often as it says."""

import numpy as np
import pytest
from scipy import stats

from freebody import statistics
from freebody.errors import InputError

REPETITIONS = 2000


def least_often(confidence):
    """How many of the repetitions must hold the truth: four standard deviations of the binomial count under
    its mean, which chance goes below once in 30 000."""
    return REPETITIONS * confidence - 4 * np.sqrt(REPETITIONS * confidence * (1 - confidence))


def holds(intervals, truth):
    return sum(interval.low <= truth <= interval.high for interval in intervals)


@pytest.mark.parametrize("confidence", [0.5, 0.9, 0.99])
@pytest.mark.parametrize("probability", [0.05, 0.5, 0.9])
def test_quantiles_hold_of_any_distribution(confidence, probability):
    draws = np.random.default_rng(5).exponential(size=(REPETITIONS, 60))
    found = [statistics.quantile_interval(row, probability, confidence) for row in draws]
    assert holds(found, -np.log1p(-probability)) >= least_often(confidence)


@pytest.mark.parametrize("confidence", [0.5, 0.9, 0.99])
def test_means_hold_exactly_of_normal_runs(confidence):
    draws = np.random.default_rng(6).normal(3.0, 2.0, size=(REPETITIONS, 5))
    found = [statistics.mean_interval(row.mean(), row.std(ddof=1), 5, confidence) for row in draws]
    often = holds(found, 3.0)
    assert least_often(confidence) <= often <= REPETITIONS - least_often(1 - confidence)


@pytest.mark.parametrize("truth", [0.003, 0.3, 0.9])
def test_probabilities_hold(truth):
    hits = np.random.default_rng(7).binomial(50, truth, size=REPETITIONS)
    assert holds([statistics.probability_interval(k, 50, 0.9) for k in hits], truth) >= least_often(0.9)


@pytest.mark.parametrize("probability", [0.9, 0.95])
def test_tolerance_bounds_hold(probability):
    draws = np.random.default_rng(8).normal(size=(REPETITIONS, 100))
    found = [statistics.tolerance_bounds(row, probability, 0.9) for row in draws]
    edge = stats.norm.ppf(probability)
    assert sum(bounds.upper >= edge for bounds in found) >= least_often(0.9)
    assert sum(bounds.lower <= -edge for bounds in found) >= least_often(0.9)


@pytest.mark.parametrize(("method", "truth"), [("pearson", 0.6), ("rank", 6 / np.pi * np.arcsin(0.3))])
def test_correlations_hold(method, truth):
    """Spearman's correlation of two normal numbers is 6/pi asin(r/2)."""
    rng = np.random.default_rng(9)
    x, y = rng.normal(size=(2, REPETITIONS, 100))
    y = 0.6 * x + 0.8 * y
    if method == "rank":
        x, y = stats.rankdata(x, axis=1), stats.rankdata(y, axis=1)
    found = [
        statistics.correlation_interval(np.corrcoef(a, b)[0, 1], 100, 0.9, method=method)
        for a, b in zip(x, y, strict=True)
    ]
    # The intervals are approximate: a hundredth of the coverage is theirs.
    assert holds(found, truth) >= least_often(0.89)


@pytest.mark.parametrize("confidence", [0.8, 0.95])
@pytest.mark.parametrize("probability", [0.02, 0.5, 0.75])
def test_quantiles_are_scipys(confidence, probability):
    values = np.random.default_rng(10).normal(size=200)
    found = statistics.quantile_interval(values, probability, confidence)
    low, high = stats.quantile_test(values, p=probability).confidence_interval(confidence)
    assert found.low == (low if np.isfinite(low) else -np.inf)
    assert found.high == high
    assert found.low <= found.value <= found.high


def test_a_quantile_that_the_runs_cannot_bound_has_an_infinite_end():
    found = statistics.quantile_interval(np.arange(100.0), 0.999)
    assert found.high == np.inf
    assert np.isfinite(found.low)
    assert found.half_width == np.inf


@pytest.mark.parametrize(("hits", "n"), [(0, 10), (3, 10), (10, 10), (27, 10_000)])
def test_probabilities_are_clopper_and_pearsons(hits, n):
    found = statistics.probability_interval(hits, n, 0.95)
    expected = stats.binomtest(hits, n).proportion_ci(0.95, method="exact")
    # SciPy finds the ends by a search to 1e-12.
    np.testing.assert_allclose([found.low, found.high], [expected.low, expected.high], rtol=1e-9, atol=1e-12)


def test_the_runs_needed_are_wilks_numbers():
    """Wilks's 59 and 93 runs for 95 % with 95 %, one and two sides; 22 and 38 for 90 % with 90 %."""
    assert statistics.runs_needed(0.95, 0.95) == 59
    assert statistics.runs_needed(0.95, 0.95, sides=2) == 93
    assert statistics.runs_needed(0.90, 0.90) == 22
    assert statistics.runs_needed(0.90, 0.90, sides=2) == 38
    assert statistics.runs_needed(0.9973, 0.90) == np.ceil(np.log(0.1) / np.log(0.9973))


def test_a_tolerance_bound_exists_from_the_runs_needed_on():
    least = statistics.runs_needed(0.95, 0.95)
    values = np.random.default_rng(11).normal(size=least)
    bounds = statistics.tolerance_bounds(values, 0.95, 0.95)
    assert bounds == (values.min(), values.max())
    assert statistics.tolerance_bounds(values[1:], 0.95, 0.95) == (None, None)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: statistics.quantile_interval([1.0, np.nan], 0.5), "values: .* all finite"),
        (lambda: statistics.quantile_interval([], 0.5), "values: .* at least one"),
        (
            lambda: statistics.quantile_interval([1.0], 95),
            "probability: got 95; give a number between 0 and 1",
        ),
        (lambda: statistics.probability_interval(5, 4), "hits: got 5; of 4 runs there can be 0 to 4"),
        (lambda: statistics.runs_needed(0.95, 0.95, sides=3), "sides: got 3; give 1 or 2"),
        (lambda: statistics.mean_interval(0.0, 1.0, 9, 1.0), "confidence: got 1.0"),
    ],
)
def test_wrong_input_is_refused(call, message):
    with pytest.raises(InputError, match=message):
        call()
