"""Distributions: quantile functions against SciPy's, moments of draws, draws within bounds."""

from pathlib import Path

import numpy as np
import pytest
from scipy import integrate, stats

import freebody as fb
from freebody.ensembles import Distribution
from freebody.ensembles.distributions import LEAST, Independent

PAIRS = {
    "normal": (fb.Normal(3.0, 0.5), stats.norm(3.0, 0.5)),
    "truncated": (fb.TruncatedNormal(3.0, 0.5, 2.5, 4.5), stats.truncnorm(-1.0, 3.0, 3.0, 0.5)),
    "half": (fb.TruncatedNormal(0.0, 2.0, 0.0, np.inf), stats.truncnorm(0.0, np.inf, 0.0, 2.0)),
    "below": (fb.TruncatedNormal(1.0, 2.0, -np.inf, 2.0), stats.truncnorm(-np.inf, 0.5, 1.0, 2.0)),
    "uniform": (fb.Uniform(-2.0, 5.0), stats.uniform(-2.0, 7.0)),
    "log-normal": (fb.LogNormal(12.0, 0.3), stats.lognorm(0.3, scale=12.0)),
}
EACH = pytest.mark.parametrize(("ours", "scipys"), PAIRS.values(), ids=PAIRS)
# The middles of equal parts of (0, 1), and both ends.
U = np.concatenate([[LEAST], (np.arange(4000) + 0.5) / 4000, [1.0 - LEAST]])[:, None]


@EACH
def test_the_quantile_function_is_the_inverse_of_the_distribution_function(ours: Independent, scipys):
    # Near 1 a double tells u to 1e-16 only, and SciPy's truncated normal adds its own rounding.
    np.testing.assert_allclose(scipys.cdf(ours.quantile(U)), U, rtol=1e-12, atol=1e-15)


@EACH
def test_moments_are_scipys(ours: Distribution, scipys):
    # Closed forms against closed forms, and a quadrature where SciPy has one.
    np.testing.assert_allclose(ours.moments(), [scipys.mean(), scipys.std()], rtol=1e-8)


@EACH
def test_draws_have_the_moments(ours: Distribution, scipys):
    """Of n independent draws the mean misses by its standard error, the variance by that of the variance."""
    n = 40_000
    u = np.random.default_rng(1).uniform(LEAST, 1.0 - LEAST, (n, 1))
    x = ours.draw(u, 0, 1)[:, 0]
    mean, sd = ours.moments()
    fourth = float(scipys.expect(lambda v: (v - mean) ** 4))
    # Five standard errors: the chance of one failure in ten such tests is below 1e-5.
    assert abs(x.mean() - mean) < 5.0 * sd / np.sqrt(n)
    assert abs(x.var() - sd**2) < 5.0 * np.sqrt((fourth - sd**4) / n)


@EACH
def test_every_draw_lies_within_the_bounds(ours: Distribution, scipys):
    low, high = ours.bounds(3)
    draws = ours.draw(np.repeat(U, 3, axis=1), 0, 3)
    assert (low <= draws).all()
    assert (draws <= high).all()
    assert (draws.min(axis=0) == low).all()
    assert (draws.max(axis=0) == high).all()


@pytest.mark.parametrize(("low", "high"), [(10.0, 11.0), (30.0, 40.0), (-40.0, -30.0), (-8.0, np.inf)])
def test_a_truncated_normal_is_accurate_far_from_its_mean(low: float, high: float):
    """The share of the interval below each draw, by quadrature of the density, is u."""
    end = min(high, low + 12.0)
    middle = min(abs(low), abs(high)) ** 2 / 2.0

    def mass(a: float, b: float) -> float:
        return integrate.quad(
            lambda z: np.exp(middle - z * z / 2.0), a, b, epsabs=0.0, epsrel=1e-12, limit=500
        )[0]

    if np.isinf(high):  # all of it: its density has width 1, far inside the interval
        middle, end = 0.0, 8.0
    for u in (0.1, 0.5, 0.9):
        (x,) = fb.TruncatedNormal(0.0, 1.0, low, high).quantile(np.array([[u]]))[0]
        # The logarithms of probabilities are about 800 here; doubles tell them to 1e-13.
        assert mass(low, x) / mass(low, end) == pytest.approx(u, rel=1e-9)


def test_a_truncated_normal_is_the_mirror_of_its_mirror():
    """Bounds and points turned over turn the draws over, but for the rounding of 1 - u."""
    u = U[1:-1]
    right = fb.TruncatedNormal(0.0, 1.0, 2.0, 9.0).quantile(u)
    left = fb.TruncatedNormal(0.0, 1.0, -9.0, -2.0).quantile(1.0 - u)
    np.testing.assert_allclose(right, -left, rtol=1e-13)


def test_numbers_serve_a_vector_and_vectors_broadcast():
    u = np.random.default_rng(2).uniform(LEAST, 1.0 - LEAST, (50, 3))
    together = fb.Normal([1.0, 2.0, 3.0], 0.5).draw(u, 0, 3)
    assert fb.Normal(1.0, 0.5).size is None
    assert fb.Normal([1.0, 2.0, 3.0], 0.5).size == 3
    for i in range(3):
        assert (together[:, i] == fb.Normal(i + 1.0, 0.5).draw(u[:, [i]], 0, 1)[:, 0]).all()


COVARIANCES = {
    "full": [[4.0, 1.0, 0.5], [1.0, 2.0, -0.3], [0.5, -0.3, 1.0]],
    "singular": [[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 2.0]],
}


@pytest.mark.parametrize("covariance", COVARIANCES.values(), ids=COVARIANCES)
def test_a_multivariate_normal_has_its_mean_and_covariance(covariance):
    mean = np.array([1.0, -2.0, 3.0])
    ours = fb.MultivariateNormal(mean, covariance)
    n = 40_000
    x = ours.draw(np.random.default_rng(3).uniform(LEAST, 1.0 - LEAST, (n, 3)), 0, 3)
    true = np.array(covariance)
    variances = np.diag(true)
    # Five standard errors (Wishart: the variance of a covariance is (v_i v_j + c_ij^2) / n).
    assert (np.abs(x.mean(axis=0) - mean) < 5.0 * np.sqrt(variances / n)).all()
    spread = np.sqrt((np.outer(variances, variances) + true**2) / n)
    assert (np.abs(np.cov(x.T) - true) < 5.0 * spread).all()
    # The factor is exact to rounding: its square is the covariance.
    np.testing.assert_allclose(ours._factor @ ours._factor.T, true, atol=1e-14)


def test_a_singular_covariance_keeps_its_numbers_together():
    ours = fb.MultivariateNormal([0.0, 0.0, 0.0], COVARIANCES["singular"])
    x = ours.draw(np.random.default_rng(4).uniform(LEAST, 1.0 - LEAST, (100, 3)), 0, 3)
    # The root is that of eigenvalues, of which one is zero to 1e-16: its root to 1e-8.
    np.testing.assert_allclose(x[:, 0], x[:, 1], atol=1e-7)


def test_discrete_values_come_as_often_as_their_weights_say():
    ours = fb.Discrete([[1.0, 10.0], [2.0, 20.0], [3.0, 30.0]], weights=[1.0, 0.0, 3.0])
    n = 4000
    draws = ours.draw((np.arange(n)[:, None] + 0.5) / n, 0, 2)
    rows, counts = np.unique(draws, axis=0, return_counts=True)
    assert rows.tolist() == [[1.0, 10.0], [3.0, 30.0]]
    assert counts.tolist() == [n // 4, 3 * n // 4]
    np.testing.assert_allclose(ours.moments(), [draws.mean(axis=0), draws.std(axis=0)], rtol=1e-12)
    assert [b.tolist() for b in ours.bounds(2)] == [[1.0, 10.0], [3.0, 30.0]]


def test_discrete_numbers_are_independent_of_each_other():
    ours = fb.Discrete([1.0, 2.0])
    assert ours.draw(np.array([[0.2, 0.7]]), 0, 2).tolist() == [[1.0, 2.0]]
    assert (ours.dimensions(2), fb.Discrete([[1.0, 2.0]]).dimensions(2)) == (2, 1)


def test_row_r_of_given_values_is_that_of_run_r(tmp_path: Path):
    file = tmp_path / "flights.csv"
    file.write_text("run, mass, thrust\n" + "".join(f"{i}, {10 + i}, {-i / 8}\n" for i in range(20)))
    for given in (fb.FromFile(file, ["mass", "thrust"]), fb.Samples([[10.0 + i, -i / 8] for i in range(20)])):
        rows = given.draw(np.empty((3, 0)), 5, 2)
        assert rows.tolist() == [[15.0, -0.625], [16.0, -0.75], [17.0, -0.875]]
        assert given.dimensions(2) == 0
    one = fb.FromFile(str(file), "mass")
    assert one.draw(np.empty((2, 0)), 18, 1).tolist() == [[28.0], [29.0]]


def test_distributions_compare_print_and_stay_as_they_are():
    assert fb.Normal([1, 2], 3) == fb.Normal((1.0, 2.0), 3.0)
    assert hash(fb.Uniform(0, 1)) == hash(fb.Uniform(0.0, 1.0))
    assert repr(fb.Offset(fb.LogNormal(1.0, 0.1))) == "Offset(distribution=LogNormal(median=1.0, sigma=0.1))"
    assert repr(fb.Samples([1.0, 2.0])) == repr(fb.Samples([[1.0], [2.0]])) != repr(fb.Samples([1.0, 2.5]))
    with pytest.raises(AttributeError):
        fb.Normal(0.0, 1.0).sd = 2.0  # type: ignore[misc]
