"""Gravity of planets: a gradient, energy and momentum kept, exact derivatives, the same in lanes."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import freebody as fb
from freebody.elements import Gravity
from freebody.environment import WGS84, Ellipsoid, Environment, FlatEarth, Planet, RoundEarth

from .scenes import BODY

Array = NDArray[np.float64]
EARTH = WGS84()
PLANETS = [
    EARTH,
    WGS84(center=(-6.4e6, 1e5, 3e5), angle=1.0),
    RoundEarth(rotation_rate=1e-4),
    FlatEarth(9.7, "enu"),
    FlatEarth(9.7),
]
ORBIT: dict[str, Any] = {
    "position": [5.2e6, 3.1e6, 3.2e6],
    "velocity_world": [-3.0e3, 6.6e3, 2.2e3],
    "attitude": fb.Attitude.angles("zyx", [0.5, -0.2, 0.3]),
    "angular_velocity_body": [0.6, 1.1, -0.4],
}


@pytest.mark.parametrize("planet", PLANETS, ids=repr)
def test_gravity_is_minus_the_gradient_of_the_potential(planet: Planet):
    position = np.array([4.1e6, -3.9e6, 4.3e6])
    step = 100.0
    ahead, back = (planet.potential(position + sign * step * np.eye(3), 0.0) for sign in (1.0, -1.0))
    # Rounding of 6e7 J/kg over 200 m, and g step²/r², both below 1e-9 m/s².
    np.testing.assert_allclose(planet.gravity(position, 0.0), (back - ahead) / (2.0 * step), atol=4e-9)


def test_gravity_of_many_points_at_once(rng):
    position = 7e6 * rng.normal(size=(3, 4, 3))
    every = EARTH.gravity(position, 0.0)
    np.testing.assert_array_equal(every[2, 1], EARTH.gravity(position[2, 1], 0.0))


def test_energy_and_momentum_about_the_axis_are_kept_in_orbit():
    model = fb.Model(BODY, [Gravity(EARTH)])
    run = model.simulate(model.state(**ORBIT), (0.0, 20000.0), rtol=1e-12, save_every=100.0)
    assert run.ok
    potential = BODY.mass * EARTH.potential(run.com_position_world, 0.0)
    energy = run.kinetic_energy + potential
    momentum = run.momentum_world[:, 5]
    # Three orbits of some thousand steps of 1e-12; the body turns three thousand times.
    assert np.ptp(energy) <= 1e-9 * np.abs(energy).max()
    assert np.ptp(momentum) <= 1e-9 * np.abs(momentum).max()
    # It is J2 that moves the rest of the momentum, 1e-3 of it an orbit: the test would see it missing.
    assert np.ptp(run.momentum_world[:, 3]) > 1e-4 * np.abs(momentum).max()


def test_without_j2_it_is_the_point_mass():
    x = fb.Model(BODY).state(**ORBIT)
    planet = RoundEarth(center=(3.0, 2.0, 1.0))
    native = fb.PointMassGravity(planet.mu, planet.center, gradient_torque=False)
    wrenches = [fb.Model(BODY, [f]).wrench(0.0, x) for f in (native, Gravity(planet))]
    np.testing.assert_allclose(wrenches[1], wrenches[0], rtol=1e-14, atol=1e-14)


def test_the_parts_are_the_whole():
    x = fb.Model(BODY).state(**ORBIT)
    parts = [fb.PointMassGravity(EARTH.mu, EARTH.center, False), Gravity(EARTH, point_mass=False)]
    whole = fb.Model(BODY, [Gravity(EARTH)]).wrench(0.0, x)
    np.testing.assert_allclose(fb.Model(BODY, parts).wrench(0.0, x), whole, rtol=1e-14)


@pytest.mark.parametrize("axes", ["ned", "enu"])
def test_flat_earth_is_uniform_gravity(axes):
    down = {"ned": 1.0, "enu": -1.0}[axes]
    uniform = fb.UniformGravity(9.8, (0.0, 0.0, down))
    x = fb.Model(BODY).state(**ORBIT)
    wrenches = [fb.Model(BODY, [f]).wrench(0.0, x) for f in (uniform, Gravity(FlatEarth(9.8, axes)))]
    np.testing.assert_allclose(wrenches[1], wrenches[0], rtol=1e-14, atol=1e-14)


def test_the_motion_does_not_depend_on_the_body_frame(rng):
    origin = np.array([0.4, -0.7, 0.2])
    rotation = fb.Attitude.angles("xyz", [0.7, -0.4, 1.9]).as_rotation()
    moved = BODY.in_frame(origin, rotation)
    start = fb.Attitude.rotation(ORBIT["attitude"].as_rotation() @ rotation)
    swing = np.cross(ORBIT["angular_velocity_body"], origin)
    world_from_body = ORBIT["attitude"].as_rotation()
    runs = []
    for body, x in (
        (BODY, ORBIT),
        (
            moved,
            {
                "position": ORBIT["position"] + world_from_body @ origin,
                "velocity_world": ORBIT["velocity_world"] + world_from_body @ swing,
                "attitude": start,
                "angular_velocity_body": rotation.T @ ORBIT["angular_velocity_body"],
            },
        ),
    ):
        model = fb.Model(body, [Gravity(EARTH)])
        runs.append(model.simulate(model.state(**x), (0.0, 500.0), rtol=1e-12, save_every=50.0))
    for path in ("com_position_world", "com_velocity_world"):
        mine, yours = (getattr(run, path) for run in runs)
        # Rounding of 7e6 m, and 1e-12 of it in each of some hundred steps.
        np.testing.assert_allclose(yours, mine, rtol=1e-10, atol=1e-6)


def turning_gravity(planet: Planet) -> fb.ForceLaw:
    """A law that uses all that a planet says."""

    def law(s: Any) -> Any:
        place = planet.place(s.position_world, s.time)
        angles = np.stack([1.0 * place.latitude, 1.0 * place.longitude, 1e-6 * place.altitude])
        ground = 1e-3 * planet.ground_velocity(s.position_world)
        return fb.wrench(force=angles + ground, moment=1.0 * (place.world_from_ned @ [1.0, 2.0, 3.0]))

    return fb.force(law)


@pytest.mark.parametrize("where", ["equator", "pole", "mid", "date line", "far"])
@pytest.mark.parametrize("planet", [WGS84(angle=0.3), RoundEarth(rotation_rate=7e-5)], ids=repr)
def test_the_derivatives_of_places_are_exact(planet: Ellipsoid, where):
    latitude, longitude, altitude = {
        "equator": (0.0, 0.0, 0.0),
        "pole": (np.pi / 2, 0.0, 1e3),
        "mid": (0.7, 1.0, 1e4),
        "date line": (0.2, -np.pi, 1e5),
        "far": (-0.5, 2.0, 1e9),
    }[where]
    model = fb.Model(BODY, [turning_gravity(planet), Gravity(planet)])
    time = 100.0
    position = planet.position_world(latitude, longitude, altitude, time)
    if where == "pole":
        position[:2] = 0.0
    x = model.state(position=position, velocity_world=[10.0, 20.0, 30.0])
    by_duals = model.jacobian(time, x)[0][7:, :3]
    assert np.isfinite(by_duals).all()
    if where in ("pole", "date line"):
        return  # directions jump at one, longitude at the other: no differences there
    step = 10.0
    steps = np.zeros((3, len(x)))
    steps[:, :3] = step * np.eye(3)
    ahead, back = (np.array([model.derivative(time, x + s * h)[7:] for h in steps]) for s in (1.0, -1.0))
    # Differences of numbers of order ten over 20 m round at 1e-15; (step/r)² is 2e-12 of slopes of 1e-5.
    np.testing.assert_allclose(by_duals.T, (ahead - back) / (2.0 * step), rtol=1e-8, atol=1e-13)


def test_lanes_give_what_one_motion_gives(rng):
    model = fb.Model(BODY, [turning_gravity(WGS84(angle=0.3)), Gravity(EARTH)])
    x = np.array([model.state(**{**ORBIT, "position": 7e6 * rng.normal(size=3)}) for _ in range(21)])
    time = rng.uniform(0.0, 1e5, 21)
    alone = [model.derivative(t, row) for t, row in zip(time, x, strict=True)]
    np.testing.assert_array_equal(model.derivative_batch(time, x.T.copy()).T, alone)


def test_its_constants_are_parameters():
    gravity = Gravity(Environment(EARTH), name="Earth")
    assert gravity.parameters == {"mu": EARTH.mu, "j2": EARTH.j2}
    assert dict(Gravity(RoundEarth()).parameters) == {"mu": EARTH.mu}
    assert pickle.loads(pickle.dumps(gravity)) == gravity
    x = fb.Model(BODY).state(**ORBIT)
    other = Gravity(WGS84(mu=4e14, j2=2e-3))
    wrench = fb.Model(BODY, [gravity(mu=4e14, j2=2e-3)]).wrench(0.0, x)
    np.testing.assert_array_equal(wrench, fb.Model(BODY, [other]).wrench(0.0, x))


def test_at_the_centre_there_is_no_gravity_and_the_run_says_so():
    model = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [Gravity(EARTH)])
    run = model.simulate(model.state(), (0.0, 1.0))
    assert run.outcome.status == "non_finite"
    assert "gravity" in run.outcome.message


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Gravity(9.81), "environment: got 9.81; give an Environment or a Planet"),  # pyright: ignore[reportArgumentType]
        (lambda: Gravity(RoundEarth(), point_mass=False), "point_mass: got False, but the planet has no J2"),
        (lambda: Gravity(FlatEarth(), point_mass=False), "point_mass: got False"),
    ],
)
def test_wrong_gravity(make, message):
    with pytest.raises(fb.InputError, match=message):
        make()
