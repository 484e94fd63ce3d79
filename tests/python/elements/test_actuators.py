"""Actuators: closed step responses, stops and rates, and what reads them."""

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import Actuator, Propeller
from freebody.environment import Environment

BODY = fb.RigidBody(2.0, inertia_about_com=np.diag([0.2, 0.3, 0.35]))


def response(actuator, command, end=2.0, **start):
    model = fb.Model(BODY, [actuator])
    states = {f"{actuator.name}.{name}": value for name, value in start.items()}
    return model.simulate(
        model.state(states=states), (0.0, end), rtol=1e-11, save_every=0.01, inputs=[command]
    )


def test_first_order_step():
    run = response(Actuator("elevator", time_constant=0.2), 0.3)
    # The integrator's tolerance.
    wanted = 0.3 * (1.0 - np.exp(-run.t / 0.2))
    np.testing.assert_allclose(run.states["elevator_actuator.elevator"], wanted, rtol=0, atol=1e-9)


def test_second_order_step():
    w, z = 20.0, 0.5
    run = response(Actuator("elevator", natural_frequency=w, damping=z), 0.3)
    damped = w * np.sqrt(1.0 - z * z)
    swing = np.cos(damped * run.t) + z * w / damped * np.sin(damped * run.t)
    wanted = 0.3 * (1.0 - np.exp(-z * w * run.t) * swing)
    np.testing.assert_allclose(run.states["elevator_actuator.elevator"], wanted, rtol=0, atol=1e-9)


@pytest.mark.parametrize("dynamics", [{"time_constant": 0.05}, {"natural_frequency": 20.0, "damping": 0.2}])
def test_stops_and_rates_hold(dynamics: dict[str, Any]):
    actuator = Actuator("elevator", limits=(-0.1, 0.4), rate_limit=1.5, **dynamics)
    for command, (low, high) in ((2.0, (0.39, 0.4)), (-2.0, (-0.1, -0.09))):
        run = response(actuator, command)
        x = run.states["elevator_actuator.elevator"]
        # Beyond by the error of a step at most.
        assert x.min() >= -0.1 - 1e-9
        assert x.max() <= 0.4 + 1e-9
        assert np.abs(np.diff(x)).max() <= 1.5 * 0.01 * (1.0 + 1e-9)
        assert low - 1e-9 <= x[-1] <= high + 1e-9
    # Back at once, for the command is what is clipped and nothing winds up.
    from_stop = response(actuator, 0.0, elevator=0.4)
    assert abs(from_stop.states["elevator_actuator.elevator"][-1]) < 5e-3


def test_it_comes_back_from_outside():
    ways: list[dict[str, Any]] = [{"time_constant": 0.05}, {"natural_frequency": 20.0}]
    for dynamics in ways:
        run = response(Actuator("elevator", limits=(-0.1, 0.1), **dynamics), 0.0, elevator=0.5)
        assert abs(run.states["elevator_actuator.elevator"][-1]) < 1e-6


def test_others_read_its_signal():
    """What was an input of the model is the actuator's position; its command is the input."""
    propeller = Propeller(Environment(), [0, 0, 0], [0, 0, 1], 0.3, thrust_coefficient=0.1, speed="speed")
    motor = Actuator("speed", time_constant=0.1, unit="rad/s", limits=(0.0, 500.0), initial=100.0)
    model = fb.Model(BODY, [propeller, motor])
    assert model.input_names == ("speed_command",)
    alone = fb.Model(BODY, [propeller])
    x = model.state()
    np.testing.assert_array_equal(model.wrench(0.0, x, [300.0]), alone.wrench(0.0, x[:13], [100.0]))
    assert model.derivative(0.0, x, [900.0])[-1] == pytest.approx(4000.0, rel=1e-15)


def test_a_command_may_be_a_number():
    flap = Actuator("flap", time_constant=0.5, command=0.2)
    model = fb.Model(BODY, [flap])
    assert flap.parameters["command"] == 0.2
    assert model.derivative(0.0, model.state())[-1] == pytest.approx(0.4, rel=1e-15)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "time_constant, natural_frequency: give one of the two"),
        ({"time_constant": 0.1, "natural_frequency": 1.0}, "give one of the two"),
        ({"time_constant": 0.1, "damping": 0.7}, "damping: an actuator of the first order has none"),
        ({"time_constant": -0.1}, "time_constant: got -0.1; give one finite positive number"),
        ({"natural_frequency": 1.0, "damping": -0.1}, "damping: got -0.1"),
        ({"time_constant": 0.1, "limits": (1.0, -1.0)}, "limits: got .*low first"),
        ({"time_constant": 0.1, "rate_limit": 0.0}, "rate_limit: got 0.0"),
        ({"time_constant": 0.1, "command": "elevator"}, "command: got 'elevator', the signal itself"),
        ({"time_constant": 0.1, "command": "two words"}, "command: got the name 'two words'"),
    ],
)
def test_wrong_arguments_are_named(arguments, message):
    with pytest.raises(fb.InputError, match=message):
        Actuator("elevator", **arguments)


def test_the_signal_is_a_word():
    with pytest.raises(fb.InputError, match="signal: got the name 'not a word'"):
        Actuator("not a word", time_constant=0.1)
