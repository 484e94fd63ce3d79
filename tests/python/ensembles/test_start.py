"""Initial states: what is dispersed is what the motion has, in every chart."""

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import freebody as fb
from freebody.ensembles.rotations import nearest_angles

from .scene import ATTITUDE, everything, model, state

CHARTS = [(a, f) for a in ("quaternion", "zyx", "zxz") for f in ("quasi_velocity", "generalized")]
EACH = pytest.mark.parametrize(("attitude", "form"), CHARTS)


def motions(ensemble: fb.Ensemble, n: int = 50) -> tuple[np.ndarray, ...]:
    """Positions, rotations and twists of its first runs, and the dispersed values by name."""
    draw = ensemble.sample(0, n)
    position, quaternion, twist = ensemble.base.motion(draw.x0)
    return position, fb.forms.rotation_from_quaternion(quaternion), twist, draw.dispersed, draw.x0


def columns(ensemble: fb.Ensemble, stem: str) -> list[int]:
    return [ensemble.names.index(f"{stem}_{axis}") for axis in "xyz"]


@EACH
def test_the_motion_has_what_is_dispersed(attitude: str, form: Any):
    ensemble = everything(50, attitude=attitude, form=form)
    position, rotation, twist, values, x = motions(ensemble)
    assert (position == values[:, columns(ensemble, "position")]).all()
    # Rates of coordinates and back: rounding of numbers up to 10, by angle rates up to 10 times that.
    velocity = np.einsum("nij,nj->ni", rotation, twist[:, :3])
    np.testing.assert_allclose(velocity, values[:, columns(ensemble, "velocity_world")], atol=1e-13)
    turn = values[:, columns(ensemble, "angular_velocity_body")]
    np.testing.assert_allclose(twist[:, 3:], turn, atol=1e-13)
    offsets = Rotation.from_rotvec(values[:, columns(ensemble, "attitude")]).as_matrix()
    np.testing.assert_allclose(rotation, ATTITUDE.as_rotation() @ offsets, atol=1e-14)
    place = ensemble.base.auxiliary["fin.servo"]
    assert (x[:, place] == values[:, ensemble.names.index("fin.servo")]).all()


@EACH
def test_what_is_not_dispersed_stays_to_the_last_bit(attitude: str, form: Any):
    base = model(attitude, form)
    x0 = state(base)
    ensemble = base.ensemble(x0, {"position": fb.Normal(0.0, 1.0)}, n=20, seed=1)
    x = ensemble.sample().x0
    assert (x[:, 3:] == x0[3:]).all()
    assert (base.ensemble(x0, {"mass": fb.Uniform(1.0, 2.0)}, n=5).sample().x0 == x0).all()


@EACH
def test_an_attitude_turns_the_body_with_its_velocity(attitude: str, form: Any):
    base = model(attitude, form)
    ensemble = base.ensemble(state(base), {"attitude": fb.Normal(0.0, 0.3)}, n=20, seed=1)
    _, rotation, twist, _, _ = motions(ensemble, 20)
    np.testing.assert_allclose(twist, np.tile([5.0, 0.5, -0.3, 0.8, -1.1, 1.7], (20, 1)), atol=1e-13)
    assert np.ptp(rotation[:, 0, 0]) > 0.05


@pytest.mark.parametrize("stem", ["velocity", "angular_velocity"])
@EACH
def test_body_and_world_axes_describe_one_motion(stem: str, attitude: str, form: Any):
    base = model(attitude, form)
    x0 = state(base)
    world = base.ensemble(x0, {f"{stem}_world": fb.Offset(fb.Normal(0.0, 0.5))}, n=20, seed=1).sample()
    turned = world.dispersed @ ATTITUDE.as_rotation()
    body = base.ensemble(x0, {f"{stem}_body": fb.Samples(turned)}, n=20).sample()
    np.testing.assert_allclose(body.x0, world.x0, atol=1e-13)


@pytest.mark.parametrize("sequence", ["zyx", "xyz", "zxz", "yxy"])
def test_angles_stay_next_to_the_nominal_ones(sequence: str):
    """Of the angles of one attitude, turns and the other branch included, those nearest to the nominal."""
    rng = np.random.default_rng(3)
    nominal = np.array([7.0, 0.9 if sequence[0] == sequence[2] else 2.0, -12.0])
    near = nominal + rng.uniform(-0.4, 0.4, (50, 3))
    found = nearest_angles(fb.forms.rotation(near, sequence), sequence, nominal)
    np.testing.assert_allclose(found, near, atol=1e-12)
