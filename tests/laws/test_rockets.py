"""Rockets with closed solutions: speed, jet damping, spin, impulse."""

from __future__ import annotations

import numpy as np
import pytest

import freebody as fb
from freebody.elements import Propulsion, Tank, Thruster
from freebody.environment import Environment, UniformAtmosphere

from .rockets import G0


def axial(radius: float = 0.0, ratio: float = 0.4) -> fb.Model:
    """A slender rocket: burns fuel at its mass centre, in a tank of gyration radius `ratio`."""
    body = fb.RigidBody(20.0, inertia_about_com=np.diag([4.0, 4.0, 1.0]))
    tensor = 80.0 * ratio**2 * np.diag([1.0, 1.0, 0.3])
    engine = Thruster(
        [0, 0, -2.0], [0, 0, 1], 500.0, specific_impulse=200.0, tanks="grain", exit_radius=radius
    )
    return fb.Model(body, [Propulsion([engine], [Tank("grain", 80.0, [0, 0, 0], tensor)])])


def test_tsiolkovsky() -> None:
    model = axial()
    run = model.simulate(model.state(), (0.0, 312.0), rtol=1e-12, save_every=12.0)
    mass = 20.0 + run.states["propulsion.grain_mass"]
    assert mass[-1] < 21.5
    # The integrator's tolerance, some dozens of steps.
    speed = G0 * 200.0 * np.log(100.0 / mass)
    np.testing.assert_allclose(run.velocity_body[:, 2], speed, rtol=0, atol=1e-9 * speed[-1])
    assert not run.velocity_body[:, :2].any()


def test_jet_damping() -> None:
    """I w' = -(I' + m' l^2) w about the mass centre, for an engine at the distance l: with I = I_e + k^2 m
    that is a power of I. Thomson (1961), section 7.5.
    """
    model, k = axial(), 0.4
    x0 = model.state(angular_velocity_body=[0.3, -0.2, 0.0])
    run = model.simulate(x0, (0.0, 280.0), rtol=1e-12, save_every=10.0)
    inertia = 4.0 + k**2 * run.states["propulsion.grain_mass"]
    damped = (inertia / inertia[0]) ** (2.0**2 / k**2 - 1.0)
    # The exponent of 24 multiplies the error of the mass.
    wanted = damped[:, None] * np.array([0.3, -0.2, 0.0])
    np.testing.assert_allclose(run.angular_velocity_body, wanted, rtol=0, atol=1e-9)
    assert damped[-1] < 1e-8


@pytest.mark.parametrize("share", [0.0, 0.5, 1.0])
def test_spin_of_a_rocket_that_burns(share: float) -> None:
    """The propellant leaves with the share k_e^2/k^2 of its spin: J w' = (k^2 - k_e^2) m_e w."""
    about = 0.3 * 0.4**2
    model = axial(radius=np.sqrt(2.0 * about * share))
    x0 = model.state(angular_velocity_body=[0.0, 0.0, 2.0])
    run = model.simulate(x0, (0.0, 280.0), rtol=1e-12, save_every=10.0)
    inertia = 1.0 + about * run.states["propulsion.grain_mass"]
    wanted = 2.0 * (inertia[0] / inertia) ** (1.0 - share)
    # The integrator's tolerance over a motion that grows fivefold at most.
    np.testing.assert_allclose(run.angular_velocity_body[:, 2], wanted, rtol=1e-10)


def test_the_tail_off_hardly_changes_the_impulse() -> None:
    """Every kilogram gives the same impulse, whenever it burns: only what stays behind is lost."""
    body = fb.RigidBody(20.0, inertia_about_com=np.diag([4.0, 4.0, 1.0]))
    engine = Thruster([0, 0, -2.0], [0, 0, 1], 500.0, specific_impulse=200.0, tanks="tank")
    for tail_off in (0.01, 1.0, 5.0):
        tank = Tank("tank", 80.0, [0, 0, 0], tail_off=tail_off)
        model = fb.Model(body, [Propulsion([engine], [tank])])
        run = model.simulate(model.state(), (0.0, 1000.0), rtol=1e-10)
        left = run.states["propulsion.tank_mass"][-1]
        # Forty time constants after the tank ran dry nothing is left, to the tolerance of the run.
        assert abs(left) < 1e-7
        assert run.velocity_body[-1, 2] == pytest.approx(G0 * 200.0 * np.log(5.0), rel=1e-8)


def test_thrust_falls_with_the_pressure_of_the_air() -> None:
    body = fb.RigidBody(20.0, inertia_about_com=np.diag([4.0, 4.0, 1.0]))
    for pressure in (1.0, 5e4, 1e5):
        air = Environment(atmosphere=UniformAtmosphere(pressure=pressure))
        engine = Thruster([0, 0, 0], [0, 0, 1], 500.0, exit_area=2e-3, throttle=0.5)
        model = fb.Model(body, [Propulsion([engine], environment=air)])
        # A few products.
        assert model.wrench(0.0, model.state())[2] == pytest.approx(
            0.5 * (500.0 - pressure * 2e-3), rel=1e-14
        )
