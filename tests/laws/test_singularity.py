"""Angles driven straight through their singularity: the run goes on, tells so, and stays right."""

import numpy as np
import pytest

import freebody as fb
from freebody.model import Form
from freebody.simulation import Method

from .scenes import BODY, FORMS, Array, motion_gap, relative

SEQUENCES = fb.forms.SEQUENCES
# rk4 has no tolerance: at this step its error over these seconds is below 1e-9.
METHODS = {"dp54": {}, "dop853": {}, "vern8": {}, "vern9": {}, "rk4": {"step": 0.01}}
RTOL = 1e-9
END = 9.0


def singular_angle(sequence: str) -> float:
    return 0.0 if sequence[0] == sequence[2] else 0.5 * np.pi


def steady(sequence: str, form: Form, chart: str | None = None) -> tuple[fb.Model, Array, Array]:
    """A body that turns about its second angle alone at 1 rad/s: model, start, and angles at the start."""
    axis = np.eye(3)["xyz".index(sequence[1])]
    # The axis of the greatest moment, so that the turn is steady; the body origin circles.
    moments = np.where(axis == 1.0, 1.5, [0.7, 1.1, 0.9])
    body = fb.RigidBody(12.5, [0.12, -0.05, 0.08], inertia_about_com=np.diag(moments))
    first = np.array([0.3, singular_angle(sequence) - 0.8, 0.0])
    model = fb.Model(body, [], chart or sequence, form)
    x0 = model.state(
        attitude=fb.Attitude.angles(sequence, first),
        velocity_body=-np.cross(axis, body.com),
        angular_velocity_body=axis,
    )
    return model, x0, first


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("sequence", SEQUENCES)
def test_straight_through(sequence: str, form: Form, method: Method) -> None:
    model, x0, first = steady(sequence, form)
    # The second angle is singular at 0.8 s and half a turn after; those moments are samples too.
    crossings = 0.8 + np.pi * np.arange(3)
    times = np.union1d(np.linspace(0.0, END, 901), crossings)
    settings = {"rtol": RTOL, "method": method, "save_at": times, **METHODS[method]}
    run = model.simulate(x0, (0.0, END), **settings)
    assert run.ok

    # A few hundred steps of 1e-9 at most.
    within = 1e-7
    expected = first + np.outer(run.t, [0.0, 1.0, 0.0])
    rotation = fb.forms.rotation(expected, sequence)
    assert np.abs(run.world_from_body - rotation).max() <= within
    assert np.abs(run.angular_velocity_body - run.angular_velocity_body[0]).max() <= within
    other, y0, _ = steady(sequence, form, "quaternion")
    assert motion_gap(run, other.simulate(y0, (0.0, END), **settings)) <= within

    # The second angle goes on straight, past a right angle and past whole turns; the first and the third
    # stay, and are known the worse the nearer their axes are to each other.
    distance = run.singularity_distance
    assert distance is not None
    assert np.abs(run.x[:, 4] - expected[:, 1]).max() <= within
    known = distance > 1e-3
    assert (np.abs(run.x[:, 3:6] - expected).max(axis=1)[known] <= within / distance[known]).all()
    assert known.sum() >= 900

    # It left and came back around every crossing, and around nothing else.
    changes = run.chart_changes
    assert [c.from_chart for c in changes] == [sequence, "quaternion"] * 3
    assert [c.to_chart for c in changes] == ["quaternion", sequence] * 3
    for crossing, left, back in zip(crossings, changes[::2], changes[1::2], strict=True):
        assert left.time < crossing < back.time
        for change in (left, back):
            travelled = abs(change.time - crossing)
            assert abs(change.distance - min(travelled, np.pi - travelled)) <= within


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("sequence", SEQUENCES)
def test_angles_go_on_through_near_misses(sequence: str, form: Form) -> None:
    """Tumbling at a loose tolerance, its steps long: no angle jumps further than its rate allows."""
    rng = np.random.default_rng(3)
    model = fb.Model(BODY, [], sequence, form)
    changes = 0
    for _ in range(6):
        attitude = fb.Attitude.angles("zyx", rng.uniform(-1.0, 1.0, 3))
        spin = rng.normal(size=3)
        x0 = model.state(attitude=attitude, angular_velocity_body=spin)
        run = model.simulate(x0, (0.0, 60.0), rtol=1e-4, save_every=0.01)
        assert run.ok
        # Each step may err by rtol, kinetic energy and spin by twice that.
        assert max(k.drift for k in run.conserved()) <= 2 * run.steps * 1e-4
        assert np.abs(fb.forms.rotation(run.x[:, 3:6], sequence) - run.world_from_body).max() <= 1e-14

        distance = run.singularity_distance
        assert distance is not None
        turned = 0.01 * 1.05 * np.linalg.norm(run.angular_velocity_body, axis=1).max()
        nearest = np.minimum(distance[1:], distance[:-1]) - turned
        jump = np.abs(np.diff(run.x[:, 3:6], axis=0)).max(axis=1)
        exist = nearest > 0.0
        # |α'| is at most |ω| / sin(distance); 5 % for what the rate does between samples.
        assert (jump[exist] <= turned / np.sin(nearest[exist])).all()
        assert np.mean(exist) > 0.9
        changes += len(run.chart_changes)
    assert changes > 0


@pytest.mark.parametrize("sequence", ["zyx", "zxz"])
def test_angles_do_not_depend_on_the_samples(sequence: str) -> None:
    model = fb.Model(BODY, [], sequence)
    x0 = model.state(
        attitude=fb.Attitude.angles("zyx", [0.1, 0.4, -0.3]), angular_velocity_body=[0.5, 0.9, -0.7]
    )
    fine = model.simulate(x0, (0.0, 60.0), rtol=1e-6, save_every=0.01)
    coarse = model.simulate(x0, (0.0, 60.0), rtol=1e-6, save_every=5.0)
    assert fine.chart_changes == coarse.chart_changes != ()
    # The same numbers, plus whole turns.
    assert np.abs(coarse.x - fine.x[::500]).max() <= 1e-13 * np.abs(fine.x).max()


def singular_start(sequence: str) -> fb.Attitude:
    return fb.Attitude.angles(sequence, [0.3, singular_angle(sequence), -0.2])


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_start_at_the_singularity(sequence: str) -> None:
    spin = [0.6, 1.1, -0.4]
    start = {
        "attitude": singular_start(sequence),
        "angular_velocity_body": spin,
        "velocity_body": [1.0, 0.0, 2.0],
    }
    model, other = fb.Model(BODY, attitude=sequence), fb.Model(BODY)
    run = model.simulate(model.state(**start), (0.0, 10.0), rtol=RTOL, save_every=0.1)
    reference = other.simulate(other.state(**start), (0.0, 10.0), rtol=RTOL, save_every=0.1)
    assert run.ok
    assert (run.chart_changes[0].time, run.chart_changes[0].to_chart) == (0.0, "quaternion")
    # Two runs of at most some hundred steps of 1e-9.
    assert motion_gap(run, reference) <= 1e-6
    assert np.isfinite(run.x).all()
    with pytest.raises(fb.SingularChartError, match="second angle"):
        fb.Model(BODY, attitude=sequence, form="generalized").state(**start)


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_staying_at_the_singularity(sequence: str) -> None:
    """At rest there, or turning about the third axis, which is the first one there."""
    third = np.eye(3)["xyz".index(sequence[2])]
    body = fb.RigidBody(2.0, inertia_about_com=np.diag([0.7, 1.1, 1.5]))
    model = fb.Model(body, attitude=sequence)
    for rate in (0.0, 1.0):
        x0 = model.state(attitude=singular_start(sequence), angular_velocity_body=rate * third)
        run = model.simulate(x0, (0.0, 20.0), rtol=RTOL, save_every=0.5)
        assert run.ok
        turned = fb.forms.rotation(run.t[:, None] * rate * third, "xyz")
        expected = singular_start(sequence).as_rotation() @ turned
        # Some fifty steps of 1e-9.
        assert np.abs(run.world_from_body - expected).max() <= 1e-7
        assert len(run.chart_changes) == 1


@pytest.mark.parametrize("form", FORMS)
def test_forces_through_the_singularity(form: Form) -> None:
    """A torque drives the pitch of "zyx" through 90 deg and on over the top, the mass centre off."""
    forces = [fb.UniformGravity(1.5), fb.ConstantWrench(moment=[0.02, 0.3, 0.01], force=[0.1, 0.0, 0.2])]
    runs = []
    for chart in ("zyx", "quaternion"):
        model = fb.Model(BODY, forces, chart, form)
        x0 = model.state(angular_velocity_body=[0.0, 0.4, 0.0])
        runs.append(model.simulate(x0, (0.0, 12.0), rtol=1e-10, save_every=0.05))
    assert runs[0].chart_changes
    # Some 300 steps of 1e-10 each, and a tenfold growth of differences.
    assert motion_gap(*runs) <= 3e-7
    assert relative(runs[0].energy[:, None], runs[1].energy[:, None]) <= 3e-7


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("sequence", SEQUENCES)
def test_fixed_steps_keep_their_distance(sequence: str, form: Form) -> None:
    """A step that suits the body does not have to suit angles that turn faster than it."""
    attitude, spin = fb.Attitude.angles("zyx", [0.1, 0.4, -0.3]), [0.6, 1.1, -0.4]
    for step in (0.02, 0.05, 0.1):
        runs = []
        for chart in (sequence, "quaternion"):
            model = fb.Model(BODY, [], chart, form)
            x0 = model.state(attitude=attitude, angular_velocity_body=spin)
            runs.append(model.simulate(x0, (0.0, 30.0), method="rk4", step=step, save_every=0.1))
        assert runs[0].ok
        # Such steps alone cost the body up to 5e-5, and angles that turn faster ten times that; if they lost
        # all sense it would be one and more.
        assert motion_gap(*runs) <= 1e-3
    # Many turns in one step are no motion to be followed any more, but the run ends.
    model = fb.Model(BODY, [], sequence, form)
    x0 = model.state(attitude=attitude, angular_velocity_body=[1e6, 2e6, 3e6])
    run = model.simulate(x0, (0.0, 1.0), method="rk4", step=0.1)
    assert run.outcome.status in ("reached_end", "non_finite")
