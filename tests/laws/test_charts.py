"""The twelve angle charts and the quaternion, and both kinds of velocity, tell of one motion."""

import numpy as np
import pytest

import freebody as fb
from freebody.model import Form
from freebody.simulation import Method

from .scenes import BODY, CHARTS, FORMS, START, every_force, motion_gap

CONTROL = [1.0, 0.0, -1.0, 0.1, 0.2, 0.1]
TIMES = np.linspace(0.0, 10.0, 201)


def run_in(chart: str, form: Form, rtol: float, method: Method) -> fb.Trajectory:
    model = fb.Model(BODY, every_force(np.random.default_rng(7)), chart, form)
    x0 = model.state(**START)
    return model.simulate(x0, (0.0, 10.0), rtol=rtol, method=method, save_at=TIMES, inputs=CONTROL)


@pytest.fixture(scope="module")
def exact() -> fb.Trajectory:
    return run_in("quaternion", "quasi_velocity", 1e-13, "dop853")


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("chart", CHARTS)
@pytest.mark.parametrize(("rtol", "method"), [(1e-6, "dp54"), (1e-6, "dop853"), (1e-11, "dop853")])
def test_same_path(exact: fb.Trajectory, chart: str, form: Form, rtol: float, method: Method) -> None:
    run = run_in(chart, form, rtol, method)
    assert run.ok
    # Each step may err by rtol; the forces let a small difference grow some tenfold in these 10 s, and the
    # kinks of |V|V, which no method of high order sees coming, cost a few times that.
    assert motion_gap(run, exact) <= 50 * run.steps * rtol


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("chart", fb.forms.SEQUENCES)
def test_samples_are_the_attitude_and_the_rates(chart: str, form: Form) -> None:
    """The angles of a state make its attitude, and their rates its turn, in whichever chart it ran."""
    run = run_in(chart, form, 1e-9, "dop853")
    # Through a quaternion and back: a few roundings.
    assert np.abs(fb.forms.rotation(run.x[:, 3:6], chart) - run.world_from_body).max() <= 1e-14
    model = run.model
    for t, x, u, spin in zip(run.t, run.x, run.u, run.angular_velocity_body, strict=True):
        rates = model.derivative(t, x, u)[3:6]
        if form == "generalized":
            assert (rates == x[9:12]).all()
        # The body's rate out of angle rates that are larger than it by the nearness of the singularity.
        gap = fb.forms.rate_matrix_body(x[3:6], chart) @ rates - spin
        assert np.abs(gap).max() <= 1e-14 * max(1.0, float(np.abs(rates).max()))


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("chart", CHARTS)
def test_one_acceleration(chart: str, form: Form, rng: np.random.Generator) -> None:
    """At random states the derivative means the same acceleration of the body as in quasi-velocities."""
    forces = every_force(rng)
    plain, other = fb.Model(BODY, forces), fb.Model(BODY, forces, chart, form)
    for _ in range(20):
        angles = rng.uniform(-3.0, 3.0, 3)
        # A second angle that is singular in no chart of this sequence: the state is written in it.
        sequence = "zyx" if chart == "quaternion" else chart
        angles[1] = rng.uniform(0.4, 1.1)
        start = {
            "position": rng.normal(size=3),
            "attitude": fb.Attitude.angles(sequence, angles),
            "velocity_body": rng.normal(size=3),
            "angular_velocity_body": rng.normal(size=3),
        }
        t, h = rng.uniform(0.0, 10.0), 1e-5
        x = other.state(**start)
        expected = plain.derivative(t, plain.state(**start), CONTROL)[7:]
        rate = other.derivative(t, x, CONTROL)
        ahead, behind = (other.motion((x + s * h * rate)[None])[2][0] for s in (1.0, -1.0))
        # A central difference: h² times a third derivative of some tens, 1e-16 / h from rounding.
        assert np.abs((ahead - behind) / (2.0 * h) - expected).max() <= 1e-7 * max(1, np.abs(expected).max())
