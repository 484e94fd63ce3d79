"""`freebody statistics` prints the tables of stored runs and draws them."""

import csv
import warnings

import pytest

from freebody import statistics
from python.statistics.samples import NON_FINITE, NOT_RUN, ended, runs
from python.statistics.test_sensitivity import saltelli_runs


def words(text):
    return " ".join(text.split())


@pytest.fixture
def stored(tmp_path):
    data = ended(ended(runs(500), NON_FINITE, 7), NOT_RUN, 498, 499)
    data.to_netcdf(tmp_path / "runs.nc", engine="h5netcdf")
    with warnings.catch_warnings():  # the store of a campaign has no such labels; xarray's own way warns
        warnings.simplefilter("ignore")
        data.to_zarr(tmp_path / "runs.zarr", zarr_format=3, consolidated=True)
    return data


@pytest.mark.parametrize("path", ["runs.nc", "runs.zarr"])
def test_it_prints_every_table(freebody, stored, path):
    status, out, err = freebody("statistics", path)
    assert status == 0
    assert "2 of 500 runs are not made yet" in err
    for table in statistics.summary(stored):
        assert table.title in out
        for line in (*table.lines(), *table.notes):
            assert line in out.splitlines()


def test_it_writes_tables_and_figures(freebody, stored, tmp_path):
    status, out, _ = freebody(
        "statistics", "runs.nc", "-c", "drift", "--scatter", "mass, drift", "-o", "found"
    )
    assert status == 0
    assert "tables and figures in found" in out
    assert {path.name for path in (tmp_path / "found").iterdir()} == {
        "how_the_runs_ended.csv",
        "events.csv",
        "mean_and_spread.csv",
        "what_was_dispersed.csv",
        "quantiles.csv",
        "tolerance_bounds.csv",
        "sensitivity_of_output_drift_correlations.csv",
        "histogram_output_drift.png",
        "sensitivity_output_drift.png",
        "correlations.png",
        "scatter_dispersed_mass_output_drift.png",
    }
    with (tmp_path / "found/quantiles.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    expected = statistics.quantiles(stored, ["drift"]).to_rows()
    assert [float(row["quantile"]) for row in rows] == [row["quantile"] for row in expected]


def test_runs_for_sobol_indices_show_them(freebody, tmp_path):
    saltelli_runs().to_netcdf(tmp_path / "runs.nc", engine="h5netcdf")
    _, out, _ = freebody("statistics", "runs.nc")
    assert "Sensitivity of output:y: Sobol indices" in out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("nowhere.zarr",), "nowhere.zarr: no store of runs is there"),
        (("runs.nc", "-c", "drif"), "the runs have no 'drif'; did you mean 'drift'?"),
        (
            ("runs.nc", "--scatter", "mass"),
            "--scatter: got 'mass'; give two columns, X,Y, and a folder with -o",
        ),
        (("runs.nc", "--confidence", "95"), "confidence: got 95.0; give a number between 0 and 1"),
    ],
)
def test_wrong_input_is_told_in_a_line(freebody, stored, arguments, message):
    status, _, err = freebody("statistics", *arguments)
    assert status == 2
    assert message in words(err)


def test_long_tables_are_printed_when_asked_for(freebody):
    freebody("ensemble", "falling_capsule", "-n", 40, "-o", "a.zarr")
    _, out, _ = freebody("statistics", "a.zarr")
    assert "sensitivities of 13 results are long" in words(out)
    assert "Sensitivity of" not in out
    assert "Covariances" not in out
    _, out, _ = freebody("statistics", "a.zarr", "-c", "position_x", "-c", "position_y")
    assert "Sensitivity of final:position_y" in out
    assert "Covariances" in out


def test_a_file_that_holds_no_runs_is_refused(freebody, stored, tmp_path):
    stored.drop_vars("outcome").to_netcdf(tmp_path / "other.nc", engine="h5netcdf")
    status, _, err = freebody("statistics", "other.nc")
    assert status == 2
    assert "other.nc: holds no runs of an ensemble" in err


def test_a_campaign_can_end_by_itself(freebody):
    rule = "position_z:mean:3"
    status, out, _ = freebody(
        "ensemble", "falling_capsule", "-n", 5000, "-o", "a.zarr", "--chunk", 250, "--until", rule
    )
    assert status == 0
    assert "Runs until the precision is met" in out
    status, out, _ = freebody("statistics", "a.zarr", "-c", "position_z")
    assert status == 0
    assert "final:position_z" in out
    assert "5000" not in out


def test_a_rule_that_is_none_is_told_before_the_runs(freebody, tmp_path):
    status, _, err = freebody(
        "ensemble", "falling_capsule", "-n", 5000, "-o", "a.zarr", "--until", "position_z"
    )
    assert status == 2
    assert "give column:statistic:half-width" in words(err)
    assert not (tmp_path / "a.zarr").exists()
