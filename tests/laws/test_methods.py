"""Each method of integration has its order, from a model to its samples."""

import numpy as np
import pytest

import freebody as fb
from freebody.model import Form
from freebody.simulation import Method
from freebody.simulation.settings import FIXED_STEP, METHODS

from .scenes import BODY, FORMS, START, Array, motion_gap, positive_matrix

SPAN = (0.0, 8.0)
SAMPLES = np.linspace(*SPAN, 201)
# The powers of the step that the estimated and the true error of a run go with, and what the terms behind the
# first add to the first power: vern9 takes so long steps that they count.
ADAPTIVE = {
    "dp54": (5, 5, 0.5),
    "dop853": (8, 8, 0.5),
    "vern8": (7, 8, 0.5),
    "vern9": (8, 9, 1.6),
    "rodas5p": (5, 5, 0.5),
}


def smooth_model(form: Form = "quasi_velocity") -> fb.Model:
    """Forces with derivatives of every order."""
    forces = [
        fb.UniformGravity(1.5),
        fb.PointMassGravity(50.0, center=[2.0, 3.0, -8.0]),
        fb.ConstantWrench([1.0, 2.0, 3.0], [0.2, 0.1, 0.3], axes="world", at=[-0.2, 0.1, 0.4]),
        fb.LinearDamping(positive_matrix(np.random.default_rng(1))),
    ]
    return fb.Model(BODY, forces, form=form)


def go(form: Form, method: Method, save_at: Array | None = SAMPLES, **settings) -> fb.Trajectory:
    model = smooth_model(form)
    return model.simulate(model.state(**START), SPAN, method=method, save_at=save_at, **settings)


@pytest.fixture(scope="module")
def exact() -> fb.Trajectory:
    return go("quasi_velocity", "dop853", rtol=1e-14)


@pytest.mark.parametrize("form", FORMS)
def test_rk4_has_order_four(exact: fb.Trajectory, form: Form) -> None:
    steps = np.array([0.08, 0.04, 0.02, 0.01])
    errors = [motion_gap(go(form, "rk4", step=h), exact) for h in steps]
    slopes = np.diff(np.log(errors)) / np.diff(np.log(steps))
    # The next term is smaller by about the step times rates of some 1/s.
    assert np.abs(slopes - 4.0).max() <= 0.1


def test_rk4_takes_its_step() -> None:
    run = go("quasi_velocity", "rk4", save_at=None, step=0.3)
    # 26 whole steps and the rest.
    assert run.steps == 27
    assert np.allclose(np.diff(run.t)[:-1], 0.3, rtol=1e-12)
    assert run.t[-1] == SPAN[1]


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("method", ADAPTIVE)
def test_error_follows_the_tolerance(exact: fb.Trajectory, method: Method, form: Form) -> None:
    tolerances = 10.0 ** -np.arange(7.0, 14.0)
    runs = [go(form, method, rtol=rtol) for rtol in tolerances]
    errors = np.array([motion_gap(run, exact) for run in runs])
    steps = np.array([run.steps for run in runs])
    # Each step may err by rtol; the motion lets that grow some tenfold.
    assert (errors <= 10 * steps * tolerances).all()
    estimated, true, more = ADAPTIVE[method]
    slope = np.polyfit(np.log(tolerances), np.log(errors), 1)[0]
    assert abs(slope - true / estimated) <= 0.15
    # The number of steps goes with that root of rtol.
    order = -1.0 / np.polyfit(np.log(tolerances), np.log(steps), 1)[0]
    assert abs(order - estimated) <= more


@pytest.mark.parametrize("method", ADAPTIVE)
def test_samples_inside_steps_are_as_good_as_steps(exact: fb.Trajectory, method: Method) -> None:
    rtol = 1e-9
    at_steps = go("quasi_velocity", method, save_at=None, rtol=rtol)
    truth_there = go("quasi_velocity", "dop853", save_at=at_steps.t, rtol=1e-14)
    inside = go("quasi_velocity", method, rtol=rtol)
    assert inside.steps == at_steps.steps < 2 * len(SAMPLES)
    # The interpolation is one order below the step: a few times its error.
    assert motion_gap(inside, exact) <= 5 * motion_gap(at_steps, truth_there)


@pytest.mark.parametrize("form", FORMS)
def test_gauss6_has_order_six(form: Form) -> None:
    # At the end alone: between its steps it has order four.
    exact = go(form, "dop853", save_at=np.array([SPAN[1]]), rtol=1e-14)
    steps = np.array([0.4, 0.2, 0.1, 0.05])
    errors = [motion_gap(go(form, "gauss6", step=h, save_at=exact.t), exact) for h in steps]
    slopes = np.diff(np.log(errors)) / np.diff(np.log(steps))
    # The next term is smaller by the square of the step times rates of some 1/s.
    assert np.abs(slopes - 6.0).max() <= 0.3


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("chart", ["quaternion", "zyx"])
def test_every_way_of_saving_tells_the_same(chart: str, method: Method, form: Form) -> None:
    model = fb.Model(BODY, smooth_model().forces, chart, form)
    x0, step = model.state(**START), 0.05 if method in FIXED_STEP else None

    def save(**how) -> fb.Trajectory:
        return model.simulate(x0, SPAN, method=method, step=step, **how)

    steps = save()
    again = save(save_at=steps.t)
    assert np.array_equal(again.t, steps.t)
    # The interpolation ends where the step does but for rounding, which angles near their singularity
    # enlarge.
    assert np.abs(again.x - steps.x).max() <= 1e-12 * np.abs(steps.x).max()
    every, some = save(save_every=0.3), save(save_at=[0.3, 0.6, 8.0])
    assert np.allclose(every.t, [*(0.3 * np.arange(27)), 8.0], rtol=1e-15)
    assert np.array_equal(every.x[[1, 2, -1]], some.x)
    assert np.array_equal(every.x[0], x0)
    for run in (again, every, some):
        assert (run.steps, run.rejected_steps) == (steps.steps, steps.rejected_steps)
        assert np.abs(run.outcome.state - steps.x[-1]).max() <= 1e-12 * np.abs(steps.x).max()


def test_a_tighter_first_step_changes_nothing_but_the_start() -> None:
    run = go("quasi_velocity", "dop853", save_at=None, rtol=1e-9, step=1e-4)
    assert run.t[1] - run.t[0] == 1e-4
    assert np.diff(run.t).max() > 0.05
