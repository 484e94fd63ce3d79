"""The linearization along a run is how small differences of the start go on. Konoplev (3.2)"""

import numpy as np
import pytest

import freebody as fb
from freebody.model import Form

from .scenes import BODY, CHARTS, FORMS, Array, every_force

SPAN = (0.0, 1.5)
CONTROL = [1.0, 0.0, -1.0, 0.1, 0.2, 0.1]


def start(model: fb.Model, change: Array) -> Array:
    """A state some way off the nominal one: position, turn, velocity, angular velocity, (12,)."""
    here, turn, velocity, spin = change.reshape(4, 3)
    # Well away from the singularity of the chart, where A changes too fast for fixed steps.
    chart = "zyx" if model.attitude == "quaternion" else model.attitude
    nominal = fb.Attitude.angles(chart, [0.5, 0.8, 0.7]).as_rotation()
    attitude = fb.Attitude.rotation(nominal @ fb.Attitude.angles("xyz", turn).as_rotation())
    return model.state(
        np.add(here, [1.0, 2.0, 3.0]),
        attitude,
        velocity_body=np.add(velocity, [1.0, -2.0, 0.5]),
        angular_velocity_body=np.add(spin, [0.3, 0.4, -0.2]),
    )


def transition(a: Array, step: float, difference: Array) -> Array:
    """δx at the end of δx' = A δx by the classical Runge-Kutta method, A given at half steps."""
    for begin, middle, end in zip(a[:-2:2], a[1:-1:2], a[2::2], strict=True):
        k1 = begin @ difference
        k2 = middle @ (difference + 0.5 * step * k1)
        k3 = middle @ (difference + 0.5 * step * k2)
        k4 = end @ (difference + step * k3)
        difference = difference + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
    return difference


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("chart", CHARTS)
def test_small_differences_follow_the_linearization(chart: str, form: Form, rng: np.random.Generator) -> None:
    # No jump in time and no kink of |V|V: their linearizations hold only piece by piece.
    forces = [f for f in every_force(rng) if not isinstance(f, fb.TabulatedWrench | fb.QuadraticDamping)]
    model = fb.Model(BODY, forces, chart, form)
    step = 0.01
    settings = {"rtol": 1e-13, "inputs": CONTROL}
    run = model.simulate(start(model, np.zeros(12)), SPAN, save_every=0.5 * step, **settings)
    along = model.linearize(run)
    assert along.A.shape == (len(run), model.n_states, model.n_states)

    direction = rng.normal(size=12)
    ends, starts = [], []
    for sign in (1.0, -1.0):
        x0 = start(model, sign * 1e-5 * direction)
        ends.append(model.simulate(x0, SPAN, save_at=[SPAN[1]], **settings).x[-1])
        starts.append(x0)
    expected = transition(along.A, step, starts[0] - starts[1])
    # A central difference errs by the square of 1e-5 times a third derivative of some hundreds, and by
    # 1e-12 of the runs over its 1e-5; the fixed steps err by 0.01⁴ times a fifth derivative.
    assert np.abs(ends[0] - ends[1] - expected).max() <= 1e-6 * np.abs(expected).max()


def test_inputs_act_through_the_inverse_inertia() -> None:
    model = fb.Model(BODY, [fb.UniformGravity(), fb.LinearDamping([1.0] * 6)])
    run = model.simulate(start(model, np.zeros(12)), SPAN, save_every=0.5)
    expected = np.vstack([np.zeros((7, 6)), BODY.inverse_spatial_inertia])
    # Duals through the same solve: rounding.
    assert np.abs(model.linearize(run).B - expected).max() <= 1e-15 * np.abs(expected).max() * 6


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("chart", ["quaternion", "zyx", "zxz"])
def test_samples_are_the_model_s_jacobians(chart: str, form: Form, rng: np.random.Generator) -> None:
    """A(t), B(t) are those at the state, the time and the input of each sample, tables included."""
    model = fb.Model(BODY, every_force(rng), chart, form)
    table = fb.InputTable([0.0, 0.5, 1.5], rng.normal(size=(3, 6)))
    run = model.simulate(start(model, np.zeros(12)), SPAN, save_every=0.25, inputs=table)
    along = model.linearize(run)
    assert np.array_equal(along.t, run.t)
    for i, t in enumerate(run.t):
        a, b = model.jacobian(t, run.x[i], table.at([t])[0])
        assert np.array_equal(along.A[i], a)
        assert np.array_equal(along.B[i], b)
