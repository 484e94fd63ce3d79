"""What holds for every element: any body frame, any chart, lanes, exact Jacobians, plain data, rest."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody import elements, environment
from freebody.dave_ml import DaveAerodynamics
from freebody.environment import Atmosphere, Planet, Wind
from freebody.tracing import ForceLaw

from .elements import AROUND, ELEMENTS, EVERY, THERE, Scene
from .rockets import HERE
from .scenes import Array, relative

EVERYTHING = pytest.mark.parametrize("scene", EVERY.values(), ids=EVERY.keys())
# Central differences of order 8.
STENCIL = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}


def around(scene: Scene, model: fb.Model, n: int, seed: int = 1) -> Array:
    """States around the start, (n_states, n)."""
    x0 = scene.state(model)[:, None]
    return x0 + 0.02 * np.maximum(1.0, np.abs(x0)) * np.random.default_rng(seed).normal(size=(len(x0), n))


def test_no_element_is_missing() -> None:
    acting = {type(f) for scene in EVERY.values() for f in scene.model().forces}
    public = {getattr(elements, name) for name in elements.__all__} | {DaveAerodynamics}
    assert {kind for kind in public if isinstance(kind, type) and issubclass(kind, fb.Force)} <= acting


def test_no_surroundings_are_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    made: set[type] = set()

    def noted(self: Any, planet: Any = None, atmosphere: Any = None, wind: Any = None) -> None:
        original(self, planet, atmosphere, wind)
        made.update(type(part) for part in (self.planet, self.atmosphere, self.wind))

    original = environment.Environment.__init__
    monkeypatch.setattr(environment.Environment, "__init__", noted)
    for scene in AROUND.values():
        scene.forces(HERE, False)
    abstract = {Atmosphere, Planet, Wind}
    public = {getattr(environment, name) for name in environment.__all__}
    kinds = {k for k in public if isinstance(k, type) and issubclass(k, tuple(abstract))} - abstract
    assert kinds <= made


@EVERYTHING
def test_same_motion_in_a_moved_and_turned_frame(scene: Scene) -> None:
    runs = []
    for frame in (HERE, THERE):
        model = scene.model(there=frame is THERE)
        x0 = scene.state(model, frame)
        runs.append(model.simulate(x0, (0.0, 0.5), rtol=1e-12, save_every=0.1, inputs=scene.u(model)))
    run, other = runs
    assert run.ok, run.outcome.message
    point = np.array([0.5, 0.6, -0.7])
    # Some hundred steps of 1e-12; more is lost at corners of tables and of contact, met with other steps.
    assert relative(other.point(THERE.point(point)), run.point(point)) <= 1e-9
    assert np.abs(other.world_from_body - run.world_from_body @ THERE.turn).max() <= 1e-9
    for name, values in run.states.items():
        assert np.abs(other.states[name] - values).max() <= 1e-9 * max(1.0, np.abs(values).max()), name


@EVERYTHING
def test_no_chart_matters(scene: Scene) -> None:
    model = scene.model()
    x, u = scene.state(model), scene.u(model)
    rate, wrench = model.derivative(0.3, x, u), model.wrench(0.3, x, u)
    for sequence in fb.forms.SEQUENCES:
        for form in ("quasi_velocity", "generalized"):
            other = fb.Model(model.body, model.forces, sequence, form)
            y = scene.state(other)
            # Rounding of angles, against attitudes a radian from the nearest singular one.
            scale = max(1.0, np.abs(wrench).max())
            np.testing.assert_allclose(other.wrench(0.3, y, u), wrench, rtol=0, atol=1e-12 * scale)
            own = other.derivative(0.3, y, u)[12 if form == "generalized" else 6 :]
            expected = rate[13 if form == "generalized" else 7 :]
            limit = 1e-12 * max(1.0, np.abs(rate).max())
            np.testing.assert_allclose(own, expected, rtol=0, atol=limit)


@EVERYTHING
def test_many_at_once_are_each_alone(scene: Scene) -> None:
    """Bit for bit, whoever is in company."""
    model, n = scene.model(), 13
    x, u, t = around(scene, model, n), np.tile(scene.u(model)[:, None], n), np.linspace(0.0, 1.0, n)
    rates = model.derivative_batch(t, x, u)
    for k in range(n):
        alone = model.derivative(t[k], np.ascontiguousarray(x[:, k]), np.ascontiguousarray(u[:, k]))
        np.testing.assert_array_equal(rates[:, k], alone)


def dispersions(model: fb.Model) -> dict[str, Any]:
    """The mass, and every parameter of every law that is not zero, by a tenth."""
    found: dict[str, Any] = {"mass": fb.Uniform(11.0, 14.0)}
    for force in model.forces:
        if isinstance(force, ForceLaw):
            for name, value in force.parameters.items():
                owner = "environment" if name in force.shared else force.name
                if value != 0.0:
                    found[f"{owner}.{name}"] = fb.Uniform(*sorted((0.95 * value, 1.05 * value)))
    return found


@EVERYTHING
def test_an_ensemble_is_its_runs(scene: Scene) -> None:
    model = scene.model()
    ensemble = model.ensemble(scene.state(model), dispersions(model), n=9, inputs=scene.u(model))
    runs = ensemble.run((0.0, 0.3))
    assert runs.ok.all()
    assert np.ptp(runs.final, axis=0).max() > 0.0
    for k in (0, 5, 8):
        np.testing.assert_array_equal(runs.trajectory(k).outcome.state, runs.final[k])


@EVERYTHING
def test_jacobians_are_those_of_differences(scene: Scene) -> None:
    model = scene.model()
    u, h, n = scene.u(model), 1e-3, model.n_states
    for x in around(scene, model, 3).T:
        point = np.concatenate([x, u])

        def derivative(z: Array) -> Array:
            return model.derivative(0.3, z[:n].copy(), z[n:].copy())

        got, size = np.hstack(model.jacobian(0.3, x, u)), np.abs(derivative(point)).max()
        for k, e in enumerate(np.eye(len(point))):
            column = sum(
                c * (derivative(point + i * h * e) - derivative(point - i * h * e))
                for i, c in STENCIL.items()
            )
            # Rounding over the step, of altitudes above the Earth 1e-9 m; no corner of a table or of contact
            # lies within reach.
            limit = 1e-10 * max(1.0, size, np.abs(got).max())
            np.testing.assert_allclose(got[:, k], column / h, rtol=0, atol=limit)


@EVERYTHING
def test_power_is_force_times_velocity(scene: Scene) -> None:
    """dT/dt = V F of all that acts, where the mass is the body's alone; see the others' own tests."""
    model = scene.model()
    if any(f.contents or f.spins or f.added_mass is not None for f in model.forces):
        return
    u, h = scene.u(model), 1e-4
    for x in around(scene, model, 3).T:
        x[3:7] /= np.linalg.norm(x[3:7])
        rate, twist = model.derivative(0.3, x, u), x[7:13]
        steps = np.array([k * c for k in STENCIL for c in (1.0, -1.0)]) * h
        near, told = x + steps[:, None] * rate, np.tile(u, (8, 1))
        kinetic = model.energies(np.full(8, 0.3), near, told)[0]
        slope = sum(c * (kinetic[2 * i] - kinetic[2 * i + 1]) for i, c in enumerate(STENCIL.values())) / h
        power = twist @ model.wrench(0.3, x, u)
        # Rounding of energies over the step.
        assert abs(slope - power) <= 1e-10 * max(abs(power), kinetic.max() * 10.0)


@EVERYTHING
def test_they_are_plain_data(scene: Scene) -> None:
    """They travel to other processes, and are equal to the same made anew, and to no other."""
    model = scene.model()
    for force, twin in zip(model.forces, scene.forces(HERE, False), strict=True):
        again = pickle.loads(pickle.dumps(force))
        assert type(again) is type(force)
        assert again.notices == force.notices == twin.notices
        if isinstance(force, ForceLaw):
            assert again == force == twin
            assert hash(again) == hash(twin)
    x, u = scene.state(model), scene.u(model)
    travelled = pickle.loads(pickle.dumps(model))
    np.testing.assert_array_equal(travelled.derivative(0.3, x, u), model.derivative(0.3, x, u))


@EVERYTHING
@pytest.mark.parametrize("still", [False, True], ids=["moving medium", "still medium"])
def test_rest_is_no_singular_place(scene: Scene, still: bool) -> None:
    """At rest, and moving along one axis only, unturned: where angles and directions have no derivatives."""
    model = scene.model(still=still)
    u = scene.u(model)
    for velocity in (np.zeros(3), 1e-9 * np.ones(3), *np.eye(3), *-np.eye(3)):
        x = model.state(velocity_body=velocity)
        assert np.isfinite(model.derivative(0.0, x, u)).all()
        assert all(np.isfinite(part).all() for part in model.jacobian(0.0, x, u))


def test_the_scenes_act() -> None:
    """None of these laws holds for want of a force: each scene has one, or is a servo that has none."""
    for name, scene in ELEMENTS.items():
        model = scene.model()
        still = not model.wrench(0.3, scene.state(model), scene.u(model)).any()
        assert still == (name == "actuator"), name
