"""Attitudes: in by any description, out by any other, near singularities and near the identity too."""

import copy
import itertools
import pickle

import numpy as np
import pytest

import freebody as fb

SEQUENCES = fb.forms.SEQUENCES
# The second angle at its singular values, and what a rounding, a metre-stick and an eye can tell from them.
GAPS = [0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-4]


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1776)


def random_attitude(rng: np.random.Generator) -> fb.Attitude:
    q = rng.normal(size=4)
    return fb.Attitude.quaternion(q / np.linalg.norm(q))


def elementary(axis: str, angle: float) -> np.ndarray:
    """A turn about one axis, from its definition."""
    i = "xyz".index(axis)
    j, k = (i + 1) % 3, (i + 2) % 3
    c = np.eye(3)
    c[j, j] = c[k, k] = np.cos(angle)
    c[k, j] = np.sin(angle)
    c[j, k] = -c[k, j]
    return c


def singular(sequence: str) -> list[float]:
    return [0.0, np.pi] if sequence[0] == sequence[2] else [0.5 * np.pi, -0.5 * np.pi]


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_angles_turn_about_moving_axes(sequence: str, rng: np.random.Generator) -> None:
    for angles in rng.uniform(-np.pi, np.pi, (10, 3)):
        first, second, third = (elementary(axis, angle) for axis, angle in zip(sequence, angles, strict=True))
        attitude = fb.Attitude.angles(sequence, angles)
        # Three products of cosines: some roundings.
        np.testing.assert_allclose(attitude.as_rotation(), first @ second @ third, rtol=0, atol=1e-15)


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_angles_come_back_as_typed(sequence: str, rng: np.random.Generator) -> None:
    for angles in [*rng.uniform(-10.0, 10.0, (5, 3)), np.array([7.0, singular(sequence)[1], -9.0])]:
        attitude = fb.Attitude.angles(sequence, angles)
        assert np.array_equal(attitude.as_angles(sequence), angles)
        # ... and not those of another sequence.
        for other in SEQUENCES:
            again = fb.Attitude.angles(other, attitude.as_angles(other))
            np.testing.assert_allclose(again.as_rotation(), attitude.as_rotation(), rtol=0, atol=5e-15)


def test_every_description_gives_every_other(rng: np.random.Generator) -> None:
    for _ in range(20):
        attitude = random_attitude(rng)
        rotation, quaternion = attitude.as_rotation(), attitude.as_quaternion()
        for again in (
            fb.Attitude.rotation(rotation),
            fb.Attitude.quaternion(quaternion),
            fb.Attitude.quaternion(-quaternion),
            *(fb.Attitude.angles(s, attitude.as_angles(s)) for s in SEQUENCES),
        ):
            # A handful of roundings in each conversion.
            np.testing.assert_allclose(again.as_rotation(), rotation, rtol=0, atol=3e-15)
            sign = np.sign(again.as_quaternion() @ quaternion)
            np.testing.assert_allclose(again.as_quaternion(), sign * quaternion, rtol=0, atol=3e-15)


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_the_second_angle_has_its_range(sequence: str, rng: np.random.Generator) -> None:
    low, high = (0.0, np.pi) if sequence[0] == sequence[2] else (-0.5 * np.pi, 0.5 * np.pi)
    seconds = [random_attitude(rng).as_angles(sequence)[1] for _ in range(50)]
    assert low <= min(seconds)
    assert max(seconds) <= high


@pytest.mark.parametrize("sequence", SEQUENCES)
@pytest.mark.parametrize("gap", GAPS)
def test_nothing_is_lost_near_a_singularity(sequence: str, gap: float, rng: np.random.Generator) -> None:
    for pole, side in itertools.product(singular(sequence), (1.0, -1.0)):
        first, third = rng.uniform(-np.pi, np.pi, 2)
        rotation = fb.Attitude.angles(sequence, [first, pole + side * gap, third]).as_rotation()
        angles = fb.Attitude.rotation(rotation).as_angles(sequence)
        again = fb.Attitude.angles(sequence, angles).as_rotation()
        # The first and third angle may be ill-conditioned, the attitude they stand for is not ...
        np.testing.assert_allclose(again, rotation, rtol=0, atol=5e-15)
        # ... nor is the distance to the singularity.
        assert abs(np.min(np.abs(angles[1] - singular(sequence))) - gap) < 5e-15
        # At the singularity the first angle is zero, as the docstring says.
        assert gap > 0.0 or angles[0] == 0.0


@pytest.mark.parametrize("size", [1e-7, 1e-12, 1e-300, 0.0])
def test_small_turns_keep_their_digits(size: float, rng: np.random.Generator) -> None:
    for axis in [*np.eye(3), *(random_attitude(rng).as_rotation()[0] for _ in range(5))]:
        half = 0.5 * size * axis
        attitude = fb.Attitude.quaternion([np.sqrt(1.0 - half @ half), *half])
        rotation = attitude.as_rotation()
        # First order in the turn: E + <turn>; the second order, size² / 2, is left out.
        expected = np.eye(3) + fb.forms.skew(size * axis)
        np.testing.assert_allclose(rotation, expected, rtol=0, atol=2e-16 + 0.5 * size**2)
        back = fb.Attitude.rotation(rotation)
        # Through a matrix, whose off-diagonal entries hold the turn to all digits.
        np.testing.assert_allclose(back.as_quaternion()[1:], half, rtol=1e-9, atol=0.0)
        for sequence in ("zyx", "xyz", "yzx"):
            angles = attitude.as_angles(sequence)
            by_axis = np.array([angles[sequence.index(name)] for name in "xyz"])
            # Tait-Bryan angles of a small turn are its components, to second order.
            np.testing.assert_allclose(by_axis, size * axis, rtol=0, atol=size**2)


def test_half_turns(rng: np.random.Generator) -> None:
    for axis in [*np.eye(3), random_attitude(rng).as_rotation()[0]]:
        rotation = 2.0 * np.outer(axis, axis) - np.eye(3)
        attitude = fb.Attitude.rotation(rotation)
        np.testing.assert_allclose(np.abs(attitude.as_quaternion() @ [0.0, *axis]), 1.0, rtol=1e-15)
        np.testing.assert_allclose(attitude.as_rotation(), rotation, rtol=0, atol=3e-15)
        for sequence in SEQUENCES:
            again = fb.Attitude.angles(sequence, attitude.as_angles(sequence)).as_rotation()
            np.testing.assert_allclose(again, rotation, rtol=0, atol=3e-15)


def test_what_is_typed_with_seven_digits_becomes_exact(rng: np.random.Generator) -> None:
    for _ in range(10):
        exact = random_attitude(rng)
        for attitude in (
            fb.Attitude.rotation(np.round(exact.as_rotation(), 7)),
            fb.Attitude.quaternion(np.round(exact.as_quaternion(), 7)),
        ):
            c, q = attitude.as_rotation(), attitude.as_quaternion()
            np.testing.assert_allclose(c.T @ c, np.eye(3), rtol=0, atol=3e-15)
            assert np.linalg.norm(q) == pytest.approx(1.0, abs=3e-16)
            np.testing.assert_allclose(c, exact.as_rotation(), rtol=0, atol=1e-6)


def test_the_identity() -> None:
    identity = fb.Attitude.identity()
    assert np.array_equal(identity.as_rotation(), np.eye(3))
    assert identity.as_quaternion().tolist() == [1.0, 0.0, 0.0, 0.0]
    for sequence in SEQUENCES:
        assert identity.as_angles(sequence).tolist() == [0.0, 0.0, 0.0]
        # A minus before a zero puzzles whoever reads it.
        assert not np.signbit(identity.as_angles(sequence)).any()
    assert repr(identity) == "Attitude.quaternion([1.0, 0.0, 0.0, 0.0])"


def test_answers_are_copies() -> None:
    attitude = fb.Attitude.angles("zyx", [0.1, 0.2, 0.3])
    for answer in (attitude.as_rotation, attitude.as_quaternion, lambda: attitude.as_angles("zyx")):
        answer()[...] = 9.0
        assert np.all(answer() < 2.0)


def test_copies_and_pickles_are_equal() -> None:
    attitude = fb.Attitude.angles("zyx", [7.0, 0.2, 0.3])
    for twin in (pickle.loads(pickle.dumps(attitude)), copy.deepcopy(attitude)):
        assert twin.as_angles("zyx").tolist() == [7.0, 0.2, 0.3]
        assert np.array_equal(twin.as_quaternion(), attitude.as_quaternion())
