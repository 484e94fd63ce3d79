"""Geodetic coordinates and the frames of planets, against an independent method in fifty digits."""

from __future__ import annotations

import pickle
from typing import Any

import mpmath as mp
import numpy as np
import pytest

import freebody as fb
from freebody.environment import WGS84, Ellipsoid, FlatEarth, Planet, RoundEarth

EARTH = WGS84()
SATURN = Ellipsoid(60268e3, 3.7931e16, 0.09796)
LATITUDES = (*np.linspace(-np.pi / 2, np.pi / 2, 33), 1e-300, -1e-9, 1e-4, np.pi / 2 - 1e-7)
HEIGHTS = (-1e4, -1.0, 0.0, 9144.0, 4e5, 3.6e7, 1e9)


def geodetic_by_bowring(p: float, z: float, radius: float, flattening: float) -> tuple[Any, Any]:
    """Latitude and altitude by Bowring's iteration (Survey Review 23, 1976) until it stands still."""
    with mp.workdps(50):
        a, f = mp.mpf(radius), mp.mpf(flattening)
        b = a * (1 - f)
        e2, second = f * (2 - f), (a / b) ** 2 - 1
        beta, phi = mp.atan2(a * z, b * p), mp.mpf(0)
        for _ in range(60):
            phi = mp.atan2(z + second * b * mp.sin(beta) ** 3, p - e2 * a * mp.cos(beta) ** 3)
            beta = mp.atan2(b * mp.sin(phi), a * mp.cos(phi))
        height = p * mp.cos(phi) + z * mp.sin(phi) - a * mp.sqrt(1 - e2 * mp.sin(phi) ** 2)
        return phi, height


@pytest.mark.parametrize("planet", [EARTH, SATURN], ids=["Earth", "Saturn"])
@pytest.mark.parametrize("height", HEIGHTS)
def test_latitude_and_altitude_are_right_from_below_the_ground_to_beyond_the_moon(planet, height):
    # Two roundings of the distance from the centre, 0.9e-9 m each at the Earth's surface.
    metres = 2.0 * np.spacing(planet.radius + height)
    for latitude in LATITUDES:
        x, _, z = planet.position_world(latitude, 0.0, height)
        place = planet.place([x, 0.0, z], 0.0)
        phi, h = geodetic_by_bowring(x, z, planet.radius, planet.flattening)
        assert abs(float(mp.mpf(float(place.latitude)) - phi)) <= 1e-15
        assert abs(float(mp.mpf(float(place.altitude)) - h)) <= metres


def test_there_and_back_in_arrays_of_any_shape(rng):
    latitude, longitude = rng.uniform(-1.5, 1.5, (4, 5)), rng.uniform(-np.pi, np.pi, (4, 5))
    altitude = rng.uniform(-1e4, 1e6, (4, 5))
    position = EARTH.position_world(latitude, longitude, altitude, time=1234.5)
    place = EARTH.place(position, 1234.5)
    assert position.shape == (4, 5, 3)
    # A rounding of the position, 1e-9 m, is 1.5e-16 rad; near the poles longitude has 14 times that.
    np.testing.assert_allclose(place.latitude, latitude, rtol=0, atol=1e-15)
    np.testing.assert_allclose(place.longitude, longitude, rtol=0, atol=5e-15)
    np.testing.assert_allclose(place.altitude, altitude, rtol=0, atol=4e-9)


def test_longitude_lies_above_minus_pi_and_up_to_pi():
    for y, expected in ((0.0, np.pi), (-0.0, np.pi), (1.0, np.pi), (-1.0, -np.pi)):
        longitude = EARTH.place([-7e6, y, 0.0], 0.0).longitude
        assert -np.pi < longitude <= np.pi
        assert longitude == pytest.approx(expected, abs=2e-7)


def test_the_pole_has_longitude_zero_and_axes_along_its_meridian():
    planet = WGS84(angle=0.4)
    for sign in (1.0, -1.0):
        place = planet.place([0.0, 0.0, sign * 6.4e6], 100.0)
        assert place.longitude == 0.0
        assert place.latitude == sign * np.pi / 2
        north_at_earth = planet.earth_from_world(100.0) @ place.world_from_ned[:, 0]
        np.testing.assert_allclose(north_at_earth, [-sign, 0.0, 0.0], atol=1e-15)


def test_the_centre_has_latitude_and_longitude_zero():
    place = EARTH.place([0.0, 0.0, 0.0], 0.0)
    assert (place.latitude, place.longitude, place.altitude) == (0.0, 0.0, -EARTH.radius)
    np.testing.assert_array_equal(place.world_from_ned[:, 2], [-1.0, 0.0, 0.0])


def test_near_the_centre_everything_is_finite(rng):
    position = rng.normal(size=(1000, 3)) * np.geomspace(1e-200, 1e5, 1000)[:, None]
    place = EARTH.place(position, 0.0)
    assert all(np.isfinite(part).all() for part in place)


@pytest.mark.parametrize("planet", [EARTH, WGS84(angle=1.0), RoundEarth(rotation_rate=-1e-4)])
def test_local_axes_are_those_of_growing_latitude_longitude_and_depth(planet):
    latitude, longitude, altitude, time, step = 0.7, -2.0, 5000.0, 3600.0, 1e-6
    here = planet.position_world(latitude, longitude, altitude, time)
    axes = planet.place(here, time).world_from_ned
    moved = (
        planet.position_world(latitude + step, longitude, altitude, time),
        planet.position_world(latitude, longitude + step, altitude, time),
        planet.position_world(latitude, longitude, altitude - 1.0, time),
    )
    for axis, point in zip(axes.T, moved, strict=True):
        # The curve bends away by half a step.
        np.testing.assert_allclose((point - here) / np.linalg.norm(point - here), axis, atol=step)
    np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-15)
    assert np.linalg.det(axes) == pytest.approx(1.0)


def test_the_ground_goes_with_the_velocity_of_the_ground():
    for planet in (EARTH, RoundEarth(rotation_rate=2e-4, center=(1e6, 2.0, 3.0))):
        before, here, after = (planet.position_world(0.5, 1.0, 2e4, t) for t in (9.5, 10.0, 10.5))
        # Chord against tangent: r ω³ dt³/24 is 2e-6 m at most.
        np.testing.assert_allclose(after - before, planet.ground_velocity(here), atol=3e-6)


def test_axes_that_go_along_with_a_point_turn_as_their_rate_says():
    velocity = np.array([-300.0, 8000.0, 500.0])
    here = EARTH.position_world(0.9, 0.3, 1e5, 50.0)
    rate = EARTH.ned_rate(here, velocity, 50.0)
    step = 0.05
    before, after = (EARTH.place(here + dt * velocity, 50.0 + dt).world_from_ned for dt in (-step, step))
    turning = (after - before) / (2.0 * step) @ EARTH.place(here, 50.0).world_from_ned.T
    expected = [[0.0, -rate[2], rate[1]], [rate[2], 0.0, -rate[0]], [-rate[1], rate[0], 0.0]]
    # Rates of 2e-3 rad/s; the third derivative over six is 1e-9 rad/s³, times step²: 1e-11.
    np.testing.assert_allclose(turning, expected, atol=1e-10)


def test_a_world_that_starts_near_the_vehicle_keeps_the_digits():
    site = EARTH.position_world(0.5, 0.6, 100.0)
    local = WGS84(center=-site)
    position = [1e-12, 0.0, 0.0]
    assert local.place(position, 0.0).altitude == pytest.approx(100.0, abs=4e-9)
    np.testing.assert_array_equal(local.position_world(0.5, 0.6, 100.0), np.zeros(3))


def test_j2_of_wgs84_follows_from_its_defining_constants():
    """Heiskanen and Moritz, Physical Geodesy (1967), eqs. 2-90 and 2-58: J2 of a level ellipsoid."""
    with mp.workdps(40):
        f = mp.mpf(EARTH.flattening)
        e2 = f * (2 - f)
        s = mp.sqrt(e2 / (1 - e2))
        q0 = ((1 + 3 / s**2) * mp.atan(s) - 3 / s) / 2
        b = EARTH.radius * (1 - f)
        m = mp.mpf(EARTH.rotation_rate) ** 2 * mp.mpf(EARTH.radius) ** 2 * b / mp.mpf(EARTH.mu)
        j2 = float(e2 / 3 * (1 - 2 * m * s / (15 * q0)))
    # Printed to twelve digits.
    assert pytest.approx(j2, abs=1e-14) == EARTH.j2


@pytest.mark.parametrize("axes", ["ned", "enu"])
def test_flat_earth(axes):
    planet = FlatEarth(9.81, axes, latitude=0.3, longitude=4.0, altitude=50.0)
    up = planet.place([0.0, 0.0, 0.0], 0.0).world_from_ned @ [0.0, 0.0, -1.0]
    place = planet.place(7.0 * up, 3.0)
    assert place.altitude == 57.0
    assert (place.latitude, place.longitude) == (0.3, pytest.approx(4.0 - 2.0 * np.pi))
    np.testing.assert_array_equal(planet.gravity(up, 0.0), -9.81 * up)
    assert planet.potential(up, 0.0) == pytest.approx(9.81 * 51.0)
    np.testing.assert_array_equal(planet.position_world(altitude=57.0), 7.0 * up)
    north = {"ned": [1.0, 0.0, 0.0], "enu": [0.0, 1.0, 0.0]}[axes]
    np.testing.assert_array_equal(place.world_from_ned[:, 0], north)


@pytest.mark.parametrize("planet", [EARTH, FlatEarth(axes="enu"), RoundEarth(center=(1.0, 2.0, 3.0))])
def test_planets_pickle(planet: Planet):
    again = pickle.loads(pickle.dumps(planet))
    position = np.array([6.4e6, 1e5, -3e5])
    for mine, yours in zip(planet.place(position, 9.0), again.place(position, 9.0), strict=True):
        np.testing.assert_array_equal(mine, yours)
    assert repr(again) == repr(planet)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Ellipsoid(-1.0, 1.0), "radius: .*positive"),
        (lambda: Ellipsoid(1.0, 0.0), "mu: .*positive"),
        (lambda: WGS84(flattening=298.257223563), "flattening: got 298.257; .*not its inverse"),
        (lambda: WGS84(center=(1.0, 2.0)), "center: "),
        (lambda: WGS84(j2=np.nan), "j2: "),
        (
            lambda: FlatEarth(axes="esd"),  # pyright: ignore[reportArgumentType]
            "axes: got 'esd'; allowed are 'ned', 'enu'",
        ),
        (lambda: FlatEarth(latitude=45.0), "latitude: got 45; allowed .*np.deg2rad"),
        (lambda: EARTH.position_world(28.5, -1.0, 0.0), "latitude: got 28.5; .*np.deg2rad"),
        (lambda: EARTH.position_world(0.5, -80.6, 0.0), "longitude: got -80.6; .*np.deg2rad"),
        (lambda: EARTH.position_world(0.5, 0.5, -7e6), "altitude: got -7e"),
        (lambda: EARTH.position_world(0.5), "latitude, longitude: both"),
        (lambda: EARTH.position_world(np.nan, 0.0), "latitude: got nan"),
        (lambda: FlatEarth().position_world(0.1), r"latitude: got 0\.1; a flat earth has one, 0 rad"),
    ],
)
def test_wrong_planets_and_places(make, message):
    with pytest.raises(fb.InputError, match=message):
        make()
