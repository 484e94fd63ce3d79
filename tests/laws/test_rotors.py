"""What turns inside or on a body: wheels, rotors, a constant momentum."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import freebody as fb
from freebody.elements import GyroscopicMomentum, Propeller, ReactionWheels
from freebody.environment import Environment, UniformAtmosphere

from .scenes import BODY, START, Array
from .spinners import (
    AIR,
    AXES,
    HUBS,
    INERTIAS,
    SHAFTS,
    THRUST,
    TORQUE,
    VACUUM,
    inputs_of,
    vehicle,
    wheel_momentum,
    wheels,
)


def test_free_motion_keeps_the_momentum_of_body_and_wheels() -> None:
    """Motors, friction and the lag of a rotor are inside: in a vacuum the whole keeps what it has."""
    model = vehicle(environment=VACUUM)
    run = model.simulate(
        model.state(**START), (0.0, 20.0), rtol=1e-12, inputs=inputs_of(model), save_every=0.5
    )
    c, w = run.world_from_body, run.angular_velocity_body
    v = run.velocity_body + np.cross(w, BODY.com)
    inside = w @ BODY.inertia_about_com + wheel_momentum(run)
    angular, linear = (np.einsum("nij,nj->ni", c, part) for part in (inside, BODY.mass * v))
    # The integrator's tolerance, some thousand steps; the wheels have most of the momentum.
    for kept in (angular, linear):
        assert np.abs(kept - kept[0]).max() <= 1e-9 * np.linalg.norm(kept[0])
    # They exchanged it: speeds and rates changed by their own size.
    assert np.abs(wheel_momentum(run)[-1] - wheel_momentum(run)[0]).max() > 1.0


def test_wheels_against_their_own_momenta() -> None:
    """As states the momentum H of all and each wheel's own about its axis, l = J (W + aw): H' = 0, l' = t."""
    model = fb.Model(BODY, [wheels()])
    torques = np.array([0.2, -0.3, 0.0, 0.1])
    x0 = model.state(**START)
    times = np.linspace(0.0, 10.0, 41)
    run = model.simulate(x0, (0.0, 10.0), rtol=1e-12, inputs=torques, save_at=times)

    axes = AXES / np.linalg.norm(AXES, axis=1)[:, None]
    carrier = BODY.inertia_about_com - np.einsum("i,ij,ik->jk", INERTIAS, axes, axes)
    w0 = np.array(START["angular_velocity_body"])
    own = INERTIAS * (np.array([50.0, -30.0, 10.0, 20.0]) + axes @ w0)
    total = START["attitude"].as_rotation() @ (carrier @ w0 + axes.T @ own)

    def rates(t: float, y: Array) -> Array:
        c = y[:9].reshape(3, 3)
        w = np.linalg.solve(carrier, c.T @ total - axes.T @ (own + torques * t))
        return (c @ fb.forms.skew(w)).ravel()

    start = START["attitude"].as_rotation().ravel()
    apart = solve_ivp(rates, (0.0, 10.0), start, method="DOP853", rtol=1e-13, atol=1e-13, t_eval=times)
    attitude = apart.y.T.reshape(-1, 3, 3)
    # Both integrate to about 1e-12 a step, some hundred steps.
    assert np.abs(run.world_from_body - attitude).max() <= 1e-10
    for k, t in enumerate(times):
        w = np.linalg.solve(carrier, attitude[k].T @ total - axes.T @ (own + torques * t))
        speeds = (own + torques * t) / INERTIAS - axes @ w
        assert np.abs(run.angular_velocity_body[k] - w).max() <= 1e-9
        got = [run.states[f"reaction_wheels.wheel_{i}_speed"][k] for i in (1, 2, 3, 4)]
        np.testing.assert_allclose(got, speeds, rtol=0, atol=1e-9 * 50.0)


def test_a_gyrostat_is_a_body_with_a_wheel_that_keeps_its_speed() -> None:
    """A propeller in a vacuum at constant speed has the same constant momentum."""
    shaft = np.array([0.3, -0.2, 0.9])
    rotor = Propeller(VACUUM, [1, 2, 3], shaft, 1.0, thrust_coefficient=0.1, speed=300.0, inertia=0.02)
    momentum = 0.02 * 300.0 * shaft / np.linalg.norm(shaft)
    models = [fb.Model(BODY, [force]) for force in (rotor, GyroscopicMomentum(momentum))]
    x = models[0].state(**START)
    a, b = (model.derivative(0.0, x) for model in models)
    # A few products.
    np.testing.assert_allclose(a, b, rtol=0, atol=1e-14 * np.abs(b).max())


def test_power_of_motors_and_air() -> None:
    """dE/dt = sum of motor torque times speed, less friction, and what air gives at the hubs."""
    model = vehicle()
    forces = {force.name: force for force in model.forces}
    lift, pusher = (a / np.linalg.norm(a) for a in SHAFTS)
    shafts = [
        (f"reaction_wheels.wheel_{i + 1}_speed", a / np.linalg.norm(a), j)
        for i, (a, j) in enumerate(zip(AXES, INERTIAS, strict=True))
    ]
    shafts += [("lift.lift_speed", -lift, 0.01), ("pusher.pusher_speed", pusher, 0.02)]
    rng = np.random.default_rng(3)
    for _ in range(5):
        x = model.state(**START) * rng.uniform(0.7, 1.3, model.n_states)
        x[3:7] /= np.linalg.norm(x[3:7])
        u = inputs_of(model)
        rate = model.derivative(0.0, x, u)
        twist, twist_rate = x[7:13], rate[7:13]
        # Kinetic energy: body with its rotors at rest, and for each shaft J W (a w) + J W^2 / 2.
        power = twist @ BODY.spatial_inertia @ twist_rate
        motors = air = 0.0
        for name, axis, inertia in shafts:
            speed, speed_rate = x[model.auxiliary[name]], rate[model.auxiliary[name]]
            turned = axis @ twist[3:]
            power += inertia * (speed_rate * turned + speed * (axis @ twist_rate[3:]) + speed * speed_rate)
            # Motor, friction and air together turn the shaft relative to the body, with its speed.
            motors += inertia * (speed_rate + axis @ twist_rate[3:]) * speed
        for name, hub, axis, hand in (("lift", HUBS[0], lift, -1.0), ("pusher", HUBS[1], pusher, 1.0)):
            alone = fb.Model(BODY, [steady(forces[name])])
            speed = x[model.auxiliary[f"{name}.{name}_speed"]]
            given = alone.state()
            given[:13] = x[:13]
            # A steady rotor without inertia gives the body all that air does to it.
            wrench = alone.wrench(0.0, given, [speed])
            air += wrench @ twist
            assert hand * (wrench[3:] - np.cross(hub, wrench[:3])) @ axis < 0.0
        # A gyrostat does no work. Sums of some twenty products.
        assert power == pytest.approx(motors + air, rel=1e-11)


def steady(force: fb.Force) -> Propeller:
    """The propeller of the scene without inertia, its speed an input."""
    i = ("lift", "pusher").index(force.name)
    coefficients: list[dict[str, Any]] = [
        {"thrust_coefficient": THRUST, "torque_coefficient": TORQUE, "hand": "left"},
        {"thrust_coefficient": 0.1, "torque_coefficient": 0.02},
    ]
    return Propeller(AIR, HUBS[i], SHAFTS[i], (0.5, 0.4)[i], speed="speed", **coefficients[i])


def test_thrust_and_torque_are_those_of_the_coefficients() -> None:
    """At 20 m/s along its axis in still air, 40 turns a second."""
    air = Environment(atmosphere=UniformAtmosphere(1.2))
    propeller = Propeller(
        air, [1, 0, 0.5], [1, 0, 0], 2.0, thrust_coefficient=THRUST, torque_coefficient=TORQUE, speed="speed"
    )
    model = fb.Model(BODY, [propeller])
    x = model.state(velocity_body=[20.0, 3.0, -4.0])
    n, advance = 40.0, 20.0 / (40.0 * 2.0)
    thrust = 1.2 * n**2 * 2.0**4 * (0.12 - 0.05 * advance - 0.06 * advance**2)
    torque = 1.2 * n**2 * 2.0**5 * TORQUE(advance)
    got = model.wrench(0.0, x, [2.0 * np.pi * n])
    # The advance ratio is 1e-7 less, for the guard of a rotor at rest.
    np.testing.assert_allclose(got, [thrust, 0, 0, -torque, 0.5 * thrust, 0], rtol=1e-6, atol=1e-12)
    # At rest it gives nothing, and its derivative is finite.
    assert not model.wrench(0.0, x, [0.0]).any()
    assert all(np.isfinite(part).all() for part in model.jacobian(0.0, x, [0.0]))


def test_a_wheel_at_its_largest_speed_takes_no_more() -> None:
    wheel = ReactionWheels([[0, 0, 1]], 0.1, max_torque=0.5, max_speed=100.0)
    model = fb.Model(BODY, [wheel])
    run = model.simulate(model.state(), (0.0, 60.0), inputs=[2.0], save_every=1.0)
    speed, w = run.states["reaction_wheels.wheel_1_speed"], run.angular_velocity_body
    # The command of 2 N m is cut to 0.5: in ten seconds 5 N m s.
    momentum = 0.1 * (speed[10] + w[10, 2])
    assert momentum == pytest.approx(5.0, rel=1e-8)
    # The last 2 % go exponentially.
    assert 99.9 < speed[-1] < 100.0 + 1e-6
    assert "wheel_1 is at its largest speed" in run.outcome.message
    back = model.derivative(60.0, run.x[-1], [-0.3])[model.auxiliary["reaction_wheels.wheel_1_speed"]]
    assert back < -2.9
