"""Chunks as tasks of Dask workers: the store is that of one machine, also when a worker is lost."""

import os
import signal

import numpy as np
import pytest
from dask.config import set as configured
from distributed import Client, LocalCluster

import freebody as fb
from freebody.campaigns import connected
from python.campaigns.scene import SPAN, campaign, ensemble, tree


@pytest.fixture(scope="module")
def cluster():
    # A worker may ask the killed one for as long as this.
    patience = configured({"distributed.comm.timeouts.connect": "5s"})
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": ":0"}
    with patience, LocalCluster(**options, protocol="tcp://") as cluster:
        yield cluster


@pytest.fixture
def client(cluster):
    with Client(cluster) as client:
        yield client


def test_the_store_is_that_of_one_machine_although_a_worker_is_killed(tmp_path, client):
    workers = client.run(os.getpid)
    victims = list(workers.values())[:1]

    def kill(part):
        if part > 0.3 and victims:
            os.kill(victims.pop(), signal.SIGKILL)

    campaign(tmp_path / "cluster", 1000, client=client, progress=kill)
    assert not victims, "one was killed in the middle"
    campaign(tmp_path / "here", 1000)
    assert tree(tmp_path / "cluster") == tree(tmp_path / "here")


def test_what_one_machine_began_a_cluster_ends(tmp_path, cluster):
    campaign(tmp_path / "both", 60)
    with connected(cluster.scheduler_address) as client:
        campaign(tmp_path / "both", 200, client=client)
    campaign(tmp_path / "here", 200)
    assert tree(tmp_path / "both") == tree(tmp_path / "here")


@fb.event(terminal=False)
def turned(s):
    return s.angular_velocity_body[1]


@fb.output(unit="m/s", take="max")
def fastest(s):
    return np.linalg.norm(s.velocity_body)


@pytest.mark.parametrize("sampling", ["random", "sobol", "latin_hypercube"])
def test_runs_on_workers_are_those_in_memory(tmp_path, client, sampling):
    given = ensemble(60, sampling=sampling, events=[turned], outputs=[fastest])
    stored = given.campaign(tmp_path / "a", SPAN, rtol=1e-6, chunk=7, client=client)
    for name, values in given.run(SPAN, rtol=1e-6, threads=2).chunk.items():
        np.testing.assert_array_equal(stored.chunk[name], values, name)


def test_an_error_on_a_worker_is_raised_here(tmp_path, client):
    (tmp_path / "a").mkdir()
    runs = ensemble(60)
    runs.campaign(tmp_path / "a", (0.0, 2.0), chunk=20)
    (tmp_path / "a/runs_done/c/1").unlink()
    (tmp_path / "a/outcome/zarr.json").unlink()
    (tmp_path / "a/outcome/c/1").unlink()
    (tmp_path / "a/outcome/c/1").mkdir()
    with pytest.raises(fb.StoreError, match="start the same campaign again"):
        runs.campaign(tmp_path / "a", (0.0, 2.0), client=client)


def test_a_scheduler_that_does_not_answer():
    with (
        pytest.raises(fb.InputError, match="no scheduler answers"),
        connected("tcp://127.0.0.1:9", patience=1.0),
    ):
        pass


def test_compiled_code_is_not_sent(tmp_path, client):
    base = fb.compile(ensemble(10).base)
    runs = base.ensemble(base.state(), {"position": fb.Normal(0.0, 1.0)}, n=10)
    with pytest.raises(fb.InputError, match="stays on this machine"):
        runs.campaign(tmp_path / "a", (0.0, 1.0), client=client)
    assert not (tmp_path / "a").exists()
