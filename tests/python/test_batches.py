"""f and its Jacobians at many states at once."""

import numpy as np
import pytest

import freebody as fb

COUNT = 130  # more than two blocks of the kernel, and no multiple of any number of lanes


@fb.force(
    parameters={"drag": (0.3, "N s/m"), "full": (1.0, "rad"), "lag": (0.2, "s")},
    inputs={"flap": "rad"},
    states={"servo": (0.1, "rad")},
)
def flap(s, p):
    v = s.velocity_body
    push = fb.wrench(force=-p.drag * (1.0 + s.states.servo / p.full) * v)
    return push, {"servo": (s.inputs.flap - s.states.servo) / p.lag}


def models():
    body = fb.RigidBody(2.0, [0.1, -0.2, 0.05], inertia_about_com=np.diag([0.2, 0.3, 0.35]))
    yield fb.Model(body, [fb.UniformGravity(), fb.LinearDamping([1, 2, 3, 0.1, 0.2, 0.3])])
    yield fb.Model(body, [fb.PointMassGravity(50.0, [9, 9, 9]), flap], attitude="zyx", form="generalized")


@pytest.fixture(params=[0, 1], ids=["usual forces", "laws in angles"])
def model(request):
    return list(models())[request.param]


@pytest.fixture
def points(model):
    rng = np.random.default_rng(3)
    attitude = fb.Attitude.angles("zyx", [0.3, 0.4, -0.2])
    x0 = model.state([1, 2, 3], attitude, velocity_body=[1, 2, 3], angular_velocity_body=[0.3, -0.2, 0.1])
    x = x0[:, None] * rng.uniform(0.9, 1.1, (model.n_states, COUNT))
    return rng.uniform(0.0, 2.0, COUNT), x, rng.normal(size=(model.n_inputs, COUNT))


def test_derivatives_are_those_of_the_states_alone(model, points):
    t, x, u = points
    dx = model.derivative_batch(t, x, u)
    for k in range(0, COUNT, 13):
        np.testing.assert_array_equal(dx[:, k], model.derivative(t[k], x[:, k].copy(), u[:, k].copy()))
    out = np.empty_like(x)
    assert model.derivative_batch(t, x, u, out, threads=0) is out
    np.testing.assert_array_equal(out, dx)


def test_jacobians_are_those_of_the_states_alone(model, points):
    t, x, u = points
    jacobian = model.jacobian_batch(t, x, u, threads=2)
    assert jacobian.shape == (model.n_states, model.n_states + model.n_inputs, COUNT)
    for k in range(0, COUNT, 13):
        alone = np.hstack(model.jacobian(t[k], x[:, k].copy(), u[:, k].copy()))
        # The same sums in another order: roundings of the largest entry.
        np.testing.assert_allclose(jacobian[:, :, k], alone, rtol=0, atol=1e-14 * np.abs(alone).max())


def test_entries_left_out_are_zero(model, points):
    t, x, u = points
    dense, sparse = model.jacobian_batch(t, x, u), model.jacobian_batch(t, x, u, sparse=True)
    rows, columns = model.jacobian_entries
    assert rows.dtype == columns.dtype == np.int64
    np.testing.assert_array_equal(sparse, dense[rows, columns])
    left_out = np.ones(dense.shape[:2], dtype=bool)
    left_out[rows, columns] = False
    assert np.all(dense[left_out] == 0.0)
    out = np.empty_like(sparse)
    assert model.jacobian_batch(t, x, u, out, threads=2, sparse=True) is out
    np.testing.assert_array_equal(out, sparse)


def test_known_models_leave_entries_out():
    known, other = models()
    assert len(known.jacobian_entries[0]) < 13 * 19
    assert len(other.jacobian_entries[0]) == other.n_states * (other.n_states + other.n_inputs)


def test_one_time_and_one_input_stand_for_all(model, points):
    _, x, u = points
    wide = np.repeat(u[:, :1], COUNT, axis=1)
    for f in (model.derivative_batch, model.jacobian_batch):
        np.testing.assert_array_equal(f(0.5, x, u[:, 0]), f(np.full(COUNT, 0.5), x, wide))
        np.testing.assert_array_equal(f(0.5, x), f(0.5, x, np.zeros_like(u)))


def test_arrays_of_any_layout_are_read(model, points):
    t, x, u = points
    dx = model.derivative_batch(t, x, u)
    np.testing.assert_array_equal(model.derivative_batch(t, np.asfortranarray(x), u), dx)
    np.testing.assert_array_equal(
        model.derivative_batch(t[0], x[:, ::2], u[:, 0]).shape, (len(x), COUNT // 2)
    )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"x": np.zeros((3, 4))}, r"x: got shape \[3, 4\]; allowed is \[13, 4\]"),
        ({"x": [1.0, 2.0]}, r"x: want an array \(13, n\), a state a column"),
        ({"t": np.zeros(3)}, r"t: got shape \[3\]; allowed is \[\] or \[1\] or \[5\]"),
        ({"u": np.zeros(2)}, r"u: got shape \[2\]; allowed is \[6\] or \[6, 5\]"),
        ({"out": np.zeros((13, 4))}, r"out: want a writeable, contiguous float64 array of shape \[13, 5\]"),
    ],
)
def test_wrong_arguments_are_refused(change, message):
    model = next(models())
    given = {"t": 0.0, "x": np.ones((13, 5))} | change
    with pytest.raises(fb.InputError, match=message):
        model.derivative_batch(**given)


def test_no_states_are_no_derivatives():
    model = next(models())
    assert model.derivative_batch(0.0, np.empty((13, 0))).shape == (13, 0)
