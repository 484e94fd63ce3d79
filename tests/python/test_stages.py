"""Runs in stages: the body is exchanged, its motion goes on."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.tracing.notice_law import notice

UPPER = fb.RigidBody(4.0, (0.6, 0.02, -0.01), inertia_about_com=np.diag([0.5, 0.9, 1.0]), name="upper")
LOWER = fb.RigidBody(10.0, (-0.9, 0.0, 0.03), inertia_about_com=np.diag([1.0, 3.0, 3.5]), name="lower")
GRAVITY = fb.UniformGravity(9.81)
TURN = fb.Attitude.angles("zyx", [0.4, -0.7, 1.1]).as_rotation()
ORIGIN = np.array([0.5, 0.1, -0.2])


@fb.event(direction="rising", parameters={"depth": (3.0, "m")})
def low(s: Any, p: Any) -> Any:
    return s.position_world[2] - p.depth


@fb.event(direction="rising")
def deep(s: Any) -> Any:
    return s.position_world[2] - 2.0


@fb.force(states={"fuel": (5.0, "kg")}, parameters={"flow": (0.5, "kg/s")})
def tank(s: Any, p: Any) -> Any:
    return fb.wrench(force=np.stack([20.0, 0.0, 0.0])), {"fuel": -p.flow}


def whole(attitude: str = "zyx") -> fb.Model:
    return fb.Model(UPPER + LOWER, [GRAVITY], attitude, name="whole")


def start(model: fb.Model) -> Any:
    return model.state(velocity_body=(3.0, 0.0, -1.0), angular_velocity_body=(0.1, 0.3, 0.2))


def test_momentum_is_shared_out_at_a_separation() -> None:
    model = whole()
    runs = []
    for part in (UPPER, LOWER):
        stages = [fb.Stage(model, until=low), fb.Stage(fb.Model(part, [GRAVITY]))]
        runs.append(fb.simulate_stages(stages, start(model), (0.0, 3.0), rtol=1e-12))
    before = runs[0].stages[0].momentum_world[-1]
    after = sum(run.stages[1].momentum_world[0] for run in runs)
    # Roundings alone: the state goes through a rotation matrix.
    np.testing.assert_allclose(after, before, rtol=1e-13, atol=1e-12)
    for run in runs:
        (separation,) = run.separations
        assert separation.time == run.events[0].time == run.stages[0].t[-1] == run.stages[1].t[0]
        assert np.array_equal(separation.before, run.stages[0].x[-1])
        assert np.array_equal(separation.after, run.stages[1].x[0])
        assert run.outcome.status == "reached_end"
        assert run.outcome.message.startswith("stage 2 of 2 ('model'): reached the end")


@pytest.mark.parametrize("attitude", ["quaternion", "zyx", "zxz"])
def test_a_frame_of_its_own_changes_no_motion(attitude: str) -> None:
    model = whole()
    plain = fb.Model(UPPER, [GRAVITY], attitude)
    moved = fb.Model(UPPER.in_frame(ORIGIN, TURN), [GRAVITY], attitude)
    push, spin = np.array([0.5, -0.2, 0.1]), np.array([0.05, 0.02, -0.03])
    in_frame: dict[str, Any] = {
        "velocity_increment": TURN.T @ (push + np.cross(spin, ORIGIN)),
        "angular_velocity_increment": TURN.T @ spin,
    }
    ways = [
        fb.Stage(plain, velocity_increment=push, angular_velocity_increment=spin),
        fb.Stage(moved, origin=ORIGIN, rotation=TURN, **in_frame),
    ]
    one, other = (
        fb.simulate_stages([fb.Stage(model, until=0.8), way], start(model), (0.0, 2.0), save_every=0.25)
        for way in ways
    )
    assert np.array_equal(one.t, other.t)
    # Tolerance 1e-9 a step.
    np.testing.assert_allclose(other.com_position_world, one.com_position_world, atol=1e-8)
    np.testing.assert_allclose(
        other.stages[1].angular_velocity_world, one.stages[1].angular_velocity_world, atol=1e-8
    )
    jump = one.com_velocity_world[one.t == 0.8]
    assert np.linalg.norm(jump[1] - jump[0]) > 0.1


def test_states_go_on_by_their_names() -> None:
    first = fb.Model(UPPER + LOWER, [GRAVITY, tank], name="first")
    second = fb.Model(UPPER, [tank, tank(name="other")])
    third = fb.Model(UPPER, [tank(name="other")])
    stages = [
        fb.Stage(first, until=1.0),
        fb.Stage(second, until=2.0),
        fb.Stage(third, states={"other.fuel": 9.0}),
    ]
    progress: list[float] = []
    run = fb.simulate_stages(
        stages, first.state(), (0.0, 3.0), save_at=[0.5, 1.0, 1.5], progress=progress.append
    )
    assert run.t.tolist() == [0.0, 0.5, 1.0, 1.0, 1.5, 2.0, 2.0, 3.0]
    ends = [stage.states for stage in run.stages]
    assert ends[1]["tank.fuel"].tolist() == pytest.approx([4.5, 4.25, 4.0])
    assert ends[1]["other.fuel"].tolist() == pytest.approx([5.0, 4.75, 4.5])
    assert ends[2]["other.fuel"].tolist() == pytest.approx([9.0, 8.5])
    assert len(run) == 8
    assert run.mass.tolist() == [14.0] * 3 + [4.0] * 5
    assert run.steps == sum(stage.steps for stage in run.stages)
    assert progress == sorted(progress)


def test_how_runs_in_stages_end() -> None:
    model = whole()
    last = fb.Stage(model, until=low(depth=8.0))
    run = fb.simulate_stages([fb.Stage(model, until=low), last], start(model), (0.0, 9.0), save_every=0.5)
    assert (run.outcome.status, run.outcome.event, len(run.stages)) == ("event", "low", 2)
    assert run.ok
    assert run.position_world[-1, 2] == pytest.approx(8.0)
    # Another event ends all; the time may be over sooner; a stage may be over before it begins.
    run = fb.simulate_stages([fb.Stage(model, until=low, events=[deep]), last], start(model), (0.0, 9.0))
    assert (run.outcome.event, len(run.stages), run.separations) == ("deep", 1, ())
    run = fb.simulate_stages([fb.Stage(model, until=low), last], start(model), (0.0, 0.1))
    assert (run.outcome.status, len(run.stages)) == ("reached_end", 1)
    assert "stage 1 of 2" in run.outcome.message
    late = [fb.Stage(model, until=low), fb.Stage(model, until=0.2), fb.Stage(model)]
    run = fb.simulate_stages(late, start(model), (0.0, 2.0), save_every=0.5)
    assert (len(run.stages), len(run.separations)) == (2, 2)
    run = fb.simulate_stages(
        [fb.Stage(model, until=0.5), fb.Stage(model)], start(model), (0.0, 2.0), max_steps=3
    )
    assert run.outcome.status == "step_limit"
    assert not run.ok


def test_what_any_stage_has_to_say_is_said() -> None:
    @fb.force
    def wing(s: Any) -> Any:
        return fb.wrench()

    wing.notices = (
        notice("deeper than it may be", lambda s: s.position_world[0] + 2.0 - s.position_world[2]),
    )
    deep_one = fb.Model(UPPER + LOWER, [GRAVITY, wing], name="whole")
    stages = [fb.Stage(deep_one, until=low), fb.Stage(fb.Model(UPPER, [GRAVITY]))]
    run = fb.simulate_stages(stages, deep_one.state(), (0.0, 2.0))
    assert [n.message for n in run.outcome.notices] == ["deeper than it may be"]
    assert run.outcome.message.endswith("deeper than it may be")


def test_runs_of_ensembles_go_in_stages_one_by_one() -> None:
    """The draws of a quantity that both models have are the same if all dispersions are."""
    models = [whole("quaternion"), fb.Model(UPPER, [GRAVITY])]
    spread = {"angular_velocity_body": fb.Offset(fb.Normal([0.0] * 3, [0.1] * 3))}
    first, second = (m.ensemble(start(m), spread, n=4, seed=2) for m in models)

    def flown(r: int) -> Any:
        stages = [fb.Stage(first.model(r), until=0.5), fb.Stage(second.model(r))]
        return fb.simulate_stages(stages, first.initial_state(r), (0.0, 1.0)).outcome.state

    ends = np.array([flown(r) for r in range(4)])
    assert np.array_equal(ends[2], flown(2))
    assert len(np.unique(ends[:, 12])) == 4


def test_wrong_stages_are_refused() -> None:
    model = whole()
    x0 = start(model)

    @fb.event(terminal=False)
    def passing(s: Any) -> Any:
        return s.time - 1.0 * s.time

    def refused(match: str, stages: Any, **options: Any) -> None:
        with pytest.raises(fb.InputError, match=match):
            fb.simulate_stages(stages, x0, (0.0, 1.0), **options)

    with pytest.raises(fb.InputError, match="until: 'passing' is an event that ends nothing"):
        fb.Stage(model, until=passing)
    with pytest.raises(fb.InputError, match="model: got 3"):
        fb.Stage(3)  # type: ignore[arg-type]
    for given, match in (
        ({"events": 3}, "events: got 3; give a list of events"),
        ({"outputs": "mass"}, "outputs: got 'm'; give a list of outputs"),
        ({"states": 3}, "states: got 3; give values by name"),
    ):
        with pytest.raises(fb.InputError, match=match):
            fb.Stage(model, **given)  # type: ignore[arg-type]
    refused("stages: got", [])
    refused(r"stages\[0\]: nothing ends it", [fb.Stage(model), fb.Stage(model)])
    refused("times must rise", [fb.Stage(model, until=0.5), fb.Stage(model, until=0.4)])
    refused(r"stages\[0\]: a frame, an increment or states", [fb.Stage(model, velocity_increment=(1, 0, 0))])
    refused("inputs: no option of runs in stages", [fb.Stage(model)], inputs=[1.0] * 6)
    refused("where all stages have ended", [fb.Stage(model, until=-1.0)])
