"""What forces keep, runs keep; what forces give, runs receive."""

from io import StringIO

import numpy as np
import pytest
from rich.console import Console

import freebody as fb
from freebody.model import Form
from freebody.report import summary

from .scenes import BODY, CHARTS, FORMS, START, Array, every_force, relative

REVOLUTION = 2.0 * np.pi


def tumbling(rng: np.random.Generator, number: int) -> fb.RigidBody:
    axes = fb.Attitude.angles("zyx", rng.uniform(-1.0, 1.0, 3)).as_rotation()
    moments = np.array([0.7, 1.1, 1.5]) * rng.uniform(0.93, 1.07, 3)
    com = rng.uniform(-1.0, 1.0, 3) * [0.2, 1.0, 3.0][number % 3]
    return fb.RigidBody(12.5, com, inertia_about_com=fb.principal_inertia(moments, axes))


def free_run(body: fb.RigidBody, rng: np.random.Generator, velocity_of_com: Array) -> fb.Trajectory:
    """1000 revolutions of a body about no special axis."""
    model = fb.Model(body)
    turn = rng.normal(size=3)
    turn /= np.linalg.norm(turn)
    velocity = velocity_of_com - np.cross(turn, body.com)
    x0 = model.state([1.0, 2.0, 3.0], velocity_body=velocity, angular_velocity_body=turn)
    return model.simulate(x0, (0.0, 1000 * REVOLUTION), rtol=1e-12, save_every=2 * REVOLUTION)


@pytest.mark.parametrize("moving", [False, True])
@pytest.mark.parametrize("number", range(6))
def test_free_motion_for_1000_revolutions(number: int, moving: bool) -> None:
    rng = np.random.default_rng(number)
    run = free_run(tumbling(rng, number), rng, rng.normal(size=3) if moving else np.zeros(3))
    assert run.ok
    kept = run.conserved()
    assert [k.name for k in kept] == ["energy", "momentum", "angular momentum about the mass centre"]
    text = StringIO()
    Console(file=text, width=200).print(summary(run))
    for k in kept:
        # Some 35 000 steps err by up to 1e-12 each, mostly to either side.
        assert k.drift <= 1e-9
        assert f"{k.name}: drift {k.drift:.1e}" in text.getvalue()


def kept_by(run: fb.Trajectory) -> dict[str, float]:
    return {k.name: k.drift for k in run.conserved()}


def test_uniform_gravity(rng: np.random.Generator) -> None:
    model = fb.Model(BODY, [fb.UniformGravity(9.81, direction=rng.normal(size=3))])
    run = model.simulate(model.state(**START), (0.0, 20.0), rtol=1e-12)
    kept = kept_by(run)
    assert set(kept) == {"energy", "level momentum", "angular momentum about the mass centre"}
    # Each of the steps may err by rtol.
    assert max(kept.values()) <= run.steps * 1e-12


ORBIT = fb.PointMassGravity(3.0e3, center=[1.0, -2.0, 0.5], gradient_torque=False)


def test_point_mass() -> None:
    model = fb.Model(BODY, [ORBIT])
    start = {**START, "position": [10.0, 2.0, 3.0], "velocity_body": [2.0, 9.0, -8.0]}
    run = model.simulate(model.state(**start), (0.0, 60.0), rtol=1e-12)
    kept = kept_by(run)
    assert set(kept) == {
        "energy",
        "angular momentum about the mass centre",
        "angular momentum about the centre",
    }
    # Bound, so that every quantity stays of one size, and at least three times around the centre.
    assert (run.energy < 0.0).all()
    sweep = np.unwrap(np.arctan2(*(run.com_position_world - ORBIT.center)[:, 1::-1].T))
    assert abs(sweep[-1] - sweep[0]) > 3 * REVOLUTION
    # Each of the steps may err by rtol, relative to vectors up to four times those at the far end.
    assert max(kept.values()) <= 4 * run.steps * 1e-12


def test_gradient_torque_on_a_circular_orbit(rng: np.random.Generator) -> None:
    """The Jacobi integral ½ω·Jω − Ω·Jω + 3/2 Ω² r̂·Jr̂ of a body carried around at the rate Ω."""
    mu, radius = 1.0e4, 20.0
    rate = np.sqrt(mu / radius**3)
    model = fb.Model(BODY, [fb.PointMassGravity(mu)], attitude="quaternion")
    attitude = fb.Attitude.angles("zyx", rng.uniform(-1.0, 1.0, 3))
    rotation = attitude.as_rotation()
    turn = rotation.T @ [0.0, 0.0, rate] + 0.2 * rng.normal(size=3)
    velocity = rotation.T @ [0.0, rate * radius, 0.0] - np.cross(turn, BODY.com)
    position = np.array([radius, 0.0, 0.0]) - rotation @ BODY.com
    x0 = model.state(position, attitude, velocity_body=velocity, angular_velocity_body=turn)
    run = model.simulate(x0, (0.0, 10 * REVOLUTION / rate), rtol=1e-12)

    inertia = BODY.inertia_about_com
    up = np.einsum("nji,nj->ni", run.world_from_body, run.com_position_world) / radius
    pole = run.world_from_body[:, 2, :] * rate
    turn = run.angular_velocity_body
    along = np.einsum("ni,ij,nj->n", up, inertia, up)
    momentum = turn @ inertia
    integral = np.sum((0.5 * turn - pole) * momentum, axis=1) + 1.5 * rate**2 * along
    # The orbit is a circle to the integrator's tolerance: each step may err by rtol, and the terms are
    # about as large as their sum.
    assert np.ptp(integral) <= 10 * run.steps * 1e-12 * np.abs(integral).max()
    # The torque is no small thing here: without it the integral moves by a good part of itself.
    assert np.ptp(along) * 1.5 * rate**2 > 0.05 * np.abs(integral).max()
    assert run.conserved() == []


def gauss_panels(end: float, panels: int) -> tuple[Array, Array]:
    """Nodes and weights of the eight-point Gauss rule on equal panels from zero."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    edges = np.linspace(0.0, end, panels + 1)
    half = 0.5 * np.diff(edges)[:, None]
    return (edges[:-1, None] + half * (nodes + 1.0)).ravel(), (half * weights).ravel()


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("chart", CHARTS[:3] + CHARTS[-3:])
def test_work_and_impulse(rng: np.random.Generator, chart: str, form: Form) -> None:
    """The kinetic energy gains ∫VᵀF dt, the momentum about the world origin ∫LF dt (1.7)."""
    model = fb.Model(BODY, every_force(rng), chart, form)
    times, weights = gauss_panels(10.0, 200)
    wanted = np.concatenate([[0.0], times, [10.0]])
    control = [1.0, 0.0, -1.0, 0.1, 0.2, 0.1]
    run = model.simulate(model.state(**START), (0.0, 10.0), rtol=1e-11, save_at=wanted, inputs=control)
    inside = slice(1, -1)
    pairs = zip(run.t[inside], run.x[inside], run.u[inside], strict=True)
    wrench = np.array([model.wrench(t, x, u) for t, x, u in pairs])
    twist = np.hstack([run.velocity_body, run.angular_velocity_body])[inside]
    power = np.sum(twist * wrench, axis=1)
    transform = fb.forms.wrench_transform(run.position_world, run.world_from_body)[inside]
    world = np.einsum("nij,nj->ni", transform, wrench)

    # The rule is exact to rounding on panels of 0.05 s except where |V|V has its kinks; each step errs by
    # rtol, and the motion's own growth makes up to fifty of that.
    within = 50 * run.steps * 1e-11
    energy = run.kinetic_energy
    assert abs(energy[-1] - energy[0] - weights @ power) <= within * energy.max()
    momentum = run.momentum_world
    gained = momentum[-1] - momentum[0]
    for half in (slice(0, 3), slice(3, 6)):
        expected = (weights @ world)[half] + momentum[0, half]
        assert relative((gained + momentum[0])[None, half], expected[None]) <= within
