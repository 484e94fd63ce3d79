"""Runs: which samples they hold, how they end, and what can be read off them."""

import pickle
import signal
import threading
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import freebody as fb

BODY = fb.RigidBody(
    2.0, [0.1, -0.2, 0.3], inertia_about_com=fb.principal_inertia([1.0, 1.4, 1.9]), name="hull"
)
GRAVITY = fb.UniformGravity(9.81, name="earth")
MODEL = fb.Model(BODY, [GRAVITY], name="stone")
X0 = MODEL.state([1.0, 2.0, 3.0], velocity_body=[1.0, 0.5, -2.0], angular_velocity_body=[0.3, 2.0, 0.1])
METHODS: list[dict[str, Any]] = [
    {"method": "dop853"},
    {"method": "dp54"},
    {"method": "rk4", "step": 1e-3},
    {"method": "rodas5p"},
    {"method": "gauss6", "step": 0.03},
]


def stone(t_span: tuple[float, float] = (0.0, 1.0), **options: Any) -> fb.Trajectory:
    return MODEL.simulate(X0, t_span, **options)


@pytest.mark.parametrize("options", METHODS, ids=lambda o: o["method"])
def test_save_every(options: dict[str, Any]) -> None:
    run = stone((2.0, 3.0), save_every=0.25, **options)
    assert run.t.tolist() == [2.0, 2.25, 2.5, 2.75, 3.0]
    assert np.array_equal(run.x[0], X0)
    # The polynomial of the last step ends where the step does, to rounding.
    np.testing.assert_allclose(run.x[-1], run.outcome.state, rtol=0, atol=1e-14)
    # The end is a sample too, when no interval ends there.
    assert stone((0.0, 1.0), save_every=0.4, **options).t == pytest.approx([0.0, 0.4, 0.8, 1.0])
    assert stone((0.0, 1.0), save_every=50.0, **options).t.tolist() == [0.0, 1.0]
    # An interval that is a rounding short of the span makes no sample next to the end.
    assert stone((0.0, 0.3), save_every=0.1, **options).t == pytest.approx([0.0, 0.1, 0.2, 0.3])
    assert stone((0.0, 0.7), save_every=0.1, **options).t.size == 8


@pytest.mark.parametrize("options", METHODS, ids=lambda o: o["method"])
def test_save_at(options: dict[str, Any]) -> None:
    wanted = [0.0, 0.123, 0.1230001, 0.5, 1.0]
    run = stone(save_at=wanted, **options)
    assert run.t.tolist() == wanted
    assert np.array_equal(run.x[0], X0)
    inner = stone(save_at=[0.5], **options)
    assert inner.t.tolist() == [0.5]
    assert inner.outcome.time == 1.0
    # Samples lie on the motion, whatever steps it took: those of another sampling are the same.
    assert np.array_equal(inner.x[0], run.x[3])
    # A stone falls as it falls.
    com = run.com_position_world
    fall = com[0] + np.outer(run.t, run.com_velocity_world[0]) + np.outer(0.5 * run.t**2, [0.0, 0.0, 9.81])
    # dp54's samples are of order 4: some of its tolerance of 1e-9 more.
    np.testing.assert_allclose(com, fall, rtol=0, atol=1e-8)


@pytest.mark.parametrize("options", METHODS, ids=lambda o: o["method"])
def test_without_times_every_step_is_a_sample(options: dict[str, Any]) -> None:
    run = stone(**options)
    assert len(run) == run.t.size == run.steps + 1
    assert run.t[0] == 0.0
    assert run.t[-1] == 1.0
    assert np.all(np.diff(run.t) > 0.0)


def test_step_is_the_fixed_or_the_first_one() -> None:
    run = stone(method="rk4", step=0.3)
    # Four steps; the last one is cut at the end.
    np.testing.assert_allclose(run.t, [0.0, 0.3, 0.6, 0.9, 1.0], rtol=1e-15)
    assert (run.steps, run.rejected_steps) == (4, 0)
    for method in ("dop853", "dp54"):
        first = stone(method=method, step=1e-4)
        assert first.t[1] == 1e-4
        assert np.diff(first.t).max() > 1e-3
    # A first step beyond the end, or far too bold, is no harm.
    for step in (5.0, 1e300):
        bold = stone(step=step)
        np.testing.assert_allclose(bold.x[-1], stone().x[-1], rtol=0, atol=1e-7)


@pytest.mark.parametrize("options", METHODS, ids=lambda o: o["method"])
def test_a_good_end(options: dict[str, Any]) -> None:
    run = stone(**options)
    assert run.ok
    assert run.outcome.ok
    assert run.outcome.status == "reached_end"
    assert run.outcome.time == 1.0
    assert run.outcome.force is None
    assert run.outcome.message == "reached the end at t = 1 s"
    assert np.array_equal(run.outcome.state, run.x[-1])
    assert run.chart_changes == ()
    assert run.evaluations > run.steps > 0
    assert run.wall_time > 0.0
    assert run.model is MODEL
    assert repr(run) == f"<Trajectory of 'stone': {len(run)} samples, reached_end>"


def test_a_run_out_of_steps_keeps_what_it_did() -> None:
    whole = stone(method="rk4", step=0.1)
    run = stone(method="rk4", step=0.1, max_steps=3)
    assert (run.ok, run.outcome.status) == (False, "step_limit")
    assert "raise max_steps" in run.outcome.message
    assert np.array_equal(run.t, whole.t[:4])
    assert np.array_equal(run.x, whole.x[:4])
    assert run.outcome.time == run.t[-1]
    assert np.array_equal(run.outcome.state, run.x[-1])


def test_a_run_without_finite_derivative_names_the_force() -> None:
    sun = fb.PointMassGravity(1.0, center=BODY.com, gradient_torque=False, name="sun")
    model = fb.Model(BODY, [GRAVITY, sun])
    run = model.simulate(model.state(), (0.0, 1.0))
    assert (run.outcome.status, run.outcome.time, run.outcome.force) == ("non_finite", 0.0, "sun")
    assert "not finite at t = 0 of 1 s; force 'sun' made it so" in run.outcome.message
    assert np.array_equal(run.x, [model.state()])
    # What is read off it may be infinite, but it comes without a warning.
    assert run.energy.tolist() == [-np.inf]
    run.conserved()


def test_a_run_that_blows_up_ends() -> None:
    model = fb.Model(BODY, [fb.QuadraticDamping(np.full(6, -1e3), name="thrust")])
    run = model.simulate(model.state(velocity_body=[1.0, 0.0, 0.0]), (0.0, 10.0), save_every=1e-4)
    # v' = k v² is infinite at 1 / k, and -D/m = 500 here as the mass centre lies off the line of the force.
    assert run.outcome.status in {"step_too_small", "non_finite"}
    assert 0.0 < run.outcome.time < 1.0 / 100.0
    assert "t = 0.00" in run.outcome.message
    assert len(run) > 2
    assert np.isfinite(run.x).all()


def test_a_run_that_ends_before_its_first_sample_is_empty() -> None:
    run = stone(save_at=[0.9], step=1e-3, max_steps=1)
    assert len(run) == 0
    for name, shape in SHAPES.items():
        assert getattr(run, name).shape == (0, *shape), name
    assert run.angles("zyx").shape == (0, 3)
    assert run.point([1, 2, 3]).shape == (0, 3)
    assert run.conserved() == []
    assert run.to_xarray().sizes["time"] == 0
    # ... and yet it says where it came to.
    assert run.outcome.time == pytest.approx(1e-3)
    assert np.isfinite(run.outcome.state).all()


def test_progress_is_told_the_part_done() -> None:
    heard: list[float] = []
    run = stone((5.0, 15.0), method="rk4", step=1e-3, save_at=[15.0], progress=heard.append)
    assert run.ok
    assert len(heard) >= 5
    assert all(0.0 < a < b <= 1.0 for a, b in pairwise(heard))
    # A short run may have nothing to tell.
    stone(progress=heard.append)


@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError])
def test_what_progress_raises_stops_the_run(error: type[BaseException]) -> None:
    calls = []

    def stop(part: float) -> None:
        calls.append(part)
        raise error("enough")

    with pytest.raises(error, match="enough"):
        stone((0.0, 1e6), method="rk4", step=1e-3, save_at=[1e6], progress=stop)
    assert len(calls) == 1


def test_an_interrupt_stops_a_long_run() -> None:
    threading.Timer(0.05, signal.raise_signal, [signal.SIGINT]).start()
    with pytest.raises(KeyboardInterrupt):
        # Some minutes of steps.
        stone((0.0, 1e6), method="rk4", step=1e-3, save_at=[1e6], max_steps=1_000_000_000)


def test_input_tables_between_and_outside_their_rows() -> None:
    times, values = [0.0, 1.0, 1.0, 3.0], [[0.0, 8.0], [2.0, 8.0], [5.0, -8.0], [9.0, -8.0]]
    linear, hold = fb.InputTable(times, values), fb.InputTable(times, values, "hold")
    t = [-5.0, 0.0, 0.5, 1.0, 2.0, 3.0, 99.0]
    # At the jump the later row; outside the first and the last.
    assert linear.at(t)[:, 0].tolist() == [0.0, 0.0, 1.0, 5.0, 7.0, 9.0, 9.0]
    assert hold.at(t)[:, 0].tolist() == [0.0, 0.0, 0.0, 5.0, 5.0, 9.0, 9.0]
    assert linear.at(t)[:, 1].tolist() == [8.0, 8.0, 8.0, -8.0, -8.0, -8.0, -8.0]
    assert linear.at(np.array([2])).shape == (1, 2)
    assert fb.InputTable([7.0], [[3.0]]).at([0.0, 7.0, 9.0]).tolist() == [[3.0]] * 3


@pytest.mark.parametrize("interpolation", ["linear", "hold"])
@pytest.mark.parametrize("options", METHODS, ids=lambda o: o["method"])
def test_inputs_over_time(interpolation: Any, options: dict[str, Any]) -> None:
    """A push along x on a body that does not turn: its speed is the integral of the table over the mass."""
    body = fb.RigidBody(2.0, inertia_about_com=np.eye(3))
    model = fb.Model(body)
    table = fb.InputTable([0.2, 0.6, 0.6, 1.4], np.outer([1.0, 3.0, -2.0, 4.0], np.eye(6)[0]), interpolation)
    run = model.simulate(model.state(), (0.0, 2.0), save_every=0.1, inputs=table, **options)
    assert np.array_equal(run.u, table.at(run.t))
    fine = np.linspace(0.0, 2.0, 200_001)
    push = table.at(fine)[:, 0]
    # Trapezoids, a jump within one of them: 5 N over 5 µs.
    speed = np.concatenate([[0.0], np.cumsum(0.5e-5 * (push[1:] + push[:-1]))]) / body.mass
    np.testing.assert_allclose(run.velocity_world[:, 0], np.interp(run.t, fine, speed), rtol=0, atol=4e-5)
    # A tabulated force in the model is the same.
    forced = fb.Model(
        body, [fb.TabulatedWrench(table.times, table.values[:, :3], interpolation=interpolation)]
    )
    twin = forced.simulate(forced.state(), (0.0, 2.0), save_every=0.1, **options)
    np.testing.assert_allclose(twin.x, run.x, rtol=0, atol=1e-12)


def test_constant_inputs() -> None:
    u = [3.0, -1.0, 2.0, 0.5, 0.2, -0.4]
    run = stone(inputs=u, save_every=0.5)
    assert run.u.tolist() == [u] * 3
    assert stone(save_every=0.5).u.tolist() == [[0.0] * 6] * 3
    pushed = fb.Model(BODY, [GRAVITY, fb.ConstantWrench(u[:3], u[3:])])
    np.testing.assert_allclose(run.x, pushed.simulate(X0, (0, 1), save_every=0.5).x, rtol=0, atol=1e-10)


# What can be read off n samples, but for the leading n.
SHAPES: dict[str, tuple[int, ...]] = {
    "t": (),
    "x": (13,),
    "u": (6,),
    "position_world": (3,),
    "world_from_body": (3, 3),
    "quaternion": (4,),
    "velocity_body": (3,),
    "velocity_world": (3,),
    "angular_velocity_body": (3,),
    "angular_velocity_world": (3,),
    "com_position_world": (3,),
    "com_velocity_world": (3,),
    "kinetic_energy": (),
    "potential_energy": (),
    "energy": (),
    "momentum_world": (6,),
}


def test_what_can_be_read_off_a_run() -> None:
    run = stone(save_every=0.125)
    n = len(run)
    assert n == 9
    for name, shape in SHAPES.items():
        values = getattr(run, name)
        assert values.shape == (n, *shape), name
        assert values.dtype == np.float64, name
    assert run.singularity_distance is None
    assert (run.state_names, run.state_units) == (MODEL.state_names, MODEL.state_units)
    c = run.world_from_body
    np.testing.assert_allclose(
        c @ c.transpose(0, 2, 1), np.broadcast_to(np.eye(3), c.shape), rtol=0, atol=2e-15
    )
    np.testing.assert_allclose(run.point(BODY.com), run.com_position_world, rtol=0, atol=0)
    assert np.array_equal(run.point([0, 0, 0]), run.position_world)
    # The definitions, sample by sample; sizes up to 1e3, so some roundings of that.
    for i in range(n):
        twist = np.concatenate([run.velocity_body[i], run.angular_velocity_body[i]])
        momentum = fb.forms.momentum_world(BODY, run.position_world[i], c[i], twist)
        np.testing.assert_allclose(run.momentum_world[i], momentum, rtol=0, atol=1e-12)
        np.testing.assert_allclose(
            run.kinetic_energy[i], 0.5 * twist @ BODY.spatial_inertia @ twist, rtol=1e-14
        )
        np.testing.assert_allclose(c[i] @ run.velocity_body[i], run.velocity_world[i], rtol=0, atol=1e-14)
    # A weight has its potential at the height of the mass centre: the third axis points down.
    height = -run.com_position_world[:, 2]
    np.testing.assert_allclose(run.potential_energy, 2.0 * 9.81 * height, rtol=1e-14)
    assert np.array_equal(run.energy, run.kinetic_energy + run.potential_energy)


def test_angles_of_a_run() -> None:
    model = fb.Model(BODY, [GRAVITY], "yzx", "generalized")
    start = model.state(
        attitude=fb.Attitude.angles("yzx", [0.3, 0.2, 7.0]), angular_velocity_body=[2.0, 0.1, 0.2]
    )
    run = model.simulate(start, (0.0, 3.0), save_every=0.1)
    assert run.angles()[0].tolist() == [0.3, 0.2, 7.0]
    assert np.array_equal(run.angles(), run.x[:, 3:6])
    assert np.array_equal(run.angles("yzx"), run.x[:, 3:6])
    assert run.angles()[:, 2].max() > 2.0 * np.pi
    assert run.singularity_distance is not None
    np.testing.assert_allclose(run.singularity_distance, 0.5 * np.pi - np.abs(run.angles()[:, 1]), rtol=1e-12)
    for sequence in fb.forms.SEQUENCES:
        turned = fb.forms.rotation(run.angles(sequence), sequence)
        np.testing.assert_allclose(turned, run.world_from_body, rtol=0, atol=1e-14)


def test_quaternions_of_a_run_do_not_jump() -> None:
    run = stone((0.0, 20.0), save_every=0.01)
    # 2 rad/s for 0.01 s turn a quaternion by 0.01; a change of sign would be 2.
    assert np.linalg.norm(np.diff(run.quaternion, axis=0), axis=1).max() < 0.011


def test_conserved_quantities() -> None:
    free = fb.Model(BODY)
    names = [c.name for c in free.simulate(X0, (0.0, 1.0)).conserved()]
    assert names[:2] == ["energy", "momentum"]
    assert all("angular momentum" in name for name in names[2:])
    kept = stone((0.0, 10.0), save_every=0.1).conserved()
    assert {c.name for c in kept} >= {"energy", "level momentum", "angular momentum about the mass centre"}
    assert all(c.unit and c.reference > 0.0 for c in kept)
    # rtol is 1e-9 a step, and a hundred steps are enough.
    assert all(c.drift < 1e-7 for c in kept)
    # With damping, or while somebody pushes, nothing is promised.
    damped = fb.Model(BODY, [GRAVITY, fb.LinearDamping(np.ones(6))])
    assert damped.simulate(X0, (0.0, 1.0)).conserved() == []
    assert stone(inputs=[1, 0, 0, 0, 0, 0]).conserved() == []


def test_chart_changes_are_told() -> None:
    model = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), attitude="zyx")
    run = model.simulate(model.state(angular_velocity_body=[0.0, 1.0, 0.0]), (0.0, 2.0))
    assert run.ok
    assert run.chart_changes
    first = run.chart_changes[0]
    assert (first.from_chart, first.to_chart) == ("zyx", "quaternion")
    # The pitch is the time here, and where it stood when the run changed is the distance.
    assert first.distance == pytest.approx(abs(0.5 * np.pi - first.time), abs=1e-6)
    assert all(a.to_chart == b.from_chart for a, b in pairwise(run.chart_changes))


def test_to_xarray() -> None:
    table = fb.InputTable([0.0, 1.0], [[0.0] * 6, [1.0] * 6])
    run = stone(save_every=0.25, inputs=table)
    dataset = run.to_xarray()
    units = {
        "position_world": "m",
        "velocity_world": "m s-1",
        "velocity_body": "m s-1",
        "com_position_world": "m",
        "com_velocity_world": "m s-1",
        "quaternion": "1",
        "angular_velocity_body": "rad s-1",
        "angular_velocity_world": "rad s-1",
        "kinetic_energy": "J",
        "potential_energy": "J",
        "energy": "J",
    }
    assert np.array_equal(dataset["time"], run.t)
    assert dataset["time"].attrs["units"] == "s"
    for name, unit in units.items():
        assert dataset[name].attrs["units"] == unit
        assert dataset[name].dims[0] == "time"
        assert np.array_equal(dataset[name], getattr(run, name))
    for i, name in enumerate(MODEL.input_names):
        assert np.array_equal(dataset[f"input_{name}"], run.u[:, i])
        assert dataset[f"input_{name}"].attrs["units"] == MODEL.input_units[i]
    assert dataset["position_world"].coords["axis"].values.tolist() == ["x", "y", "z"]
    assert dataset.attrs["outcome"] == "reached_end"


def test_runs_can_be_sent() -> None:
    run = stone(save_every=0.25)
    twin = pickle.loads(pickle.dumps(run))
    assert np.array_equal(twin.x, run.x)
    assert np.array_equal(twin.energy, run.energy)
    assert (twin.outcome.status, twin.steps, twin.model.name) == ("reached_end", run.steps, "stone")
    # Also what is told only when asked.
    assert (twin.outcome.message, twin.chart_changes, twin.events) == (run.outcome.message, (), ())
    assert np.array_equal(twin.outcome.state, run.outcome.state)
    assert np.array_equal(twin.u, np.zeros((len(run), MODEL.n_inputs)))


@pytest.mark.parametrize("options", METHODS, ids=lambda o: o["method"])
def test_a_run_repeats_itself(options: dict[str, Any]) -> None:
    assert np.array_equal(stone(**options).x, stone(**options).x)


def test_an_argument_may_come_in_any_numeric_form() -> None:
    options: dict[str, Any] = {"t_span": np.array([0, 1]), "save_every": np.float32(0.5), "max_steps": 1e6}
    again = MODEL.simulate(X0.tolist(), **options)
    assert np.array_equal(again.x, stone(save_every=0.5).x)
