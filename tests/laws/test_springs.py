"""Springs and tethers: energy, periods, and lines that only pull."""

from __future__ import annotations

import numpy as np
import pytest

import freebody as fb
from freebody.elements import RotationalSpring, Spring, Tether

from .scenes import BODY, START

END = np.array([0.4, -0.2, 0.3])
ANCHOR = np.array([1.0, 3.0, -1.0])


def test_a_spring_keeps_the_energy() -> None:
    spring = Spring(300.0, at=END, anchor=ANCHOR, length=1.5)
    turning = RotationalSpring([30.0, 20.0, 25.0], START["attitude"].as_rotation())
    model = fb.Model(BODY, [fb.UniformGravity(), spring, turning])
    run = model.simulate(model.state(**START), (0.0, 5.0), rtol=1e-11, save_every=0.05)
    stretched = np.linalg.norm(run.point(END) - ANCHOR, axis=1) - 1.5
    K = np.diag([30.0, 20.0, 25.0])
    G = 0.5 * np.trace(K) * np.eye(3) - K
    turned = START["attitude"].as_rotation().T @ run.world_from_body
    stored = 150.0 * stretched**2 + np.trace(G @ (np.eye(3) - turned), axis1=1, axis2=2)
    total = run.kinetic_energy + run.potential_energy + stored
    # Some two hundred steps of 1e-11.
    assert np.abs(total - total[0]).max() <= 1e-9 * np.abs(stored).max()


def test_a_damped_spring_takes_the_power_of_its_damper(rng: np.random.Generator) -> None:
    bare, damped = (Spring(300.0, at=END, anchor=ANCHOR, length=1.5, damping=c) for c in (0.0, 7.0))
    for _ in range(20):
        model = fb.Model(BODY, [damped])
        x = model.state(rng.normal(size=3), velocity_body=rng.normal(size=3), angular_velocity_body=[1, 2, 3])
        twist = x[7:13]
        extra = model.wrench(0.0, x) - fb.Model(BODY, [bare]).wrench(0.0, x)
        line = x[:3] + END - ANCHOR
        rate = line @ (twist[:3] + np.cross(twist[3:], END)) / np.linalg.norm(line)
        # One product more or less.
        assert extra @ twist == pytest.approx(-7.0 * rate**2, rel=1e-10, abs=1e-12)


def test_the_period_of_a_mass_on_a_spring() -> None:
    ball = fb.RigidBody(2.0, inertia_about_com=np.eye(3))
    model = fb.Model(ball, [Spring(50.0, anchor=[0.0, 0.0, 0.0])])
    period = 2.0 * np.pi * np.sqrt(2.0 / 50.0)
    x0 = model.state([0.3, -0.2, 0.1], velocity_body=[0.5, 0.1, 0.0])
    run = model.simulate(x0, (0.0, period), rtol=1e-12)
    # Of free length zero it is a harmonic oscillator in space, through the anchor too.
    np.testing.assert_allclose(run.x[-1], x0, rtol=0, atol=1e-10)
    straight = model.simulate(model.state([0.3, 0.0, 0.0]), (0.0, period), rtol=1e-12)
    np.testing.assert_allclose(straight.position_world[-1], [0.3, 0.0, 0.0], rtol=0, atol=1e-9)


def test_the_period_of_a_rotational_spring() -> None:
    wheel = fb.RigidBody(1.0, inertia_about_com=np.diag([0.2, 0.3, 0.4]))
    model = fb.Model(wheel, [RotationalSpring([1.0, 2.0, 5.0])])
    amplitude = 1e-4
    for axis, (stiffness, inertia) in enumerate(((1.0, 0.2), (2.0, 0.3), (5.0, 0.4))):
        period = 2.0 * np.pi * np.sqrt(inertia / stiffness)
        turn = fb.Attitude.angles("xyz", amplitude * np.eye(3)[axis])
        run = model.simulate(model.state(attitude=turn), (0.0, period), rtol=1e-12)
        # A pendulum's period is longer by a sixteenth of its amplitude squared: here 1e-9 of a turn of 1e-4.
        back = run.world_from_body[-1] - turn.as_rotation()
        assert np.abs(back).max() <= 1e-11


@pytest.mark.parametrize("damping", [0.0, 40.0])
def test_a_tether_only_pulls(damping: float, rng: np.random.Generator) -> None:
    model = fb.Model(BODY, [Tether(500.0, 2.0, at=END, anchor=ANCHOR, damping=damping)])
    for _ in range(100):
        x = model.state(2.0 * rng.normal(size=3), velocity_body=3.0 * rng.normal(size=3))
        line = x[:3] + END - ANCHOR
        force = model.wrench(0.0, x)[:3]
        tension = -force @ line / np.linalg.norm(line)
        assert tension >= 0.0
        np.testing.assert_allclose(np.cross(force, line), 0.0, atol=1e-9)
        if np.linalg.norm(line) < 2.0:
            assert not force.any()


def test_a_tether_keeps_the_energy_through_slack_and_pull() -> None:
    stiffness, length, onset = 400.0, 1.0, 0.02
    ball = fb.RigidBody(2.0, inertia_about_com=np.eye(3))
    model = fb.Model(ball, [fb.UniformGravity(), Tether(stiffness, length, onset=onset)])
    run = model.simulate(model.state([0.3, 0.0, 0.0]), (0.0, 5.0), rtol=1e-11, save_every=0.01)
    beyond = np.linalg.norm(run.position_world, axis=1) - length
    assert beyond.min() < -0.1
    assert beyond.max() > 0.1
    inside, more = np.clip(beyond, 0.0, onset), np.maximum(beyond - onset, 0.0)
    stored = stiffness * (inside**3 / (6.0 * onset) + 0.5 * (more + onset) * more)
    total = run.kinetic_energy + run.potential_energy + stored
    # Corners of the second derivative at the onset, some ten times.
    assert np.abs(total - total[0]).max() <= 1e-7 * stored.max()


def test_a_towed_body_follows_its_anchor() -> None:
    """An anchor in uniform motion is one at rest seen from a frame that goes along."""
    speed = np.array([0.7, 0.2, -0.3])
    fixed, towed = (
        fb.Model(BODY, [Tether(200.0, 1.0, at=END, anchor=anchor, damping=5.0)]) for anchor in (ANCHOR, "tug")
    )
    wanted = [f"tug{part}_{axis}" for part in ("", "_velocity") for axis in "xyz"]
    assert list(towed.input_names) == wanted
    times = np.array([0.0, 4.0])
    inputs = fb.InputTable(times, np.hstack([ANCHOR + times[:, None] * speed, np.tile(speed, (2, 1))]))
    start = {"attitude": START["attitude"], "angular_velocity_body": START["angular_velocity_body"]}
    rest = fixed.simulate(fixed.state(**start), (0.0, 4.0), rtol=1e-11, save_every=0.2)
    tow = towed.simulate(
        towed.state(velocity_world=speed, **start), (0.0, 4.0), rtol=1e-11, save_every=0.2, inputs=inputs
    )
    gap = tow.position_world - rest.position_world - rest.t[:, None] * speed
    # Corners met with other steps.
    assert np.abs(gap).max() <= 1e-8


def test_wrong_springs_are_told() -> None:
    with pytest.raises(fb.InputError, match="stiffness: got -1"):
        Spring(-1.0)
    with pytest.raises(fb.InputError, match="anchor: got the name"):
        Spring(1.0, anchor="a buoy")
    with pytest.raises(fb.InputError, match="length"):
        Tether(1.0, 0.0)
    with pytest.raises(fb.InputError, match="stiffness: not symmetric"):
        RotationalSpring([[1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    with pytest.raises(fb.InputError, match="damping: its smallest eigenvalue is -1"):
        RotationalSpring(1.0, damping=[1.0, 1.0, -1.0])
