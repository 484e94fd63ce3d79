"""Every ending of a run is data: what stopped it, when, in which state, and by which force."""

import numpy as np
import pytest

import freebody as fb
from freebody.simulation import Method

from .scenes import BODY, START

BALL = fb.RigidBody(1.0, inertia_about_com=np.eye(3))
METHODS = {
    "dp54": {},
    "dop853": {},
    "vern8": {},
    "vern9": {},
    "rk4": {"step": 0.01},
    "rodas5p": {},
    "gauss6": {"step": 0.01},
}
STAGES = {"dp54": 6, "dop853": 12, "vern8": 12, "vern9": 15, "rk4": 4, "rodas5p": 8, "gauss6": 6}


def check_data(run: fb.Trajectory) -> None:
    """Whatever happened, there are numbers up to there and nothing else."""
    assert run.t[-1] == run.outcome.time
    assert np.array_equal(run.x[-1], run.outcome.state)
    assert np.isfinite(run.x).all()
    assert np.isfinite(run.kinetic_energy).all()
    assert f"{run.outcome.time:.9g}" in run.outcome.message


@pytest.mark.parametrize("method", METHODS)
def test_reached_end(method: Method) -> None:
    model = fb.Model(BODY)
    run = model.simulate(model.state(**START), (1.0, 4.0), method=method, **METHODS[method])
    assert (run.ok, run.outcome.status, run.outcome.time) == (True, "reached_end", 4.0)
    check_data(run)
    # Each step evaluates the stages of its method, and the first asks for little more.
    more = run.evaluations - STAGES[method] * (run.steps + run.rejected_steps)
    assert more >= 0
    # The iteration of gauss6 takes what it takes.
    assert method == "gauss6" or more <= 3 + run.steps


@pytest.mark.parametrize("method", METHODS)
def test_step_limit(method: Method) -> None:
    model = fb.Model(BODY)
    run = model.simulate(model.state(**START), (0.0, 100.0), method=method, max_steps=5, **METHODS[method])
    assert (run.ok, run.outcome.status) == (False, "step_limit")
    assert run.steps + run.rejected_steps == 5
    assert "max_steps" in run.outcome.message
    check_data(run)
    # Going on from there is the same motion.
    rest = model.simulate(run.outcome.state, (run.outcome.time, 5.0), rtol=1e-12)
    whole = model.simulate(model.state(**START), (0.0, 5.0), rtol=1e-12)
    # Five steps of 1e-9 at the most; rk4 at 0.01 s errs less.
    assert np.abs(rest.x[-1] - whole.x[-1]).max() <= 1e-8 * np.abs(whole.x[-1]).max()


@pytest.mark.parametrize("method", ["dp54", "dop853", "vern8", "vern9", "rodas5p"])
def test_step_too_small_at_a_collision(method: Method) -> None:
    """A fall into a point mass ends at π/√8 √(r³/μ), where it is infinitely fast."""
    model = fb.Model(BALL, [fb.PointMassGravity(1.0, gradient_torque=False)])
    run = model.simulate(model.state([1.0, 0.0, 0.0]), (0.0, 5.0), method=method)
    assert (run.ok, run.outcome.status) == (False, "step_too_small")
    # The tolerance of 1e-9 a step, some hundred steps.
    assert abs(run.outcome.time - np.pi / np.sqrt(8.0)) <= 1e-7
    check_data(run)


@pytest.mark.parametrize("method", METHODS)
def test_non_finite_at_the_start(method: Method) -> None:
    model = fb.Model(BALL, [fb.UniformGravity(), fb.LinearDamping([1e300] * 6, name="brake")])
    run = model.simulate(
        model.state(velocity_body=[1e10, 0.0, 0.0]), (0.0, 5.0), method=method, **METHODS[method]
    )
    assert (run.ok, run.outcome.status, run.outcome.force) == (False, "non_finite", "brake")
    assert run.outcome.time == 0.0
    assert "'brake'" in run.outcome.message
    assert len(run) == 1


@pytest.mark.parametrize("method", METHODS)
def test_non_finite_on_the_way(method: Method) -> None:
    """A force beyond all numbers that sets in at 2 s is named, with the time."""
    blast = fb.TabulatedWrench(
        [0.0, 2.0],
        [[0.0, 0.0, 0.0], [1e308, 0.0, 0.0]],
        at=[0.0, 9.0, 0.0],
        interpolation="hold",
        name="blast",
    )
    model = fb.Model(BALL, [fb.UniformGravity(), blast])
    run = model.simulate(model.state(), (0.0, 5.0), method=method, **METHODS[method])
    assert (run.outcome.status, run.outcome.force, run.outcome.time) == ("non_finite", "blast", 2.0)
    # The last state is that of the fall.
    assert abs(run.x[-1, 2] - 0.5 * 9.80665 * 4.0) <= 1e-7
    check_data(run)
    with pytest.raises(fb.NonFiniteError, match="blast"):
        model.derivative(2.0, run.outcome.state)


def test_a_motion_that_grows_beyond_all_numbers() -> None:
    model = fb.Model(BALL, [fb.LinearDamping([-1e3] * 6)])
    run = model.simulate(model.state(velocity_body=[1.0, 0.0, 0.0]), (0.0, 5.0), method="rk4", step=0.01)
    # Every force was finite, the step was too much: one of ten times the growth time makes 1 into 644.
    assert (run.outcome.status, run.outcome.force) == ("non_finite", None)
    assert abs(run.outcome.time - 0.01 * np.log(1e308) / np.log(644.0)) <= 0.02
    assert np.isfinite(run.x).all()


def test_samples_end_where_the_run_does() -> None:
    model = fb.Model(BALL, [fb.PointMassGravity(1.0, gradient_torque=False)])
    run = model.simulate(model.state([1.0, 0.0, 0.0]), (0.0, 5.0), save_every=0.1)
    assert np.allclose(run.t, 0.1 * np.arange(12), rtol=1e-15)
    none = model.simulate(model.state([1.0, 0.0, 0.0]), (0.0, 5.0), save_at=[3.0, 4.0])
    assert len(none) == 0
    assert none.point([1.0, 0.0, 0.0]).shape == (0, 3)
    assert none.conserved() == []


def test_progress_is_told_and_can_stop() -> None:
    model = fb.Model(BODY)
    heard: list[float] = []
    model.simulate(model.state(**START), (0.0, 100.0), method="rk4", step=0.01, progress=heard.append)
    assert len(heard) == 10_000 // 1024
    assert (np.diff(heard) > 0.0).all()
    assert 0.0 < heard[0] < heard[-1] < 1.0

    def stop(part: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        model.simulate(model.state(**START), (0.0, 100.0), method="rk4", step=0.01, progress=stop)


@pytest.mark.parametrize("method", ["dop853", "dp54"])
def test_a_motion_that_outgrows_the_squares_of_doubles_ends(method: Method) -> None:
    """Driven to infinity, a run says so at once instead of creeping on to its last step."""
    model = fb.Model(BALL, [fb.LinearDamping([-1e3] * 6)])
    run = model.simulate(model.state(velocity_body=[1.0, 0.0, 0.0]), (0.0, 5.0), method=method)
    assert run.outcome.status == "non_finite"
    # exp(1000 t) reaches 1e150 at 0.345 s.
    assert 0.34 < run.outcome.time < 0.41
    assert run.steps < 100_000
