"""Events and outputs of ensembles: those of the runs alone, to the last bit."""

import numpy as np
import pytest

import freebody as fb

from .scene import BODY


@fb.event(direction="rising")
def ground(s):
    return s.position_world[2]


@fb.event(terminal=False)
def level(s):
    return s.world_from_body[2, 0]


@fb.output(unit="m")
def downrange(s):
    return s.position_world[0]


@fb.output(take="max")
def fastest(s):
    return s.velocity_body @ s.velocity_body


def thrown(attitude: str = "quaternion") -> fb.Ensemble:
    """Bodies thrown up, tumbling; some come down in time."""
    model = fb.Model(BODY, [fb.UniformGravity(), fb.LinearDamping([0.1] * 6)], attitude)
    x0 = model.state(velocity_body=[5.0, 0.0, -4.0], angular_velocity_body=[0.3, 2.0, 0.1])
    return model.ensemble(
        x0,
        {"velocity_world": fb.Offset(fb.Normal(0.0, [1.0, 0.5, 1.5])), "mass": fb.Uniform(10.0, 15.0)},
        n=60,
        seed=3,
        events=[ground, level],
        outputs=[downrange, fastest],
    )


@pytest.mark.parametrize("attitude", ["quaternion", "zyx"])
def test_events_and_outputs_are_those_of_the_runs_alone(attitude: str):
    ensemble = thrown(attitude)
    runs = ensemble.run((0.0, 1.0))
    assert set(runs.status) == {"reached_end", "event"}
    assert runs.ok.all()
    for r in range(0, 60, 7):
        alone = runs.trajectory(r)
        assert alone.outcome.status == runs.status[r]
        # In a chart of its own a run alone takes its own steps, to the same tolerance.
        near = 0.0 if attitude == "quaternion" else 1e-7
        np.testing.assert_allclose(runs.end_time[r], alone.outcome.time, rtol=near)
        for name, values in runs.outputs.items():
            np.testing.assert_allclose(values[r], alone.outputs[name], rtol=near)
        for e, event in enumerate(ensemble.events):
            came = [o for o in alone.events if o.name == event.name]
            assert runs.chunk["event_count"][r, e] == len(came)
            first = came[0].time if came else np.nan
            np.testing.assert_allclose(runs.event_times[event.name][r], first, rtol=near)
            seen = runs.chunk["event_state"][r, e]
            if not came:
                assert np.isnan(seen).all()
                continue
            # The same motion may have the other triple of angles.
            for a, b in zip(*(ensemble.model(r).motion(x[None]) for x in (seen, came[0].state)), strict=True):
                np.testing.assert_allclose(a, b, rtol=near, atol=near)


def test_runs_that_an_event_ended_end_there():
    runs = thrown().run((0.0, 1.0), save_every=0.25)
    down = runs.status == "event"
    assert (runs.chunk["stopped_by"] == np.where(down, 0, -1)).all()
    assert (runs.end_time[down] == runs.event_times["ground"][down]).all()
    assert (runs.final[down] == runs.chunk["event_state"][down, 0]).all()
    assert np.isnan(runs.event_times["ground"][~down]).all()
    assert runs.samples is not None
    assert runs.t is not None
    ended = runs.t[None] > runs.end_time[:, None]
    assert np.isnan(runs.samples[ended]).all()
    assert np.isfinite(runs.samples[~ended]).all()


def test_events_and_outputs_are_labelled():
    data = thrown().run((0.0, 1.0)).to_xarray()
    assert data["outputs"].sel(output="downrange").dims == ("run",)
    assert data["output_unit"].sel(output="downrange").item() == "m"
    assert data["event_time"].sel(event="level").attrs["units"] == "s"
    assert data["event_state"].dims == ("run", "event", "state")
