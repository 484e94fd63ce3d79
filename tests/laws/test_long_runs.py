"""gauss6 over very many revolutions: what is conserved neither drifts nor wanders off."""

import numpy as np
import pytest

import freebody as fb

from .scenes import BODY, START, Array

# An error of the phase grows, one of energy and momentum does not.
STEPS_A_TURN = 10


def deviation(history: Array) -> float:
    return float(np.abs(history / history[0] - 1.0).max())


def spin(model: fb.Model, x0: Array, turns: float, **settings) -> fb.Trajectory:
    turn = 2.0 * np.pi / float(np.linalg.norm(x0[10:13]))
    settings = {"method": "gauss6", "step": turn / STEPS_A_TURN} | settings
    run = model.simulate(x0, (0.0, turns * turn), save_every=turns * turn / 200, **settings)
    assert run.ok
    return run


@pytest.mark.parametrize("turns", [100, 100_000])
def test_energy_and_momentum_of_a_tumbling_body(turns: int) -> None:
    """About the middle axis it turns over and over again."""
    body = fb.RigidBody(0.06, inertia_about_com=fb.principal_inertia([1.2e-5, 2.0e-5, 3.0e-5]))
    model = fb.Model(body)
    run = spin(model, model.state(angular_velocity_body=[0.006, 6.0, 0.0]), turns)
    momentum = np.linalg.norm(run.momentum_world[:, 3:], axis=1)
    # Roundings of 1e-16, however many steps there were.
    assert deviation(run.kinetic_energy) <= 2e-14
    assert deviation(momentum) <= 2e-14


def test_energy_with_the_mass_centre_off_the_origin() -> None:
    model = fb.Model(BODY)
    run = spin(model, model.state(**START), 10_000)
    assert deviation(run.kinetic_energy) <= 2e-14


def test_explicit_steps_of_the_same_cost_lose_the_energy() -> None:
    model = fb.Model(BODY)
    x0 = model.state(**START)
    run = spin(model, x0, 1000, method="dop853", step=None, rtol=1e-8)
    assert deviation(run.kinetic_energy) >= 1e-8
