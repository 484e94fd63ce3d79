"""Contact with planes: restitution, friction, rest, and planes that move."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import freebody as fb
from freebody.elements import Contact

from .scenes import Array
from .waters import TURNING, water

G = 9.80665
BALL = fb.RigidBody(2.0, inertia_about_com=np.diag([0.1, 0.1, 0.1]))
# The mass centre of the block lies over the middle of its feet, as does the origin.
FEET = [[0.5, 0.4, 0.1], [0.5, -0.4, 0.1], [-0.5, 0.4, 0.1], [-0.5, -0.4, 0.1]]
BLOCK = fb.RigidBody(10.0, inertia_about_com=np.diag([0.6, 0.9, 1.4]))


def leaving(damping: float, speed: float) -> float:
    """The speed after the bounce: λ (v + v') = ln((1 + λ v)/(1 − λ v')). Hunt and Crossley (1975)."""

    def gap(after: float) -> float:
        return damping * (speed + after) - np.log((1.0 + damping * speed) / (1.0 - damping * after))

    # v' = -v is the other root, the way in.
    root: Any = brentq(gap, 1e-9, min(speed, (1.0 - 1e-12) / damping), xtol=1e-14)
    return float(root)


@pytest.mark.parametrize("damping", [0.05, 0.2, 1.0])
@pytest.mark.parametrize("speed", [0.5, 2.0])
def test_a_ball_bounces_as_hunt_and_crossley_say(damping: float, speed: float) -> None:
    """Whatever the stiffness and the onset: the closed form knows neither."""
    for stiffness, onset in ((1e4, 1e-3), (1e5, 1e-5), (1e4, 1.0)):
        contact = Contact([0.0, 0.0, 0.0], stiffness, damping=damping, onset=onset)
        model = fb.Model(BALL, [contact])
        run = model.simulate(model.state(velocity_body=[0.0, 0.0, speed]), (0.0, 1.0), rtol=1e-11)
        assert run.position_world[-1, 2] < 0.0
        # The corner where the parabola begins and ends costs what it costs: some 1e-9 with these steps.
        assert -run.velocity_body[-1, 2] == pytest.approx(leaving(damping, speed), rel=1e-7)


def test_restitution_falls_with_the_speed_as_the_documentation_says() -> None:
    for speed in (0.01, 0.1):
        # e = 1 - 2/3 λ v + O((λ v)²).
        assert leaving(0.3, speed) / speed == pytest.approx(1.0 - 0.2 * speed, abs=(0.3 * speed) ** 2)


def test_without_damping_and_friction_energy_is_kept() -> None:
    model = fb.Model(BLOCK, [fb.UniformGravity(), Contact(FEET, 2e4, onset=5e-3)])
    x0 = model.state([0.0, 0.0, -0.5], velocity_body=[0.2, 0.0, 0.0], angular_velocity_body=[0.5, 0.3, 0.1])
    run = model.simulate(x0, (0.0, 2.0), rtol=1e-11, save_every=0.01)
    stored = np.zeros(len(run.t))
    for foot in FEET:
        depth = run.point(np.array(foot))[:, 2]
        inside = np.clip(depth, 0.0, 5e-3)
        beyond = np.maximum(depth - 5e-3, 0.0)
        stored += 2e4 * (inside**3 / (6.0 * 5e-3) + (beyond + 5e-3) * beyond / 2.0)
    total = run.kinetic_energy + run.potential_energy + stored
    assert stored.max() > 10.0
    # Several bounces; each corner loses what the step control lets pass.
    assert np.abs(total - total[0]).max() <= 1e-7 * np.abs(run.kinetic_energy).max()


def slope(angle: float, friction: float, slip_speed: float = 1e-2) -> tuple[fb.Model, Array]:
    """A block on a slope that falls along its first axis, in equilibrium across it."""
    normal = np.array([np.sin(angle), 0.0, -np.cos(angle)])
    downhill = np.array([np.cos(angle), 0.0, np.sin(angle)])
    attitude = fb.Attitude.rotation(np.column_stack([downhill, [0.0, 1.0, 0.0], -normal]))
    stiffness = 1e5
    contact = Contact(
        FEET, stiffness, normal=normal, damping=1.0, friction=friction, slip_speed=slip_speed, onset=1e-4
    )
    model = fb.Model(BLOCK, [fb.UniformGravity(G), contact])
    sunk = BLOCK.mass * G * np.cos(angle) / (4.0 * stiffness) + 0.5e-4
    start = model.state(normal * (0.1 - sunk), attitude)
    return model, start


def along(run: fb.Trajectory, angle: float) -> Array:
    return run.velocity_world @ np.array([np.cos(angle), 0.0, np.sin(angle)])


@pytest.mark.parametrize("slip_speed", [1e-2, 1e-3])
def test_a_block_at_rest_creeps_as_documented(slip_speed: float) -> None:
    angle, friction = np.radians(20.0), 0.6
    model, x0 = slope(angle, friction, slip_speed)
    run = model.simulate(x0, (0.0, 10.0), method="rodas5p", rtol=1e-7, atol=1e-10, save_every=0.5)
    creep = slip_speed * np.tan(angle) / np.sqrt(friction**2 - np.tan(angle) ** 2)
    # Feet downhill carry more than those uphill, but all slip alike: the sum of their friction is Coulomb's.
    np.testing.assert_allclose(along(run, angle)[2:], creep, rtol=1e-4)


def test_an_implicit_method_rests_on_the_ground_in_fewer_steps() -> None:
    """Friction settles within v_s m/(μ N), 0.2 ms here; explicit methods have to follow."""
    model, x0 = slope(np.radians(20.0), 0.6, 1e-3)
    steps = {
        method: model.simulate(x0, (0.0, 5.0), method=method, rtol=1e-6, atol=1e-10).steps
        for method in ("rodas5p", "dop853")
    }
    assert steps["rodas5p"] < steps["dop853"] / 3


def test_a_block_slides_with_the_acceleration_of_coulomb() -> None:
    angle, friction = np.radians(30.0), 0.3
    model, x0 = slope(angle, friction)
    run = model.simulate(x0, (0.0, 4.0), rtol=1e-9, save_every=0.1)
    late = run.t > 2.0
    rate = np.polyfit(run.t[late], along(run, angle)[late], 1)[0]
    # Beyond a thousand slip speeds what is smooth differs from Coulomb by less than 1e-6.
    assert rate == pytest.approx(G * (np.sin(angle) - friction * np.cos(angle)), rel=1e-5)


def test_friction_stays_within_coulombs_cone(rng: np.random.Generator) -> None:
    model = fb.Model(BALL, [Contact([0.0, 0.0, 0.0], 1e3, friction=0.7, damping=0.2)])
    for _ in range(50):
        force = model.wrench(0.0, model.state([0.0, 0.0, 0.02], velocity_body=rng.normal(size=3)))[:3]
        assert np.hypot(force[0], force[1]) <= 0.7 * -force[2]
        assert force[2] <= 0.0
    # Away faster than 1/λ the spring would have to pull; it does not.
    away = model.state([0.0, 0.0, 0.02], velocity_body=[0.0, 0.0, -6.0])
    assert not model.wrench(0.0, away).any()
    assert not model.wrench(0.0, model.state([0.0, 0.0, -0.02])).any()


def test_a_belt_carries_along_what_lies_on_it() -> None:
    belt = np.array([0.7, -0.2, 0.0])
    model = fb.Model(
        BLOCK, [fb.UniformGravity(), Contact(FEET, 1e5, velocity=belt, damping=1.0, friction=0.5)]
    )
    run = model.simulate(model.state([0.0, 0.0, -0.1]), (0.0, 5.0), method="rodas5p", rtol=1e-8)
    # Without a load along the belt there is no creep: what is left falls off within v_s/(μ g), 2 ms.
    np.testing.assert_allclose(run.velocity_world[-1], belt, rtol=0, atol=1e-6)


def test_planes_that_move_are_planes_at_rest_seen_from_a_moving_frame() -> None:
    rise = np.array([0.3, 0.1, -0.4])
    still, carried = (
        fb.Model(BLOCK, [fb.UniformGravity(), Contact(FEET, 1e4, velocity=v, damping=0.4, friction=0.3)])
        for v in (np.zeros(3), rise)
    )
    motion: dict[str, Any] = {"angular_velocity_body": [0.2, 0.1, 0.3]}
    runs = [
        model.simulate(
            model.state([0.0, 0.0, -0.15], velocity_body=v, **motion), (0.0, 1.0), rtol=1e-10, save_every=0.1
        )
        for model, v in ((still, np.zeros(3)), (carried, rise))
    ]
    gap = runs[1].position_world - runs[0].position_world - runs[0].t[:, None] * rise
    # Other roundings, and corners met with other steps.
    assert np.abs(gap).max() <= 1e-7


def test_a_deck_moves_as_its_inputs_say() -> None:
    contact = Contact([0.0, 0.0, 0.0], 1e3, moving="deck", damping=0.5)
    model = fb.Model(BALL, [contact])
    assert model.input_names == ("deck_height", "deck_speed")
    assert model.input_units == ("m", "m/s")
    x = model.state()
    # Risen by 2 cm, and rising: deeper by as much, with that speed inwards.
    np.testing.assert_allclose(
        model.wrench(0.0, x, [0.02, 0.1])[:3], [0.0, 0.0, -1e3 * (0.02 - 0.5e-3) * 1.05], rtol=1e-13
    )


def test_on_the_ground_of_a_planet_things_turn_with_it() -> None:
    planet = TURNING
    env = water(planet=planet)
    foot = np.array([0.0, 0.0, 0.2])
    contact = Contact.on_ground(env, foot, 1e4, altitude=100.0, damping=0.5, friction=0.6)
    model = fb.Model(BALL, [contact])
    up = np.array([0.6, 0.0, 0.8])
    down = -up
    attitude = fb.Attitude.rotation(np.column_stack([np.cross([0.0, 1.0, 0.0], down), [0, 1.0, 0], down]))
    position = up * (planet.radius + 100.0 + 0.19)
    at_rest = planet.ground_velocity(position + 0.2 * down)
    x = model.state(position, attitude, velocity_world=at_rest)
    force = model.wrench(0.0, x)[:3]
    # One centimetre deep, and no slip: metres in a thousand kilometres have ten digits left.
    np.testing.assert_allclose(force, [0.0, 0.0, -1e4 * (0.01 - 0.5e-3)], rtol=0, atol=1e-4)
    assert dict(contact.parameters)["altitude"] == 100.0


def test_wrong_contacts_are_told() -> None:
    for words, arguments in (
        ("points: got shape", {"points": [1.0, 2.0]}),
        ("stiffness", {"stiffness": -1.0}),
        ("normal: got the zero vector", {"normal": [0.0, 0.0, 0.0]}),
        ("onset", {"onset": 0.0}),
        ("friction: got -0.1", {"friction": -0.1}),
        ("moving: got the name", {"moving": "my deck"}),
    ):
        with pytest.raises(fb.InputError, match=words):
            Contact(**{"points": [0.0, 0.0, 0.0], "stiffness": 1e3, **arguments})


def test_contact_never_gives_energy() -> None:
    """Tumbling to rest: what damping and friction take does not come back."""
    contact = Contact(FEET, 2e4, damping=0.5, friction=0.4, onset=5e-3)
    model = fb.Model(BLOCK, [fb.UniformGravity(G), contact])
    x0 = model.state([0.0, 0.0, -0.4], velocity_body=[1.0, 0.3, 0.0], angular_velocity_body=[1.0, 0.5, 0.3])
    run = model.simulate(x0, (0.0, 3.0), rtol=1e-10, save_every=0.005)
    stored = np.zeros(len(run.t))
    for foot in FEET:
        depth = run.point(np.array(foot))[:, 2]
        inside, beyond = np.clip(depth, 0.0, 5e-3), np.maximum(depth - 5e-3, 0.0)
        stored += 2e4 * (inside**3 / (6.0 * 5e-3) + (beyond + 5e-3) * beyond / 2.0)
    total = run.kinetic_energy + run.potential_energy + stored
    assert total[0] - total[-1] > 0.5 * run.kinetic_energy[0]
    # Flights keep it to the tolerance of the run.
    assert np.diff(total).max() <= 1e-8 * abs(total[0])
