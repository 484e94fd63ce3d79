"""The marine vehicles: their matrices by an independent way, and what is published of their speed."""

import mpmath as mp
import numpy as np
import pytest

import freebody as fb
from freebody.model_file import shipped_model
from freebody.verify import marine


@pytest.mark.parametrize(("cases", "count"), [(marine.remus, 3), (marine.otter, 4)])
def test_residuals(cases, count):
    residuals = list(cases())
    assert len(residuals) == count
    assert [residual for residual in residuals if not residual.passed] == []


def test_the_quadrature_of_lambs_integrals():
    """Against thirty digits, from the integrals as they stand in articles 114 and 115."""

    def integral(square):
        def inner(x):
            return 1 / ((square + x) * mp.sqrt(a**2 + x) * (b**2 + x))

        return a * b**2 * mp.quad(inner, [0, b**2, a**2, 10 * a**2, mp.inf])

    with mp.workdps(30):
        a, b = mp.mpf(8) / 10, mp.mpf(95) / 1000
        alpha, beta = integral(a**2), integral(b**2)
        spread, whole = b**2 - a**2, a**2 + b**2
        turning = spread**2 * (alpha - beta) / ((2 * spread + whole * (beta - alpha)) * whole)
        wanted = [float(k) for k in (alpha / (2 - alpha), beta / (2 - beta), turning)]
    # Sums of thirty doubles.
    assert marine.spheroid(0.8, 0.095) == pytest.approx(wanted, rel=1e-13)


def test_the_mass_of_the_auv():
    """MSS's 31.9 kg is a spheroid 1 % longer; the vehicle hangs from its origin: roll couples with sway."""
    inertia = fb.load(shipped_model("remus_100")).model.body.spatial_inertia
    assert inertia[0, 0] == pytest.approx(31.9 / 1.0096**3, rel=1e-3)
    assert inertia[1, 3] == pytest.approx(-0.02 * inertia[0, 0], rel=1e-14)


def test_a_shift_made_twice_would_be_seen():
    """As the port of the vessel's program has it: 57 % more in roll."""
    body = fb.load(shipped_model("otter")).model.body
    twice = 55 * 0.432**2 + 55 * body.com[2] ** 2 + 25 * 0.35**2
    assert twice == pytest.approx(16.679, abs=5e-4)
    assert twice / body.inertia_about_com[0, 0] - 1.0 == pytest.approx(0.566, abs=5e-4)


def test_the_torque_of_the_propeller_heels_the_auv():
    """By the angle at which the weight brings it back, about a degree."""
    file = fb.load(shipped_model("remus_100"))
    run = file.model.simulate(file.x0, (0.0, 20.0), inputs=[0.0, 0.0, 1525.0 * np.pi / 30.0])
    assert np.degrees(run.angles("zyx")[-1, 2]) == pytest.approx(-1.05, abs=0.02)


def test_the_otter_rests():
    """What the current does is not of its motion through the water."""
    assert not fb.load(shipped_model("otter")).model.state()[:3].any()


@pytest.mark.parametrize("name", ["remus_100", "otter"])
def test_the_shipped_runs_end(name):
    run = fb.load(shipped_model(name)).simulate()
    assert run.ok
    # The otter turns to starboard, and so does the AUV.
    assert run.angular_velocity_body[-1, 2] > 0.1
