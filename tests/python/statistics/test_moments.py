"""One pass over blocks gives what the whole gives."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from freebody import statistics
from freebody.errors import InputError
from python.statistics.samples import NON_FINITE, NOT_RUN, ended, runs


@pytest.fixture(scope="module")
def rows():
    rng = np.random.default_rng(3)
    return rng.normal(size=(1000, 3)) @ [[1.0, 0.5, 0.0], [0.0, 2.0, 0.1], [0.0, 0.0, 3.0]] + [
        1.0,
        -5.0,
        100.0,
    ]


def assert_same(found, whole):
    assert (found.count, found.missing) == (whole.count, whole.missing)
    # Sums of a thousand terms in another order: some hundred roundings of 1e-16 at worst.
    np.testing.assert_allclose(found.mean, whole.mean, rtol=1e-13)
    np.testing.assert_allclose(found.covariance, whole.covariance, rtol=1e-12, atol=1e-13)
    assert np.array_equal(found.least, whole.least)
    assert np.array_equal(found.greatest, whole.greatest)


@given(cuts=st.lists(st.integers(0, 1000), max_size=8))
def test_blocks_of_any_sizes_give_the_whole(rows, cuts):
    found = statistics.Moments(3)
    for block in np.split(rows, sorted(cuts)):
        found.add(block)
    assert_same(found, statistics.Moments(3).add(rows))


def test_merging_in_any_grouping_gives_the_whole(rows):
    a, b, c = (statistics.Moments(3).add(part) for part in np.split(rows, [100, 350]))
    assert_same(c.merge(a.merge(b)), statistics.Moments(3).add(rows))


def test_they_are_numpys(rows):
    found = statistics.Moments(3).add(rows)
    np.testing.assert_allclose(found.mean, rows.mean(axis=0), rtol=1e-13)
    np.testing.assert_allclose(found.covariance, np.cov(rows.T), rtol=1e-12)
    np.testing.assert_allclose(found.sd, rows.std(axis=0, ddof=1), rtol=1e-12)
    np.testing.assert_allclose(found.correlation, np.corrcoef(rows.T), rtol=1e-12)


def test_a_small_spread_about_a_large_mean_is_kept():
    # A mean of 1e9 and deviations of 1e-3: sums of squares would lose all of it, for 1e18 has an ulp of 128.
    deviations = np.random.default_rng(0).normal(size=10_000) * 1e-3
    values = 1e9 + deviations
    found = statistics.Moments(1)
    for block in np.split(values, 10):
        found.add(block[:, None])
    # The values themselves are rounded to 1.2e-7, of which the spread is 1e-3.
    np.testing.assert_allclose(found.sd[0], (values - 1e9).std(ddof=1), rtol=1e-6)


def test_a_row_that_is_not_finite_is_counted_and_left_out(rows):
    holes = rows.copy()
    holes[[3, 500], [0, 2]] = np.nan, np.inf
    found = statistics.Moments(3).add(holes)
    assert (found.count, found.missing) == (998, 2)
    assert_same(found.merge(statistics.Moments(3)), statistics.Moments(3).add(holes))


def test_what_does_not_vary_has_no_correlation():
    found = statistics.Moments(2).add([[0.1, 1.0], [0.1, 2.0], [0.1, 4.0]])
    assert np.isnan(found.correlation[0]).all()
    assert found.correlation[1, 1] == 1.0


def test_one_run_has_a_mean_and_no_spread():
    found = statistics.Moments(2).add([[1.0, 2.0]])
    assert np.array_equal(found.mean, [1.0, 2.0])
    assert np.isnan(found.covariance).all()


def test_runs_that_ended_badly_or_are_not_made_are_left_out():
    data = ended(ended(runs(100), NON_FINITE, 3, 4), NOT_RUN, 98, 99)
    found = statistics.moments(data, ["drift", "miss"])
    kept = runs(100)["outputs"].values[[*range(3), *range(5, 98)]][:, ::-1]
    assert_same(found, statistics.Moments(2).add(kept))
    assert sum(statistics.outcomes(data).values()) == 98
    assert statistics.outcomes(data)["non_finite"] == 2


def test_columns_are_found_by_their_names():
    data = runs(10)
    assert statistics.column(data, "miss") == statistics.column(data, "output:miss")
    assert statistics.column(data, "wind").unit == "m/s"
    assert statistics.column(data, "event:crossing").unit == "s"
    assert statistics.column(data, "end_time").key == "end_time"
    assert [c.key for c in statistics.results(data)] == ["output:miss", "output:drift", "event:crossing"]
    without = data.drop_vars(["outputs", "event_time"])
    assert [c.key for c in statistics.results(without)] == ["final:position_x", "final:position_y"]


def test_a_name_that_is_not_there_is_refused():
    with pytest.raises(InputError, match="the runs have no 'mis'; did you mean 'miss'"):
        statistics.column(runs(10), "mis")


def test_a_name_that_is_not_clear_is_refused():
    data = runs(10).assign_coords(quantity=["miss", "wind"])
    with pytest.raises(InputError, match="give one of output:miss, dispersed:miss"):
        statistics.column(data, "miss")
