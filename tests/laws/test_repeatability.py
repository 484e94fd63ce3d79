"""The same question has the same answer, to the last bit."""

import numpy as np
import pytest

import freebody as fb
from freebody.model import Form
from freebody.simulation import Method

from .scenes import BODY, CHARTS, FORMS, START, every_force

CONTROL = np.array([1.0, 0.0, -1.0, 0.1, 0.2, 0.1])


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("chart", CHARTS)
def test_derivative_in_place_and_anew(chart: str, form: Form, rng: np.random.Generator) -> None:
    model = fb.Model(BODY, every_force(rng), chart, form)
    x, out = model.state(**START), np.full(model.n_states, np.nan)
    for t in rng.uniform(0.0, 10.0, 20):
        anew = model.derivative(t, x, CONTROL)
        returned = model.derivative(t, x, CONTROL, out=out)
        assert returned is out
        assert np.array_equal(anew, out)
        # Arguments of another kind are the same numbers.
        assert np.array_equal(model.derivative(np.float64(t), x.tolist(), tuple(CONTROL)), out)
        x = x + 0.01 * out
    zeros = np.zeros(6)
    assert np.array_equal(model.derivative(1.0, x), model.derivative(1.0, x, zeros))


@pytest.mark.parametrize("method", ["rk4", "dp54", "dop853", "vern8", "vern9"])
@pytest.mark.parametrize("chart", ["quaternion", "zyx", "zxz"])
def test_simulation_twice(chart: str, method: Method) -> None:
    """From equal models made apart, too."""
    runs = []
    for _ in range(2):
        model = fb.Model(BODY, every_force(np.random.default_rng(7)), chart)
        step = 0.01 if method == "rk4" else None
        x0 = model.state(**START)
        runs.append(model.simulate(x0, (0.0, 10.0), method=method, step=step, inputs=CONTROL))
    first, second = runs
    assert np.array_equal(first.t, second.t)
    assert np.array_equal(first.x, second.x)
    assert first.chart_changes == second.chart_changes
    assert (first.steps, first.evaluations) == (second.steps, second.evaluations)
    assert np.array_equal(first.energy, second.energy)


def test_a_run_leaves_its_model_and_start_as_they_were() -> None:
    model = fb.Model(BODY, every_force(np.random.default_rng(7)), "zyx")
    x0 = model.state(**START)
    before, rate = x0.copy(), model.derivative(0.3, x0, CONTROL)
    model.simulate(x0, (0.0, 5.0), inputs=CONTROL)
    assert np.array_equal(x0, before)
    assert np.array_equal(model.derivative(0.3, x0, CONTROL), rate)


def test_progress_does_not_disturb() -> None:
    model = fb.Model(BODY)
    x0 = model.state(**START)
    quiet = model.simulate(x0, (0.0, 500.0), rtol=1e-11)
    told: list[float] = []
    loud = model.simulate(x0, (0.0, 500.0), rtol=1e-11, progress=told.append)
    assert told
    assert np.array_equal(quiet.x, loud.x)
