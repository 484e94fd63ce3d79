"""Tracks: a run as seen from a turning planet, of any point of the body."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import Gravity
from freebody.environment import WGS84, Environment, FlatEarth, Planet, RoundEarth, Wind, WindHere

EARTH = WGS84(angle=0.2)
BODY = fb.RigidBody(
    12.5, com=[0.12, -0.05, 0.08], inertia_about_com=[[0.7, 0.05, 0.1], [0.05, 1.1, -0.02], [0.1, -0.02, 1.5]]
)
POINT = np.array([2.0, -0.5, 1.5])
TURNED = fb.Attitude.angles("zyx", [0.5, -0.3, 1.1])
WIND: Any = "wind"  # which is no frame
PLACE: dict[str, Any] = {"latitude": 0.6, "longitude": -1.4, "altitude": 3000.0}


def thrown(
    planet: Planet = EARTH, attitude: str = "quaternion", form: Any = "quasi_velocity", **given: Any
) -> Any:
    """A tumbling body thrown over the ground, and its run."""
    forces = [Gravity(planet), fb.ConstantWrench([3.0, 5.0, -40.0], [0.1, 0.2, -0.3], at=BODY.com)]
    model = fb.Model(BODY, forces, attitude, form)
    start = {**PLACE, "velocity_ned": [60.0, -30.0, -80.0], "attitude": TURNED, **given}
    x = model.state(**planet.motion(**start, angular_velocity_body=[0.3, -0.2, 0.5]))
    return model.simulate(x, (0.0, 10.0), rtol=1e-12, save_every=0.01)


def resting() -> Any:
    """A body that the ground carries: a force at its centre balances gravity but for what turning needs."""
    turn, time = EARTH.angular_velocity_world, 0.0
    position = EARTH.position_world(**PLACE, time=time)

    @fb.force
    def support(s: Any) -> Any:
        com = s.position_world + s.world_from_body @ s.com
        carried = np.cross(turn, np.cross(turn, com - EARTH.center))
        held = s.world_from_body.T @ (carried - EARTH.gravity(com, s.time))
        return fb.wrench(force=s.mass * held, at=s.com)

    body = fb.RigidBody(BODY.mass, com=BODY.com, inertia_about_com=np.eye(3))
    model = fb.Model(body, [Gravity(EARTH), support])
    start = EARTH.motion(position_world=position, rates_relative_to="earth", attitude=TURNED, point=BODY.com)
    return model.simulate(model.state(**start), (0.0, 3600.0), rtol=1e-12, save_every=600.0)


def test_what_rests_on_the_turning_earth_stays_where_it_is():
    run = resting()
    track = EARTH.track(run, BODY.com)
    # An hour's travel of 1.4e6 m with 1e-12 of 6e6 m in each of some ten steps.
    np.testing.assert_allclose(track.altitude, 3000.0, atol=1e-4)
    np.testing.assert_allclose(track.latitude, 0.6, atol=1e-10)
    np.testing.assert_allclose(track.longitude, -1.4, atol=1e-10)
    np.testing.assert_allclose(track.velocity_ned, 0.0, atol=1e-6)
    np.testing.assert_allclose(track.acceleration_earth, 0.0, atol=1e-9)
    # 1e-12 rad in each of some ten steps, and as much of 7e-5 rad/s in another direction; far below 7e-5.
    np.testing.assert_allclose(track.angular_velocity("earth"), 0.0, atol=1e-11)
    np.testing.assert_allclose(track.angular_velocity("ned"), 0.0, atol=1e-11)
    np.testing.assert_allclose(track.angles(), np.tile(TURNED.as_angles("zyx"), (len(run), 1)), atol=1e-10)


def test_an_accelerometer_at_rest_feels_the_plumb_line():
    """Gravity with the centrifugal part is the gradient of a potential: level surfaces are those of WGS-84.

    At altitude 0 normal gravity is along the normal of the ellipsoid, its size by Somigliana's formula: NIMA
    TR 8350.2, 3rd ed., eq. 4-1 with the constants of table 3.4.
    """
    latitude = 0.6
    start = EARTH.motion(latitude=latitude, longitude=0.3, altitude=0.0, rates_relative_to="earth")
    model = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [])
    run = model.simulate(model.state(**start), (0.0, 1e-3))
    track = EARTH.track(run)
    turn, position = EARTH.angular_velocity_world, track.position_world[0]
    carried = np.cross(turn, np.cross(turn, position))
    felt = track.axes("ned")[0].T @ (carried - EARTH.gravity(position, 0.0))
    s2 = np.sin(latitude) ** 2
    normal = 9.7803253359 * (1.0 + 0.00193185265241 * s2) / np.sqrt(1.0 - 0.00669437999013 * s2)
    # J4 of the normal field, 2.4e-6, is left out of ours: 5 J4 g at most.
    np.testing.assert_allclose(felt, [0.0, 0.0, -normal], atol=1.2e-4)


def test_specific_force_of_a_point_is_its_acceleration_less_gravity():
    run = resting()
    track = EARTH.track(run, POINT)
    turn = EARTH.angular_velocity_world
    position = track.position_world
    felt = np.cross(turn, np.cross(turn, position)) - EARTH.gravity(position, run.t)
    np.testing.assert_allclose(track.specific_force_body, track.resolve(felt, "body"), atol=1e-9)
    np.testing.assert_allclose(
        track.gravity, np.linalg.norm(EARTH.gravity(position, 0.0), axis=1), rtol=1e-15
    )


@pytest.mark.parametrize(
    ("attitude", "form"),
    [("quaternion", "quasi_velocity"), ("zxz", "quasi_velocity"), ("xyz", "generalized")],
)
def test_velocity_and_acceleration_are_the_derivatives_of_the_path(attitude, form):
    run = thrown(attitude=attitude, form=form)
    track = EARTH.track(run, POINT)
    step = run.t[1] - run.t[0]

    def rate(values: Any) -> Any:
        """Central differences of order 4: 2.5 m that turn at 2 rad/s err by 2.5 · 2⁶ step⁴/30 = 5e-8 m/s²."""
        return (8.0 * (values[3:-1] - values[1:-3]) - (values[4:] - values[:-4])) / (12.0 * step)

    for path, velocity, tolerance in (
        (track.position_world, track.velocity_world, 1e-6),  # 1e-9 m of rounding over the step
        (track.velocity_world, track.acceleration_world, 2e-7),
        (track.position_earth, track.velocity_earth, 1e-6),
        (track.velocity_earth, track.acceleration_earth, 2e-7),
    ):
        np.testing.assert_allclose(velocity[2:-2], rate(path), atol=tolerance)
    climb = rate(track.altitude)
    np.testing.assert_allclose(-track.velocity_ned[2:-2, 2], climb, atol=1e-6)


def test_vectors_are_the_same_in_every_frame():
    track = EARTH.track(thrown(), POINT)
    for frame in ("world", "earth", "ned", "enu", "lvlh", "body"):
        axes = track.axes(frame)
        turned = np.einsum("nij,nj->ni", axes, track.resolve(track.acceleration_world, frame))
        np.testing.assert_allclose(turned, track.acceleration_world, atol=1e-13)
    north, east, down = track.velocity_ned.T
    np.testing.assert_allclose(track.velocity_enu.T, [east, north, -down])
    np.testing.assert_allclose(track.speed, np.linalg.norm(track.velocity_earth, axis=1))
    gamma, chi = track.flight_path_angle, track.course
    direction = [np.cos(gamma) * np.cos(chi), np.cos(gamma) * np.sin(chi), -np.sin(gamma)]
    np.testing.assert_allclose((track.speed * direction).T, track.velocity_ned, atol=1e-12)


def test_the_start_comes_back_out_of_the_track():
    for frame in ("world", "earth", "ned", "enu", "lvlh"):
        given: dict[str, Any] = {"relative_to": frame, "rates_relative_to": frame, "point": POINT}
        track = EARTH.track(thrown(**given), POINT)
        np.testing.assert_allclose(track.angles("zyx", frame)[0], [0.5, -0.3, 1.1], atol=1e-14)
        np.testing.assert_allclose(track.angular_velocity(frame)[0], [0.3, -0.2, 0.5], atol=1e-14)
        np.testing.assert_allclose(track.velocity_ned[0], [60.0, -30.0, -80.0], atol=1e-11)
        place = track.latitude[0], track.longitude[0], track.altitude[0]
        np.testing.assert_allclose(place, [0.6, -1.4, 3000.0], rtol=1e-12)


def test_the_track_does_not_depend_on_where_the_world_starts_and_how_it_is_turned():
    site = RoundEarth(rotation_rate=7e-5).position_world(0.6, -1.4, 3000.0)
    worlds = [
        RoundEarth(rotation_rate=7e-5),
        RoundEarth(rotation_rate=7e-5, center=-site),
        RoundEarth(rotation_rate=7e-5, angle=2.0, center=(1e5, 2e5, -3e5)),
    ]
    first, *others = (planet.track(thrown(planet), POINT, site=(0.6, -1.4, 0.0)) for planet in worlds)
    for other in others:
        # Rounding of positions, 1e-9 m, and 1e-12 of 6e6 m in each of some ten steps.
        np.testing.assert_allclose(other.altitude, first.altitude, atol=1e-4)
        np.testing.assert_allclose(other.latitude, first.latitude, atol=1e-11)
        np.testing.assert_allclose(other.longitude, first.longitude, atol=1e-11)
        np.testing.assert_allclose(other.velocity_ned, first.velocity_ned, atol=1e-5)
        np.testing.assert_allclose(other.angles(), first.angles(), atol=1e-9)
        np.testing.assert_allclose(other.specific_force_body, first.specific_force_body, atol=1e-8)
        np.testing.assert_allclose(other.position_enu, first.position_enu, atol=1e-4)


def test_from_a_launch_site():
    track = EARTH.track(thrown(), site=(0.6, -1.4, 1000.0))
    np.testing.assert_allclose(track.position_ned[0], [0.0, 0.0, -2000.0], atol=1e-8)
    step = track.position_ned[1] - track.position_ned[0]
    np.testing.assert_allclose(step / 0.01, track.velocity_ned[0], atol=0.1)
    np.testing.assert_allclose(track.position_enu[:, 2], -track.position_ned[:, 2])


class Breeze(Wind):
    """A wind whose north component can be dispersed."""

    def __init__(self) -> None:
        self.parameters = {"north": (-8.0, "m/s")}

    def here(self, place: Any, s: Any, p: Any) -> WindHere:
        north = -8.0 if p is None else p.north
        return WindHere(np.stack([1.0 * north, 6.0, 0.0]), np.zeros(3))


def test_the_flow_of_the_air():
    run = thrown()
    flow = EARTH.track(run, environment=Environment(EARTH, wind=Breeze())).flow
    track = EARTH.track(run)
    relative = track.velocity_ned - [-8.0, 6.0, 0.0]
    world_from_ned, world_from_body = track.axes("ned"), track.axes("body")
    expected = np.einsum("nji,njk,nk->ni", world_from_body, world_from_ned, relative)
    np.testing.assert_allclose(flow.velocity_body, expected, atol=1e-11)
    np.testing.assert_allclose(flow.airspeed, np.linalg.norm(relative, axis=1))
    np.testing.assert_allclose(flow.dynamic_pressure, 0.5 * 1.225 * flow.airspeed**2)
    np.testing.assert_allclose(flow.mach, flow.airspeed / 340.294)
    alpha, beta = flow.angle_of_attack, flow.sideslip
    axes = [np.cos(alpha) * np.cos(beta), np.sin(beta), np.sin(alpha) * np.cos(beta)]
    np.testing.assert_allclose((flow.airspeed * axes).T, flow.velocity_body, atol=1e-12)
    np.testing.assert_allclose(flow.angular_velocity_body, track.angular_velocity("earth"), atol=1e-15)


def test_acceleration_and_air_while_fuel_flows_out():
    @fb.contents(inputs={"fuel": "kg"})
    def tank(s: Any) -> Any:
        at = np.stack([0.5 - 0.02 * s.inputs.fuel, 0.0, 0.1])
        return fb.mass_properties(mass=s.inputs.fuel, com=at, inertia_about_com=(0.2, 0.3, 0.3))

    @fb.force(states={"fuel": (8.0, "kg")}, publishes=("fuel",), contents=(tank,))
    def engine(s: Any) -> Any:
        return fb.wrench(force=[6.0, 0.0, 0.0], at=[-1.0, 0.05, 0.0]), {"fuel": -0.4 + 0.0 * s.time}

    environment = Environment(EARTH, wind=Breeze())
    model = fb.Model(BODY, [Gravity(environment), engine], environment=environment)
    x = model.state(**EARTH.motion(**PLACE, velocity_ned=[50.0, 0.0, 0.0], attitude=TURNED))
    run = model.simulate(x, (0.0, 5.0), rtol=1e-12, save_every=0.01)
    track = EARTH.track(run, POINT)
    v, step = track.velocity_world, 0.01
    rate = (8.0 * (v[3:-1] - v[1:-3]) - (v[4:] - v[:-4])) / (12.0 * step)
    # As above: 2.5 m that turn at 2 rad/s, and 1e-11 m/s of rounding over the step.
    np.testing.assert_allclose(track.acceleration_world[2:-2], rate, atol=2e-7)
    relative = track.velocity_ned - [-8.0, 6.0, 0.0]
    np.testing.assert_allclose(track.flow.airspeed, np.linalg.norm(relative, axis=1))


@pytest.mark.parametrize("axes", ["ned", "enu"])
def test_over_a_flat_earth(axes):
    planet = FlatEarth(axes=axes, latitude=0.3, longitude=0.4)
    model = fb.Model(BODY, [Gravity(planet)])
    x = model.state(**planet.motion(altitude=50.0, velocity_enu=[3.0, 4.0, 5.0], point=BODY.com))
    track = planet.track(model.simulate(x, (0.0, 1.0), save_every=0.5), BODY.com, site=(0.3, 0.4, 0.0))
    np.testing.assert_allclose(track.altitude, [50.0, 52.5 - 9.80665 / 8.0, 55.0 - 9.80665 / 2.0])
    np.testing.assert_allclose(track.position_enu[-1], [3.0, 4.0, track.altitude[-1]])
    np.testing.assert_allclose(track.specific_force_body, 0.0, atol=1e-12)
    assert set(track.latitude) == {0.3}
    track.to_xarray()


def test_as_a_dataset():
    environment = Environment(EARTH, wind=Breeze())
    dataset = EARTH.track(
        thrown(point=POINT), POINT, site=(0.6, -1.4, 0.0), environment=environment
    ).to_xarray()
    assert all(variable.attrs["units"] and variable.attrs["long_name"] for variable in dataset.values())
    assert dataset["velocity_ned"].sel(ned="down").values[0] == pytest.approx(-80.0)
    assert dataset["mach"].attrs["units"] == "1"
    assert dataset.attrs["point"] == "2, -0.5, 1.5"


def test_columns_of_an_orbit_are_there_where_it_has_a_plane():
    track = EARTH.track(thrown())
    rows = {row.name: row for row in track.rows()}
    np.testing.assert_array_equal(rows["angles_lvlh"].values, track.angles("zyx", "lvlh"))
    np.testing.assert_array_equal(rows["rates_lvlh"].values, track.angular_velocity("lvlh"))
    assert rows["angles_lvlh"].components == ("yaw_pitch_roll", ("yaw", "pitch", "roll"))
    still = RoundEarth()
    model = fb.Model(BODY, [Gravity(still)])
    fall = model.simulate(model.state(**still.motion(**PLACE, point=BODY.com)), (0.0, 1.0))
    for planet, run in ((still, fall), (FlatEarth(), fall)):
        assert not [row for row in planet.track(run, BODY.com).rows() if "lvlh" in row.name]


def test_a_run_without_samples():
    model = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [Gravity(EARTH)])
    run = model.simulate(model.state(), (0.0, 1.0))
    assert not run.ok
    assert len(EARTH.track(run, environment=Environment(EARTH)).rows()[0].values) == len(run)


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (lambda run: EARTH.track(run, point=(1.0, 2.0)), "point: "),
        (lambda run: EARTH.track(run, site=(50.0, 8.0, 0.0)), r"latitude: got 50; .*np\.deg2rad"),
        (lambda run: EARTH.track(run).position_ned, "site: the track has none"),
        (lambda run: EARTH.track(run).flow, "environment: the track has none"),
        (lambda run: EARTH.track(run).axes(WIND), "frame: got 'wind'; allowed are 'world'"),
        (lambda run: EARTH.track(run).angles("zyy"), "sequence: got 'zyy'"),
        (lambda run: EARTH.track(run).angles("zyx", WIND), "relative_to: got 'wind'"),
        (lambda run: EARTH.track(run).resolve([1.0, 2.0, 3.0], "ned"), "vectors_world: got shape"),
    ],
)
def test_wrong_tracks(ask: Any, message: str):
    with pytest.raises(fb.InputError, match=message):
        ask(thrown())
