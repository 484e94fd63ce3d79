"""A body moves the same whichever of its frames describes it."""

import numpy as np
import pytest

import freebody as fb

from .scenes import BODY, START, Array, positive_matrix, relative

DAMPING = positive_matrix(np.random.default_rng(6))
PUSH, TWIST, WHERE = np.array([3.0, -2.0, 1.0]), np.array([0.1, 0.2, -0.1]), np.array([0.3, 0.2, -0.1])
PULL, TORQUE, THERE = np.array([1.0, 2.0, 3.0]), np.array([0.2, 0.1, 0.3]), np.array([-0.2, 0.1, 0.4])
TIMES = [0.0, 2.0, 2.0, 5.0, 10.0]
TABLE = np.random.default_rng(5).normal(size=(2, 5, 3))
# A material point, in the axes of the old frame.
POINT = np.array([0.5, 0.6, -0.7])


def forces_seen_from(origin: Array, turn: Array) -> list[fb.Force]:
    """The same forces, their numbers written in the frame at `origin` with axes `turn` (old from new).

    Quadratic damping is none of them: it goes component by component, so it belongs to its axes.
    """

    def place(point: Array) -> Array:
        return turn.T @ (point - origin)

    # V_old = X V_new, and the power VᵀDV is the same.
    zero = np.zeros((3, 3))
    transform = np.block([[turn, fb.forms.skew(origin) @ turn], [zero, turn]])
    return [
        fb.UniformGravity(1.5),
        fb.PointMassGravity(50.0, center=[2.0, 3.0, -8.0]),
        fb.ConstantWrench(turn.T @ PUSH, turn.T @ TWIST, at=place(WHERE)),
        fb.ConstantWrench(PULL, TORQUE, axes="world", at=place(THERE)),
        fb.TabulatedWrench(TIMES, TABLE[0] @ turn, TABLE[1] @ turn, at=place(THERE)),
        fb.LinearDamping(transform.T @ DAMPING @ transform),
        fb.InputWrench(axes="world", at=place(WHERE)),
    ]


def run_in_frame(origin: Array, turn: Array) -> tuple[fb.Trajectory, Array]:
    """The run of the body described in another frame, and the path of the material point."""
    model = fb.Model(BODY.in_frame(origin, turn), forces_seen_from(origin, turn))
    rotation, spin = START["attitude"].as_rotation(), np.array(START["angular_velocity_body"])
    x0 = model.state(
        START["position"] + rotation @ origin,
        fb.Attitude.rotation(rotation @ turn),
        velocity_body=turn.T @ (START["velocity_body"] + np.cross(spin, origin)),
        angular_velocity_body=turn.T @ spin,
    )
    control = [0.5, -0.3, 0.2, 0.1, 0.2, -0.1]
    run = model.simulate(x0, (0.0, 10.0), rtol=1e-12, save_every=0.1, inputs=control)
    return run, run.point(turn.T @ (POINT - origin))


@pytest.fixture(scope="module")
def original() -> tuple[fb.Trajectory, Array]:
    return run_in_frame(np.zeros(3), np.eye(3))


@pytest.mark.parametrize("number", range(10))
def test_same_motion_from_another_frame(original: tuple[fb.Trajectory, Array], number: int) -> None:
    rng = np.random.default_rng(number)
    origin = rng.uniform(-5.0, 5.0, 3)
    quaternion = rng.normal(size=4)
    turn = fb.Attitude.quaternion(quaternion / np.linalg.norm(quaternion)).as_rotation()
    run, path = run_in_frame(origin, turn)
    before, old_path = original
    # Some 300 steps of 1e-12 each, while the forces let small differences grow some tenfold.
    assert relative(path, old_path) <= 1e-9
    assert np.abs(run.world_from_body - before.world_from_body @ turn).max() <= 1e-9
    # What belongs to the body and not to its frame is the same too.
    assert relative(run.com_position_world, before.com_position_world) <= 1e-9
    assert relative(run.com_velocity_world, before.com_velocity_world) <= 1e-9
    assert np.abs(run.kinetic_energy - before.kinetic_energy).max() <= 1e-9 * before.kinetic_energy.max()
    assert np.abs(run.potential_energy - before.potential_energy).max() <= 1e-9 * before.kinetic_energy.max()


def test_frames_make_a_group(rng: np.random.Generator) -> None:
    """In a frame and on from there to another is the same as there at once; and back is where it began."""
    origins = rng.uniform(-5.0, 5.0, (2, 3))
    turns = [fb.Attitude.angles("zyx", rng.uniform(-1.0, 1.0, 3)).as_rotation() for _ in range(2)]
    two = BODY.in_frame(origins[0], turns[0]).in_frame(origins[1], turns[1])
    one = BODY.in_frame(origins[0] + turns[0] @ origins[1], turns[0] @ turns[1])
    back = one.in_frame(
        -(turns[0] @ turns[1]).T @ (origins[0] + turns[0] @ origins[1]), (turns[0] @ turns[1]).T
    )
    # Rounding of offsets of metres against a tensor of their squares.
    for got, expected in ((two, one), (back, BODY)):
        gap = np.abs(got.spatial_inertia - expected.spatial_inertia).max()
        assert gap <= 1e-13 * np.abs(one.spatial_inertia).max()
