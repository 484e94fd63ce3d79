"""Runs: each is what it is alone, ends as it does, and is labelled."""

import json
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.ensembles.layout import variables
from freebody.simulation import checked_settings

from .scene import BODY, everything, model, state

SPAN = (0.0, 2.0)


@pytest.mark.parametrize("attitude", ["quaternion", "zyx"])
@pytest.mark.parametrize("form", ["quasi_velocity", "generalized"])
def test_a_run_is_the_trajectory_that_it_is_alone(attitude: str, form: Any):
    ensemble = everything(20, attitude=attitude, form=form)
    runs = ensemble.run(SPAN, rtol=1e-10, save_every=0.5)
    assert runs.samples is not None
    for r in (0, 7, 19):
        alone = runs.trajectory(r)
        assert alone.ok
        if (attitude, form) == ("quaternion", "quasi_velocity"):
            assert (alone.x == runs.samples[r]).all()
            assert (alone.outcome.state == runs.final[r]).all()
        else:
            # Ensembles run in quaternions and quasi-velocities: both errors are of the tolerance, which
            # angle rates next to the singularity multiply.
            np.testing.assert_allclose(alone.x, runs.samples[r], rtol=1e-6, atol=1e-6)


def test_samples_and_final_states_are_where_they_were_asked_for():
    runs = everything(10).run(SPAN, save_at=[0.0, 0.3, 2.0])
    assert runs.t is not None
    assert runs.samples is not None
    assert runs.t.tolist() == [0.0, 0.3, 2.0]
    assert (runs.samples[:, 0] == runs.ensemble.sample().x0).all()
    # The last sample is read off the last step, the final state is its end.
    np.testing.assert_allclose(runs.samples[:, -1], runs.final, rtol=1e-14, atol=1e-14)
    assert (runs.end_time == 2.0).all()
    without = everything(10).run(SPAN)
    assert without.samples is None
    assert (without.final == runs.final).all()


def test_any_part_of_an_ensemble_is_the_same_part():
    """Chunks, threads and neighbours do not matter, to the last bit."""
    ensemble = everything(50)
    runs = ensemble.run(SPAN, save_at=[1.0], threads=1)
    for first, count, threads in ((0, 50, 2), (13, 1, 1), (30, 20, 2)):
        part = ensemble.chunk(first, count, runs.settings, threads=threads)
        for name, values in part.items():
            np.testing.assert_array_equal(values, runs.chunk[name][first : first + count], name)


def test_a_run_that_ends_badly_is_a_row_with_its_outcome():
    @fb.force(parameters={"depth": (10.0, "m")})
    def bottom(s, p):
        """No number behind a depth."""
        return fb.wrench(force=np.stack([1e-3 * np.sqrt(p.depth + s.position_world[0]), 0.0, 0.0]))

    base = fb.Model(BODY, [bottom])
    x0 = base.state([5.0, 0.0, 0.0], velocity_body=[-1.0, 0.0, 0.0])
    ensemble = base.ensemble(x0, {"bottom.depth": fb.Discrete([-6.0, -4.5, 10.0])}, n=60, seed=1)
    runs = ensemble.run(SPAN)
    depth = runs.dispersed[:, 0]
    ended = {-6.0: "non_finite", -4.5: "step_too_small", 10.0: "reached_end"}
    assert runs.status.tolist() == [ended[d] for d in depth.tolist()]
    assert set(depth.tolist()) == set(ended)
    assert (runs.ok == (depth > 0.0)).all()
    assert (runs.chunk["culprit"] == np.where(depth == -6.0, 0, -1)).all()
    assert (runs.end_time[depth == -6.0] == 0.0).all()
    assert (runs.end_time[depth == -4.5] < 1.0).all()
    counts = [(runs.status == word).sum() for word in ("reached_end", "step_too_small", "non_finite")]
    assert repr(runs) == "<Runs of 'model': {} reached_end, {} step_too_small, {} non_finite>".format(*counts)
    short = ensemble.run(SPAN, max_steps=1)
    assert set(short.status[depth == 10.0]) == {"step_limit"}


def test_wrong_settings_are_refused_before_a_run():
    ensemble = everything(3)
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"t_span": (1.0, 0.0)}, "t_span: got (1.0, 0.0) s"),
        ({"method": "euler"}, "method: got 'euler'"),
        ({"method": "rk4"}, "step: rk4 has a fixed step"),
        ({"rtol": 2.0}, "rtol: got 2.0"),
        ({"save_at": [3.0]}, "save_at: the times must rise and lie within the span"),
        ({"threads": 0}, "threads: got 0; give a whole number"),
        ({"progress": 3}, "progress: got 3; give a function of the part done"),
    ]
    for given, message in wrong:
        arguments: dict[str, Any] = {"t_span": SPAN, **given}
        with pytest.raises(fb.InputError) as caught:
            ensemble.run(**arguments)
        assert message in str(caught.value)


def test_progress_is_told_and_an_interruption_ends_it():
    told: list[float] = []
    ensemble = everything(2000)
    ensemble.run((0.0, 5.0), progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0

    def interrupt(_: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ensemble.run((0.0, 50.0), progress=interrupt)


def test_everything_is_labelled():
    ensemble = everything(20)
    runs = ensemble.run(SPAN, save_every=1.0)
    data = runs.to_xarray()
    assert data.sizes == {"run": 20, "state": 14, "quantity": len(ensemble.names), "time": 3}
    assert (data["final_state"].sel(state="position_z").values == runs.final[:, 2]).all()
    assert (
        data["dispersed"].sel(quantity="mass").values == runs.dispersed[:, runs.names.index("mass")]
    ).all()
    assert data["state_unit"].sel(state="velocity_x").item() == "m/s"
    assert data["quantity_unit"].sel(quantity="fin.slope").item() == "N s/m"
    assert data["nominal"].sel(quantity="mass").item() == 12.5
    factor = data["quantity_factor"]
    assert factor.sel(quantity="damper.gain").item() == -1
    assert factor.sel(quantity="moon.center_x") == factor.sel(quantity="moon.center_z")
    assert factor.sel(quantity="com_x") != factor.sel(quantity="com_y")
    assert data["time"].attrs["units"] == "s"
    meanings = data["outcome"].attrs["flag_meanings"].split()
    assert meanings[int(data["outcome"][0])] == "reached_end"
    described = json.loads(data.attrs["model"])
    assert described["body"]["mass"] == 12.5
    assert described["forces"][2] == {"kind": "ForceLaw", "name": "fin", "slope": 5.0, "lag": 0.2}
    assert json.loads(data.attrs["dispersions"])["inertia"] == "Uniform(low=0.9, high=1.1)"
    assert data.attrs["seed"] == "7"


def test_the_layout_is_what_comes():
    """Names, dimensions and types are known before a run: stores are made by them."""
    ensemble = everything(5)
    runs = ensemble.run(SPAN, save_at=[1.0, 2.0])
    sizes = {"run": 5, "state": 14, "quantity": len(ensemble.names), "time": 2}
    known = variables(ensemble, runs.settings)
    assert known.keys() == runs.chunk.keys()
    for name, variable in known.items():
        assert runs.chunk[name].dtype == variable.dtype, name
        assert runs.chunk[name].shape == tuple(sizes[d] for d in variable.dims), name


def test_the_number_of_a_run_repeats_it_alone():
    """Run 71 234 of a campaign, without those before it."""
    base = model()
    given = {"mass": fb.Uniform(11.0, 14.0), "velocity_body": fb.Offset(fb.Normal(0.0, 1.0))}
    alone = base.ensemble(state(base), given, n=100_000, seed=7).trajectory(71_234, SPAN)
    again = base.ensemble(state(base), given, n=71_235, seed=7)
    part = again.chunk(71_230, 5, checked_settings(SPAN))
    assert (part["final_state"][4] == alone.outcome.state).all()
