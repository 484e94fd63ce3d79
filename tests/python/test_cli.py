"""The command line: exit status, messages, and the files it writes."""

import io
import json
import math
import re
from importlib.metadata import version

import pytest
import xarray as xr
from rich.console import Console

from freebody import verify
from freebody.cli import progress
from freebody.model_file import shipped_model, shipped_names
from freebody.verify.residual import Residual


def test_run_writes_data_and_figure_and_says_where(freebody, tmp_path):
    status, out, _ = freebody("run", "heavy_top")
    assert status == 0
    data, plot = out.splitlines()[-2:]
    assert data.split() == ["data", "out/heavy_top/heavy_top.nc"]
    assert plot.split() == ["plot", "out/heavy_top/heavy_top.png"]
    assert (tmp_path / "out/heavy_top/heavy_top.png").stat().st_size > 10_000
    with xr.open_dataset(tmp_path / "out/heavy_top/heavy_top.nc", engine="h5netcdf") as stored:
        assert stored.attrs["model_file"] == shipped_model("heavy_top").read_text()
        assert stored["point_rim"].shape == (501, 3)


def test_run_says_what_was_simulated_and_kept(freebody):
    _, out, _ = freebody("run", "heavy_top", "--no-plot")
    for part in ("Thrown heavy top", "outcome", "energy: drift", "steps", "wall time"):
        assert part in out


def test_run_says_that_and_when_it_changed_its_chart(freebody, tmp_path):
    # A pitch of 1 rad/s passes the 90 deg of zyx at pi/2 s.
    (tmp_path / "loop.toml").write_text(
        '[model]\nname = "loop"\n[body]\nmass = 1\ninertia_about_com = { principal = [1, 2, 2.5] }\n'
        "[initial]\nangular_velocity_body = [0, 1, 0]\n"
        '[simulation]\nend = 2\nattitude = "zyx"\n[output]\nsave_every = 0.1\n'
    )
    status, out, _ = freebody("run", "loop.toml")
    assert status == 0
    change = re.search(r"chart change +zyx to quaternion at ([0-9.]+) s", out)
    assert change
    assert 0 < float(change[1]) < math.pi / 2
    with xr.open_dataset(tmp_path / "out/loop/loop.nc", engine="h5netcdf") as stored:
        assert stored.attrs["chart_changes"].count("zyx to quaternion") == 1


def test_run_writes_where_it_is_told(freebody, tmp_path):
    path = shipped_model("heavy_top")
    status, _, _ = freebody("run", path, "-o", "a/b.csv", "--plot", "c/d.svg")
    assert status == 0
    assert (tmp_path / "a/b.csv").read_text().startswith("time [s],")
    assert (tmp_path / "c/d.svg").exists()


@pytest.mark.parametrize("options", [("-o", "x.mat"), ("--plot", "x.gif")])
def test_an_unknown_suffix_is_refused_before_the_run(freebody, tmp_path, options):
    status, out, err = freebody("run", "toutatis", *options)
    assert (status, out) == (2, "")
    assert "suffix" in err
    assert list(tmp_path.rglob("*.*")) == []


def test_a_run_that_ends_early_keeps_its_data(freebody, tmp_path):
    text = shipped_model("heavy_top").read_text()
    (tmp_path / "short.toml").write_text(text.replace("[simulation]", "[simulation]\nmax_steps = 10"))
    status, out, err = freebody("run", "short.toml")
    assert status == 1
    assert "ended early" in err
    assert "out/short/short.nc" in out
    with xr.open_dataset(tmp_path / "out/short/short.nc", engine="h5netcdf") as stored:
        assert 0 < stored["time"].size < 501
        assert stored.attrs["outcome"] == "step_limit"


@pytest.mark.parametrize(("save", "written"), [("save_at = [2.0]", []), ("save_every = 1.0", ["short.nc"])])
def test_a_run_that_ends_at_once_is_told_too(freebody, tmp_path, save, written):
    text = shipped_model("heavy_top").read_text().replace('save_every = "5 ms"', save)
    (tmp_path / "short.toml").write_text(text.replace("[simulation]", "[simulation]\nmax_steps = 1"))
    status, _, err = freebody("run", "short.toml")
    assert status == 1
    assert "ended early" in err
    assert [path.name for path in (tmp_path / "out/short").iterdir()] == written


@pytest.mark.parametrize("command", ["run", "check"])
def test_a_bad_file_is_one_message(freebody, tmp_path, command):
    (tmp_path / "bad.toml").write_text(shipped_model("toutatis").read_text().replace("mass", "mas"))
    status, out, err = freebody(command, "bad.toml")
    assert (status, out) == (2, "")
    assert err.startswith("error: bad.toml:13: body.mas: unknown key; did you mean 'mass'?")
    assert "Traceback" not in err


def test_an_unknown_name_tells_the_known_ones(freebody):
    status, _, err = freebody("check", "toutatus")
    assert status == 2
    assert all(name in err for name in shipped_names())


def test_a_folder_that_cannot_be_made_is_one_message(freebody, tmp_path):
    (tmp_path / "out").write_text("a file")
    status, _, err = freebody("run", "heavy_top")
    assert status == 2
    assert err.startswith("error: ")


def test_check_says_what_the_file_describes(freebody):
    status, out, _ = freebody("check", "jeod_9a")
    assert status == 0
    for part in (
        "ISS-like body: 400000 kg",
        "(-3, -1.5, 4) m",
        "Earth (PointMassGravity)",
        "0 s to 8 h",
        "is valid",
    ):
        assert part in out


def test_verify_prints_a_table(freebody):
    status, out, _ = freebody("verify", "--only", "nesc_02")
    assert status == 0
    assert out.splitlines()[0].split() == [
        "case",
        "quantity",
        "largest",
        "residual",
        "allowed",
        "unit",
        "pass",
    ]
    assert "NESC 2" in out


def test_verify_prints_json(freebody):
    status, out, _ = freebody("verify", "--only", "nesc_02", "--json")
    lines = json.loads(out)
    assert status == 0
    assert len(lines) == 4
    for line in lines:
        assert set(line) == {"case", "quantity", "residual", "allowed", "unit", "passed"}
        assert line["passed"] is (line["residual"] <= line["allowed"]) is True


@pytest.mark.parametrize("residual", [2.0, float("nan")])
def test_verify_fails_by_its_exit_status(freebody, monkeypatch, residual):
    def wrong():
        yield Residual("wrong", "number", residual, 1.0, "m")

    monkeypatch.setitem(verify.CASES, "wrong", verify.Case(wrong))
    status, out, _ = freebody("verify", "--only", "wrong")
    assert status == 1
    assert "NO" in out


def test_verify_refuses_an_unknown_case(freebody):
    status, _, err = freebody("verify", "--only", "nothing")
    assert status == 2
    assert "jeod_9a" in err


def test_version_is_the_packages(freebody):
    assert freebody("--version")[:2] == (0, f"freebody {version('freebody')}\n")


@pytest.mark.parametrize(
    ("terminal", "patience", "shown"), [(True, 0.0, True), (True, 60.0, False), (False, 0.0, False)]
)
def test_a_bar_only_on_a_terminal_and_only_for_long_runs(monkeypatch, terminal, patience, shown):
    monkeypatch.setattr(progress, "PATIENCE", patience)
    screen = io.StringIO()
    with progress.LongRunProgress(Console(file=screen, force_terminal=terminal)) as bar:
        bar.update(0.5)
    assert ("simulating" in screen.getvalue()) is shown


def test_equations_prints_latex(freebody):
    status, out, _ = freebody("equations", "heavy_top", "--form", "2.10", "--angles", "zxz")
    assert status == 0
    assert out.startswith("\\begin{align*}\n")
    assert out.count("&=") == 6


@pytest.mark.parametrize(
    ("language", "text"),
    [("c", "void f_3_2("), ("numpy", "import numpy as np"), ("casadi", "import casadi as ca")],
)
def test_equations_writes_code_where_it_is_told(freebody, tmp_path, language, text):
    status, out, err = freebody("equations", "heavy_top", f"--{language}", "--output", "code/rate.txt")
    assert (status, out) == (0, "")
    assert "code/rate.txt" in err
    assert text in (tmp_path / "code/rate.txt").read_text()


def test_equations_refuses_two_languages(freebody):
    status, _, err = freebody("equations", "heavy_top", "--c", "--jax")
    assert status == 2
    assert "--c, --jax: these came together; give one of them" in err
