"""What a campaign leaves: a labelled dataset that depends on the campaign alone."""

import multiprocessing
import resource

import numpy as np
import pytest
import xarray as xr

import freebody as fb
from freebody.campaigns import open_runs
from python.campaigns.scene import SPAN, campaign, ensemble, tree


def test_the_store_is_the_dataset_of_the_same_runs_in_memory(tmp_path):
    runs = campaign(tmp_path / "a.zarr", 60, save_at=[0.5, 1.0])
    kept = ensemble(60).run(SPAN, rtol=1e-6, save_at=[0.5, 1.0])
    stored, wanted = xr.open_zarr(tmp_path / "a.zarr"), kept.to_xarray()
    assert set(stored.variables) == {*wanted.variables, "runs_done"}
    for name, variable in wanted.variables.items():
        assert stored[name].dims == variable.dims
        np.testing.assert_array_equal(stored[name].values.astype(variable.dtype), variable.values)
        assert {key: stored[name].attrs[key] for key in variable.attrs} == dict(variable.attrs)
    assert set(stored.coords) == set(wanted.coords)
    assert {key: stored.attrs[key] for key in wanted.attrs} == wanted.attrs
    np.testing.assert_array_equal(runs.final, kept.final)
    np.testing.assert_array_equal(runs.samples, kept.samples)
    assert runs.outputs == {}
    assert len(runs) == 60
    assert stored.final_state.sel(state="velocity_x", run=59) == kept.final[59, 7]


def test_no_byte_depends_on_threads_or_on_when(tmp_path):
    for name, threads in (("a", 1), ("b", 2)):
        campaign(tmp_path / name, 60, threads=threads)
    assert tree(tmp_path / "a") == tree(tmp_path / "b")


@pytest.mark.parametrize("chunk", [1, 7, 1000])
def test_results_do_not_depend_on_the_chunk(tmp_path, chunk):
    runs, whole = campaign(tmp_path / "a", 40, chunk=chunk), ensemble(40).run(SPAN, rtol=1e-6)
    for name, values in whole.chunk.items():
        np.testing.assert_array_equal(runs.chunk[name], values, name)


@pytest.mark.parametrize("sampling", ["random", "sobol"])
def test_a_campaign_that_has_grown_is_one_made_so_large(tmp_path, sampling):
    for path, sizes in (("grown", (30, 40, 110)), ("whole", (110,))):
        for n in sizes:
            ensemble(n, sampling=sampling).campaign(tmp_path / path, SPAN, rtol=1e-6, chunk=25)
    assert tree(tmp_path / "grown") == tree(tmp_path / "whole")


def test_a_finished_campaign_has_nothing_to_do(tmp_path):
    campaign(tmp_path / "a", 60)
    told = []
    ensemble(60).campaign(tmp_path / "a", SPAN, rtol=1e-6, progress=told.append)
    assert told == [1.0]


def test_progress_ends_with_all_runs(tmp_path):
    told = []
    campaign(tmp_path / "a", 60, progress=told.append)
    assert told == sorted(told)
    assert (told[0], told[-1]) == (0.0, 1.0)


@pytest.mark.parametrize(
    ("given", "options", "words"),
    [
        ({"seed": 8}, {}, "seed is 7 there, 8 here"),
        ({}, {"rtol": 1e-7}, "rtol is 1e-06 there, 1e-07 here"),
        ({}, {"method": "dp54"}, "method is dop853 there, dp54 here"),
        ({}, {"save_at": [1.0]}, "the times of the samples differ"),
        ({}, {"chunk": 10}, "chunks of 25 runs"),
        ({"n": 20}, {}, "has 60 runs, 20 are asked for"),
        ({"inputs": [1.0, 0, 0, 0, 0, 0]}, {}, "the inputs differ"),
    ],
)
def test_another_campaign_is_refused_and_told_what_differs(tmp_path, given, options, words):
    campaign(tmp_path / "a", 60)
    before = tree(tmp_path / "a")
    with pytest.raises(fb.StoreError, match=words):
        ensemble(**{"n": 60, **given}).campaign(tmp_path / "a", SPAN, **{"rtol": 1e-6, **options})
    assert tree(tmp_path / "a") == before


def test_a_design_that_cannot_grow_is_not_grown(tmp_path):
    for n, refused in ((50, False), (60, True)):
        given = ensemble(n, sampling="latin_hypercube")
        if refused:
            with pytest.raises(fb.StoreError, match="nothing can be added"):
                given.campaign(tmp_path / "a", SPAN)
        else:
            given.campaign(tmp_path / "a", SPAN)


def test_what_is_no_campaign_is_left_alone(tmp_path):
    (tmp_path / "photo.jpg").write_bytes(b"mine")
    with pytest.raises(fb.StoreError, match="is no campaign"):
        campaign(tmp_path, 10)
    assert tree(tmp_path) == {"photo.jpg": b"mine"}


def test_a_url_will_do():
    runs = campaign("memory://campaigns/a.zarr", 60)
    np.testing.assert_array_equal(runs.final, ensemble(60).run(SPAN, rtol=1e-6).final)
    assert open_runs("memory://campaigns/a.zarr").sizes["run"] == 60


@pytest.mark.parametrize("file", ["final_state/c/1/0", "steps/c/1"])
def test_a_damaged_file_is_an_error_and_no_numbers(tmp_path, file):
    campaign(tmp_path / "a", 60)
    damaged = tmp_path / "a" / file
    data = bytearray(damaged.read_bytes())
    data[len(data) // 2] ^= 1
    damaged.write_bytes(data)
    with pytest.raises((ValueError, RuntimeError)):
        open_runs(tmp_path / "a").load()


def _peak(path, n, pipe):
    times = np.linspace(0.0, 0.02, 100)
    ensemble(n).campaign(path, (0.0, 0.02), rtol=1e-3, chunk=500, save_at=times)
    pipe.send(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)


def test_memory_is_that_of_a_chunk(tmp_path):
    """10 000 runs with 100 samples are 104 MB; a chunk of 500 is 5 MB, held a few times over."""
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["freebody.campaigns"])
    peaks = []
    for n in (1000, 10_000):
        here, there = context.Pipe(duplex=False)
        process = context.Process(target=_peak, args=(tmp_path / f"{n}", n, there))
        process.start()
        assert here.poll(120), "the campaign of the other process came to nothing"
        peaks.append(here.recv())
        process.join()
    assert peaks[1] - peaks[0] < 40_000  # kB
