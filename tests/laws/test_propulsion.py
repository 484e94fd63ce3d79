"""Propulsion: what the body gains the propellant carries away, in any frame, in lanes, with Jacobians."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.tracing import ForceLaw

from .rockets import (
    AREA,
    FUEL,
    G0,
    HERE,
    HINGES,
    MAIN,
    MASSES,
    POINTS,
    RADIUS,
    SHARES,
    SIDE,
    Frame,
    momentum,
    propulsion,
    rocket,
    whole,
)
from .scenes import Array, relative

INPUTS = {"throttle": 0.9, "pitch": 0.1, "yaw": -0.2}


def inputs_of(model: fb.Model) -> Array:
    return np.array([INPUTS.get(name, 0.0) for name in model.input_names])


def rotation(axis: Array, angle: Any) -> Any:
    k = fb.forms.skew(axis / np.linalg.norm(axis))
    return np.eye(3) + np.sin(angle) * k + (1.0 - np.cos(angle)) * (k @ k)


SIGNALS = {"throttle": "1", "pitch": "rad", "yaw": "rad", "fuel_mass": "kg", "oxygen_mass": "kg"}
CARRIED = [f"{kind}_{axis}" for kind in ("linear", "angular") for axis in "xyz"]
UNITS = {"linear": "N s", "angular": "N m s"}


def ledger() -> ForceLaw:
    """Adds up, in world axes about the world origin, the momentum that leaves, and what the steady flow in
    the body takes up. It knows the thrusters' numbers and not the wrench of the propulsion.
    """

    def adds(s: Any) -> Any:
        c, o, v, w = s.world_from_body, s.position_world, s.velocity_body, s.angular_velocity_body
        gimbal = rotation(HINGES[0], s.inputs.pitch) @ rotation(HINGES[1], s.inputs.yaw)
        directions = [gimbal @ MAIN["direction"], SIDE["direction"]]
        levels, thrusts = [s.states.level, 1.0], [120.0, 30.0 - 101325.0 * AREA]
        k = np.searchsorted(MASSES, 3.0)
        slope = (POINTS[k] - POINTS[k - 1]) / (MASSES[k] - MASSES[k - 1])
        m = s.inputs.oxygen_mass
        oxygen = POINTS[k - 1] + (m - MASSES[k - 1]) * slope + m * slope
        sources = [SHARES[0] * FUEL["at"] + SHARES[1] * oxygen, FUEL["at"]]
        linear, angular = np.zeros(3), np.zeros(3)
        vacuum = ((MAIN, 120.0, 80.0, RADIUS), (SIDE, 30.0, 60.0, 0.0))
        for (place, most, impulse, radius), d, level, thrust, a in zip(
            vacuum, directions, levels, thrusts, sources, strict=True
        ):
            flow, r = level * most / (G0 * impulse), place["at"]
            axis = place["direction"] / np.linalg.norm(place["direction"])
            push = level * thrust * d / np.linalg.norm(place["direction"])
            leaving = c @ (flow * (v + np.cross(w, r)) - push)
            disc = flow * radius**2 / 4.0 * (w + axis * (axis @ w))
            h, turning = flow * (r - a), flow * np.cross(a, r)
            inside = c @ np.cross(w, h)
            linear = linear + leaving + inside
            angular = angular + np.cross(o + c @ r, leaving) + c @ disc
            angular = angular + np.cross(o, inside) + c @ (np.cross(v, h) + np.cross(w, turning))
        rates = dict(zip(CARRIED, [*linear, *angular], strict=True))
        lag = {"level": (np.clip(s.inputs.throttle, 0.0, 1.0) - s.states.level) / 0.5}
        return fb.wrench(), rates | lag

    states: dict[str, Any] = {name: (0.0, UNITS[name.partition("_")[0]]) for name in CARRIED}
    return ForceLaw(adds, inputs=SIGNALS, states=states | {"level": (0.0, "1")}, name="ledger")


def test_the_impulse_is_the_momentum_gained_and_carried_away() -> None:
    model = rocket(HERE, ledger())
    run = model.simulate(HERE.state(model), (0.0, 10.0), rtol=1e-12, inputs=inputs_of(model), save_every=0.5)
    assert run.ok
    # The table of the oxygen has no corner on this way.
    assert MASSES[1] < run.states["propulsion.oxygen_mass"].min()
    carried = np.column_stack([run.states[f"ledger.{name}"] for name in CARRIED])
    total = momentum(run) + carried
    for half in (slice(3), slice(3, 6)):
        moved = np.abs(carried[:, half]).max()
        # Some 200 steps of 1e-12 each, on states of the size of what is carried away.
        assert np.abs(total[:, half] - total[0, half]).max() <= 1e-9 * moved
    # All of it counts: the flow changes the motion by much more than that.
    assert np.abs(carried[-1]).min() > 1.0


@pytest.mark.parametrize("interpolation", ["linear", "cubic"])
@pytest.mark.parametrize("number", range(3))
def test_same_motion_from_another_frame(number: int, interpolation: str) -> None:
    rng = np.random.default_rng(number)
    quaternion = rng.normal(size=4)
    turn = fb.Attitude.quaternion(quaternion / np.linalg.norm(quaternion)).as_rotation()
    frames = [HERE, Frame(rng.uniform(-3.0, 3.0, 3), turn)]
    runs = []
    for frame in frames:
        model = rocket(frame, fb.UniformGravity(1.5), interpolation=interpolation)
        span = {"rtol": 1e-12, "inputs": inputs_of(model), "save_every": 0.25}
        runs.append(model.simulate(frame.state(model), (0.0, 10.0), **span))
    point = np.array([0.5, 0.6, -0.7])
    paths = [run.point(frame.point(point)) for run, frame in zip(runs, frames, strict=True)]
    # Some 200 steps of 1e-12 each, while the motion lets small differences grow some tenfold.
    assert relative(paths[1], paths[0]) <= 1e-9
    assert np.abs(runs[1].world_from_body - runs[0].world_from_body @ turn).max() <= 1e-9
    for name in ("fuel_mass", "oxygen_mass", "main_level"):
        a, b = (run.states[f"propulsion.{name}"] for run in runs)
        np.testing.assert_allclose(a, b, rtol=0, atol=1e-10 * np.abs(a).max())


def test_power_is_the_work_of_the_wrench_and_of_the_mass_that_leaves() -> None:
    """dT/dt = V F + V Theta' V / 2, T = V Theta V / 2 of body and propellant turning together."""

    model = rocket()
    run = model.simulate(HERE.state(model), (0.0, 4.0), rtol=1e-12, inputs=inputs_of(model), save_every=0.5)
    h = 1e-5
    for t, x, u in zip(run.t[1:], run.x[1:], run.u[1:], strict=True):
        rate = model.derivative(t, x, u)
        energies, inertias = [], []
        for sign in (1.0, -1.0):
            v, theta = twist_and_inertia(model, x + sign * h * rate)
            energies.append(0.5 * v @ theta @ v)
            inertias.append(theta)
        v, _ = twist_and_inertia(model, x)
        power = v @ model.wrench(t, x, u) + 0.25 * v @ (inertias[0] - inertias[1]) @ v / h
        # Central differences err by the square of the step; their rounding is 1e-16 T/h.
        assert (energies[0] - energies[1]) / (2.0 * h) == pytest.approx(power, rel=1e-7)


def twist_and_inertia(model: fb.Model, x: Array) -> tuple[Array, Array]:
    """The twist of a state, and the spatial inertia of the whole then."""
    places = model.auxiliary
    mass, q, j = whole(*(x[[places[f"propulsion.{name}_mass"]]] for name in ("fuel", "oxygen")))
    cross = fb.forms.skew(q[0])
    return x[7:13], np.block([[mass[0] * np.eye(3), -cross], [cross, j[0]]])


def test_an_empty_tank_ends_the_thrust_and_is_told() -> None:
    model = rocket()
    run = model.simulate(HERE.state(model), (0.0, 120.0), inputs=inputs_of(model), save_every=1.0)
    assert run.ok
    masses = [run.states[f"propulsion.{name}_mass"] for name in ("fuel", "oxygen")]
    # The rest goes exponentially, and the integrator errs by its tolerance.
    assert all(m.min() > -1e-8 for m in masses)
    fuel = masses[0]
    assert fuel[-1] < 1e-6
    assert np.abs(model.wrench(run.t[-1], run.x[-1], run.u[-1])).max() < 1e-3
    # Without fuel the main engine, which burns both, rests as well: the oxygen stays.
    assert masses[1][-1] > 0.5
    assert masses[1][-1] == pytest.approx(masses[1][-20], abs=1e-6)
    assert "'fuel' runs dry" in run.outcome.message
    assert "'oxygen' runs dry" not in run.outcome.message


def test_rockets_of_an_ensemble_are_those_alone() -> None:
    """Thrust and load differ; in some of the runs a tank is empty before the end, and they say so."""
    model = rocket(HERE, fb.UniformGravity())
    dispersions: dict[str, Any] = {
        "propulsion.main_thrust": fb.Normal(120.0, 5.0),
        "propulsion.fuel_mass": fb.Uniform(1.0, 4.0),
    }
    ensemble = fb.Ensemble(model, HERE.state(model), dispersions, 19, inputs=inputs_of(model))
    runs = ensemble.run((0.0, 30.0))
    assert runs.ok.all()
    told = np.array(runs.notice_times["the tank 'fuel' runs dry: its flow and its thrust fade"])
    empty = runs.final[:, model.auxiliary["propulsion.fuel_mass"]] < 4e-3
    np.testing.assert_array_equal(empty, np.isfinite(told))
    assert 0 < empty.sum() < 19
    for k in range(0, 19, 6):
        np.testing.assert_array_equal(runs.trajectory(k).outcome.state, runs.final[k])


def test_it_travels_and_takes_other_parameters() -> None:
    law = propulsion()
    again = pickle.loads(pickle.dumps(law))
    assert again == law
    assert hash(again) == hash(law)
    weak = law(main_thrust=60.0)
    model = fb.Model(rocket().body, [weak])
    assert weak.parameters["main_thrust"] == 60.0
    assert model.state_names == rocket().state_names
