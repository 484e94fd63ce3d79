"""Buoyancy: balance, stiffness, periods, and Archimedes by integration."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import Buoyancy, Flotation

from .scenes import Array
from .waters import BODY, DENSITY, water

G = 9.80665
LENGTH, BEAM, DRAUGHT = 2.0, 0.8, 0.2
# A box afloat, the origin anywhere: its waterplane 5 cm above it, its middle 10 cm ahead.
MIDDLE = np.array([0.1, 0.0, -0.05])
VOLUME = LENGTH * BEAM * DRAUGHT
CENTER = MIDDLE + np.array([0.0, 0.0, DRAUGHT / 2.0])
COM = MIDDLE + np.array([0.0, 0.0, 0.02])
BOX = fb.RigidBody(DENSITY * VOLUME, COM, inertia_about_com=np.diag([20.0, 110.0, 120.0]))
FLOAT = Flotation(
    water(),
    VOLUME,
    CENTER,
    waterplane_area=LENGTH * BEAM,
    transverse_moment=LENGTH * BEAM**3 / 12.0,
    longitudinal_moment=BEAM * LENGTH**3 / 12.0,
    at=MIDDLE,
)


def test_a_neutral_body_hovers_and_swings_about_its_centres() -> None:
    """Weight below buoyancy by h: the moment is m g h sin θ about any axis across."""
    lower = np.array([0.0, 0.0, 0.03])
    body = fb.RigidBody(BODY.mass, lower, inertia_about_com=np.diag([0.2, 4.0, 4.2]))
    model = fb.Model(body, [fb.UniformGravity(G), Buoyancy(water(), body.mass / DENSITY)])
    assert np.abs(model.wrench(0.0, model.state([1.0, 2.0, 3.0]))).max() <= 1e-12 * body.mass * G
    for angle in (0.1, 1.0, 2.5):
        got = model.wrench(0.0, model.state(attitude=fb.Attitude.angles("xyz", [angle, 0.0, 0.0])))
        np.testing.assert_allclose(got[3], -body.mass * G * 0.03 * np.sin(angle), rtol=1e-12)
        assert np.abs(got[:3]).max() <= 1e-12 * body.mass * G


def test_the_period_of_roll_under_water() -> None:
    """A pendulum about the mass centre, where the forces cancel: J_c θ'' = −m g h sin θ."""
    lower = np.array([0.0, 0.0, 0.03])
    body = fb.RigidBody(BODY.mass, lower, inertia_about_com=np.diag([0.2, 4.0, 4.2]))
    model = fb.Model(body, [fb.UniformGravity(G), Buoyancy(water(), body.mass / DENSITY)])
    amplitude = 1e-3
    period = 2.0 * np.pi * np.sqrt(0.2 / (body.mass * G * 0.03)) * (1.0 + amplitude**2 / 16.0)
    x0 = model.state(attitude=fb.Attitude.angles("xyz", [amplitude, 0.0, 0.0]))
    run = model.simulate(x0, (0.0, period), rtol=1e-12)
    # The next term of the series is amplitude^4, and the speed at the turn errs by its first order.
    np.testing.assert_allclose(run.x[-1], x0, rtol=0, atol=1e-9)


def afloat(attitude: fb.Attitude, depth: float, element: fb.Force = FLOAT) -> Array:
    """The wrench with the middle of the waterplane so deep, without weight."""
    model = fb.Model(BOX, [element])
    rotation = attitude.as_rotation()
    return model.wrench(0.0, model.state(np.array([0.0, 0.0, depth]) - rotation @ MIDDLE, attitude))


def archimedes(attitude: fb.Attitude, depth: float) -> Array:
    """Columns of the box up to the surface, on a fine grid, by the middle rule."""
    n = 400
    x = (np.arange(n) + 0.5) / n * LENGTH - LENGTH / 2.0
    y = (np.arange(n) + 0.5) / n * BEAM - BEAM / 2.0
    grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    down = attitude.as_rotation()[2]
    top = -(depth + grid @ down[:2]) / down[2]
    column = DRAUGHT - top
    cell = LENGTH * BEAM / n**2
    middle = np.column_stack([grid, (DRAUGHT + top) / 2.0])
    volume, first = column.sum() * cell, (middle * column[:, None]).sum(axis=0) * cell
    force = -DENSITY * G * volume * down
    moment = np.cross(first, -DENSITY * G * down) + np.cross(MIDDLE, force)
    return np.concatenate([force, moment])


@pytest.mark.parametrize("angles", [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.05, 0.3], [-0.12, 0.06, 2.0]])
@pytest.mark.parametrize("depth", [0.0, 0.05, -0.04])
def test_a_box_displaces_what_archimedes_says(angles: Any, depth: float) -> None:
    attitude = fb.Attitude.angles("zyx", angles[::-1])
    # The middle rule errs by the square of the cell, 2.5e-3 of the sides.
    np.testing.assert_allclose(afloat(attitude, depth), archimedes(attitude, depth), rtol=0, atol=1e-4 * 3e3)


def test_its_stiffness_is_that_of_metacentric_heights() -> None:
    h = 1e-4
    level = fb.Attitude.identity()
    heave = (afloat(level, h) - afloat(level, -h))[2] / (2.0 * h)
    assert heave == pytest.approx(-DENSITY * G * LENGTH * BEAM, rel=1e-8)
    weight = BOX.mass * G
    below = CENTER[2] - COM[2]
    for axis, moment in ((0, LENGTH * BEAM**3 / 12.0), (1, BEAM * LENGTH**3 / 12.0)):
        sides = []
        for sign in (1, -1):
            turn = fb.Attitude.angles("xyz", sign * h * np.eye(3)[axis])
            model = fb.Model(BOX, [fb.UniformGravity(G), FLOAT])
            x = model.state(-turn.as_rotation() @ MIDDLE, turn)
            sides.append(model.wrench(0.0, x)[3 + axis])
        # GM = BM − BG: heeling is stiffened by the waterplane, and eased by weight that lies above B.
        stiffness = weight * (moment / VOLUME - below)
        assert (sides[0] - sides[1]) / (2.0 * h) == pytest.approx(-stiffness, rel=1e-6)


def test_metacentric_heights_say_the_same() -> None:
    below = CENTER[2] - COM[2]
    other = Flotation.from_metacentric_heights(
        water(),
        VOLUME,
        CENTER,
        COM,
        waterplane_area=LENGTH * BEAM,
        transverse=LENGTH * BEAM**3 / 12.0 / VOLUME - below,
        longitudinal=BEAM * LENGTH**3 / 12.0 / VOLUME - below,
        at=MIDDLE,
    )
    for key, value in FLOAT.parameters.items():
        # A sum and its difference.
        assert other.parameters[key] == pytest.approx(value, rel=1e-14)


def test_a_box_floats_at_rest_and_heaves_with_its_period() -> None:
    model = fb.Model(BOX, [fb.UniformGravity(G), FLOAT])
    rest = model.state(-MIDDLE)
    assert np.abs(model.wrench(0.0, rest)).max() <= 1e-12 * BOX.mass * G
    # Heave alone is linear, without the water it carries: ω² = ρ g A/m = g/T.
    period = 2.0 * np.pi * np.sqrt(DRAUGHT / G)
    x0 = model.state(np.array([0.0, 0.0, 0.05]) - MIDDLE)
    run = model.simulate(x0, (0.0, period), rtol=1e-12)
    # Fifty steps of 1e-12, and an unstable nothing: heave does not heel it.
    np.testing.assert_allclose(run.x[-1], x0, rtol=0, atol=1e-10)


def test_buoyancy_afloat_keeps_the_energy() -> None:
    """That of the water pushed away: what the first moment of the displaced volume says."""
    model = fb.Model(BOX, [fb.UniformGravity(G), FLOAT])
    x0 = model.state(
        [0.0, 0.0, 0.08],
        fb.Attitude.angles("zyx", [0.3, 0.1, 0.3]),
        velocity_body=[0.1, 0.2, 0.1],
        angular_velocity_body=[0.3, 0.2, 0.1],
    )
    run = model.simulate(x0, (0.0, 5.0), rtol=1e-11, save_every=0.05)
    down = run.world_from_body[:, 2]
    depth = run.point(MIDDLE)[:, 2]
    area, across, along = LENGTH * BEAM, LENGTH * BEAM**3 / 12.0, BEAM * LENGTH**3 / 12.0
    squares = area * depth**2 + along * down[:, 0] ** 2 + across * down[:, 1] ** 2
    stored = DENSITY * G * (VOLUME * (depth + down @ (CENTER - MIDDLE)) + 0.5 * squares / down[:, 2])
    total = run.kinetic_energy + run.potential_energy + stored
    # A hundred steps of 1e-11.
    assert np.abs(total - total[0]).max() <= 1e-9 * np.abs(stored).max()


def test_a_hull_capsized_stays_finite() -> None:
    for angle in (1.4, np.pi / 2.0, 3.0):
        assert np.isfinite(afloat(fb.Attitude.angles("xyz", [angle, 0.1, 0.0]), 0.1)).all()


def test_wrong_hulls_are_told() -> None:
    sizes: dict[str, Any] = {"waterplane_area": 1.0, "transverse_moment": 0.1, "longitudinal_moment": 0.1}
    with pytest.raises(fb.InputError, match=r"lies 0.1 m above the waterplane"):
        Flotation(water(), 0.1, [0.0, 0.0, -0.1], **sizes)
    with pytest.raises(fb.InputError, match="volume"):
        Buoyancy(water(), 0.0)
    with pytest.raises(fb.InputError, match=r"transverse: got -5 m; BM"):
        Flotation.from_metacentric_heights(
            water(), 0.1, [0, 0, 0.1], [0, 0, 0], waterplane_area=1.0, transverse=-5.0, longitudinal=1.0
        )
