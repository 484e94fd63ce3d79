"""Planets, starts and tracks of model files."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError

import freebody as fb
from freebody.environment import WGS84, Ellipsoid, Environment, FlatEarth, Planet, RoundEarth
from freebody.model_file.context import Context
from freebody.model_file.fields import Section
from freebody.model_file.planet_schema import (
    SECTIONS,
    AnyPlanet,
    StartOnPlanet,
    TrackTable,
    start_on_planet,
)
from freebody.model_file.problems import Source
from freebody.model_file.schema import Initial

FT = 0.3048


class Surroundings(Section):
    """[environment], as far as the planet goes."""

    planet: AnyPlanet


class Start(Initial, StartOnPlanet):
    """[initial], with the keys of both."""


def planet_of(text: str) -> Planet:
    return Surroundings.model_validate(tomllib.loads(text)).planet.planet()


def start_of(text: str, planet: Planet, point: Any = (0.0, 0.0, 0.0)) -> dict[str, Any]:
    start = Start.model_validate(tomllib.loads(text))
    turned = fb.Attitude.identity()
    if start.attitude is not None and start.attitude.angles is not None:
        turned = fb.Attitude.angles("zyx", start.attitude.angles)
    return start_on_planet(start, planet, turned, point, 100.0)


def constants(planet: Planet) -> dict[str, Any]:
    return {key: np.asarray(value).tolist() for key, value in vars(planet).items()}


@pytest.mark.parametrize(
    ("text", "planet"),
    [
        ('planet = "wgs84"', WGS84()),
        ('planet = "round_earth"', RoundEarth()),
        ('planet = "flat"', FlatEarth()),
        (
            """
            [planet]
            type = "wgs84"
            radius = "20925646.99508 ft"
            inverse_flattening = 298.257223563
            mu = "1.407644311e16 ft^3/s^2"
            j2 = 0.00108262982
            rotation_rate = "0.004178073 deg/s"
            angle = "90 deg"
            """,
            WGS84(
                20925646.99508 * FT,
                1.407644311e16 * FT**3,
                j2=0.00108262982,
                rotation_rate=np.deg2rad(0.004178073),
                angle=np.pi / 2,
            ),
        ),
        (
            'planet = { type = "ellipsoid", radius = "3396.2 km", mu = 4.2828e13, center = [1.0, 2.0, 3.0] }',
            Ellipsoid(3396.2e3, 4.2828e13, center=(1.0, 2.0, 3.0)),
        ),
        (
            'planet = { type = "round_earth", radius = "20902255.199 ft" }',
            RoundEarth(radius=20902255.199 * FT),
        ),
        (
            'planet = { type = "flat", gravity = "32 ft/s^2", axes = "enu", altitude = "100 ft" }',
            FlatEarth(32.0 * FT, "enu", altitude=100.0 * FT),
        ),
    ],
)
def test_planets(text, planet):
    made = planet_of(text)
    assert type(made) is type(planet)
    mine, yours = constants(made), constants(planet)
    assert mine.keys() == yours.keys()
    for key, value in yours.items():
        if isinstance(value, str):
            assert mine[key] == value, key
        else:  # the factors of units round once more
            np.testing.assert_allclose(mine[key], value, rtol=1e-15, err_msg=key)


def test_the_world_can_start_at_a_place():
    text = 'planet = { type = "wgs84", origin = { latitude = "28.5 deg", longitude = "-80.6 deg" } }'
    place = planet_of(text).place([0.0, 0.0, 0.0], 0.0)
    np.testing.assert_allclose(np.rad2deg([place.latitude, place.longitude]), [28.5, -80.6], rtol=1e-14)
    assert place.altitude == pytest.approx(0.0, abs=2e-9)


def test_nesc_case_9():
    """NASA/TM-2015-218675, case 9: fired eastward and up from the equator, looking east."""
    planet = WGS84()
    state = start_of(
        """
        latitude = 0.0
        longitude = 0.0
        altitude = 0.0
        velocity_ned = "[0, 1000, -1000] ft/s"
        attitude = { angles = "[90, 0, 0] deg", sequence = "zyx" }
        """,
        planet,
    )
    time = 100.0
    place = planet.place(state["position"], time)
    relative = state["velocity_world"] - planet.ground_velocity(state["position"])
    np.testing.assert_allclose(place.world_from_ned.T @ relative / FT, [0, 1000, -1000], atol=1e-11)
    body_axes = place.world_from_ned.T @ state["attitude"].as_rotation()
    np.testing.assert_allclose(body_axes, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)
    np.testing.assert_array_equal(state["angular_velocity_body"], 0.0)


def test_the_orbit_of_jeod_run_10a():
    state = start_of(
        """
        position = [-4292653.41, 955168.47, 5139356.57]
        velocity_world = [109.649663, -7527.726490, 1484.521489]
        attitude = { angles = "[0, 85, 0] deg", sequence = "zyx" }
        attitude_relative_to = "lvlh"
        rates_relative_to = "lvlh"
        """,
        RoundEarth(),
        point=(6.0, 0.0, 0.0),
    )
    turned = state["attitude"].as_rotation()
    rate = turned @ state["angular_velocity_body"]
    com = state["position"] + 6.0 * turned[:, 0]
    np.testing.assert_allclose(com, [-4292653.41, 955168.47, 5139356.57], rtol=1e-15)
    np.testing.assert_allclose(rate @ com, 0.0, atol=1e-12)
    velocity = state["velocity_world"] + np.cross(rate, com - state["position"])
    np.testing.assert_allclose(velocity, [109.649663, -7527.726490, 1484.521489], atol=1e-11)


def test_frames_when_none_is_named():
    planet = WGS84()
    by_place = start_of("latitude = 0.5\nlongitude = 1.0", planet)
    ned = planet.place(by_place["position"], 100.0).world_from_ned
    np.testing.assert_allclose(by_place["attitude"].as_rotation(), ned, atol=1e-15)
    by_position = start_of("position_earth = [7e6, 1e6, 0.0]", planet)
    np.testing.assert_array_equal(by_position["attitude"].as_rotation(), np.eye(3))
    for state in (by_place, by_position):
        ground = planet.ground_velocity(state["position"])
        np.testing.assert_array_equal(state["velocity_world"], ground)


def test_rates_in_world_axes():
    state = start_of("latitude = 0.5\nlongitude = 1.0\nangular_velocity_world = [0.1, 0.2, 0.3]", WGS84())
    rate = state["attitude"].as_rotation() @ state["angular_velocity_body"]
    np.testing.assert_allclose(rate, [0.1, 0.2, 0.3], atol=1e-15)


def test_the_gravity_of_the_file_and_a_track_of_it():
    body = fb.RigidBody(2.0, com=[1.0, 0.0, 0.0], inertia_about_com=np.eye(3))
    environment = Environment(WGS84())
    context = Context(body, environment, Source(Path("a.toml"), {}, {}), "forces[0]")
    (gravity,) = SECTIONS
    force = gravity.model_validate({"type": "gravity", "name": "Earth"}).element(context)
    model = fb.Model(body, [force])
    start = start_of("latitude = 0.5\nlongitude = 1.0\naltitude = '1 km'", environment.planet, body.com)
    run = model.simulate(model.state(**start), (100.0, 101.0))
    tables = [
        {"point": "com", "site": {"latitude": "0.5 rad", "longitude": 1.0}},
        {"point": "[1, 0, 0] m"},
        {},
    ]
    by_name, by_place, origin = (TrackTable.model_validate(table).track(run, environment) for table in tables)
    assert by_name.altitude[0] == pytest.approx(1000.0)
    assert by_name.position_enu[0, 2] == pytest.approx(1000.0)
    np.testing.assert_array_equal(by_place.altitude, by_name.altitude)
    np.testing.assert_array_equal(origin.position_world, run.position_world)


@pytest.mark.parametrize(
    ("kind", "text", "message"),
    [
        (Surroundings, 'planet = "wgs72"', "unknown planet 'wgs72'; did you mean 'wgs84'"),
        (Surroundings, "planet = { mu = 1.0 }", "the key type is missing"),
        (Surroundings, 'planet = { type = "ellipsoid", radius = 1.0 }', "this key is missing"),
        (Surroundings, 'planet = { type = "wgs84", mass = 1.0 }', "unknown key"),
        (Surroundings, 'planet = { type = "round_earth", j2 = 1.0 }', "unknown key"),
        (Surroundings, 'planet = { type = "wgs84", mu = "1 kg" }', "gravitational parameter"),
        (
            Surroundings,
            'planet = { type = "wgs84", flattening = 0.1, inverse_flattening = 10.0 }',
            "takes one of flattening, inverse_flattening",
        ),
        (
            Surroundings,
            'planet = { type = "wgs84", center = [0, 0, 0], origin = { latitude = 0.0, longitude = 0.0 } }',
            "takes one of center, origin",
        ),
        (Start, "velocity_ned = [0, 0, 0]\nvelocity_enu = [0, 0, 0]", "takes one of velocity_ned"),
        (Start, "velocity_body = [0, 0, 0]\nlatitude = 0.1", "does not go with keys of the planet"),
        (Start, "position = [0, 0, 0]\nlatitude = 0.1", "takes one of position"),
        (Start, 'attitude_relative_to = "eci"', "unknown word 'eci'"),
        (Start, "latitude = 45.0", "-90 to 90 degrees; came 45.0, write"),
        (TrackTable, 'point = "tip"', "needs .origin., .com. or three numbers"),
        (TrackTable, "site = { latitude = 2.0, longitude = 0.0 }", "-90 to 90 degrees"),
    ],
)
def test_wrong_sections(kind, text, message):
    with pytest.raises(ValidationError, match=message):
        kind.model_validate(tomllib.loads(text))
