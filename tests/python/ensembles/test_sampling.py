"""Points of the unit hypercube: independent of what is asked for, even, within the open cube."""

import itertools
import pickle
from typing import Any

import numpy as np
import pytest
from scipy import stats

from freebody.ensembles import Design
from freebody.ensembles.distributions import LEAST

SAMPLINGS = ("random", "latin_hypercube", "sobol", "saltelli")
EACH = pytest.mark.parametrize("sampling", SAMPLINGS)


def design(sampling: Any, n: int = 1024, d: int = 6, seed: int = 7) -> Design:
    return Design(sampling, seed, n, tuple((f"x_{i}",) for i in range(d)), tuple((i,) for i in range(d)))


@EACH
def test_a_run_has_its_point_whatever_is_asked_for(sampling: Any):
    whole = design(sampling).points(0, 1024)
    for count in (1, 7, 100, 1000):
        parts = [design(sampling).points(k, min(count, 1024 - k)) for k in range(0, 1024, count)]
        assert (np.concatenate(parts) == whole).all()
    again = design(sampling)
    assert (np.concatenate([again.points(k, 8) for k in range(0, 1024, 8)]) == whole).all()


@EACH
def test_another_seed_has_other_points(sampling: Any):
    one, other = (design(sampling, seed=seed).points(0, 64) for seed in (1, 2))
    assert (one != other).mean() > 0.99


@EACH
@pytest.mark.parametrize("seed", [0, 1, 2**64 - 1])
def test_points_lie_within_the_open_cube(sampling: Any, seed: int):
    points = design(sampling, n=8192, seed=seed).points(0, 8192)
    assert points.min() >= LEAST
    assert points.max() <= 1.0 - LEAST


def test_random_points_are_alike_and_independent():
    """Kolmogorov and Smirnov's test on each coordinate; correlations of pairs, and of neighbouring runs."""
    n, d = 50_000, 6
    points = design("random", n=n, d=d).points(0, n)
    # Chances of at least 1e-5 for each of some twenty comparisons: a right generator passes for any seed.
    assert all(stats.kstest(column, "uniform").pvalue > 1e-5 for column in points.T)
    correlations = np.corrcoef(np.hstack([points[1:], points[:-1]]).T)
    assert np.abs(correlations - np.eye(2 * d)).max() < 5.0 / np.sqrt(n)


def test_random_points_do_not_depend_on_how_many_runs_there_are():
    assert (design("random", n=10).points(3, 5) == design("random", n=10**9).points(3, 5)).all()
    assert (design("random", n=10**12).points(10**12 - 2, 1) != design("random", n=2).points(0, 1)).all()


def test_a_latin_hypercube_has_one_run_in_each_layer():
    n = 500
    points = design("latin_hypercube", n=n).points(0, n)
    layers = np.sort(np.ceil(points * n).astype(int) - 1, axis=0)
    assert (layers == np.arange(n)[:, None]).all()


def test_sobol_points_fill_every_elementary_interval():
    """2^m points of two coordinates are a (0, m, 2) net: one in each box of volume 2^-m."""
    points = design("sobol", n=256, d=2).points(0, 256)
    for k in range(9):
        rows, columns = (points * [2**k, 2 ** (8 - k)]).astype(int).T
        assert len(set(zip(rows.tolist(), columns.tolist(), strict=True))) == 256


def test_saltelli_exchanges_one_factor_at_a_time():
    factors, places = (("a",), ("b_x", "b_y"), ("c",)), ((0,), (1, 2), (3,))
    one = Design("saltelli", 3, 5 * 64, factors, places)
    points = one.points(0, one.n)
    A, B, AB = one.blocks(points)
    assert A.shape == B.shape == (64, 4)
    assert AB.shape == (64, 3, 4)
    for i, own in enumerate(places):
        rest = [k for k in range(4) if k not in own]
        assert (AB[:, i][:, own] == B[:, own]).all()
        assert (AB[:, i][:, rest] == A[:, rest]).all()
    # A and B are halves of one set of Sobol points: no coordinate of one is that of the other.
    assert (A != B).all()
    for i, j in itertools.combinations(range(4), 2):
        assert len({(int(8 * x), int(8 * y)) for x, y in A[:, [i, j]]}) > 32


def test_values_that_are_given_take_no_coordinate():
    assert Design("random", 1, 10, (), ()).points(2, 3).shape == (3, 0)


@EACH
def test_a_design_pickles_without_its_points(sampling: Any):
    one = design(sampling, n=4096)
    points = one.points(100, 50)
    stored = pickle.dumps(one)
    assert len(stored) < 2000
    assert (pickle.loads(stored).points(100, 50) == points).all()
