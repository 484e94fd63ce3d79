"""The command that does the runs of a dispersed model file."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import xarray as xr

import freebody as fb
from freebody.model_file import shipped_model

LAWS = """
import freebody as fb

@fb.event(terminal=True, direction="rising")
def low(s):
    return s.position_world[2] + 900.0

@fb.output(unit="m", take="max")
def depth(s):
    return s.position_world[2]
"""


def test_a_campaign_of_a_model_file(freebody, tmp_path):
    status, out, _ = freebody(
        "ensemble", "falling_capsule", "-n", 50, "--seed", 7, "--chunk", 20, "-o", "a.zarr"
    )
    assert status == 0
    assert "50 of 50 runs, 100.000%" in out
    data = xr.open_zarr(tmp_path / "a.zarr")
    assert data.attrs["model_file"] == shipped_model("falling_capsule").read_text()
    assert data.attrs["title"] == "Falling sample capsule, dispersed"
    loaded = fb.load(shipped_model("falling_capsule"))
    runs = loaded.ensemble(50, seed=7).run(loaded.t_span)
    np.testing.assert_array_equal(data.final_state, runs.final)


def test_started_again_it_goes_on(freebody, tmp_path):
    for n in (30, 50):
        status, _, err = freebody("ensemble", "falling_capsule", "-n", n, "--chunk", 20)
        assert status == 0
    assert "30 of 50 runs were done before" in err or "20 of 50" in err
    assert xr.open_zarr(tmp_path / "out/falling_capsule/falling_capsule.zarr").sizes["run"] == 50


def test_another_campaign_is_refused(freebody):
    freebody("ensemble", "falling_capsule", "-n", 10, "-o", "a.zarr")
    status, _, err = freebody("ensemble", "falling_capsule", "-n", 10, "--seed", 2, "-o", "a.zarr")
    assert status == 2
    assert "seed is 1 there, 2 here" in err


def test_events_and_outputs_of_a_python_file(freebody, tmp_path):
    (tmp_path / "laws.py").write_text(LAWS)
    status, out, _ = freebody("ensemble", "falling_capsule", "-n", 20, "-o", "a.zarr", "--laws", "laws.py")
    assert status == 0
    assert "event in 20 of 20 runs" in out
    data = xr.open_zarr(tmp_path / "a.zarr")
    depths = data.outputs.sel(output="depth").values
    np.testing.assert_allclose(depths, -900.0, rtol=1e-9)  # where the event is


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["toutatis", "-n", "5"], "needs dispersions"),
        (["falling_capsule", "--sampling", "halton"], "allowed are random"),
        (["falling_capsule", "--laws", "empty.py"], "defines no event and no output"),
        (["falling_capsule", "--laws", "wrong.py"], "ZeroDivisionError"),
        (["falling_capsule", "--laws", "none.py"], "none.py"),
    ],
)
def test_what_is_wrong_is_said(freebody, tmp_path, arguments, words):
    (tmp_path / "empty.py").write_text("")
    (tmp_path / "wrong.py").write_text("1 / 0")
    status, _, err = freebody("ensemble", *arguments, "-o", "a.zarr")
    assert status == 2
    assert words in err
    assert not (tmp_path / "a.zarr").exists()


def test_control_c_says_how_to_go_on(tmp_path):
    command = [sys.executable, "-m", "freebody", "ensemble", "falling_capsule", "-n", "1000000"]
    command += ["--chunk", "100", "-o", str(tmp_path / "a.zarr")]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while not (tmp_path / "a.zarr/runs_done/c/1").exists():
        assert process.poll() is None
        time.sleep(0.01)
    os.kill(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "the same command goes on" in err
