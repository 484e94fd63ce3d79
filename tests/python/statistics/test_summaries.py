"""The tables of a set of runs say what the functions say, and what was left out."""

import csv

import numpy as np
import pytest

from freebody import statistics
from python.statistics.samples import EVENT, NON_FINITE, NOT_RUN, ended, runs
from python.statistics.test_sensitivity import saltelli_runs


def titles(tables):
    return {table.title: table for table in tables}


@pytest.fixture(scope="module")
def data():
    made = ended(runs(1000), NON_FINITE, *range(10))
    made["outcome"][[20, 21]] = EVENT
    return made


@pytest.fixture(scope="module")
def tables(data):
    return titles(statistics.summary(data))


def test_every_table_is_there(tables):
    assert list(tables) == [
        "How the runs ended",
        "Events",
        "Mean and spread",
        "What was dispersed",
        "Quantiles",
        "Tolerance bounds",
        "Covariances",
        "Correlations",
        "Sensitivity of output:miss: correlations",
        "Sensitivity of output:drift: correlations",
        "Sensitivity of event:crossing: correlations",
    ]


def test_runs_that_ended_badly_are_counted(tables):
    endings = tables["How the runs ended"]
    assert {row["outcome"]: row["runs"] for row in endings.to_rows()} == {
        "reached_end": 988,
        "event": 2,
        "non_finite": 10,
    }
    assert "10 of 1000 runs ended badly; they are left out of every other table" in endings.notes
    assert {row["runs"] for row in tables["Mean and spread"].to_rows()} == {990, occurrences(tables)}


def occurrences(tables):
    (event,) = tables["Events"].to_rows()
    return event["runs"]


def test_the_numbers_are_those_of_the_functions(data, tables):
    kept = data["outputs"].values[10:]
    spread = {row["column"]: row for row in tables["Mean and spread"].to_rows()}
    drift = spread["output:drift"]
    np.testing.assert_allclose(drift["mean"], kept[:, 1].mean(), rtol=1e-12)  # another order of the sum
    np.testing.assert_allclose(drift["sd"], kept[:, 1].std(ddof=1), rtol=1e-12)
    assert (drift["least"], drift["greatest"]) == (kept[:, 1].min(), kept[:, 1].max())
    quantiles = [row for row in tables["Quantiles"].to_rows() if row["column"] == "output:miss"]
    for row in quantiles:
        expected = statistics.quantile_interval(kept[:, 0], row["probability"])
        assert row["quantile"] == expected.value
        assert row["high"] == (expected.high if np.isfinite(expected.high) else None)
    bounds = tables["Tolerance bounds"].to_rows()[0]
    assert (bounds["above"], bounds["below"]) == statistics.tolerance_bounds(kept[:, 0], 0.9973, 0.90)


def test_matrices_are_those_of_the_moments(data, tables):
    found = statistics.moments(data, ["output:miss", "output:drift", "event:crossing"])
    for title, matrix in (("Covariances", found.covariance), ("Correlations", found.correlation)):
        shown = [list(row)[1:] for row in tables[title].rows]
        assert np.array_equal(shown, matrix)
        assert tables[title].notes == (f"{found.missing} runs without a value in some column are left out",)


def test_too_few_runs_are_said():
    table = statistics.tolerances(runs(100), ["drift"])
    assert table.to_rows()[0]["above"] is None
    assert "such a bound needs 852 runs" in table.notes
    assert "–" in str(table)


@pytest.mark.parametrize(
    ("sampling", "word"),
    [("latin_hypercube", "better"), ("sobol", "nothing guarantees"), ("saltelli", "A and B")],
)
def test_intervals_that_are_not_for_these_runs_say_so(sampling, word):
    notes = statistics.endings(runs(12).assign_attrs(sampling=sampling)).notes
    assert any(word in note for note in notes)
    assert not any(word in note for note in statistics.endings(runs(12)).notes)


def test_runs_for_sobol_indices_have_their_table():
    tables = titles(statistics.summary(saltelli_runs()))
    rows = tables["Sensitivity of output:y: Sobol indices"].to_rows()
    assert [row["factor"] for row in rows] == ["x1", "x2", "x3"]
    assert {row["runs"] for row in tables["Mean and spread"].to_rows()} == {4096}


def test_a_summary_is_of_what_is_asked_for(data):
    tables = titles(statistics.summary(data, ["drift"]))
    assert "Correlations" not in tables
    assert {row["column"] for row in tables["Quantiles"].to_rows()} == {"output:drift"}


@pytest.mark.parametrize("outcome", [NON_FINITE, NOT_RUN])
def test_runs_of_which_none_ended_well_can_be_summed_up(outcome):
    none = ended(runs(5), outcome, *range(5))
    assert "Quantiles" not in titles(statistics.summary(none))


def test_one_run_can_be_summed_up():
    tables = titles(statistics.summary(runs(1)))
    assert tables["Mean and spread"].to_rows()[0]["sd"] is None


def test_blocks_are_read_one_after_another(data, monkeypatch):
    """The tables do not depend on how much is read at once."""
    whole = [table.to_rows() for table in statistics.summary(data)]
    monkeypatch.setattr("freebody.statistics.summaries._GATHERED", 1)
    assert [table.to_rows() for table in statistics.summary(data)] == whole


def test_a_table_reads_well_without_rich():
    table = statistics.ResultTable(
        "Heights", ("name", "height"), (("a", 1.23456789), ("long name", None)), ("all in m",)
    )
    assert str(table).splitlines() == [
        "Heights",
        "name        height",
        "------------------",
        "a          1.23457",
        "long name        –",
        "all in m",
    ]


def test_a_table_is_stored_in_full(tmp_path):
    table = statistics.ResultTable("Heights", ("name", "height"), (("a, b", 0.1 + 0.2), ("c", None)))
    table.save(tmp_path / "heights.csv")
    with (tmp_path / "heights.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert rows == [{"name": "a, b", "height": "0.30000000000000004"}, {"name": "c", "height": ""}]
