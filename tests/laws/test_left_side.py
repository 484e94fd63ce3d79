"""Wheels, added mass and mass that changes: what they keep, and that no frame and no chart matters."""

from __future__ import annotations

from typing import Any

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import simpson

import freebody as fb
from freebody.simulation import checked_settings

from .scenes import BODY, CHARTS, FORMS, START, Array, motion_gap, relative
from .vehicles import (
    EXITS,
    FLOW,
    FULL,
    NO_MOVE,
    NO_TURN,
    SHARES,
    SPEED,
    TANK,
    WAYS,
    added_mass,
    all_of_it,
    by_hand,
    engine,
    flow_momentum,
    fluid,
    vehicle,
    wheel,
)

POINT = np.array([0.5, 0.6, -0.7])
TIGHT: dict[str, Any] = {"rtol": 1e-12, "save_every": 0.1}


def drift(values: Array) -> float:
    """The largest deviation from the first value, relative to the largest size."""
    rows = values.reshape(len(values), -1)
    return float(np.abs(rows - rows[0]).max() / np.linalg.norm(rows, axis=1).max())


def run_in_frame(origin: Array, turn: Array) -> tuple[fb.Trajectory, Array]:
    model = fb.Model(BODY.in_frame(origin, turn), all_of_it(origin, turn))
    rotation, spin = START["attitude"].as_rotation(), np.array(START["angular_velocity_body"])
    x0 = model.state(
        START["position"] + rotation @ origin,
        fb.Attitude.rotation(rotation @ turn),
        velocity_body=turn.T @ (START["velocity_body"] + np.cross(spin, origin)),
        angular_velocity_body=turn.T @ spin,
    )
    run = model.simulate(x0, (0.0, 5.0), **TIGHT)
    return run, run.point(turn.T @ (POINT - origin))


@pytest.mark.parametrize("attitude", [[0.0, 0.0, 0.0], [0.4, -0.7, 1.1]])
@pytest.mark.parametrize("origin", [[0.0, 0.0, 0.0], [-0.4, 0.3, 0.5]])
def test_no_frame_matters(origin: list[float], attitude: list[float]) -> None:
    turn = fb.Attitude.angles("zyx", attitude).as_rotation()
    (run, path), (other, expected) = run_in_frame(np.array(origin), turn), run_in_frame(NO_MOVE, NO_TURN)
    # The error of runs at a tolerance of 1e-12 over five seconds of a motion that turns fifty times.
    assert relative(path, expected) < 1e-9
    assert relative(run.angular_velocity_world, other.angular_velocity_world) < 1e-9
    assert relative(run.momentum_world, other.momentum_world) < 1e-9
    assert relative(run.states["wheel.speed"], other.states["wheel.speed"]) < 1e-9
    assert relative(run.com_position_world, other.com_position_world) < 1e-9
    np.testing.assert_allclose(run.mass, BODY.mass + FULL - FLOW * run.t, rtol=1e-13)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("attitude", CHARTS)
def test_no_chart_matters(attitude: str, form: Any) -> None:
    """Charts that are left near their singularity among them."""
    run, reference = (
        model.simulate(model.state(**START), (0.0, 2.0), **TIGHT)
        for model in (vehicle(attitude, form), vehicle())
    )
    # Steps of a tolerance of 1e-12, a few hundred of them.
    assert motion_gap(run, reference) < 1e-9
    assert relative(run.states["wheel.speed"], reference.states["wheel.speed"]) < 1e-9


@pytest.mark.parametrize("torque", [0.0, 0.3])
def test_a_gyrostat_keeps_its_momentum(torque: float) -> None:
    model = fb.Model(BODY, [wheel(torque=torque)])
    run = model.simulate(model.state(**START), (0.0, 20.0), **TIGHT)
    # Tolerance 1e-12 a step over some hundred steps.
    assert drift(run.momentum_world) < 1e-10
    # What the motor does on the wheel relative to the body is all that the energy gains.
    assert drift(run.energy - run.states["wheel.work"]) < 1e-10
    if torque:
        assert abs(run.energy[-1] - run.energy[0]) > 100.0
    assert run.conserved() == []


def test_a_wheel_without_a_motor_keeps_its_spin_in_space() -> None:
    model = fb.Model(BODY, [wheel()])
    run = model.simulate(model.state(**START), (0.0, 20.0), **TIGHT)
    axis = np.array(model.forces[0].spins[0].axis)
    assert drift(run.states["wheel.speed"] + run.angular_velocity_body @ axis) < 1e-11


def test_a_fluid_does_no_work_of_its_own() -> None:
    model = fb.Model(BODY, [fluid()])
    run = model.simulate(model.state(**START), (0.0, 20.0), **TIGHT)
    whole = BODY.spatial_inertia + added_mass()
    twist = np.hstack([run.velocity_body, run.angular_velocity_body])
    # Tolerance 1e-12 a step over some hundred steps.
    assert drift(0.5 * np.einsum("ni,ij,nj->n", twist, whole, twist)) < 1e-10
    # Kirchhoff: the impulse of body and fluid stays, about a point of space.
    impulse = twist @ whole
    linear = np.einsum("nij,nj->ni", run.world_from_body, impulse[:, :3])
    angular = np.einsum("nij,nj->ni", run.world_from_body, impulse[:, 3:])
    assert drift(linear) < 1e-10
    assert drift(angular + np.cross(run.position_world, linear)) < 1e-10
    assert drift(run.momentum_world) > 1e-3  # the body's alone does not


def test_what_a_rocket_gains_its_exhaust_carries_away() -> None:
    model = fb.Model(BODY, [engine()])
    times = np.linspace(0.0, 2.0, 2001)
    run = model.simulate(model.state(**START), (0.0, 2.0), rtol=1e-12, save_at=times)
    flow = np.zeros((len(times), 6))
    for exit_, share, way in zip(EXITS, SHARES, WAYS, strict=True):
        swing = np.cross(run.angular_velocity_body, exit_)
        gas = np.einsum("nij,nj->ni", run.world_from_body, run.velocity_body + swing - SPEED * way)
        flow += FLOW * share * np.hstack([gas, np.cross(run.point(exit_), gas)])
    carried = simpson(flow, x=times, axis=0)
    # Body and fuel as one rigid body, and what the fuel has from its way to the exits.
    inside = run.world_from_body @ flow_momentum()
    total = run.momentum_world + np.hstack([inside, np.cross(run.point(TANK), inside)])
    gained = total[-1] - total[0]
    # Simpson's rule on steps of 1 ms of motions that turn by 0.01 rad in it: h⁴/180 of them.
    assert np.abs(gained + carried).max() < 1e-8 * np.abs(gained).max()
    assert run.conserved() == []


def test_derivative_and_jacobian_are_those_of_full_matrices() -> None:
    model = vehicle("zyx")
    x = model.state(**START, states={"wheel.speed": 30.0, "engine.fuel": 2.5})
    places = range(6, 15)
    with mp.workdps(50):
        exact = [mp.mpf(v) for v in x]
        found = model.derivative(0.3, x)[6:]
        np.testing.assert_allclose(found, np.array(by_hand(exact), float), rtol=1e-12, atol=1e-12)
        step = mp.mpf("1e-18")
        a, _ = model.jacobian(0.3, x)
        for j in range(len(x)):
            ahead, behind = list(exact), list(exact)
            ahead[j], behind[j] = exact[j] + step, exact[j] - step
            pairs = zip(by_hand(ahead), by_hand(behind), strict=True)
            column = np.array([(p - q) / (2 * step) for p, q in pairs], float)
            # Chain rules of some ten steps, and a solution with a matrix of condition 1e3.
            np.testing.assert_allclose(a[places, j], column, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("attitude", ["quaternion", "zyx", "zxz"])
def test_many_at_once_are_each_alone(attitude: str, form: Any, rng: np.random.Generator) -> None:
    model = vehicle(attitude, form)
    x = model.state(**START) + 0.1 * rng.normal(size=(21, model.n_states))
    t, u = rng.uniform(0.0, 2.0, 21), rng.normal(size=(21, model.n_inputs))
    batch = model.derivative_batch(t, x.T, u.T).T
    jacobians = np.moveaxis(model.jacobian_batch(t, x.T, u.T), -1, 0)
    for i in range(21):
        assert np.array_equal(batch[i], model.derivative(t[i], x[i], u[i]))
        a, b = model.jacobian(t[i], x[i], u[i])
        assert np.array_equal(jacobians[i], np.hstack([a, b]))


@fb.event(direction="falling", inputs={"fuel": "kg"}, parameters={"rest": (3.6, "kg")}, terminal=False)
def low(s: Any, p: Any) -> Any:
    return s.inputs.fuel - p.rest


@fb.event(direction="falling", parameters={"rest": (16.1, "kg")}, terminal=False)
def light(s: Any, p: Any) -> Any:
    return s.mass - p.rest


@fb.output(take="max", inputs={"speed": "rad/s"})
def fastest(s: Any) -> Any:
    return s.inputs.speed


@fb.output(take="min")
def lightest(s: Any) -> Any:
    return s.mass


def test_events_and_outputs_see_published_states_and_the_whole_mass() -> None:
    model = vehicle("zyx")
    run = model.simulate(model.state(**START), (0.0, 5.0), events=[low, light], outputs=[fastest, lightest])
    # The fuel falls by a rate that is known; times are found to their rounding.
    due = {"low": (FULL - 3.6) / FLOW, "light": (BODY.mass + FULL - 16.1) / FLOW}
    assert {e.name: e.time for e in run.events} == pytest.approx(due, abs=1e-13)
    assert run.outputs["lightest"] == pytest.approx(run.mass[-1], rel=1e-14)
    assert run.outputs["fastest"] >= run.states["wheel.speed"].max()


def test_runs_of_an_ensemble_are_each_alone() -> None:
    model = vehicle("zyx")
    dispersions: dict[str, Any] = {
        "mass": fb.Uniform(11.0, 14.0),
        "com": fb.Offset(fb.Normal([0.0] * 3, [0.01] * 3)),
        "engine.exhaust_speed": fb.Uniform(200.0, 300.0),
        "wheel.torque": fb.Uniform(-0.2, 0.2),
        "wheel.speed": fb.Uniform(0.0, 60.0),
        "engine.fuel": fb.Uniform(3.0, 5.0),
    }
    ensemble = model.ensemble(
        model.state(**START), dispersions, n=19, seed=5, events=[low], outputs=[fastest, lightest]
    )
    settings = checked_settings((0.0, 1.0), save=(0.25, None))
    whole, threaded = (ensemble.chunk(0, 19, settings, threads=n) for n in (1, 2))
    for r in range(19):
        one = ensemble.chunk(r, 1, settings)
        for name, rows in whole.items():
            assert np.array_equal(rows[r : r + 1], one[name], equal_nan=True), name
            assert np.array_equal(rows[r], threaded[name][r], equal_nan=True), name
        alone = ensemble.trajectory(r, (0.0, 1.0))
        # Two runs of a tolerance of 1e-9 a step, one of them in angles, of which a rotation has many triples.
        same = [*range(3), *range(6, model.n_states)]
        final = alone.outcome.state[same]
        assert np.abs(final - whole["final_state"][r, same]).max() < 1e-8 * np.abs(final).max()
        assert alone.outputs["lightest"] == pytest.approx(whole["outputs"][r, 1], rel=1e-12)
        assert alone.mass[0] == pytest.approx(ensemble.model(r).body.mass + alone.states["engine.fuel"][0])


def test_what_is_printed_is_what_runs() -> None:
    model = vehicle("zyx")
    x = model.state(**START)
    compiled = fb.compile(model)  # of the equations (3.2)
    # Sums in another order.
    np.testing.assert_allclose(compiled.derivative(0.2, x), model.derivative(0.2, x), rtol=1e-12, atol=1e-12)
    with pytest.raises(fb.InputError, match=r"form: 2\.8 is that of a body alone, and force 'wheel'"):
        fb.equations("2.8", model=model)
