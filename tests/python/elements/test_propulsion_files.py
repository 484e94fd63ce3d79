"""The keys of propulsion in model files make the elements that Python makes, in any unit."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody import elements
from freebody.environment import Environment
from freebody.model_file.shipped import shipped_model

HEAD = """
[model]
name = "test"
[body]
mass = 50.0
inertia_about_com = { principal = [30.0, 40.0, 50.0] }
[simulation]
end = 1.0
"""


def model_of(text: str, folder: Path) -> fb.Model:
    path = folder / "test.toml"
    path.write_text(HEAD + text)
    return fb.load(path).model


def same(text: str, elements: list[fb.Force], folder: Path) -> None:
    """The file's forces are these, but for the rounding of units."""
    model = model_of(text, folder)
    other = fb.Model(model.body, elements)
    assert model.state_names == other.state_names
    assert model.input_names == other.input_names
    assert [f.inputs for f in model.forces] == [f.inputs for f in elements]
    rng = np.random.default_rng(1)
    for _ in range(5):
        x, u = rng.normal(size=model.n_states), rng.normal(size=model.n_inputs)
        x[3:7] /= np.linalg.norm(x[3:7])
        a, b = model.derivative(0.0, x, u), other.derivative(0.0, x, u)
        np.testing.assert_allclose(a, b, rtol=1e-12, atol=1e-12 * np.abs(b).max())


def test_propulsion(tmp_path: Path) -> None:
    text = """
    [[forces]]
    type = "propulsion"
    [[forces.thrusters]]
    name = "main"
    at = "[0, 10, -100] cm"
    direction = [0, 0, 1]
    thrust = "0.12 kN"
    specific_impulse = "80 s"
    tanks = { fuel = 3, oxygen = 7 }
    throttle = "throttle"
    lag = "500 ms"
    gimbal = [{ angle = "pitch", axis = [0, 1, 0] }, { angle = "2 deg", axis = [1, 0, 0] }]
    exit_area = "1 cm^2"
    exit_radius = "15 cm"
    [[forces.tanks]]
    name = "fuel"
    mass = "4 kg"
    com = [0.1, 0.0, 0.2]
    inertia_about_com = [0.05, 0.06, 0.07]
    capacity = "5 kg"
    tail_off = "10 g"
    [[forces.tanks]]
    name = "oxygen"
    mass = 5.0
    masses = "[0, 2, 6] kg"
    com = [[0.0, 0.0, 0.1], [0.0, 0.1, 0.2], [0.1, 0.1, 0.3]]
    inertia_about_com = [[0, 0, 0], [0.1, 0.1, 0.2], [0.3, 0.4, 0.5]]
    """
    main = elements.Thruster(
        [0.0, 0.1, -1.0],
        [0, 0, 1],
        120.0,
        specific_impulse=80.0,
        tanks={"fuel": 3.0, "oxygen": 7.0},
        throttle="throttle",
        lag=0.5,
        gimbal=[("pitch", [0, 1, 0]), (np.deg2rad(2.0), [1, 0, 0])],
        exit_area=1e-4,
        exit_radius=0.15,
        name="main",
    )
    tensor = np.diag([0.05, 0.06, 0.07])
    fuel = elements.Tank("fuel", 4.0, [0.1, 0, 0.2], tensor, capacity=5.0, tail_off=0.01)
    oxygen = elements.Tank(
        "oxygen",
        5.0,
        [[0.0, 0.0, 0.1], [0.0, 0.1, 0.2], [0.1, 0.1, 0.3]],
        [np.zeros((3, 3)), np.diag([0.1, 0.1, 0.2]), np.diag([0.3, 0.4, 0.5])],
        masses=[0.0, 2.0, 6.0],
    )
    same(text, [elements.Propulsion([main], [fuel, oxygen], Environment())], tmp_path)


def test_propellers_wheels_and_actuators(tmp_path: Path) -> None:
    text = """
    [[forces]]
    type = "propeller"
    name = "left"
    at = "[0, -50, 0] cm"
    axis = [1, 0, 0]
    diameter = "60 cm"
    thrust_coefficient = [0.1, -0.05]
    torque_coefficient = { advance_ratio = [0, 1], values = [0.01, 0.02] }
    hand = "left"
    speed = "rotor"
    lag = "0.2 s"
    inertia = "2 g m^2"
    initial_speed = "600 rpm"
    [[forces]]
    type = "propeller"
    name = "right"
    at = "[0, 50, 0] cm"
    axis = [1, 0, 0]
    diameter = 0.6
    thrust_coefficient = 0.1
    torque = "3 N m"
    inertia = 0.002
    wake_fraction = 0.1
    thrust_deduction = 0.05
    [[forces]]
    type = "actuator"
    signal = "rotor"
    unit = "rad/s"
    natural_frequency = "20 rad/s"
    damping = 0.7
    limits = "[0, 3000] rpm"
    rate_limit = "1000 rad/s^2"
    initial = "600 rpm"
    [[forces]]
    type = "actuator"
    signal = "wheel_torque"
    unit = "N m"
    time_constant = "10 ms"
    command = 0.1
    [[forces]]
    type = "reaction_wheels"
    axes = [[1, 0, 0], [0, 1, 1]]
    inertias = "[50, 60] g m^2"
    torques = ["wheel_torque", "-20 mN m"]
    max_torque = 0.3
    max_speed = "5000 rpm"
    viscous = 1e-5
    coulomb = "1 mN m"
    stiction_speed = "2 rad/s"
    initial_speeds = [1.0, -2.0]
    prefix = "spin"
    [[forces]]
    type = "gyroscopic_momentum"
    momentum = "[1, 2, 3] N m s"
    """
    e, rpm = elements, np.pi / 30.0
    air = Environment()
    left = e.Propeller(
        air,
        [0, -0.5, 0],
        [1, 0, 0],
        0.6,
        thrust_coefficient=[0.1, -0.05],
        torque_coefficient=fb.Table([0, 1], [0.01, 0.02]),
        hand="left",
        speed="rotor",
        lag=0.2,
        inertia=0.002,
        initial_speed=600 * rpm,
        name="left",
    )
    right = e.Propeller(
        air,
        [0, 0.5, 0],
        [1, 0, 0],
        0.6,
        thrust_coefficient=0.1,
        torque=3.0,
        inertia=0.002,
        wake_fraction=0.1,
        thrust_deduction=0.05,
        name="right",
    )
    rotor = e.Actuator(
        "rotor",
        unit="rad/s",
        natural_frequency=20.0,
        damping=0.7,
        limits=(0.0, 3000 * rpm),
        rate_limit=1000.0,
        initial=600 * rpm,
    )
    motor = e.Actuator("wheel_torque", unit="N m", time_constant=0.01, command=0.1)
    wheels = e.ReactionWheels(
        [[1, 0, 0], [0, 1, 1]],
        [0.05, 0.06],
        torques=["wheel_torque", -0.02],
        max_torque=0.3,
        max_speed=5000 * rpm,
        viscous=1e-5,
        coulomb=1e-3,
        stiction_speed=2.0,
        initial_speeds=[1.0, -2.0],
        prefix="spin",
    )
    same(text, [left, right, rotor, motor, wheels, e.GyroscopicMomentum([1, 2, 3])], tmp_path)


FAULTS: list[Any] = [
    ('type = "actuator"\nsignal = "a"', "forces[0]: needs exactly one of time_constant, natural_frequency"),
    (
        'type = "actuator"\nsignal = "a"\ntime_constant = 1\nlimits = "[0, 1] m"',
        "forces[0].limits: 'm' is no unit of an angle (rad)",
    ),
    ('type = "actuator"\nsignal = "a b"\ntime_constant = 1', "signal: got the name 'a b'"),
    (
        'type = "propulsion"\nthrusters = [{ at = [0, 0, 0], direction = [0, 0, 0], thrust = 1 }]',
        "forces[0].thrusters[0]: thruster: direction: got the zero vector",
    ),
    (
        'type = "propulsion"\nthrusters = [{ at = [0, 0, 0], direction = [0, 0, 1], thrust = "1 kg" }]',
        "forces[0].thrusters[0].thrust: 'kg' is no unit of a force (N)",
    ),
    (
        'type = "propulsion"\nthrusters = []\ntanks = [{ name = "a", mass = 1, com = [1, 2] }]',
        "forces[0].tanks[0].com",
    ),
    (
        'type = "propeller"\nat = [0, 0, 0]\naxis = [1, 0, 0]\ndiameter = 1\nthrust_coefficient = 1',
        "forces[0]: needs exactly one of speed, torque",
    ),
    (
        'type = "propeller"\nat = [0, 0, 0]\naxis = [1, 0, 0]\ndiameter = 1\nspeed = "3 m"\n'
        "thrust_coefficient = 1",
        "forces[0].speed: 'm' is no unit of an angular velocity (rad/s)",
    ),
    (
        'type = "reaction_wheels"\naxes = [[1, 0, 0]]\ninertias = "1 kg"',
        "forces[0].inertias: 'kg' is no unit",
    ),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_faults_are_told_by_key(text: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(fb.ModelFileError) as raised:
        model_of(f"[[forces]]\n{text}\n", tmp_path)
    assert message in str(raised.value)


@pytest.mark.parametrize("name", ["quadrotor", "gyrostat"])
def test_the_vehicles_run(name: str) -> None:
    run = fb.load(shipped_model(name)).simulate()
    assert run.ok


def test_the_mass_centre_at_the_start_is_that_of_the_whole(tmp_path: Path) -> None:
    path = tmp_path / "fuelled.toml"
    path.write_text("""
    [model]
    name = "fuelled"
    [body]
    mass = 10.0
    com = [1.0, 0.0, 0.0]
    inertia_about_com = { principal = [1.0, 2.0, 2.0] }
    [[forces]]
    type = "propulsion"
    tanks = [{ name = "fuel", mass = 30.0, com = [-1.0, 0.0, 0.0], inertia_about_com = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }]
    thrusters = [{ name = "jet", at = [-3.0, 0.0, 0.0], direction = [1.0, 0.0, 0.0], thrust = 0.0 }]
    [initial]
    point = "com"
    position = [5.0, 0.0, 0.0]
    [simulation]
    end = 1.0
    """)  # noqa: E501  (one line of the file)
    run = fb.load(path).simulate()
    assert isinstance(run, fb.Trajectory)
    assert run.com[0].tolist() == [-0.5, 0.0, 0.0]
    assert run.com_position_world[0].tolist() == [5.0, 0.0, 0.0]
