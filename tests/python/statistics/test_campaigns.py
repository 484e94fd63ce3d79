"""A campaign ends at the first look that shows enough, whatever made its runs."""

import numpy as np
import pytest

import freebody as fb
from freebody import statistics
from freebody.campaigns import campaign_until
from freebody.ensembles import Sampling
from freebody.errors import InputError

SPAN = (0.0, 2.0)
RULES = [
    statistics.Precision("final:position_y", absolute=0.05),
    statistics.Precision("final:position_y", "quantile", probability=0.9, absolute=0.15),
]


@pytest.fixture(scope="module")
def ensemble():
    def made(n=20_000, sampling: Sampling = "random"):
        body = fb.RigidBody(mass=2.0, inertia_about_com=np.diag([0.4, 0.9, 1.1]))
        model = fb.Model(body)
        gust = {"velocity_world": fb.Normal(0.0, 0.5)}
        return model.ensemble(model.state(), gust, n=n, seed=3, sampling=sampling)

    return made


def test_it_stops_where_the_runs_in_memory_would(ensemble, tmp_path):
    stored, stopped = campaign_until(ensemble(), RULES, tmp_path / "a.zarr", SPAN, start=500)
    whole = ensemble().run(SPAN).to_xarray()
    assert stopped.met
    assert stopped == statistics.run_until(lambda k: whole, RULES, start=500, limit=20_000, multiple=500)
    assert len(stored) == stopped.runs
    assert np.array_equal(stored.final, whole["final_state"].values[: stopped.runs])


def test_started_again_it_stops_there_and_makes_no_run_twice(ensemble, tmp_path):
    path = tmp_path / "b.zarr"
    ensemble(1000).campaign(path, SPAN, chunk=500)
    first = campaign_until(ensemble(), RULES, path, SPAN, start=500)[1]
    files = {file: file.stat().st_mtime_ns for file in path.rglob("c/*") if file.is_file()}
    again = campaign_until(ensemble(), RULES, path, SPAN, start=500, threads=1)[1]
    assert again == first
    assert {file: file.stat().st_mtime_ns for file in files} == files


def test_a_larger_store_is_kept_and_not_looked_at(ensemble, tmp_path):
    ensemble(6000).campaign(tmp_path / "c.zarr", SPAN, chunk=500)
    stored, stopped = campaign_until(ensemble(), RULES, tmp_path / "c.zarr", SPAN, start=500)
    assert stopped == campaign_until(ensemble(), RULES, tmp_path / "d.zarr", SPAN, start=500)[1]
    assert len(stored) == 6000 > stopped.runs


def test_a_campaign_that_is_never_enough_makes_all_runs(ensemble, tmp_path):
    rule = statistics.Precision("final:position_y", absolute=1e-9)
    stored, stopped = campaign_until(ensemble(700), rule, tmp_path / "e.zarr", SPAN, start=200)
    assert (stopped.met, stopped.runs, len(stored)) == (False, 700, 700)


@pytest.mark.parametrize("sampling", ["latin_hypercube", "saltelli"])
def test_samples_that_nothing_can_be_added_to_are_refused(ensemble, tmp_path, sampling):
    with pytest.raises(InputError, match=r"first runs depend on how many follow; .* 'random' or 'sobol'"):
        campaign_until(ensemble(1000, sampling), RULES, tmp_path / "f.zarr", SPAN)
