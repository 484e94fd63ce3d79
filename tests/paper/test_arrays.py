"""Forms on arrays: leading dimensions broadcast, wrong arguments are named."""

import inspect

import numpy as np
import pytest

import freebody as fb
from freebody import forms
from freebody.verify.point_masses import Motion

ANGLES = "yzx"


@pytest.fixture
def angles() -> str:
    return ANGLES


def test_leading_dimensions_broadcast_like_a_loop(body: fb.RigidBody, rng: np.random.Generator) -> None:
    q = Motion.random(rng, ANGLES, (3, 1)).q
    q_dot = rng.normal(size=(4, 6))
    wrench = rng.normal(size=6)
    got = forms.generalized_acceleration(body, q, q_dot, wrench, ANGLES)
    assert got.shape == (3, 4, 6)
    sums = forms.lagrange(body, q, q_dot, ANGLES).christoffel
    symbols = forms.christoffel_symbols(body, q, ANGLES)
    assert symbols.shape == (3, 1, 6, 6, 6)
    for i in range(3):
        for j in range(4):
            one = forms.generalized_acceleration(body, q[i, 0], q_dot[j], wrench, ANGLES)
            np.testing.assert_array_equal(got[i, j], one)
            alone = forms.lagrange(body, q[i, 0], q_dot[j], ANGLES)
            np.testing.assert_array_equal(sums[i, j], alone.christoffel)


def test_matrices_among_the_arguments_broadcast_like_a_loop(rng: np.random.Generator) -> None:
    position = rng.normal(size=(3, 1, 3))
    rotation = Motion.random(rng, ANGLES, (4,)).rotation.value
    got = forms.wrench_transform(position, rotation)
    assert got.shape == (3, 4, 6, 6)
    for i in range(3):
        for j in range(4):
            np.testing.assert_array_equal(got[i, j], forms.wrench_transform(position[i, 0], rotation[j]))


def test_layout_and_type_of_an_array_do_not_matter(body: fb.RigidBody, rng: np.random.Generator) -> None:
    twist = rng.integers(-5, 5, size=(4, 6))
    expected = forms.force_cross(twist.astype(float))
    for same in (
        twist,
        twist.tolist(),
        np.asfortranarray(twist),
        twist.astype(np.float32),
        twist[::-1][::-1],
    ):
        np.testing.assert_array_equal(forms.force_cross(same), expected)
    energy = forms.kinetic_energy(body, twist)
    assert energy.shape == (4,)
    assert np.ndim(forms.kinetic_energy(body, twist[0])) == 0
    assert expected.dtype == np.float64


def test_arguments_are_left_alone(body: fb.RigidBody, rng: np.random.Generator) -> None:
    q, q_dot = rng.normal(size=(2, 6))
    before = q.copy(), q_dot.copy()
    result = forms.generalized(body, q, q_dot, ANGLES)
    result.D[...] = 0.0
    np.testing.assert_array_equal((q, q_dot), before)
    forms.spatial_inertia(body)[...] = 0.0
    assert forms.spatial_inertia(body)[0, 0] == body.mass


# The shape of one item of every array argument, by its name.
ITEMS = {
    "vector": (3,),
    "point": (3,),
    "position": (3,),
    "acceleration": (3,),
    "moment": (3,),
    "alpha": (3,),
    "alpha_dot": (3,),
    "angular_velocity_body": (3,),
    "quaternion": (4,),
    "q": (6,),
    "q_dot": (6,),
    "q_ddot": (6,),
    "twist": (6,),
    "twist_rate": (6,),
    "wrench": (6,),
    "x": (12,),
    "rotation": (3, 3),
    "world_from_body": (3, 3),
    "inertia": (3, 3),
}
FUNCTIONS = [name for name in forms.__all__ if name.islower()]


def taking(field: str) -> list[str]:
    """The functions with an argument of this name."""
    return [name for name in FUNCTIONS if field in inspect.signature(getattr(forms, name)).parameters]


PLACES = [(name, field) for field in ITEMS for name in taking(field)]


def call(name: str, **arguments: object) -> object:
    """Call a form with these arguments; good ones stand in for the others."""
    good: dict[str, object] = {"angles": ANGLES, "form": "blocks"}
    for field, item in ITEMS.items():
        good[field] = np.eye(3) if item == (3, 3) else np.linspace(0.1, 1.0, item[0])
    function = getattr(forms, name)
    return function(**{field: (good | arguments)[field] for field in inspect.signature(function).parameters})


@pytest.mark.parametrize("name", FUNCTIONS)
def test_good_arguments_pass(name: str, body: fb.RigidBody) -> None:
    result = call(name, body=body)
    for part in result if isinstance(result, tuple) else (result,):
        assert np.isfinite(np.asarray(part)).all()


def wrong_arrays(item: tuple[int, ...]) -> dict[str, tuple[object, str]]:
    good = np.eye(3) if len(item) == 2 else np.ones(item)
    nan, infinite = good.copy(), good.copy()
    nan[-1], infinite[-1] = np.nan, -np.inf
    allowed = r"\(\.\.\., " + ", ".join(map(str, item)) + r"\)"
    return {
        "nan": (nan, "nan at index .*finite"),
        "inf": (infinite, "-inf at index .*finite"),
        "too long": (np.ones((*item[:-1], item[-1] + 1)), f"shape .*{allowed}"),
        "a number": (1.0, rf"shape \(\).*{allowed}"),
        "empty": (np.ones((0, *item)), "empty"),
        "nothing": ([], f"{allowed}"),
        "complex": (good + 0j, "complex128"),
        "text": (good.astype(str), "dtype <U"),
        "object": (good.astype(object), "dtype object"),
        "none": (None, "dtype object"),
        "truth": (good.astype(bool), "dtype bool"),
        "ragged": ([[1.0, 2.0], [3.0]], "not an array"),
    }


@pytest.mark.parametrize("fault", wrong_arrays((3,)))
@pytest.mark.parametrize(("name", "field"), PLACES)
def test_wrong_array_is_named(name: str, field: str, fault: str, body: fb.RigidBody) -> None:
    value, told = wrong_arrays(ITEMS[field])[fault]
    with pytest.raises(fb.InputError, match=rf"^{field}: .*{told}"):
        call(name, body=body, **{field: value})


@pytest.mark.parametrize("wrong", ["ZYX", "zyy", "xx", "", "quaternion", 321, None])
@pytest.mark.parametrize("name", taking("angles"))
def test_unknown_sequence_is_named(name: str, wrong: object, body: fb.RigidBody) -> None:
    with pytest.raises(fb.InputError, match=rf"^angles: got {wrong!r}; allowed are zxz, .*, yxz"):
        call(name, body=body, angles=wrong)


@pytest.mark.parametrize("name", taking("body"))
def test_what_is_no_body_is_named(name: str) -> None:
    with pytest.raises(fb.InputError, match=r"^body: got float; give a freebody.RigidBody"):
        call(name, body=1.0)


@pytest.mark.parametrize("name", ["quasi_acceleration", "generalized_acceleration"])
@pytest.mark.parametrize("wrong", ["2.6", "", 2.7, None])
def test_unknown_form_is_named(name: str, wrong: object, body: fb.RigidBody) -> None:
    with pytest.raises(fb.InputError, match=r"^form: got .*; allowed are 'blocks', "):
        call(name, body=body, form=wrong)


@pytest.mark.parametrize(
    ("name", "field", "value", "told"),
    [
        ("wrench_transform", "world_from_body", 2.0 * np.eye(3), "not a rotation matrix .*is 3"),
        ("gravity_wrench", "world_from_body", np.diag([1.0, 1.0, -1.0]), "determinant must be"),
        ("momentum_world", "world_from_body", np.full((3, 3), 1e200), "not a rotation matrix"),
        ("angles_from_rotation", "rotation", np.zeros((3, 3)), "not a rotation matrix"),
        ("rotation_from_quaternion", "quaternion", np.zeros(4), r"got \(0, 0, 0, 0\)"),
        ("rotation_acceleration", "inertia", np.diag([1.0, 1.0, 0.0]), "smallest principal moment is 0"),
        ("rotation_acceleration", "inertia", np.eye(3) + np.eye(3, k=1), "not symmetric"),
    ],
)
def test_wrong_value_is_named(name: str, field: str, value: object, told: str, body: fb.RigidBody) -> None:
    with pytest.raises(fb.InputError, match=f"^{field}: .*{told}"):
        call(name, body=body, **{field: value})


def test_shapes_that_do_not_broadcast_are_shown() -> None:
    with pytest.raises(fb.InputError, match=r"alpha \(3, 3\), alpha_dot \(4, 3\)"):
        forms.rate_matrix_world_dot(np.ones((3, 3)), np.ones((4, 3)), ANGLES)


def test_a_result_beyond_the_range_of_doubles_is_refused(body: fb.RigidBody) -> None:
    with pytest.raises(fb.NonFiniteError, match=r"inverse_dynamics: .*twist, twist_rate"):
        forms.inverse_dynamics(body, np.full(6, 1e200), np.zeros(6))


def test_errors_are_one_family() -> None:
    assert issubclass(fb.InputError, fb.FreebodyError)
    assert issubclass(fb.InputError, ValueError)
    assert issubclass(fb.SingularChartError, fb.FreebodyError)
    assert issubclass(fb.NonFiniteError, fb.FreebodyError)
