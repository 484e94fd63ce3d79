"""Added mass: shifted once, no work of its own, Munk's moment, Lamb's integrals."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import numpy as np
import pytest

import freebody as fb
from freebody.elements import AddedMass, Buoyancy
from freebody.environment import Ellipsoid

from .scenes import START, Array
from .waters import BODY, CURRENT, DENSITY, MASS, PLACE, TILT, TURNING, in_water, water

# Sums of products of order ten in another order.
ROUNDING = 1e-13


def matrix(element: fb.Force) -> Array:
    """Its added mass about the origin."""
    assert element.added_mass is not None
    return element.added_mass


def twist_at(twist: Array, point: Array, axes: Array) -> Array:
    """The twist of a point in axes, of that of the origin: v + ω × r."""
    v, w = twist[:3], twist[3:]
    return np.concatenate([axes.T @ (v + np.cross(w, point)), axes.T @ w])


def test_the_matrix_about_the_origin_has_the_energy_of_that_about_its_point(rng: np.random.Generator) -> None:
    shifted = matrix(AddedMass(water(), MASS, at=PLACE, axes=TILT))
    np.testing.assert_array_equal(shifted, shifted.T)
    for _ in range(20):
        one, two = rng.normal(size=(2, 6))
        wanted = twist_at(one, PLACE, TILT) @ MASS @ twist_at(two, PLACE, TILT)
        assert one @ shifted @ two == pytest.approx(wanted, abs=ROUNDING * np.abs(shifted).max() * 36)


def test_in_still_water_its_coriolis_part_does_no_work(rng: np.random.Generator) -> None:
    model = fb.Model(BODY, [AddedMass(water(), MASS, at=PLACE, axes=TILT)])
    for _ in range(20):
        twist = rng.normal(size=6)
        start: dict[str, Any] = START | {"velocity_body": twist[:3], "angular_velocity_body": twist[3:]}
        x = model.state(**start)
        force = model.wrench(0.0, x)
        assert abs(force @ twist) <= ROUNDING * np.abs(force).max() * np.abs(twist).max() * 6


@pytest.mark.parametrize("current", [None, CURRENT])
def test_energy_is_kept_in_the_frame_of_the_water(current: Array | None) -> None:
    element = AddedMass(water(current), MASS, at=PLACE, axes=TILT)
    model = fb.Model(BODY, [element])
    run = model.simulate(model.state(**START), (0.0, 20.0), rtol=1e-11, save_every=0.5)
    drift = np.zeros(3) if current is None else current
    relative = run.velocity_body - np.einsum("nji,j->ni", run.world_from_body, drift)
    twist = np.hstack([relative, run.angular_velocity_body])
    whole = BODY.spatial_inertia + matrix(element)
    energy = 0.5 * np.einsum("ni,ij,nj->n", twist, whole, twist)
    # Some hundred steps of 1e-11.
    assert np.abs(energy - energy[0]).max() <= 1e-9 * energy[0]
    # And with it the momentum of body and water together, in the axes of the world.
    momentum = np.einsum("nij,jk,nk->ni", run.world_from_body, whole[:3], twist)
    assert np.abs(momentum - momentum[0]).max() <= 1e-9 * np.abs(momentum).max()


@pytest.mark.parametrize("form", ["quasi_velocity", "generalized"])
def test_motion_in_a_current_is_motion_in_still_water_carried_along(form: Any) -> None:
    still, carried = (
        fb.Model(BODY, [AddedMass(water(c), MASS, at=PLACE, axes=TILT)], "quaternion", form)
        for c in (None, CURRENT)
    )
    turn = START["attitude"].as_rotation()
    faster = START | {"velocity_body": START["velocity_body"] + turn.T @ CURRENT}
    runs = [
        model.simulate(model.state(**start), (0.0, 10.0), rtol=1e-11, save_every=0.5)
        for model, start in ((still, START), (carried, faster))
    ]
    gap = runs[1].position_world - runs[0].position_world - runs[0].t[:, None] * CURRENT
    # Some hundred steps of 1e-11 in metres.
    assert np.abs(gap).max() <= 1e-9
    assert np.abs(runs[1].world_from_body - runs[0].world_from_body).max() <= 1e-9


def test_a_body_at_rest_in_water_that_turns_with_a_planet_stays_there() -> None:
    """Attraction, the buoyancy of water that goes round with it, and no part of added mass left over."""
    planet = TURNING
    env = water(planet=planet)
    body = fb.RigidBody(31.0, PLACE, inertia_about_com=np.diag([2.0, 2.0, 2.0]))
    gravity = fb.PointMassGravity(planet.mu, gradient_torque=False)
    others = in_water(env)
    forces = [gravity, Buoyancy(env, 31.0 / DENSITY, PLACE), *(others[k] for k in ("added mass", "damping"))]
    model = fb.Model(body, forces)
    position = np.array([6e5, 3e5, 7e5])
    turning = planet.angular_velocity_world
    x = model.state(
        position,
        START["attitude"],
        velocity_world=planet.ground_velocity(position),
        angular_velocity_world=turning,
    )
    assert np.abs(model.derivative(0.0, x)[7:]).max() <= 1e-10
    # Without the water's own acceleration, 0.7 m/s², it would be driven off.
    assert np.linalg.norm(np.cross(turning, planet.ground_velocity(position))) > 0.5


def test_in_a_current_on_a_turning_planet_it_is_kirchhoffs() -> None:
    """The rate of the twist relative to the water by differences along a run; the force by its definition.

    The water turns with the planet; the current stands in its axes, which over the metre of this run differ
    by a millionth of a radian.
    """
    turning = Ellipsoid(6e6, 1e13, rotation_rate=1e-2)
    planet = Ellipsoid(6e6, 1e13, rotation_rate=1e-2, center=-turning.position_world(0.6, 0.8))
    model = fb.Model(BODY, [in_water(water(CURRENT, planet))["added mass"]])
    start = planet.ground_velocity(np.zeros(3)) + np.array([1.0, 2.0, -0.5])
    x0 = model.state(
        [0, 0, 0], START["attitude"], velocity_world=start, angular_velocity_body=[0.3, -0.5, 0.4]
    )
    h = 1e-3
    run = model.simulate(x0, (0.0, 8 * h), rtol=1e-13, save_at=h * np.arange(9))
    seat = run.point(PLACE)
    stream = np.array(
        [
            planet.ground_velocity(r) + planet.place(r, t).world_from_ned @ CURRENT
            for r, t in zip(seat, run.t, strict=True)
        ]
    )
    body_from_world = np.swapaxes(run.world_from_body, 1, 2)
    here = run.velocity_body + np.cross(run.angular_velocity_body, PLACE)
    linear = (here - np.einsum("nij,nj->ni", body_from_world, stream)) @ TILT
    angular = (run.angular_velocity_body - body_from_world @ planet.angular_velocity_world) @ TILT
    relative_twist = np.hstack([linear, angular])
    weights = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280]) / h
    momentum, v, w = MASS @ relative_twist[4], linear[4], angular[4]
    swept = [np.cross(w, momentum[:3]), np.cross(w, momentum[3:]) + np.cross(v, momentum[:3])]
    own = -(MASS @ (weights @ relative_twist)) - np.concatenate(swept)
    force = TILT @ own[:3]
    wanted = np.concatenate([force, TILT @ own[3:] + np.cross(PLACE, force)])

    twist = np.concatenate([run.velocity_body[4], run.angular_velocity_body[4]])
    rate = model.derivative(run.t[4], run.x[4])[7:13]
    got = BODY.spatial_inertia @ rate + fb.forms.force_cross(twist) @ BODY.spatial_inertia @ twist
    assert np.abs(got - wanted).max() <= 1e-7 * np.abs(wanted).max()


def test_the_moment_of_a_spheroid_is_munks() -> None:
    """½ ρ U² V (k₂ − k₁) sin 2α, and it turns the bow away from the flow. Munk, NACA report 184 (1924)"""
    a, b, speed = 0.8, 0.095, 2.0
    hull = AddedMass.spheroid(water(), a, b)
    model = fb.Model(BODY, [hull])
    along, across = matrix(hull)[0, 0], matrix(hull)[2, 2]
    for alpha in np.radians([-10.0, 3.0, 30.0, 80.0]):
        # Downwards through the water with the bow ahead: the flow comes from below.
        v = speed * np.array([np.cos(alpha), 0.0, np.sin(alpha)])
        moment = model.wrench(0.0, model.state(velocity_body=v))[3:]
        munk = 0.5 * speed**2 * (across - along) * np.sin(2.0 * alpha)
        np.testing.assert_allclose(moment, [0.0, munk, 0.0], rtol=0, atol=ROUNDING * 100.0)
        assert moment[1] * alpha > 0.0


@pytest.mark.parametrize("ratio", [0.01, 0.11875, 0.5, 0.9, 0.96, 0.999, 1.0])
def test_factors_of_a_spheroid_are_lambs_integrals(ratio: float) -> None:
    """Of an ellipsoid: α₀ = abc ∫ dλ/((a² + λ) Δ), and so on. Lamb, Hydrodynamics, articles 114 and 115."""
    with mp.workdps(30):
        b = mp.mpf(ratio)

        def integral(square: Any) -> Any:
            def inner(x: Any) -> Any:
                return 1 / ((square + x) * mp.sqrt(1 + x) * (b**2 + x))

            return b**2 * mp.quad(inner, [0, b**2, 1, 10, mp.inf])

        alpha, beta = integral(mp.mpf(1)), integral(b**2)
        spread = b**2 - 1
        turning = mp.mpf(0)
        if ratio < 1.0:
            turning = spread**2 * (alpha - beta) / (2 * spread + (b**2 + 1) * (beta - alpha)) / (1 + b**2)
        wanted = [float(alpha / (2 - alpha)), float(beta / (2 - beta)), float(turning)]
    mass = 4.0 / 3.0 * np.pi * 1025.0 * ratio**2
    got = matrix(AddedMass.spheroid(water(), 1.0, ratio))
    k = got[[0, 1, 4], [0, 1, 4]] / [mass, mass, mass * (1.0 + ratio**2) / 5.0]
    # Some ten roundings; the third factor falls with the square of the eccentricity and loses that much.
    np.testing.assert_allclose(k, wanted, rtol=1e-12, atol=1e-15)


def test_factors_of_the_limits() -> None:
    mass = 4.0 / 3.0 * np.pi * 1025.0
    sphere = matrix(AddedMass.spheroid(water(), 1.0, 1.0))
    np.testing.assert_allclose(sphere, 0.5 * mass * np.diag([1.0, 1.0, 1.0, 0.0, 0.0, 0.0]), atol=1e-9)
    needle = matrix(AddedMass.spheroid(water(), 1.0, 1e-3)) / (mass * 1e-6)
    # A needle carries its own volume across and nothing along; the error falls as b² ln b.
    np.testing.assert_allclose(np.diag(needle), [0.0, 1.0, 1.0, 0.0, 0.2, 0.2], atol=1e-4)


def test_a_cylinder_is_the_sum_of_its_strips() -> None:
    length, radius = 2.0, 0.1
    whole = matrix(AddedMass.cylinder(water(), length, radius, axial=3.0, roll=0.01))
    x, dx = np.polynomial.legendre.leggauss(8)
    strips = np.zeros((6, 6))
    for place, share in zip(x * length / 2.0, dx * length / 2.0, strict=True):
        strip = np.diag([0.0, 1.0, 1.0, 0.0, 0.0, 0.0]) * share * 1025.0 * np.pi * radius**2
        strips += matrix(AddedMass(water(), strip, at=[place, 0.0, 0.0]))
    strips += np.diag([3.0, 0.0, 0.0, 0.01, 0.0, 0.0])
    np.testing.assert_allclose(whole, strips, rtol=0, atol=1e-12 * np.abs(whole).max())


def test_derivatives_are_its_negatives() -> None:
    given: dict[str, Any] = {
        "X_udot": -5.5,
        "Y_vdot": -82.5,
        "Z_wdot": -55.0,
        "K_pdot": -2.1,
        "M_qdot": -11.9,
        "N_rdot": -24.5,
    }
    np.testing.assert_array_equal(
        np.diag(matrix(AddedMass.from_derivatives(water(), **given))), -np.array([*given.values()])
    )
    with pytest.raises(fb.InputError, match=r"Y_vdot: got 82.5; a derivative of added mass is not positive"):
        AddedMass.from_derivatives(water(), Y_vdot=82.5)


def test_wrong_matrices_are_told() -> None:
    skew = np.diag([1.0, 2.0, 3.0, 1.0, 1.0, 1.0])
    skew[0, 4] = 0.5
    with pytest.raises(fb.InputError, match=r"matrix: not symmetric: \[0, 4\] is 0.5 and \[4, 0\] is 0"):
        AddedMass(water(), skew)
    with pytest.raises(fb.InputError, match=r"smallest eigenvalue is -2"):
        AddedMass(water(), [1.0, -2.0, 1.0, 0.0, 0.0, 0.0])
    with pytest.raises(fb.InputError, match="the spheroid is prolate"):
        AddedMass.spheroid(water(), 0.1, 0.8)
    with pytest.raises(fb.InputError, match=r"environment: got 1025.0; give a"):
        AddedMass(1025.0, np.eye(6))  # type: ignore[arg-type]
