"""Rigid bodies: which numbers are one, and that any frame describes the same."""

import pickle
from typing import Any

import numpy as np
import pytest

import freebody as fb

# Tests on random bodies draw from fixed seeds; sizes are of order one unless a test says otherwise, so that a
# tolerance of 1e-13 is some hundred roundings.
TOLERANCE = 1e-13


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1906)


def random_rotation(rng: np.random.Generator) -> np.ndarray:
    q = rng.normal(size=4)
    return fb.Attitude.quaternion(q / np.linalg.norm(q)).as_rotation()


def point_masses(rng: np.random.Generator, count: int = 6) -> tuple[np.ndarray, np.ndarray]:
    """Masses (n,) and places (n, 3)."""
    return rng.uniform(0.5, 2.0, count), rng.normal(size=(count, 3))


def body_of(masses: np.ndarray, places: np.ndarray, **kind: str) -> fb.RigidBody:
    """The body of point masses, by sums that know no theorem about parallel axes."""
    com = masses @ places / masses.sum()
    about = places if kind.get("about") == "origin" else places - com
    squares = np.einsum("ni,ni->n", about, about)
    tensor = np.einsum(
        "n,nij->ij", masses, squares[:, None, None] * np.eye(3) - about[:, :, None] * about[:, None, :]
    )
    field = "inertia_about_origin" if kind.get("about") == "origin" else "inertia_about_com"
    return fb.RigidBody(masses.sum(), com, **{field: tensor})


def same(a: fb.RigidBody, b: fb.RigidBody, tolerance: float = TOLERANCE) -> None:
    np.testing.assert_allclose(a.mass, b.mass, rtol=tolerance)
    np.testing.assert_allclose(a.com, b.com, rtol=0, atol=tolerance)
    np.testing.assert_allclose(a.inertia_about_com, b.inertia_about_com, rtol=0, atol=10 * tolerance)


def test_about_com_and_about_origin_are_one_body(rng: np.random.Generator) -> None:
    masses, places = point_masses(rng)
    a, b = body_of(masses, places), body_of(masses, places, about="origin")
    same(a, b)
    np.testing.assert_allclose(a.inertia_about_origin, b.inertia_about_origin, atol=1e-12)


def test_spatial_inertia(rng: np.random.Generator) -> None:
    masses, places = point_masses(rng)
    body = body_of(masses, places)
    theta = body.spatial_inertia
    # Konoplev (1.6) as a sum over point masses: each adds m Aᵀ A with A = [E, -⟨r⟩].
    maps = [np.hstack([np.eye(3), -fb.forms.skew(r)]) for r in places]
    expected = sum(m * a.T @ a for m, a in zip(masses, maps, strict=True))
    np.testing.assert_allclose(theta, expected, rtol=0, atol=1e-12)
    assert np.array_equal(theta, theta.T)
    assert np.linalg.eigvalsh(theta)[0] > 0.0
    # The inverse is in closed form; its error grows with the condition number, here below 100.
    np.testing.assert_allclose(theta @ body.inverse_spatial_inertia, np.eye(6), rtol=0, atol=1e-13)
    np.testing.assert_allclose(
        body.inverse_spatial_inertia, body.inverse_spatial_inertia.T, rtol=0, atol=1e-15
    )


def test_principal_moments_and_axes(rng: np.random.Generator) -> None:
    moments, axes = np.array([2.0, 3.0, 4.5]), random_rotation(rng)
    tensor = fb.principal_inertia(moments, axes)
    body = fb.RigidBody(1.0, inertia_about_com=tensor)
    np.testing.assert_allclose(body.principal_moments, moments, rtol=1e-14)
    for moment, axis in zip(moments, axes.T, strict=True):
        np.testing.assert_allclose(tensor @ axis, moment * axis, rtol=0, atol=1e-14)
    assert np.array_equal(fb.principal_inertia(moments), np.diag(moments))


def test_products_in_the_positive_integral_convention(rng: np.random.Generator) -> None:
    masses, places = point_masses(rng)
    x, y, z = (places - masses @ places / masses.sum()).T
    tensor = fb.positive_integral_inertia(
        masses @ (y * y + z * z),
        masses @ (x * x + z * z),
        masses @ (x * x + y * y),
        Pxy=masses @ (x * y),
        Pxz=masses @ (x * z),
        Pyz=masses @ (y * z),
    )
    np.testing.assert_allclose(tensor, body_of(masses, places).inertia_about_com, rtol=0, atol=TOLERANCE)
    assert fb.positive_integral_inertia(1, 2, 3, 0.1)[0, 1] == -0.1


def test_another_frame_and_back(rng: np.random.Generator) -> None:
    body = body_of(*point_masses(rng))
    for _ in range(10):
        origin, turn = 5.0 * rng.normal(size=3), random_rotation(rng)
        there = body.in_frame(origin, turn)
        # The way back: the old origin and axes as the new frame sees them.
        back = there.in_frame(-turn.T @ origin, turn.T)
        same(back, body)
        np.testing.assert_allclose(there.principal_moments, body.principal_moments, rtol=1e-13)
        assert (there.mass, there.name) == (body.mass, body.name)


def test_frames_are_a_group(rng: np.random.Generator) -> None:
    masses, places = point_masses(rng)
    body = body_of(masses, places)
    (r1, c1), (r2, c2) = [(rng.normal(size=3), random_rotation(rng)) for _ in range(2)]
    same(body.in_frame(r1, c1).in_frame(r2, c2), body.in_frame(r1 + c1 @ r2, c1 @ c2))
    same(body.in_frame(), body, 0.0)
    # What the new frame is: places r in it are c1ᵀ(r - r1).
    same(body.in_frame(r1, c1), body_of(masses, (places - r1) @ c1))
    # Konoplev (1.6): the same kinetic energy, so Θ goes with the twist's transform.
    lift = np.block([[c1, np.zeros((3, 3))], [fb.forms.skew(r1) @ c1, c1]])
    turned = np.linalg.solve(lift, np.linalg.solve(lift, body.spatial_inertia).T)
    np.testing.assert_allclose(body.in_frame(r1, c1).spatial_inertia, turned, rtol=0, atol=1e-12)


def test_exact_turns_stay_exact() -> None:
    body = fb.RigidBody(1.0, [1.0, 2.0, 3.0], inertia_about_com=np.diag([2.0, 3.0, 4.0]))
    quarter = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    turned = body.in_frame(rotation=quarter)
    assert turned.com.tolist() == [-2.0, 1.0, 3.0]
    assert np.array_equal(turned.inertia_about_com, np.diag([3.0, 2.0, 4.0]))


def test_a_rotation_typed_with_seven_digits_changes_no_body(rng: np.random.Generator) -> None:
    body = body_of(*point_masses(rng))
    typed = np.round(random_rotation(rng), 7)
    moved = body.in_frame(rotation=typed)
    np.testing.assert_allclose(moved.principal_moments, body.principal_moments, rtol=1e-14)
    np.testing.assert_allclose(np.linalg.norm(moved.com), np.linalg.norm(body.com), rtol=1e-14)


def test_joined_bodies_are_the_sum_of_their_point_masses(rng: np.random.Generator) -> None:
    (m1, p1), (m2, p2), (m3, p3) = (point_masses(rng) for _ in range(3))
    a, b, c = body_of(m1, p1), body_of(m2, p2), body_of(m3, p3)
    both = body_of(np.concatenate([m1, m2]), np.concatenate([p1, p2]))
    same(a + b, both)
    np.testing.assert_allclose(
        (a + b).spatial_inertia, a.spatial_inertia + b.spatial_inertia, rtol=0, atol=1e-12
    )
    same(a + b, b + a)
    same((a + b) + c, a + (b + c))
    assert (a + b).name == "body + body"
    # Joining and moving commute.
    r, turn = rng.normal(size=3), random_rotation(rng)
    same((a + b).in_frame(r, turn), a.in_frame(r, turn) + b.in_frame(r, turn))


EDGES = {
    "disc": [1.0, 1.0, 2.0],
    "lamina": [1.0, 2.0, 3.0],
    "thin rod": [1e-9, 1.0, 1.0],
    "wire": [1e-13, 1.0, 1.0],
    "thin lamina": [1e-6, 1.0, 1.0 + 1e-6],
    "ball": [1.0, 1.0, 1.0],
}


@pytest.mark.parametrize("size", [1e-20, 1.0, 1e20])
@pytest.mark.parametrize("edge", EDGES)
def test_bodies_at_the_edge_pass_in_every_frame(edge: str, size: float, rng: np.random.Generator) -> None:
    moments = size * np.array(EDGES[edge])
    for _ in range(20):
        tensor = fb.principal_inertia(moments, random_rotation(rng))
        body = fb.RigidBody(1.0, inertia_about_com=tensor, name=edge)
        nearby = np.sqrt(size) * rng.normal(size=3)
        # Rounding of the tensor in turned axes: some units in the last place of its largest entry.
        np.testing.assert_allclose(body.principal_moments, moments, rtol=0, atol=4e-15 * moments[2])
        assert (body.in_frame(nearby, random_rotation(rng)) + body).mass == 2.0
        assert pickle.loads(pickle.dumps(body)) == body


# Nearer to rounding than this, the smallest moment cannot be known about so far an origin.
FAR = [(edge, d) for edge in EDGES for d in (1.0, 1e2, 1e5) if EDGES[edge][0] > 1e-14 * (1.0 + d**2)]


@pytest.mark.parametrize(("edge", "distance"), FAR)
def test_bodies_at_the_edge_pass_about_a_far_origin(
    edge: str, distance: float, rng: np.random.Generator
) -> None:
    for _ in range(20):
        com = distance * random_rotation(rng)[0]
        about_com = fb.principal_inertia(EDGES[edge], random_rotation(rng))
        offset = np.dot(com, com) * np.eye(3) - np.outer(com, com)
        body = fb.RigidBody(1.0, com, inertia_about_origin=about_com + offset, name=edge)
        # The tensor about the origin is of the size distance², known to some roundings of it.
        np.testing.assert_allclose(
            body.inertia_about_com, about_com, rtol=0, atol=1e-15 * (1.0 + distance**2)
        )
        # What was accepted once stays a body, however it is described.
        assert (body.in_frame(com, random_rotation(rng)) + body).mass == 2.0
        assert pickle.loads(pickle.dumps(body)) == body


def test_ten_decimals_are_enough() -> None:
    # A lamina and an asymmetry as a print-out with ten decimals leaves them.
    typed = [[0.3333333333, 0.1000000001, 0.0], [0.1, 0.3333333333, 0.0], [0.0, 0.0, 0.6666666667]]
    body = fb.RigidBody(1.0, inertia_about_com=typed)
    assert np.array_equal(body.inertia_about_com, body.inertia_about_com.T)


# What cannot be a body: arguments, and the rule, the numbers and the nearest fix that the message must hold.
REFUSED: dict[str, tuple[dict[str, Any], list[str]]] = {
    "zero mass": (
        {"mass": 0.0},
        ["mass must be a positive finite number of kg", "got 0.0", "greater than 0"],
    ),
    "negative mass": ({"mass": -1.5}, ["mass must be a positive", "got -1.5", "give the mass in kg"]),
    "infinite mass": ({"mass": np.inf}, ["mass must be a positive finite", "got inf"]),
    "no mass": ({"mass": np.nan}, ["mass must be a positive finite", "got NaN"]),
    "infinite com": ({"com": [0, np.inf, 0]}, ["com must be three finite numbers in m", "[0.0, inf, 0.0]"]),
    "broken tensor": (
        {"inertia_about_com": np.diag([1.0, np.nan, 1.0])},
        ["inertia_about_com must be finite", "NaN", "give every entry"],
    ),
    "asymmetric": (
        {"inertia_about_origin": [[1, 0.125, 0], [0.25, 1, 0], [0, 0, 1]]},
        [
            "inertia_about_origin must be symmetric (to 1e-9 of its largest entry)",
            "entry (1, 2) is 0.125 and entry (2, 1) is 0.25 kg m²",
            "set both to 0.1875",
        ],
    ),
    "negative moment": (
        {"inertia_about_com": np.diag([1.0, -1.0, 3.0])},
        [
            "every principal moment about the mass centre must be positive",
            "[-1.0, 1.0, 3.0]",
            "signs of the products",
        ],
    ),
    "rod without thickness": (
        {"inertia_about_com": np.diag([0.0, 1.0, 1.0])},
        [
            "must be positive",
            "[0.0, 1.0, 1.0]",
            "give a thin rod a small moment about its axis, such as 1e-9",
        ],
    ),
    "nothing": (
        {"inertia_about_com": np.zeros((3, 3))},
        ["must be positive", "[0.0, 0.0, 0.0]", "check the units"],
    ),
    "triangle": (
        {"inertia_about_com": np.diag([3.0, 1.0, 1.5])},
        [
            "no principal moment may exceed the sum of the other two (to 1e-9 of the largest)",
            "got 1.0 + 1.5 < 3.0 kg m²",
            "the largest can be at most 2.5",
        ],
    ),
    "triangle by little": (
        {"inertia_about_com": np.diag([1.0, 1.0, 2.00000001])},
        ["no principal moment may exceed", "1.0 + 1.0 < 2.00000001", "at most 2.0"],
    ),
    "about the wrong point": (
        {"com": [3.0, 0, 0], "inertia_about_origin": np.diag([1.0, 2.0, 2.5])},
        [
            "inertia_about_origin is too small for the offset of the mass centre",
            "m|com|² alone is 9.0 kg m²",
            "[-7.0, -6.5, 1.0]",
            "if the tensor is about the mass centre, pass it as inertia_about_com",
        ],
    ),
    "about no point": (
        {"com": [3.0, 0, 0], "inertia_about_origin": np.diag([1.0, 2.0, 5.0])},
        ["too small for the offset", "9.0", "check the mass, the mass centre and the tensor"],
    ),
    "neither": (
        {"inertia_about_com": None},
        ["exactly one of inertia_about_com and inertia_about_origin", "neither"],
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_no_body_is_refused(case: str) -> None:
    arguments, told = REFUSED[case]
    complete = {"mass": 1.0, "name": "tail boom"} | arguments
    if "inertia_about_origin" not in complete:
        complete.setdefault("inertia_about_com", np.eye(3))
    with pytest.raises(fb.BodyError) as caught:
        fb.RigidBody(**complete)
    message = str(caught.value)
    assert message.startswith("body 'tail boom': ")
    assert [part for part in told if part not in message] == []


@pytest.mark.parametrize(
    "case", ["negative moment", "triangle", "triangle by little", "rod without thickness"]
)
def test_what_is_no_body_is_none_in_any_frame(case: str, rng: np.random.Generator) -> None:
    tensor = np.asarray(REFUSED[case][0]["inertia_about_com"], dtype=float)
    for _ in range(20):
        turn = random_rotation(rng)
        turned = turn @ tensor @ turn.T
        with pytest.raises(fb.BodyError, match="principal moment"):
            fb.RigidBody(1.0, inertia_about_com=turned)


def test_a_body_is_a_value() -> None:
    body = fb.RigidBody(2.0, [0.1, 0.2, 0.3], inertia_about_com=np.diag([1.0, 2.0, 2.5]), name="keel")
    again = fb.RigidBody(2.0, [0.1, 0.2, 0.3], inertia_about_com=np.diag([1.0, 2.0, 2.5]), name="keel")
    other = fb.RigidBody(2.0, [0.1, 0.2, 0.3], inertia_about_com=np.diag([1.0, 2.0, 2.6]), name="keel")
    renamed = fb.RigidBody(2.0, [0.1, 0.2, 0.3], inertia_about_com=np.diag([1.0, 2.0, 2.5]), name="fin")
    assert body == again
    assert hash(body) == hash(again)
    assert len({body, again, other, renamed}) == 3
    assert body != 2.0
    assert repr(body) == "RigidBody(2 kg, com=[0.1, 0.2, 0.3] m, name='keel')"
    restored = pickle.loads(pickle.dumps(body))
    assert restored == body
    assert type(restored) is fb.RigidBody
    body.com[0] = 9.0
    assert body == again


@pytest.mark.parametrize("field", ["mass", "com", "name", "inertia_about_com", "spatial_inertia"])
def test_a_body_does_not_change(field: str) -> None:
    body = fb.RigidBody(2.0, inertia_about_com=np.eye(3))
    with pytest.raises(AttributeError):
        setattr(body, field, 1.0)
