"""The figures of many runs show the numbers of their statistics."""

import numpy as np
import pytest

from freebody import plots, statistics
from freebody.errors import InputError
from freebody.plots import ensembles
from python.statistics.samples import NON_FINITE, ended, runs
from python.statistics.test_sensitivity import saltelli_runs


@pytest.fixture(scope="module")
def data():
    return runs(3000)


def points(line):
    return np.asarray(line.get_xdata()), np.asarray(line.get_ydata())


def widths(axes):
    """How far bars reach: a patch's box without where it stands."""
    return [patch.get_path().get_extents(patch.get_patch_transform()).width for patch in axes.patches]


def test_a_histogram_counts_every_run_and_shows_quantiles(data):
    axes = ensembles.histogram(ended(data, NON_FINITE, 0), "miss").axes[0]
    bars = axes.patches[: -len(axes.lines)]
    assert sum(round(bar.get_path().get_extents(bar.get_patch_transform()).height) for bar in bars) == 2999
    values = data["outputs"].values[1:, 0]
    median = statistics.quantile_interval(values, 0.5).value
    assert median in [points(line)[0][0] for line in axes.lines]
    assert axes.get_xlabel() == "miss (m)"


def test_a_scatter_shows_the_ellipse_of_the_covariance(data):
    axes = ensembles.scatter(data, "mass", "drift").axes[0]
    drawn = axes.transData.inverted().transform(axes.patches[0].get_verts())
    found = statistics.moments(data, ["mass", "drift"])
    away = drawn - found.mean
    distance = np.einsum("ri,ri->r", away, np.linalg.solve(found.covariance, away.T).T)
    # Every point of the ellipse is one sigma away; Bezier curves of matplotlib are round to 3e-4.
    np.testing.assert_allclose(distance, 1.0, rtol=1e-3)


def test_a_matrix_shows_every_correlation(data):
    axes = ensembles.correlations(data, ["drift", "mass", "wind"]).axes[0]
    shown = {text.get_text() for text in axes.texts}
    assert f"{statistics.moments(data, ['drift', 'mass']).correlation[0, 1]:.2f}" in shown


@pytest.mark.parametrize("rule", ["drift:mean:0.2", "miss:q0.95:0.3", "event:crossing:p:5%"])
def test_a_convergence_ends_at_the_estimate(data, rule):
    precision = statistics.parse_precision(rule)
    shown = [points(line) for line in ensembles.convergence(data, precision).axes[0].lines]
    ((runs_of, estimates),) = [(x, y) for x, y in shown if len(x) > 2]
    assert runs_of[-1] == 3000
    assert estimates[-1] == precision.estimate(data).value


def test_bars_show_sensitivities_in_order(data):
    axes = ensembles.sensitivity(data, "drift").axes[0]
    assert [label.get_text() for label in axes.get_yticklabels()] == ["mass", "wind"]
    expected = statistics.correlations(data, "drift")[0].partial
    assert expected is not None
    assert widths(axes)[0] == expected.value


def test_bars_show_sobol_indices_where_there_are_some():
    made = saltelli_runs()
    axes = ensembles.sensitivity(made, "y").axes[0]
    assert [label.get_text() for label in axes.get_yticklabels()] == ["x1", "x2", "x3"]
    assert widths(axes)[0] == statistics.sobol(made, "y")[0].total.value


@pytest.mark.parametrize(
    "draw",
    [
        lambda d: ensembles.histogram(d, "miss"),
        lambda d: ensembles.scatter(d, "miss", "drift"),
        lambda d: ensembles.sensitivity(d, "drift"),
    ],
)
def test_where_nothing_can_be_drawn_that_is_said(draw):
    with pytest.raises(InputError, match="nothing to draw"):
        draw(ended(runs(5), NON_FINITE, *range(5)))


def test_a_result_that_does_not_vary_is_drawn(data, tmp_path):
    same = data.copy(deep=True)
    same["outputs"][:] = 1.0
    plots.save(ensembles.histogram(same, "miss"), tmp_path / "same.png")
    plots.save(ensembles.correlations(same, ["miss", "mass"]), tmp_path / "matrix.png")
    plots.save(
        ensembles.convergence(same, statistics.parse_precision("miss:mean:1%")), tmp_path / "still.png"
    )
