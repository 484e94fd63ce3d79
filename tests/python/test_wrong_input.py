"""Every wrong argument of the Python face: one family of errors that name the field and what is allowed."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import freebody as fb

INERTIA = np.diag([1.0, 2.0, 2.5])
BODY = fb.RigidBody(2.0, [0.1, 0.2, 0.3], inertia_about_com=INERTIA, name="keel")
MODEL = fb.Model(BODY)
ANGLES_MODEL = fb.Model(BODY, attitude="zyx", form="generalized")
X = MODEL.state()
RUN = MODEL.simulate(X, (0.0, 1.0), save_every=0.5)
ANGLES_RUN = ANGLES_MODEL.simulate(ANGLES_MODEL.state(), (0.0, 1.0), save_every=0.5)
TABLE = fb.InputTable([0.0, 1.0], np.zeros((2, 6)))
ZEROS = np.zeros((2, 3))

Call = Callable[[Any], object]


class Refuses:
    """An object that cannot be made an array, as tensors that live elsewhere cannot."""

    def __array__(self, *_: object, **__: object) -> np.ndarray:
        raise RuntimeError("detach it first")


def simulate(**arguments: Any) -> object:
    return MODEL.simulate(**({"x0": X, "t_span": (0.0, 1.0)} | arguments))


# Array arguments: the field as messages call it, its shape, and a call that is right but for it.
ARRAYS: dict[str, tuple[str, tuple[int, ...], Call]] = {
    "RigidBody com": ("com", (3,), lambda v: fb.RigidBody(1.0, v, inertia_about_com=INERTIA)),
    "RigidBody about com": (
        "inertia_about_com",
        (3, 3),
        lambda v: fb.RigidBody(1.0, inertia_about_com=v),
    ),
    "RigidBody about origin": (
        "inertia_about_origin",
        (3, 3),
        lambda v: fb.RigidBody(1.0, inertia_about_origin=v),
    ),
    "in_frame origin": ("origin", (3,), BODY.in_frame),
    "in_frame rotation": ("rotation", (3, 3), lambda v: BODY.in_frame(rotation=v)),
    "principal_inertia moments": ("moments", (3,), fb.principal_inertia),
    "principal_inertia axes": ("axes", (3, 3), lambda v: fb.principal_inertia([1.0, 2.0, 2.5], v)),
    "Attitude.angles": ("angles", (3,), lambda v: fb.Attitude.angles("zyx", v)),
    "Attitude.quaternion": ("quaternion", (4,), fb.Attitude.quaternion),
    "Attitude.rotation": ("world_from_body", (3, 3), fb.Attitude.rotation),
    "UniformGravity direction": ("direction", (3,), lambda v: fb.UniformGravity(9.81, v)),
    "PointMassGravity center": ("center", (3,), lambda v: fb.PointMassGravity(1.0, v)),
    "ConstantWrench force": ("force", (3,), fb.ConstantWrench),
    "ConstantWrench moment": ("moment", (3,), lambda v: fb.ConstantWrench(moment=v)),
    "ConstantWrench at": ("at", (3,), lambda v: fb.ConstantWrench(at=v)),
    "TabulatedWrench force": ("force", (2, 3), lambda v: fb.TabulatedWrench([0.0, 1.0], v, ZEROS)),
    "TabulatedWrench moment": ("moment", (2, 3), lambda v: fb.TabulatedWrench([0.0, 1.0], ZEROS, v)),
    "TabulatedWrench at": ("at", (3,), lambda v: fb.TabulatedWrench([0.0, 1.0], ZEROS, at=v)),
    "InputWrench at": ("at", (3,), lambda v: fb.InputWrench(at=v)),
    "state position": ("position", (3,), lambda v: MODEL.state(position=v)),
    "state velocity_body": ("velocity_body", (3,), lambda v: MODEL.state(velocity_body=v)),
    "state velocity_world": ("velocity_world", (3,), lambda v: ANGLES_MODEL.state(velocity_world=v)),
    "state angular_velocity_body": (
        "angular_velocity_body",
        (3,),
        lambda v: ANGLES_MODEL.state(angular_velocity_body=v),
    ),
    "state angular_velocity_world": (
        "angular_velocity_world",
        (3,),
        lambda v: MODEL.state(angular_velocity_world=v),
    ),
    "derivative x": ("x", (13,), lambda v: MODEL.derivative(0.0, v)),
    "derivative u": ("u", (6,), lambda v: MODEL.derivative(0.0, X, v)),
    "jacobian x": ("x", (13,), lambda v: MODEL.jacobian(0.0, v)),
    "jacobian u": ("u", (6,), lambda v: MODEL.jacobian(0.0, X, v)),
    "wrench x": ("x", (13,), lambda v: MODEL.wrench(0.0, v)),
    "wrench u": ("u", (6,), lambda v: MODEL.wrench(0.0, X, v)),
    "simulate x0": ("x0", (13,), lambda v: simulate(x0=v)),
    "simulate t_span": ("t_span", (2,), lambda v: simulate(t_span=v)),
    "simulate inputs": ("inputs", (6,), lambda v: simulate(inputs=v)),
    "Trajectory.point": ("point", (3,), RUN.point),
}
# Here None means that nothing was given.
OPTIONAL = {
    "RigidBody about com",
    "RigidBody about origin",
    "in_frame rotation",
    "principal_inertia axes",
    "TabulatedWrench force",
    "TabulatedWrench moment",
    "simulate inputs",
    *(place for place in ARRAYS if "velocity" in place or place.endswith(" u")),
}


def wrong_arrays(shape: tuple[int, ...]) -> dict[str, tuple[Any, str]]:
    """What may come instead of an array of this shape, and what is said of it."""
    good = np.eye(3) if shape == (3, 3) else np.ones(shape)
    nan, infinite = good.copy(), good.copy()
    nan.flat[-1], infinite.flat[-1] = np.nan, -np.inf
    allowed = str(shape).replace("(", r"\(").replace(")", r"\)")
    holed = good.astype(object)
    holed.flat[0] = None
    return {
        "nan": (nan, "[Nn]a[Nn].*finite|finite.*NaN"),
        "infinite": (infinite, "-inf.*finite|finite.*-inf"),
        "too long": (np.ones((*shape[:-1], shape[-1] + 1)), f"got shape .*allowed is {allowed}"),
        "too many dimensions": (good[None], f"got shape .*allowed is {allowed}"),
        "a number": (1.0, rf"got shape \(\); allowed is {allowed}"),
        "no rows": (np.ones((0, *shape)), f"got shape .*allowed is {allowed}"),
        "empty": ([], rf"got shape \(0,\); allowed is {allowed}"),
        "complex": (good + 0j, f"dtype complex128; give real numbers of shape {allowed}"),
        "text": (good.astype(str), f"dtype <U32; give real numbers of shape {allowed}"),
        "a word": ("up", f"got 'up' of dtype <U2; give real numbers of shape {allowed}"),
        "truth values": (good.astype(bool), f"dtype bool; give real numbers of shape {allowed}"),
        "none": (None, f"got None of dtype object; give real numbers of shape {allowed}"),
        "holes": (holed.tolist(), f"None.* of dtype object; give real numbers of shape {allowed}"),
        "huge integers": (np.full(shape, 10**400, object), "dtype object; give real numbers"),
        "dates": (good.astype("datetime64[s]"), r"dtype datetime64\[s\]; give real numbers"),
        "masked": (np.ma.masked_greater(good, 0.5), "masked; fill them in or leave them out"),
        "ragged": ([[1.0, 2.0], [3.0]], f"not an array .*; give real numbers of shape {allowed}"),
        "no array": (Refuses(), f"not an array .detach it first.; give real numbers of shape {allowed}"),
        "an object": (MODEL, f"got <Model .*; give real numbers of shape {allowed}"),
    }


def refused(call: Call, value: Any, told: str) -> None:
    with pytest.raises(fb.InputError, match=told) as caught:
        call(value)
    # Whoever knows nothing of freebody may still catch it; and it is one readable line.
    assert isinstance(caught.value, fb.FreebodyError)
    assert isinstance(caught.value, ValueError)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


@pytest.mark.parametrize("fault", wrong_arrays((3,)))
@pytest.mark.parametrize("place", ARRAYS)
def test_wrong_array(place: str, fault: str) -> None:
    field, shape, call = ARRAYS[place]
    value, told = wrong_arrays(shape)[fault]
    if value is None and place in OPTIONAL:
        told = "neither" if place.startswith("RigidBody") else None
    if told is None:
        call(value)
    else:
        refused(call, value, told if told == "neither" else rf"\b{field}\b.*({told})")


# Number arguments, with what is allowed.
FINITE, POSITIVE = "give one finite number", "give one finite positive number"
NUMBERS: dict[str, tuple[str, str, Call]] = {
    "positive_integral_inertia Ixx": ("Ixx", FINITE, lambda v: fb.positive_integral_inertia(v, 1.0, 1.0)),
    "positive_integral_inertia Iyy": ("Iyy", FINITE, lambda v: fb.positive_integral_inertia(1.0, v, 1.0)),
    "positive_integral_inertia Izz": ("Izz", FINITE, lambda v: fb.positive_integral_inertia(1.0, 1.0, v)),
    "positive_integral_inertia Pxy": ("Pxy", FINITE, lambda v: fb.positive_integral_inertia(1, 1, 1, v)),
    "positive_integral_inertia Pxz": ("Pxz", FINITE, lambda v: fb.positive_integral_inertia(1, 1, 1, 0, v)),
    "positive_integral_inertia Pyz": ("Pyz", FINITE, lambda v: fb.positive_integral_inertia(1, 1, 1, Pyz=v)),
    "UniformGravity": ("acceleration", FINITE, fb.UniformGravity),
    "PointMassGravity": ("mu", POSITIVE, fb.PointMassGravity),
    "derivative t": ("t", FINITE, lambda v: MODEL.derivative(v, X)),
    "jacobian t": ("t", FINITE, lambda v: MODEL.jacobian(v, X)),
    "wrench t": ("t", FINITE, lambda v: MODEL.wrench(v, X)),
    "simulate rtol": ("rtol", POSITIVE, lambda v: simulate(rtol=v)),
    "simulate atol": ("atol", FINITE, lambda v: simulate(atol=v)),
    "simulate step": ("step", POSITIVE, lambda v: simulate(step=v)),
    "simulate save_every": ("save_every", POSITIVE, lambda v: simulate(save_every=v)),
    "simulate max_steps": ("max_steps", FINITE, lambda v: simulate(max_steps=v)),
}
WRONG_NUMBERS: dict[str, tuple[Any, str]] = {
    "nan": (np.nan, "got nan"),
    "infinite": (np.inf, "got inf"),
    "numpy infinite": (-np.float64(np.inf), r"got np.float64\(-inf\)"),
    "beyond doubles": (10**400, "got 1000000"),
    "long double": (np.longdouble("1e400"), "got np.longdouble"),
    "none": (None, "got None"),
    "truth": (True, "got True"),
    "numpy truth": (np.True_, "got np.True_"),
    "word": ("1.0", "got '1.0'"),
    "bytes": (b"1", "got b'1'"),
    "complex": (1j, "got 1j"),
    "list": ([1.0], r"got \[1.0\]"),
    "array": (np.ones((20, 20)), r"got array\(\[\[1., 1."),
    "empty": ([], r"got \[\]"),
    "ragged": ([1.0, [2.0, 3.0]], "not a number"),
    "masked": (np.ma.masked, "got masked"),
    "no array": (Refuses(), "not a number .detach it first."),
    "type": (float, "got <class 'float'>"),
    "time": (np.timedelta64(3, "s"), "got np.timedelta64"),
}
OPTIONAL_NUMBERS = {"simulate atol", "simulate step", "simulate save_every"}


@pytest.mark.parametrize("fault", WRONG_NUMBERS)
@pytest.mark.parametrize("place", NUMBERS)
def test_wrong_number(place: str, fault: str) -> None:
    field, allowed, call = NUMBERS[place]
    value, came = WRONG_NUMBERS[fault]
    if value is None and place in OPTIONAL_NUMBERS:
        call(value)
    else:
        refused(call, value, f"^{field}: {came}.*; {allowed}$")


@pytest.mark.parametrize("place", [place for place, entry in NUMBERS.items() if entry[1] == POSITIVE])
@pytest.mark.parametrize("value", [0, -0.0, -1.0, np.int8(-3)])
def test_number_that_is_not_positive(place: str, value: Any) -> None:
    field, _, call = NUMBERS[place]
    refused(call, value, f"^{field}: got .*; {POSITIVE}$")


@pytest.mark.parametrize("fault", WRONG_NUMBERS)
def test_wrong_mass(fault: str) -> None:
    value, _ = WRONG_NUMBERS[fault]
    refused(lambda v: fb.RigidBody(v, inertia_about_com=INERTIA, name="keel"), value, "^body 'keel': mass")


# Words, each of a few.
SEQUENCES = "zxz, xyx, yzy, .*, zyx, yxz"
WORDS: dict[str, tuple[str, str, Call]] = {
    "Attitude.angles": ("sequence", SEQUENCES, lambda v: fb.Attitude.angles(v, [0.1, 0.2, 0.3])),
    "as_angles": ("sequence", SEQUENCES, fb.Attitude.identity().as_angles),
    "as_angles of angles": ("sequence", SEQUENCES, fb.Attitude.angles("zyx", [0.1, 0.2, 0.3]).as_angles),
    "Trajectory.angles": ("sequence", SEQUENCES, RUN.angles),
    "Trajectory.angles of angles": ("sequence", SEQUENCES, ANGLES_RUN.angles),
    "ConstantWrench axes": ("axes", "'body', 'world'", lambda v: fb.ConstantWrench(axes=v)),
    "TabulatedWrench axes": ("axes", "'body', 'world'", lambda v: fb.TabulatedWrench([0, 1], ZEROS, axes=v)),
    "TabulatedWrench interpolation": (
        "interpolation",
        "'linear', 'hold'",
        lambda v: fb.TabulatedWrench([0, 1], ZEROS, interpolation=v),
    ),
    "InputWrench axes": ("axes", "'body', 'world'", fb.InputWrench),
    "InputTable interpolation": (
        "interpolation",
        "'linear', 'hold'",
        lambda v: fb.InputTable([0, 1], ZEROS, v),
    ),
    "Model attitude": ("attitude", "'quaternion', 'zxz', .*, 'yxz'", lambda v: fb.Model(BODY, (), v)),
    "Model form": ("form", "'quasi_velocity', 'generalized'", lambda v: fb.Model(BODY, form=v)),
    "simulate method": ("method", "'dop853', 'vern8', 'vern9', 'dp54'", lambda v: simulate(method=v)),
}
WRONG_WORDS = ["ZYX", "zyy", "Body", "cubic", "rk45", "", b"zyx", 1, None, ["zyx"], np.array(["zyx"]), ZEROS]


@pytest.mark.parametrize("value", WRONG_WORDS, ids=repr)
@pytest.mark.parametrize("place", WORDS)
def test_wrong_word(place: str, value: Any) -> None:
    field, allowed, call = WORDS[place]
    if place == "Trajectory.angles of angles" and value is None:
        call(value)
    elif place == "Trajectory.angles" and value is None:
        refused(call, value, f"^sequence: give one of {SEQUENCES}; the model has no angles")
    else:
        refused(call, value, rf"^{field}: got .*; allowed are {allowed}")


NAMES: dict[str, Call] = {
    "RigidBody": lambda v: fb.RigidBody(1.0, inertia_about_com=INERTIA, name=v),
    "Model": lambda v: fb.Model(BODY, name=v),
    "UniformGravity": lambda v: fb.UniformGravity(name=v),
    "PointMassGravity": lambda v: fb.PointMassGravity(1.0, name=v),
    "ConstantWrench": lambda v: fb.ConstantWrench(name=v),
    "TabulatedWrench": lambda v: fb.TabulatedWrench([0, 1], ZEROS, name=v),
    "LinearDamping": lambda v: fb.LinearDamping(np.ones(6), name=v),
    "QuadraticDamping": lambda v: fb.QuadraticDamping(np.ones(6), name=v),
    "InputWrench": lambda v: fb.InputWrench(name=v),
}


@pytest.mark.parametrize("value", ["", " ", b"sun", 1, ["sun"], ZEROS], ids=repr)
@pytest.mark.parametrize("place", NAMES)
def test_wrong_name(place: str, value: Any) -> None:
    refused(NAMES[place], value, "^name: got .*; give a word that is not empty")


# What has rules of its own: the call, and what is said.
OTHERS: dict[str, tuple[Callable[[], object], str]] = {
    "no inertia": (
        lambda: fb.RigidBody(1.0),
        "^body 'body': give exactly one of inertia_about_com .*neither",
    ),
    "two inertias": (
        lambda: fb.RigidBody(1.0, inertia_about_com=INERTIA, inertia_about_origin=INERTIA, name="hull"),
        "^body 'hull': give exactly one of inertia_about_com and inertia_about_origin, got both",
    ),
    "body + number": (lambda: BODY + 1, r"^body \+ other: other is 1; give a freebody.RigidBody"),  # type: ignore[operator]
    "body + core body": (lambda: BODY + object(), r"^body \+ other: other is <object"),  # type: ignore[operator]
    "array + body": (lambda: np.ones(3) + BODY, r"^other \+ body: other is 1"),
    "sum of bodies": (lambda: sum([BODY, BODY]), r"^other \+ body: other is 0; .*sum\(\) one to start from"),
    "reflected frame": (
        lambda: BODY.in_frame(rotation=np.diag([1.0, 1.0, -1.0])),
        r"^rotation: not a rotation matrix .*determinant must be \+1",
    ),
    "axes of length two": (
        lambda: fb.principal_inertia([1, 2, 3], 2 * np.eye(3)),
        "^axes: not a rotation matrix .*is 3, allowed 1e-06",
    ),
    "matrix in degrees": (
        lambda: fb.Attitude.rotation(np.full((3, 3), 57.3)),
        "^world_from_body: not a rotation",
    ),
    "huge matrix": (lambda: fb.Attitude.rotation(np.full((3, 3), 1e300)), "^world_from_body: not a rotation"),
    "long quaternion": (
        lambda: fb.Attitude.quaternion([1, 1, 0, 0]),
        "^quaternion: its length is 1.41421356, allowed is 1 to 1e-6; divide by the length",
    ),
    "zero quaternion": (lambda: fb.Attitude.quaternion(np.zeros(4)), "^quaternion: its length is 0"),
    "huge quaternion": (lambda: fb.Attitude.quaternion(np.full(4, 1e300)), "^quaternion: its length is inf"),
    "bare Attitude": (fb.Attitude, "^Attitude: make one with Attitude.angles"),
    "Attitude of numbers": (lambda: fb.Attitude([1, 0, 0, 0]), "^Attitude: make one with Attitude.angles"),
    "no direction": (lambda: fb.UniformGravity(9.81, [0, 0, 0]), "^direction: got the zero vector; give"),
    "torque by word": (
        lambda: fb.PointMassGravity(1.0, gradient_torque="no"),  # type: ignore[arg-type]
        "^gradient_torque: got 'no'; give True or False",
    ),
    "torque by array": (
        lambda: fb.PointMassGravity(1.0, gradient_torque=ZEROS),  # type: ignore[arg-type]
        "^gradient_torque: got array.*; give True or False",
    ),
    "no table": (lambda: fb.TabulatedWrench([0, 1]), "^force, moment: neither came; give at least one table"),
    "steep force": (
        lambda: fb.TabulatedWrench([0.0, 1e-320], force=[[0, 0, 0], [1e300, 0, 0]]),
        '^force: the line to row 1 is too steep .*interpolation="hold"',
    ),
    "steep moment": (
        lambda: fb.TabulatedWrench([0, 1, 2], moment=[[0] * 3, [1e308] * 3, [-1e308] * 3]),
        "^moment: the line to row 2 is too steep .*give that time twice",
    ),
    "steep inputs": (
        lambda: fb.InputTable([0, 1], [[1e308], [-1e308]]),
        "^values: the line to row 1 is too steep",
    ),
    "five coefficients": (
        lambda: fb.LinearDamping(np.ones(5)),
        r"^coefficients: got shape \(5,\); allowed are \(6,\)",
    ),
    "wide coefficients": (lambda: fb.QuadraticDamping(np.ones((6, 5))), r"allowed are \(6,\) and \(6, 6\)"),
    "no body": (lambda: fb.Model(None), "^body: got None; give a freebody.RigidBody"),  # type: ignore[arg-type]
    "one force": (
        lambda: fb.Model(BODY, fb.UniformGravity()),  # type: ignore[arg-type]
        "^forces: got <UniformGravity .*; give a list of force elements",
    ),
    "no force": (
        lambda: fb.Model(BODY, [fb.UniformGravity(), np.sin]),  # type: ignore[list-item]
        r"^forces\[1\]: got <ufunc 'sin'>; give a force element",
    ),
    "force class": (
        lambda: fb.Model(BODY, [fb.UniformGravity]),  # type: ignore[list-item]
        r"^forces\[0\]: got <class .*; give a force element",
    ),
    "inputs of one name": (
        lambda: fb.Model(BODY, [fb.InputWrench(), fb.InputWrench()]),
        r"^forces\[1\]: a second InputWrench called 'InputWrench'; give each its own name=",
    ),
    "attitude by word": (
        lambda: MODEL.state(attitude="zyx"),  # type: ignore[arg-type]
        r"^attitude: got 'zyx'; make one with Attitude.angles",
    ),
    "attitude by matrix": (lambda: MODEL.state(attitude=np.eye(3)), "^attitude: got array.*; make one with"),  # type: ignore[arg-type]
    "two velocities": (
        lambda: MODEL.state(velocity_body=[1, 0, 0], velocity_world=[1, 0, 0]),
        "^velocity_body, velocity_world: both came; give one",
    ),
    "two angular velocities": (
        lambda: MODEL.state(angular_velocity_body=[1, 0, 0], angular_velocity_world=[1, 0, 0]),
        "^angular_velocity_body, angular_velocity_world: both came; give one",
    ),
    "velocity beyond doubles": (
        lambda: MODEL.state(attitude=fb.Attitude.angles("zyx", [1, 2, 3]), velocity_world=[1.7e308] * 3),
        "too large for doubles",
    ),
    "rates beyond doubles": (
        lambda: ANGLES_MODEL.state(
            attitude=fb.Attitude.angles("zyx", [0, 1.57, 0]), angular_velocity_body=[0, 1e308, 1e308]
        ),
        "too large for doubles",
    ),
    "backward span": (
        lambda: simulate(t_span=(1, 0)),
        r"^t_span: got \(1.0, 0.0\) s; the end must lie after",
    ),
    "empty span": (lambda: simulate(t_span=(1, 1)), r"^t_span: .*the end must lie after the start"),
    "endless span": (lambda: simulate(t_span=(-1e308, 1e308)), "^t_span: .*too long for doubles"),
    "strict rtol": (lambda: simulate(rtol=1e-16), "^rtol: got 1e-16; allowed is from 1e-14 to below 1"),
    "loose rtol": (lambda: simulate(rtol=1.0), "^rtol: got 1.0; allowed is from 1e-14 to below 1"),
    "negative atol": (lambda: simulate(atol=-1e-9), "^atol: got -1e-09; allowed is 0 or more"),
    "rk4 without step": (lambda: simulate(method="rk4"), "^step: rk4 has a fixed step; give its size in s"),
    "gauss6 without step": (
        lambda: simulate(method="gauss6"),
        "^step: gauss6 has a fixed step; give its size",
    ),
    "broken max_steps": (lambda: simulate(max_steps=2.5), "^max_steps: got 2.5; give a whole number from 1"),
    "no steps": (lambda: simulate(max_steps=0), "^max_steps: got 0; give a whole number from 1"),
    "endless steps": (lambda: simulate(max_steps=1e300), r"^max_steps: got 1e\+300; give a whole number"),
    "progress by word": (lambda: simulate(progress="bar"), "^progress: got 'bar'; give a function"),
    "two ways to save": (
        lambda: simulate(save_every=0.1, save_at=[0.5]),
        "^save_every, save_at: both came; give one of them",
    ),
    "dense samples": (
        lambda: simulate(save_every=1e-300),
        "^save_every: 1e-300 s makes .*allowed are up to 1e8",
    ),
    "samples below doubles": (
        lambda: simulate(t_span=(1e17, 1e17 + 160), save_every=1.0),
        "^save_every: 1.0 s is less than doubles resolve",
    ),
    "samples outside": (lambda: simulate(save_at=[0.5, 1.5]), "^save_at: the times must rise and lie within"),
    "samples twice": (lambda: simulate(save_at=[0.5, 0.5]), "^save_at: the times must rise"),
    "narrow input table": (
        lambda: simulate(inputs=fb.InputTable([0, 1], ZEROS)),
        "^inputs: the table has 3 columns; the model has 6",
    ),
    "no run": (lambda: MODEL.linearize(X), "^run: got array.*; give a Trajectory of this model"),  # type: ignore[arg-type]
    "foreign run": (
        lambda: MODEL.linearize(ANGLES_RUN),
        "^run: its states and inputs are those of .*, not of",
    ),
    "run of no samples": (
        lambda: MODEL.linearize(MODEL.simulate(X, (0, 1), save_at=[1.0], step=1e-3, max_steps=1)),
        "^run: it has no samples",
    ),
}


@pytest.mark.parametrize("case", OTHERS)
def test_wrong_value(case: str) -> None:
    call, told = OTHERS[case]
    refused(lambda _: call(), None, told)


# Times and columns, as long as the user likes.
SERIES: dict[str, tuple[str, Call]] = {
    "TabulatedWrench": ("times", lambda v: fb.TabulatedWrench(v, np.zeros((3, 3)))),
    "InputTable": ("times", lambda v: fb.InputTable(v, np.zeros((3, 6)))),
    "InputTable.at": ("t", TABLE.at),
    "save_at": ("save_at", lambda v: simulate(save_at=v)),
}
WRONG_SERIES: dict[str, tuple[Any, str]] = {
    "a number": (1.0, r"got shape \(\); allowed is \(n,\)"),
    "a matrix": (ZEROS, r"got shape \(2, 3\); allowed is \(n,\)"),
    "empty": ([], r"got an empty array of shape \(0,\); give at least one"),
    "nan": ([0.0, np.nan, 1.0], r"got nan at index \(1,\); every number must be finite"),
    "word": ("now", r"got 'now' of dtype <U3; give real numbers of shape \(n,\)"),
    "complex": ([0.0, 1j, 2.0], r"dtype complex128; give real numbers of shape \(n,\)"),
    "truth": ([False, True], r"dtype bool; give real numbers of shape \(n,\)"),
    "dates": (np.arange(3).astype("datetime64[s]"), r"dtype datetime64\[s\]; give real numbers"),
    "ragged": ([0.0, [1.0, 2.0]], r"not an array .*; give real numbers of shape \(n,\)"),
    "generator": ((t for t in range(3)), r"got <generator .* of dtype object; give real numbers"),
    "masked": (np.ma.masked_equal([0.0, 0.5, 1.0], 0.5), "masked; fill them in"),
}


@pytest.mark.parametrize("fault", WRONG_SERIES)
@pytest.mark.parametrize("place", SERIES)
def test_wrong_series(place: str, fault: str) -> None:
    field, call = SERIES[place]
    value, told = WRONG_SERIES[fault]
    refused(call, value, f"^{field}: .*{told}")


@pytest.mark.parametrize("place", ["TabulatedWrench", "InputTable"])
def test_wrong_order_of_times(place: str) -> None:
    call = SERIES[place][1]
    refused(call, [0.0, 2.0, 1.0], "^times: 1.0 at index 2 is smaller than the one before; sort the times")
    refused(call, [1.0, 1.0, 1.0], "^times: 1.0 stands three times at index 2; a jump takes two")


@pytest.mark.parametrize(
    "value", [[1.0, 2.0], np.zeros((3, 6)), np.zeros((2, 0)), "abc", None, [[1], [None]]]
)
def test_wrong_columns(value: Any) -> None:
    refused(lambda v: fb.InputTable([0.0, 1.0], v), value, r"^values: got .*; (allowed is|give)")


WRONG_OUT: dict[str, Any] = {
    "list": [0.0] * 13,
    "short": np.zeros(12),
    "matrix": np.zeros((13, 1)),
    "single": np.zeros(13, np.float32),
    "every second": np.zeros(26)[::2],
    "read-only": np.broadcast_to(0.0, 13),
    "misaligned": np.zeros(8 * 13 + 1, np.uint8)[1:].view(float),
}


@pytest.mark.parametrize("fault", WRONG_OUT)
def test_wrong_out(fault: str) -> None:
    told = r"^out: got .*; give a writable contiguous float64 array of shape \(13,\)"
    refused(lambda v: MODEL.derivative(0.0, X, out=v), WRONG_OUT[fault], told)


MATRICES: dict[str, Any] = {
    "list": np.zeros((13, 13)).tolist(),
    "row": np.zeros(13 * 13),
    "wide": np.zeros((13, 14)),
    "single": np.zeros((13, 13), np.float32),
    "by columns": np.zeros((13, 13), order="F"),
    "a part": np.zeros((13, 19))[:, :13],
    "read-only": np.broadcast_to(0.0, (13, 13)),
    "misaligned": np.zeros(8 * 169 + 1, np.uint8)[1:].view(float).reshape(13, 13),
}


@pytest.mark.parametrize("fault", MATRICES)
def test_wrong_matrix_for_a_jacobian(fault: str) -> None:
    b = np.zeros((13, 6))
    told = r"^out\[0\]: got .*; give a writable contiguous float64 array of shape \(13, 13\)"
    refused(lambda v: MODEL.jacobian(0.0, X, out=(v, b)), MATRICES[fault], told)
    # The other one is not written either.
    a = np.full((13, 13), np.nan)
    told = r"^out\[1\]: got .*; give a writable contiguous float64 array of shape \(13, 6\)"
    refused(lambda v: MODEL.jacobian(0.0, X, out=(a, v)), MATRICES[fault], told)
    assert np.isnan(a).all()
    assert np.array_equal(b, np.zeros((13, 6)))


@pytest.mark.parametrize("pair", [np.zeros((13, 19)), (np.zeros((13, 13)),), [1, 2], 7, "ab"], ids=str)
def test_wrong_pair_for_a_jacobian(pair: Any) -> None:
    refused(lambda v: MODEL.jacobian(0.0, X, out=v), pair, "^out: got .*; give a pair of arrays")


def test_misaligned_numbers_are_copied() -> None:
    x = np.zeros(8 * 13 + 1, np.uint8)[1:].view(float)
    x[:] = X
    assert not x.flags.aligned
    assert np.array_equal(MODEL.derivative(0.0, x), MODEL.derivative(0.0, X))


def test_the_state_will_do_as_out() -> None:
    x = X.copy()
    assert MODEL.derivative(0.0, x, out=x) is x
    assert np.array_equal(x, MODEL.derivative(0.0, X))


def test_state_and_rate_may_share_memory() -> None:
    room = np.zeros(14)
    room[:13] = X
    MODEL.derivative(0.0, room[:13], out=room[1:])
    assert np.array_equal(room[1:], MODEL.derivative(0.0, X))


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("k", range(13))
def test_no_number_of_the_state_goes_unseen(k: int, bad: float) -> None:
    """Nor one that the derivative does not depend on, the position's."""
    x, out = X.copy(), np.arange(13.0)
    x[k] = bad
    for state in (x, x.tolist()):
        with pytest.raises(fb.InputError, match="x"):
            MODEL.derivative(0.0, state, out=out)
    assert np.array_equal(out, np.arange(13.0))


def test_an_error_loses_nothing() -> None:
    x, u = X.copy(), np.zeros(6)
    x[5] = np.nan
    out, pair = np.arange(13.0), (np.ones((13, 13)), np.ones((13, 6)))
    wrong: list[tuple[Any, ...]] = [(0.0, x), (np.nan, X), (0.0, X, np.full(6, np.inf)), (0.0, X, [1.0])]
    for bad in wrong:
        with pytest.raises(fb.InputError):
            MODEL.derivative(*bad, out=out)
        with pytest.raises(fb.InputError):
            MODEL.jacobian(*bad, out=pair)
    too_fast = X.copy()
    too_fast[10:] = 1e200
    with pytest.raises(fb.NonFiniteError):
        MODEL.derivative(0.0, too_fast, out=out)
    at_center = fb.Model(BODY, [fb.PointMassGravity(1.0, center=BODY.com, name="sun")])
    with pytest.raises(fb.NonFiniteError):
        at_center.derivative(0.0, X, out=out)
    with pytest.raises(fb.NonFiniteError):
        at_center.jacobian(0.0, X, out=pair)
    assert all((part == 1.0).all() for part in pair)
    assert np.array_equal(out, np.arange(13.0))
    assert np.array_equal(u, np.zeros(6))
    # ... and the model goes on.
    assert np.isfinite(MODEL.derivative(0.0, X, u, out)).all()


def test_arguments_are_neither_changed_nor_kept() -> None:
    moments, com = np.array([1.0, 2.0, 2.5]), np.array([0.1, 0.2, 0.3])
    body = fb.RigidBody(2.0, com, inertia_about_com=fb.principal_inertia(moments))
    force = np.array([1.0, 2.0, 3.0])
    wrench = fb.ConstantWrench(force)
    com[:], moments[:], force[:] = 9.0, 9.0, 9.0
    assert body == fb.RigidBody(2.0, [0.1, 0.2, 0.3], inertia_about_com=INERTIA)
    assert wrench.force.tolist() == [1.0, 2.0, 3.0]
    with pytest.raises(ValueError, match="read-only"):
        wrench.force[0] = 5.0


def test_a_bad_end_keeps_what_came_before() -> None:
    # Along a line through the attracting centre: the run ends there, whatever the reason is called.
    ball = fb.RigidBody(1.0, inertia_about_com=np.eye(3))
    model = fb.Model(ball, [fb.PointMassGravity(1.0, gradient_torque=False, name="sun")])
    run = model.simulate(model.state(position=[1.0, 0.0, 0.0]), (0.0, 10.0), save_every=0.1)
    assert not run.ok
    assert run.outcome.status in {"step_too_small", "non_finite"}
    # Free fall from rest at 1 m with mu = 1 takes pi / sqrt(8) s.
    assert run.outcome.time == pytest.approx(np.pi / np.sqrt(8.0), rel=1e-6)
    assert run.t.tolist() == pytest.approx(np.arange(12) * 0.1)
    assert np.isfinite(run.x).all()
    assert np.all(np.diff(run.position_world[:, 0]) < 0.0)


@pytest.mark.parametrize(
    ("mass", "scale"), [(1e-300, 1.0), (5e300, 1.0), (1.0, 1e-100), (1.0, 1e100), (1e-200, 1e100)]
)
def test_extreme_bodies_work(mass: float, scale: float) -> None:
    body = fb.RigidBody(mass, inertia_about_com=scale * INERTIA)
    inverse = np.linalg.inv(INERTIA) / scale
    # Two roundings of a closed form.
    np.testing.assert_allclose(body.inverse_spatial_inertia[3:, 3:], inverse, rtol=1e-14)
    assert body.inverse_spatial_inertia[0, 0] == pytest.approx(1.0 / mass, rel=1e-15)


@pytest.mark.parametrize(
    "case",
    [
        {"mass": 5e-324, "inertia_about_com": INERTIA},
        {"mass": 1.7e308, "inertia_about_com": INERTIA},
        {"mass": 1.0, "inertia_about_com": 1e300 * INERTIA},
        {"mass": 1.0, "inertia_about_com": 1e-300 * INERTIA},
        {"mass": 1.0, "inertia_about_com": 5e-324 * np.eye(3)},
        {"mass": 1.0, "inertia_about_com": np.full((3, 3), 1.7e308)},
        {"mass": 1.0, "inertia_about_origin": np.full((3, 3), -1.7e308)},
        {"mass": 1.0, "com": [1e200, 0, 0], "inertia_about_com": INERTIA},
        {"mass": 1.0, "com": [1e200, 0, 0], "inertia_about_origin": INERTIA},
    ],
)
def test_bodies_beyond_doubles_are_refused(case: dict[str, Any]) -> None:
    refused(
        lambda _: fb.RigidBody(**case, name="star"), None, "^body 'star': .*(doubles: mass|must be positive)"
    )


def test_a_body_pushed_beyond_doubles_is_refused() -> None:
    refused(BODY.in_frame, [1e200, 0, 0], r"^body 'keel': .*doubles: mass 2.0 kg, com \[-1e200")
    heavy = fb.RigidBody(4e307, inertia_about_com=INERTIA)
    refused(lambda other: heavy + other, heavy, r"doubles: mass 8e307 kg")


def test_errors_are_one_family() -> None:
    errors = [getattr(fb, name) for name in fb.__all__ if name.endswith("Error")]
    assert len(errors) == 9
    assert all(issubclass(error, fb.FreebodyError) for error in errors)
    assert issubclass(fb.BodyError, fb.InputError)
    assert issubclass(fb.InputError, ValueError)
    assert not any(issubclass(error, ValueError) for error in (fb.SingularChartError, fb.NonFiniteError))
