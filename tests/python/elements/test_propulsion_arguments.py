"""What thrusters, tanks, propellers and wheels refuse, and what they say."""

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import GyroscopicMomentum, Propeller, Propulsion, ReactionWheels, Tank, Thruster
from freebody.environment import Environment

POINT, UP = [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]


def wrong(value: Any) -> Any:
    """What no type checker would let pass."""
    return value


def thruster(**more: Any) -> Thruster:
    return Thruster(POINT, UP, 10.0, **more)


def propeller(**more: Any) -> Propeller:
    return Propeller(Environment(), POINT, UP, 1.0, **{"thrust_coefficient": 0.1, "speed": "n", **more})


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Thruster(POINT, POINT, 10.0), "thruster: direction: got the zero vector"),
        (lambda: Thruster(UP[:2], UP, 10.0), r"thruster: at: got shape \(2,\)"),
        (lambda: thruster(name="no word"), "thruster: name: got the name 'no word'"),
        (lambda: thruster(specific_impulse=200.0), "specific_impulse, tanks: one came without the other"),
        (lambda: thruster(tanks="fuel"), "specific_impulse, tanks: one came without the other"),
        (lambda: thruster(tanks=3.0, specific_impulse=2.0), "tanks: got 3.0; give the name of a tank"),
        (lambda: thruster(tanks={"fuel": 0.0}, specific_impulse=2.0), r"tanks\['fuel'\]: got 0.0"),
        (lambda: thruster(lag=0.0), "thruster: lag: got 0.0; give one finite positive number"),
        (lambda: thruster(throttle="full speed"), "throttle: got the name 'full speed'"),
        (lambda: thruster(gimbal=["pitch"]), r"gimbal\[0\]: got 'pitch'; give \(angle, axis\)"),
        (lambda: thruster(gimbal=[("pitch", POINT)]), r"gimbal\[0\]: axis: got the zero vector"),
        (lambda: Tank("fuel", -1.0, POINT, capacity=2.0), r"fuel: mass: got -1.0; allowed is 0 ... 2.0 kg"),
        (lambda: Tank("fuel", 0.0, POINT), "fuel: mass: got 0.0"),
        (lambda: Tank("fuel", 1.0, POINT, -np.eye(3)), "inertia_about_com: a principal moment is negative"),
        (lambda: Tank("fuel", 1.0, POINT, [[1, 1, 0], [0, 1, 0], [0, 0, 1]]), "not symmetric"),
        (lambda: Tank("fuel", 1.0, [POINT, UP], masses=[1.0, 2.0]), "masses: got .*rising masses, 0 first"),
        (lambda: Tank("fuel", 1.0, POINT, masses=[0.0, 2.0]), r"fuel: com: got shape \(3,\)"),
        (lambda: Tank("fuel", 1.0, [POINT, UP], masses=[0.0, 2.0], capacity=3.0), "capacity: got 3.0"),
        (lambda: Propulsion(wrong(thruster())), "thrusters: got .*; give a list"),
        (lambda: Propulsion([thruster(), thruster()]), r"thrusters\[1\]: a second one called 'thruster'"),
        (lambda: Propulsion(wrong([Tank("fuel", 1.0, POINT)])), r"thrusters\[0\]: got .*; give a Thruster"),
        (
            lambda: Propulsion([thruster(tanks="fule", specific_impulse=9.0)], [Tank("fuel", 1.0, POINT)]),
            "tanks: 'fule' is none of the tanks, 'fuel'",
        ),
        (lambda: Propulsion([thruster(exit_area=0.1)]), "exit_area: needs an environment"),
        (lambda: Thruster(POINT, UP, -1.0), "thrust: got -1; give a number of at least 0"),
        (lambda: thruster(exit_radius=-0.1), "exit_radius: got -0.1; give a number of at least 0"),
        (lambda: thruster(gimbal=wrong(0.1)), r"gimbal: got 0.1; give a list of \(angle, axis\)"),
        (lambda: Propulsion([thruster()], [], wrong(1.2)), "environment: got 1.2; give an Environment"),
        (lambda: propeller(inertia=-1.0), "inertia: got -1; give a number of at least 0"),
        (lambda: propeller(torque="t"), "propeller: speed, torque: give one of the two"),
        (lambda: propeller(speed=None), "propeller: speed, torque: give one of the two"),
        (lambda: propeller(speed=None, torque="t", inertia=1.0, lag=0.1), "lag: belongs to a speed"),
        (lambda: propeller(speed=None, torque="t"), "inertia: got 0.0; give one finite positive number"),
        (lambda: propeller(hand="up"), "hand: got 'up'; allowed are 'right', 'left'"),
        (
            lambda: propeller(thrust_coefficient=fb.Table(([0, 1], [0, 1]), np.ones((2, 2)))),
            "thrust_coefficient: got a table of 2",
        ),
        (
            lambda: Propeller(wrong(None), POINT, UP, 1.0, thrust_coefficient=1.0, speed=1.0),
            "environment: got None",
        ),
        (lambda: ReactionWheels([1, 0, 0], 0.1), r"axes: got shape \(3,\); give \(n, 3\)"),
        (lambda: ReactionWheels(np.eye(3), -0.1), "inertias: got -0.1; every one must be positive"),
        (lambda: ReactionWheels(np.eye(3), 0.1, torques=["a"]), "torques: got .* for each of 3 wheels"),
        (lambda: ReactionWheels(np.eye(3), [0.1, 0.2]), r"inertias: got shape \(2,\)"),
        (
            lambda: ReactionWheels(np.eye(3), 0.1, torques=wrong(0.5)),
            "torques: got 0.5; give a name or a number",
        ),
        (lambda: ReactionWheels(np.eye(3), 0.1, coulomb=-1.0), "coulomb: got -1.0"),
        (lambda: GyroscopicMomentum([1.0, 2.0]), r"momentum: got shape \(2,\)"),
    ],
)
def test_wrong_arguments_are_named(make: Any, message: str) -> None:
    with pytest.raises(fb.InputError, match=message):
        make()


def test_numbers_in_place_of_inputs_are_parameters() -> None:
    fixed = Propulsion([thruster(throttle=0.4, gimbal=[(0.02, [1, 0, 0])])])
    assert fixed.inputs == ()
    assert fixed.parameters == {"thruster_thrust": 10.0, "thruster_throttle": 0.4, "thruster_gimbal_1": 0.02}
    turned = fixed(thruster_gimbal_1="90 deg")
    body = fb.RigidBody(1.0, inertia_about_com=np.eye(3))
    model = fb.Model(body, [turned])
    # Turned from the third axis about the first; a cosine of a right angle.
    np.testing.assert_allclose(model.wrench(0.0, model.state())[:3], [0.0, -4.0, 0.0], rtol=0, atol=1e-15)


def test_throttles_are_cut_off() -> None:
    model = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [Propulsion([thruster(throttle="t")])])
    assert [model.wrench(0.0, model.state(), [u])[2] for u in (-1.0, 0.5, 7.0)] == [0.0, 5.0, 10.0]
