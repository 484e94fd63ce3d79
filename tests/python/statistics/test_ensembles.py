"""Statistics of real runs: the labels of ensembles are those that statistics reads."""

import numpy as np
import pytest

import freebody as fb
from freebody import statistics
from freebody.ensembles import Sampling


@pytest.fixture(scope="module")
def start():
    body = fb.RigidBody(mass=2.0, inertia_about_com=np.diag([0.4, 0.9, 1.1]))
    model = fb.Model(body, forces=[fb.ConstantWrench(force=[3.0, 0.0, 0.0], axes="world", name="push")])
    return model, model.state()


def ensemble(start, n, sampling: Sampling = "random"):
    model, x0 = start
    gust = fb.MultivariateNormal([0.0, 0.0, 0.0], [[0.25, 0.1, 0.0], [0.1, 0.25, 0.0], [0.0, 0.0, 0.25]])
    dispersions = {"mass": fb.Factor(fb.Uniform(0.9, 1.1)), "velocity_world": gust}
    return model.ensemble(x0, dispersions, n=n, seed=3, sampling=sampling)


def test_the_mean_of_known_motion(start):
    """x = v t + f t²/2m: with v about 0 and 1/m uniform in its reciprocal."""
    data = ensemble(start, 4000).run((0.0, 2.0), rtol=1e-9).to_xarray()
    rule = statistics.Precision("final:position_x", confidence=0.9999, absolute=1.0)
    found = rule.judge(data).interval
    expected = 3.0 * 2.0**2 / 2 / 2.0 * np.log(1.1 / 0.9) / 0.2
    assert found.low <= expected <= found.high
    assert statistics.column(data, "velocity_world_x").unit == "m/s"


def test_runs_are_made_until_they_are_enough(start):
    def first(k):
        return ensemble(start, k).run((0.0, 2.0)).to_xarray()

    rule = statistics.Precision("final:position_y", absolute=0.05)
    stopped = statistics.run_until(first, rule, start=200, limit=20_000)
    assert stopped.met
    # y = v_y t has a standard deviation of 1 m: 1.96 / sqrt(n) is 0.05 at 1537 runs, give or take a look.
    assert 1537 * 0.8 <= stopped.runs <= 1537 * 1.5 * 1.2


def test_sobol_indices_of_known_motion(start):
    made = ensemble(start, 4 * 512, "saltelli")
    data = made.run((0.0, 2.0)).to_xarray()
    found = {index.factor: index for index in statistics.sobol(data, "final:position_y", 0.999)}
    # Two factors: what is dispersed jointly is one.
    assert list(found) == ["velocity_world_x, velocity_world_y, velocity_world_z", "mass"]
    gust = next(iter(found.values()))
    assert gust.first.low <= 1.0 <= gust.first.high
    assert found["mass"].total.value < 1e-12  # y does not feel it, but for rounding
