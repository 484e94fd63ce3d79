"""How bodies start: in every frame, of any point of them."""

from __future__ import annotations

import tomllib
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.environment import WGS84, FlatEarth, RoundEarth, lvlh
from freebody.model_file import shipped_model

EARTH = WGS84(angle=0.2)
PLACE: dict[str, Any] = {"latitude": 0.6, "longitude": -1.4, "altitude": 3000.0, "time": 7000.0}
TURNED = fb.Attitude.angles("zyx", [0.5, -0.3, 1.1])
FRAMES = ("world", "earth", "ned", "enu", "lvlh")


def frame_axes(frame: str, position: Any, velocity: Any) -> Any:
    """Axes of a frame as columns, in world axes."""
    place = EARTH.place(position, PLACE["time"])
    north, east, down = place.world_from_ned.T
    return {
        "world": np.eye(3),
        "earth": EARTH.earth_from_world(PLACE["time"]).T,
        "ned": place.world_from_ned,
        "enu": np.column_stack([east, north, -down]),
        "lvlh": lvlh(position, velocity).world_from_lvlh,
    }[frame]


def test_what_is_left_out_rests_on_the_ground_and_looks_north():
    start = EARTH.motion(**PLACE)
    position = EARTH.position_world(*(PLACE[key] for key in ("latitude", "longitude", "altitude", "time")))
    np.testing.assert_array_equal(start["position"], position)
    np.testing.assert_array_equal(start["velocity_world"], EARTH.ground_velocity(position))
    np.testing.assert_array_equal(start["angular_velocity_body"], np.zeros(3))
    world_from_ned = EARTH.place(position, PLACE["time"]).world_from_ned
    np.testing.assert_allclose(start["attitude"].as_rotation(), world_from_ned, atol=1e-15)
    fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3))).state(**start)


def test_nesc_case_2():
    """NASA/TM-2015-218675, case 2: the state at the start, in ft, ft/s and deg/s."""
    start = WGS84().motion(
        latitude=0.0,
        longitude=0.0,
        altitude=30000 * 0.3048,
        angular_velocity_body=np.deg2rad([10.0, 20.0, 30.0]),
    )
    # Printed to twelve digits.
    np.testing.assert_allclose(start["position"], [2.09556463255e7 * 0.3048, 0.0, 0.0], atol=1e-5)
    np.testing.assert_allclose(start["velocity_world"][[0, 2]], 0.0, atol=1e-13)
    axes = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]
    np.testing.assert_allclose(start["attitude"].as_rotation(), axes, atol=1e-15)
    np.testing.assert_allclose(np.rad2deg(start["angular_velocity_body"]), [10.0, 20.0, 30.0], rtol=1e-15)


def test_jeod_runs_9_and_10():
    """The start of JEOD's SIM_dyncomp as the shipped file has it, of 40-digit arithmetic."""
    given = tomllib.loads(shipped_model("jeod_9a").read_text())["initial"]
    kinematics = {key: given[key] for key in ("position", "velocity_world")}
    start = RoundEarth(mu=3.986004415e14).motion(
        position_world=kinematics["position"],
        velocity_world=kinematics["velocity_world"],
        attitude=fb.Attitude.angles("yxz", [np.deg2rad(-11.6), 0.0, 0.0]),
        relative_to="lvlh",
    )
    np.testing.assert_allclose(
        start["attitude"].as_rotation(), given["attitude"]["rotation"], rtol=0, atol=1e-15
    )
    # Run 10A: the rate of LVLH is h/r² about -y.
    r, v = np.array(kinematics["position"]), np.array(kinematics["velocity_world"])
    rate = lvlh(r, v).angular_velocity_world
    np.testing.assert_allclose(rate, np.cross(r, v) / (r @ r), rtol=1e-15)


@pytest.mark.parametrize("frame", FRAMES)
def test_attitude_relative_to_every_frame(frame):
    velocity = [1000.0, 7000.0, -500.0]
    start = EARTH.motion(**PLACE, velocity_world=velocity, attitude=TURNED, relative_to=frame)
    axes = frame_axes(frame, start["position"], velocity)
    np.testing.assert_allclose(axes.T @ start["attitude"].as_rotation(), TURNED.as_rotation(), atol=1e-15)


@pytest.mark.parametrize("frame", FRAMES)
def test_a_body_without_rate_in_a_frame_turns_with_its_axes(frame):
    velocity = np.array([1000.0, 7000.0, -500.0])
    start = EARTH.motion(**PLACE, velocity_world=velocity, attitude=TURNED, rates_relative_to=frame)
    position, time, step = start["position"], PLACE["time"], 0.05

    def axes(dt: float) -> Any:
        moved = position + dt * velocity
        if frame == "earth":
            return EARTH.earth_from_world(time + dt).T
        if frame in ("ned", "enu"):
            return EARTH.place(moved, time + dt).world_from_ned
        return np.eye(3) if frame == "world" else lvlh(moved, velocity).world_from_lvlh

    turning = (axes(step) - axes(-step)) / (2.0 * step) @ axes(0.0).T
    omega = start["attitude"].as_rotation() @ start["angular_velocity_body"]
    # Rates of 1e-3 rad/s; a third derivative of some 1e-9 rad/s³ over six, times step².
    np.testing.assert_allclose([turning[2, 1], turning[0, 2], turning[1, 0]], omega, atol=1e-11)


@pytest.mark.parametrize("key", ["velocity_ned", "velocity_enu", "velocity_earth"])
def test_velocities_relative_to_the_turning_earth(key):
    given = np.array([30.0, -40.0, 5.0])
    keys: dict[str, Any] = {**PLACE, key: given}
    start = EARTH.motion(**keys)
    axes = frame_axes(key.removeprefix("velocity_"), start["position"], start["velocity_world"])
    relative = start["velocity_world"] - EARTH.ground_velocity(start["position"])
    np.testing.assert_allclose(relative, axes @ given, atol=1e-12)


def test_a_place_by_its_coordinates_on_earth():
    by_angles = EARTH.motion(**PLACE)["position"]
    on_earth = EARTH.earth_from_world(PLACE["time"]) @ by_angles
    start = EARTH.motion(position_earth=on_earth, time=PLACE["time"])
    np.testing.assert_allclose(start["position"], by_angles, rtol=1e-15)


def test_of_a_point_that_is_not_the_origin():
    point, rate = np.array([3.0, -1.0, 2.0]), np.array([0.3, 0.2, -0.5])
    given: dict[str, Any] = {**PLACE, "velocity_ned": [50.0, 0.0, -3.0], "attitude": TURNED}
    at_origin = EARTH.motion(**given, angular_velocity_body=rate)
    at_point = EARTH.motion(**given, angular_velocity_body=rate, point=point)
    turned = at_point["attitude"].as_rotation()
    np.testing.assert_allclose(at_point["position"] + turned @ point, at_origin["position"], rtol=1e-15)
    swing = turned @ np.cross(at_point["angular_velocity_body"], point)
    np.testing.assert_allclose(at_point["velocity_world"] + swing, at_origin["velocity_world"], atol=1e-12)


def test_over_a_flat_earth():
    start = FlatEarth(axes="enu").motion(altitude=20.0, velocity_ned=[1.0, 2.0, 3.0])
    np.testing.assert_array_equal(start["position"], [0.0, 0.0, 20.0])
    np.testing.assert_array_equal(start["velocity_world"], [2.0, 1.0, -3.0])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({}, "latitude, longitude: both are needed"),
        ({"position_world": [7e6, 0, 0], "altitude": 1.0}, "position_world.*say where the point is once"),
        ({"position_world": [7e6, 0, 0], "position_earth": [7e6, 0, 0]}, "say where the point is once"),
        ({**PLACE, "velocity_ned": [1, 0, 0], "velocity_world": [1, 0, 0]}, "give one velocity"),
        ({**PLACE, "relative_to": "body"}, "relative_to: got 'body'; allowed are 'world', 'earth'"),
        ({**PLACE, "rates_relative_to": "eci"}, "rates_relative_to: got 'eci'"),
        ({**PLACE, "attitude": [0, 0, 0]}, "attitude: got .*Attitude.angles"),
        ({**PLACE, "velocity_ned": [1, 0]}, "velocity_ned: got shape"),
        ({**PLACE, "velocity_world": [0, 0, 0], "relative_to": "lvlh"}, "no orbital plane"),
    ],
)
def test_wrong_starts(given, message):
    with pytest.raises(fb.InputError, match=message):
        EARTH.motion(**given)
