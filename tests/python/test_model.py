"""Models: what their numbers are called, how a state is made, and what f(x, u, t) takes and refuses."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest

import freebody as fb

SEQUENCES = fb.forms.SEQUENCES
CHARTS = ("quaternion", *SEQUENCES)
FORMS = ("quasi_velocity", "generalized")
BODY = fb.RigidBody(
    12.5, [0.12, -0.05, 0.08], inertia_about_com=fb.principal_inertia([1.0, 1.4, 1.9]), name="hull"
)
# Far from the singularities of all twelve sequences.
ATTITUDE = fb.Attitude.angles("zyx", [0.5, -0.7, 0.6])
POSITION, VELOCITY, RATE = [10.0, -20.0, 30.0], [1.0, 2.0, -3.0], [0.1, -0.2, 0.3]
# Some roundings in numbers of order one to ten.
TOLERANCE = 1e-13


def model_of(attitude: str, form: Any = "quasi_velocity", *forces: fb.Force) -> fb.Model:
    return fb.Model(BODY, forces, attitude, form)


def state_of(model: fb.Model) -> np.ndarray:
    return model.state(POSITION, ATTITUDE, velocity_body=VELOCITY, angular_velocity_body=RATE)


QUATERNION = ("quaternion_w", "quaternion_x", "quaternion_y", "quaternion_z")
ANGLES = ("angle_1", "angle_2", "angle_3")
PLACE = ("position_x", "position_y", "position_z")
TWIST = (
    "velocity_x",
    "velocity_y",
    "velocity_z",
    "angular_velocity_x",
    "angular_velocity_y",
    "angular_velocity_z",
)
WRENCH = ("force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z")
STATES = {
    ("quaternion", "quasi_velocity"): (
        PLACE + QUATERNION + TWIST,
        ("m",) * 3 + ("1",) * 4 + ("m/s",) * 3 + ("rad/s",) * 3,
    ),
    ("quaternion", "generalized"): (
        PLACE
        + QUATERNION
        + ("position_rate_x", "position_rate_y", "position_rate_z")
        + ("quaternion_rate_w", "quaternion_rate_x", "quaternion_rate_y", "quaternion_rate_z"),
        ("m",) * 3 + ("1",) * 4 + ("m/s",) * 3 + ("1/s",) * 4,
    ),
    ("angles", "quasi_velocity"): (
        PLACE + ANGLES + TWIST,
        ("m",) * 3 + ("rad",) * 3 + ("m/s",) * 3 + ("rad/s",) * 3,
    ),
    ("angles", "generalized"): (
        PLACE
        + ANGLES
        + (
            "position_rate_x",
            "position_rate_y",
            "position_rate_z",
            "angle_rate_1",
            "angle_rate_2",
            "angle_rate_3",
        ),
        ("m",) * 3 + ("rad",) * 3 + ("m/s",) * 3 + ("rad/s",) * 3,
    ),
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("attitude", CHARTS)
def test_names_and_units(attitude: str, form: str) -> None:
    model = model_of(attitude, form)
    kind = "quaternion" if attitude == "quaternion" else "angles"
    assert (model.state_names, model.state_units) == STATES[kind, form]
    assert model.n_states == len(model.state_names)
    assert (model.input_names, model.input_units) == (WRENCH, ("N",) * 3 + ("N m",) * 3)
    assert model.n_inputs == 6
    x = state_of(model)
    a, b = model.jacobian(0.0, x)
    assert model.derivative(0.0, x).shape == x.shape == (model.n_states,)
    assert (a.shape, b.shape) == ((model.n_states, model.n_states), (model.n_states, 6))
    assert model.wrench(0.0, x).shape == (6,)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("attitude", CHARTS)
def test_a_state_is_the_motion_it_was_made_of(attitude: str, form: str) -> None:
    model = model_of(attitude, form)
    c = ATTITUDE.as_rotation()
    ways = [
        {"velocity_body": VELOCITY, "angular_velocity_body": RATE},
        {"velocity_world": c @ VELOCITY, "angular_velocity_body": RATE},
        {"velocity_body": VELOCITY, "angular_velocity_world": c @ RATE},
        {"velocity_world": c @ VELOCITY, "angular_velocity_world": c @ RATE},
    ]
    for way in ways:
        x = model.state(POSITION, ATTITUDE, **way)
        np.testing.assert_allclose(x, state_of(model), rtol=0, atol=TOLERANCE)
    # The first sample of a run gives it all back.
    run = model.simulate(state_of(model), (0.0, 1e-3), save_at=[0.0])
    np.testing.assert_allclose(run.position_world[0], POSITION, rtol=0, atol=0)
    np.testing.assert_allclose(run.world_from_body[0], c, rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(run.velocity_body[0], VELOCITY, rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(run.velocity_world[0], c @ VELOCITY, rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(run.angular_velocity_body[0], RATE, rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(run.angular_velocity_world[0], c @ RATE, rtol=0, atol=TOLERANCE)


@pytest.mark.parametrize("attitude", CHARTS)
def test_generalized_states_hold_the_rates_of_their_coordinates(attitude: str) -> None:
    """The first half of x' is the second half of x, and both forms turn alike."""
    quasi, general = model_of(attitude), model_of(attitude, "generalized")
    x, y = state_of(quasi), state_of(general)
    n = y.size // 2
    assert np.array_equal(general.derivative(0.0, y)[:n], y[n:])
    np.testing.assert_allclose(quasi.derivative(0.0, x)[:n], y[n:], rtol=0, atol=TOLERANCE)


def test_defaults_are_zero_and_the_identity() -> None:
    assert model_of("quaternion").state().tolist() == [0.0] * 3 + [1.0] + [0.0] * 9
    for attitude in ("zyx", "xyz"):
        for form in FORMS:
            assert model_of(attitude, form).state().tolist() == [0.0] * 12


@pytest.mark.parametrize("sequence", SEQUENCES)
@pytest.mark.parametrize("form", FORMS)
def test_angles_stand_in_the_state_as_typed(sequence: str, form: str) -> None:
    typed = [7.0, 4.0, -9.0]
    model = model_of(sequence, form)
    x = model.state(attitude=fb.Attitude.angles(sequence, typed), angular_velocity_body=RATE)
    assert x[3:6].tolist() == typed
    # ... and the rates go with them.
    run = model.simulate(x, (0.0, 1e-3), save_at=[0.0])
    np.testing.assert_allclose(run.angular_velocity_body[0], RATE, rtol=0, atol=1e-12)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("attitude", ["quaternion", "zyx", "zxz"])
def test_without_input_elements_u_is_the_wrench_about_the_origin(attitude: str, form: str) -> None:
    weight = fb.UniformGravity(9.81)
    model = model_of(attitude, form, weight)
    x, u = state_of(model), np.array([3.0, -1.0, 2.0, 0.5, 0.2, -0.4])
    np.testing.assert_allclose(model.wrench(0.0, x, u) - model.wrench(0.0, x), u, rtol=0, atol=TOLERANCE)
    pushed = model_of(attitude, form, weight, fb.ConstantWrench(u[:3], u[3:]))
    np.testing.assert_allclose(model.derivative(0.0, x, u), pushed.derivative(0.0, x), rtol=0, atol=TOLERANCE)
    b = model.jacobian(0.0, x)[1]
    np.testing.assert_allclose(
        b @ u, model.derivative(0.0, x, u) - model.derivative(0.0, x), rtol=0, atol=TOLERANCE
    )
    if form == "quasi_velocity":
        assert np.all(b[:-6] == 0.0)
        np.testing.assert_allclose(b[-6:], BODY.inverse_spatial_inertia, rtol=0, atol=1e-15)
    assert model.forces == (weight,)


def test_several_input_elements_share_u_in_order() -> None:
    place = np.array([1.0, 2.0, 3.0])
    model = model_of(
        "quaternion",
        "quasi_velocity",
        fb.InputWrench(name="engine"),
        fb.UniformGravity(9.81),
        fb.InputWrench("world", name="tug", at=place),
    )
    assert model.n_inputs == 12
    assert model.input_names == tuple(f"{name}.{part}" for name in ("engine", "tug") for part in WRENCH)
    assert model.input_units == (("N",) * 3 + ("N m",) * 3) * 2
    x, engine, tug = state_of(model), np.arange(1.0, 7.0), np.arange(6.0, 0.0, -1.0)
    got = model.wrench(0.0, x, np.concatenate([engine, tug])) - model.wrench(0.0, x)
    c = ATTITUDE.as_rotation()
    pull, turn = c.T @ tug[:3], c.T @ tug[3:]
    np.testing.assert_allclose(got, engine + np.concatenate([pull, turn + np.cross(place, pull)]), atol=1e-12)
    # u that is left out is zero.
    np.testing.assert_array_equal(model.derivative(0.0, x), model.derivative(0.0, x, np.zeros(12)))
    assert model.jacobian(0.0, x)[1].shape == (13, 12)
    assert fb.Model(BODY, [fb.InputWrench(name="engine")]).input_names == WRENCH


def test_the_wrench_is_the_sum_of_the_forces() -> None:
    forces = [
        fb.UniformGravity(9.81),
        fb.LinearDamping([1, 2, 3, 4, 5, 6]),
        fb.ConstantWrench([1, 0, 0], axes="world", at=[0, 1, 0]),
    ]
    x = state_of(model_of("quaternion"))
    parts = [model_of("quaternion", "quasi_velocity", f).wrench(0.0, x) for f in forces]
    total = model_of("quaternion", "quasi_velocity", *forces).wrench(0.0, x)
    # Weights of some hundred newtons: absolute roundings of 1e-13.
    np.testing.assert_allclose(total, sum(parts), rtol=0, atol=1e-12)
    np.testing.assert_allclose(parts[1], -np.arange(1, 7) * [*VELOCITY, *RATE], rtol=1e-15)
    down = ATTITUDE.as_rotation().T @ [0.0, 0.0, 12.5 * 9.81]
    np.testing.assert_allclose(parts[0], [*down, *np.cross(BODY.com, down)], rtol=0, atol=1e-12)


def test_what_derivative_takes() -> None:
    model = model_of("quaternion")
    x, u = np.arange(1.0, 14.0), np.arange(6.0)
    expected = model.derivative(0.0, x, u)
    wide = np.zeros((13, 2))
    wide[:, 0] = x
    single = x.astype(np.float32)
    for same in (
        x.tolist(),
        tuple(x),
        x.astype(int),
        single,
        wide[:, 0],
        x[::-1][::-1],
        x.astype(">f8"),
        x.view(Sub),
    ):
        assert np.array_equal(model.derivative(0.0, same, u), expected)
        assert np.array_equal(model.jacobian(0.0, same, u)[0], model.jacobian(0.0, x, u)[0])
        assert np.array_equal(model.wrench(0.0, same, u), model.wrench(0.0, x, u))
    for same in (u.tolist(), u.astype(int), np.arange(12.0)[::2] / 2.0):
        assert np.array_equal(model.derivative(0.0, x, same), expected)
    times: tuple[Any, ...] = (0, 0.0, np.float32(0.0), np.int64(0), np.array(0.0))
    for t in times:
        assert np.array_equal(model.derivative(t, x, u), expected)
    read_only = x.copy()
    read_only.flags.writeable = False
    assert np.array_equal(model.derivative(0.0, read_only, u), expected)
    assert np.array_equal(model.derivative(t=0.0, x=x, u=u), expected)


class Sub(np.ndarray):
    """An array by another name."""


def test_derivative_writes_where_it_is_told() -> None:
    model = model_of("quaternion")
    x, out = np.arange(1.0, 14.0), np.full(13, np.nan)
    before = x.copy()
    result = model.derivative(0.0, x, out=out)
    assert result is out
    assert np.array_equal(out, model.derivative(0.0, x))
    assert np.array_equal(x, before)
    # Each call without `out` brings its own array.
    assert model.derivative(0.0, x) is not model.derivative(0.0, x)


@pytest.mark.parametrize("attitude", ["quaternion", "zyx"])
def test_jacobian_writes_where_it_is_told(attitude: str) -> None:
    model = model_of(attitude)
    x, u, n = state_of(model), np.arange(6.0), model.n_states
    out = np.full((n, n), np.nan), np.full((n, 6), np.nan)
    assert model.jacobian(0.0, x, u, out) is out
    for written, new in zip(out, model.jacobian(0.0, x, u), strict=True):
        assert np.array_equal(written, new)
    # A pair may be kept in any arrays that are contiguous.
    kept = np.zeros(n * n + 6 * n)
    model.jacobian(0.0, x, u, (kept[: n * n].reshape(n, n), kept[n * n :].reshape(n, 6)))
    assert np.array_equal(kept, np.concatenate([part.ravel() for part in out]))


def test_jacobian_of_many_states_and_inputs() -> None:
    """More than there is room for on the stack."""
    columns = [fb.InputWrench(name=f"thruster {i}", at=[0.1 * i, 0.0, 0.0]) for i in range(5)]
    model = model_of("quaternion", "quasi_velocity", *columns)
    x, u = state_of(model), np.arange(30.0)
    a, b = model.jacobian(0.0, x, u)
    assert (a.shape, b.shape) == ((13, 13), (13, 30))
    single, _ = model_of("quaternion").jacobian(0.0, x, model.wrench(0.0, x, u))
    np.testing.assert_allclose(a, single, rtol=0, atol=1e-12)  # rounding of terms of order ten
    out = np.empty((13, 13)), np.empty((13, 30))
    model.jacobian(0.0, x, u, out)
    assert np.array_equal(np.hstack(out), np.hstack([a, b]))


@pytest.mark.parametrize("sequence", SEQUENCES)
@pytest.mark.parametrize("turns", [0.0, 2.0, -4.0])
@pytest.mark.parametrize("form", FORMS)
def test_a_singular_chart_says_its_angle(sequence: str, turns: float, form: str) -> None:
    model = model_of(sequence, form)
    pole = (0.0 if sequence[0] == sequence[2] else 0.5 * np.pi) + turns * np.pi
    x = state_of(model)
    x[4] = pole
    degrees = f"{np.rad2deg(pole):.0f}"
    told = f"at t = 1.5 s the second angle of '{sequence}' is .* rad = {degrees}.* deg, .*use another"
    with pytest.raises(fb.SingularChartError, match=told):
        model.derivative(1.5, x)
    with pytest.raises(fb.SingularChartError, match=told):
        model.jacobian(1.5, x)
    # The wrench needs no rates of angles.
    assert np.isfinite(model.wrench(1.5, x)).all()
    # Next to it there are rates, large as they may be.
    x[4] = pole + 1e-9
    assert np.isfinite(model.derivative(1.5, x)).all()


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_a_state_at_the_singularity_exists_in_quasi_velocities_only(sequence: str) -> None:
    pole = 0.0 if sequence[0] == sequence[2] else 0.5 * np.pi
    attitude = fb.Attitude.angles(sequence, [0.3, pole, 0.1])
    x = model_of(sequence).state(attitude=attitude, angular_velocity_body=RATE)
    assert x[3:6].tolist() == [0.3, pole, 0.1]
    with pytest.raises(
        fb.SingularChartError, match=f"^the second angle of '{sequence}' is .*angle rates do not exist"
    ):
        model_of(sequence, "generalized").state(attitude=attitude, angular_velocity_body=RATE)
    # Other charts know nothing of it.
    model_of("quaternion", "generalized").state(attitude=attitude, angular_velocity_body=RATE)


@pytest.mark.parametrize("attitude", ["quaternion", "zyx"])
def test_what_is_not_finite_is_named(attitude: str) -> None:
    sun = fb.PointMassGravity(1.0, center=[1.0, 0.0, 0.0], name="sun")
    brake = fb.QuadraticDamping(np.full(6, 1e10), name="brake")
    model = model_of(attitude, "quasi_velocity", fb.UniformGravity(), sun, brake)
    x = model.state(position=np.subtract([1.0, 0.0, 0.0], BODY.com))
    for call in (model.derivative, model.jacobian, model.wrench):
        with pytest.raises(
            fb.NonFiniteError, match=r"at t = 2.5 s, x = \[0.88, .*the wrench of force 'sun' is not"
        ):
            call(2.5, x)
    fast = model.state(velocity_body=[1e150, 0.0, 0.0])
    with pytest.raises(fb.NonFiniteError, match="force 'brake' is not finite"):
        model.derivative(0.0, fast)
    spinning = model_of(attitude).state(angular_velocity_body=[1e200, 1e200, 0.0])
    with pytest.raises(
        fb.NonFiniteError, match="the motion or the sum of its wrenches is too large for doubles"
    ):
        model_of(attitude).derivative(0.0, spinning)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("attitude", ["quaternion", "yzx"])
def test_copies_and_pickles_are_the_same_model(attitude: str, form: Any) -> None:
    forces: list[fb.Force] = [
        fb.UniformGravity(3.7, [1, 0, 1], name="mars"),
        fb.PointMassGravity(2.0, [5, 0, 0], gradient_torque=False),
        fb.ConstantWrench([1, 2, 3], [4, 5, 6], "world", [7, 8, 9]),
        fb.TabulatedWrench([0, 1], [[0, 0, 0], [1, 2, 3]], interpolation="hold"),
        fb.LinearDamping(np.arange(36.0).reshape(6, 6)),
        fb.QuadraticDamping(np.ones(6)),
        fb.InputWrench("world", [1, 0, 0], name="tug"),
    ]
    model = fb.Model(BODY, forces, attitude, form, name="probe")
    x, u = state_of(model), np.arange(6.0)
    for twin in (pickle.loads(pickle.dumps(model)), copy.copy(model), copy.deepcopy(model)):
        assert repr(twin) == repr(model)
        assert (twin.name, twin.attitude, twin.form, twin.body) == ("probe", attitude, form, BODY)
        assert [f.name for f in twin.forces] == [f.name for f in forces]
        assert np.array_equal(twin.derivative(0.5, x, u), model.derivative(0.5, x, u))


def test_repr() -> None:
    model = fb.Model(
        BODY, [fb.UniformGravity(name="earth"), fb.InputWrench()], "zyx", "generalized", name="boat"
    )
    assert repr(model) == "<Model 'boat': 'hull', forces: earth, InputWrench; zyx, generalized>"
    assert repr(fb.Model(BODY)) == "<Model 'model': 'hull', forces: none; quaternion, quasi_velocity>"
    assert repr(fb.UniformGravity(name="earth")) == "<UniformGravity 'earth'>"


def test_forces_may_come_in_any_iterable() -> None:
    forces = [fb.UniformGravity(), fb.LinearDamping(np.ones(6))]
    for given in (forces, tuple(forces), iter(forces), (f for f in forces)):
        assert fb.Model(BODY, given).forces == tuple(forces)


def test_extreme_directions_and_coefficients() -> None:
    for size in (5e-324, 1e-200, 1.0, 1e200, 1.7e308):
        assert fb.UniformGravity(1.0, [0, 0, size]).direction.tolist() == [0.0, 0.0, 1.0]
    diagonal = np.arange(1.0, 7.0)
    x = state_of(model_of("quaternion"))
    for damping in (fb.LinearDamping, fb.QuadraticDamping):
        by_diagonal, full = damping(diagonal), damping(np.diag(diagonal))
        np.testing.assert_array_equal(
            model_of("quaternion", "quasi_velocity", by_diagonal).wrench(0.0, x),
            model_of("quaternion", "quasi_velocity", full).wrench(0.0, x),
        )


def test_linearization_along_a_run() -> None:
    model = model_of("zyx", "quasi_velocity", fb.UniformGravity(), fb.LinearDamping(np.ones(6)))
    table = fb.InputTable([0.0, 1.0], [[0.0] * 6, [1.0] * 6])
    run = model.simulate(state_of(model), (0.0, 1.0), save_every=0.25, inputs=table)
    along = model.linearize(run)
    assert (along.A.shape, along.B.shape) == ((5, 12, 12), (5, 12, 6))
    assert np.array_equal(along.t, run.t)
    for i in range(5):
        a, b = model.jacobian(run.t[i], run.x[i], run.u[i])
        assert np.array_equal(along.A[i], a)
        assert np.array_equal(along.B[i], b)


def test_a_linearization_at_the_singularity_says_when() -> None:
    model = model_of("zxz")
    run = model.simulate(state_of(model), (0.0, 1.0), save_at=[0.0, 0.5, 1.0])
    run.x[1, 4] = 0.0
    with pytest.raises(fb.SingularChartError, match=r"at t = 0.5 s the second angle of 'zxz' is 0 rad"):
        model.linearize(run)
