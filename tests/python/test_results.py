"""Stored runs: what goes in comes out, with its units."""

import csv

import numpy as np
import pytest
import xarray as xr

import freebody as fb
from freebody import results
from freebody.errors import InputError
from freebody.model_file import load_model, shipped_model


@pytest.fixture(scope="module")
def run():
    return load_model(shipped_model("heavy_top")).simulate()


@pytest.fixture(scope="module")
def dataset(run):
    return results.to_dataset(
        run, points={"rim": [0.5, -0.2, 2.0]}, attributes={"title": "top", "model_file": "text"}
    )


def test_the_dataset_is_the_run(run, dataset):
    assert np.array_equal(dataset["time"], run.t)
    for name in ("position_world", "velocity_body", "quaternion", "angular_velocity_world", "energy"):
        assert np.array_equal(dataset[name], getattr(run, name))
    assert np.array_equal(dataset["angles"], run.angles("zxz"), equal_nan=True)
    assert np.array_equal(dataset["point_rim"], run.point([0.5, -0.2, 2.0]))
    assert np.array_equal(dataset["linear_momentum_world"], run.momentum_world[:, :3])
    assert dataset.attrs["outcome"] == run.outcome.status


def test_every_variable_has_unit_and_meaning(dataset):
    for name, variable in dataset.data_vars.items():
        assert variable.attrs["units"], name
        assert variable.attrs["long_name"], name


def test_a_mass_centre_that_moves_in_the_body_is_stored(run):
    @fb.contents(inputs={"fuel": "kg"})
    def tank(s):
        return fb.mass_properties(mass=s.inputs.fuel, com=[0.0, 0.0, 1.0], inertia_about_com=np.zeros(3))

    @fb.force(states={"fuel": (10.0, "kg")}, publishes=("fuel",), contents=(tank,))
    def engine(s):
        return fb.wrench(), {"fuel": -1.0 + 0.0 * s.states.fuel}

    model = fb.Model(fb.RigidBody(5.0, inertia_about_com=np.eye(3)), [engine])
    burning = results.to_dataset(model.simulate(model.state(), (0.0, 5.0), save_every=5.0))
    np.testing.assert_allclose(burning["mass"], [15.0, 10.0])
    np.testing.assert_allclose(burning["com"].sel(axis="z"), [10.0 / 15.0, 0.5])
    assert "com" not in results.to_dataset(run)


def test_netcdf_gives_back_what_it_took(dataset, tmp_path):
    path = tmp_path / "run.nc"
    results.save(dataset, path)
    with xr.open_dataset(path, engine="h5netcdf") as stored:
        assert stored.identical(dataset)


def test_csv_gives_back_what_it_took(run, dataset, tmp_path):
    path = tmp_path / "run.csv"
    results.save(dataset, path)
    with path.open() as stream:
        headings, *rows = csv.reader(stream)
    columns = dict(zip(headings, np.array(rows, dtype=float).T, strict=True))
    # 17 digits: the very same doubles
    assert np.array_equal(columns["time [s]"], run.t)
    assert np.array_equal(columns["velocity_world_y [m s-1]"], run.velocity_world[:, 1])
    assert np.array_equal(columns["angles_2_x [rad]"], run.angles("zxz")[:, 1], equal_nan=True)
    assert np.array_equal(columns["energy [J]"], run.energy)


def test_a_broken_write_leaves_the_old_file(dataset, tmp_path, monkeypatch):
    def writes_half(dataset, path):
        path.write_text("half")
        raise OSError("disk full")

    path = tmp_path / "run.nc"
    path.write_text("old")
    monkeypatch.setitem(results.WRITERS, ".nc", writes_half)
    with pytest.raises(OSError, match="disk full"):
        results.save(dataset, path)
    assert [p.name for p in tmp_path.iterdir()] == ["run.nc"]
    assert path.read_text() == "old"


def test_an_unknown_suffix_is_refused(dataset, tmp_path):
    with pytest.raises(InputError, match=r"\.nc or \.csv; came '\.mat'"):
        results.save(dataset, tmp_path / "run.mat")
