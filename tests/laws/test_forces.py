"""Each force element against its formula written out once more, and its energy against its force."""

from dataclasses import dataclass

import numpy as np
import pytest

import freebody as fb
from freebody.forces import Axes
from freebody.tables import Interpolation

from .scenes import BODY, Array, positive_matrix

# The same sum of at most forty products in another order.
ROUNDING = 1e-14


@dataclass
class Moment:
    """A random state of motion."""

    t: float
    position: Array
    rotation: Array
    twist: Array

    @property
    def com(self) -> Array:
        return self.position + self.rotation @ BODY.com

    def x(self, model: fb.Model) -> Array:
        attitude = fb.Attitude.rotation(self.rotation)
        v, w = self.twist[:3], self.twist[3:]
        return model.state(self.position, attitude, velocity_body=v, angular_velocity_body=w)


@pytest.fixture(params=range(5))
def moment(request: pytest.FixtureRequest) -> Moment:
    rng = np.random.default_rng(request.param)
    quaternion = rng.normal(size=4)
    rotation = fb.Attitude.quaternion(quaternion / np.linalg.norm(quaternion)).as_rotation()
    return Moment(rng.uniform(0.0, 4.0), 3.0 * rng.normal(size=3), rotation, rng.normal(size=6))


def applied(force: Array, moment: Array, at: Array) -> Array:
    """The wrench about the origin of a force and a moment given at a point. Konoplev (1.1)"""
    return np.concatenate([force, moment + np.cross(at, force)])


def assert_wrench(force: fb.Force, moment: Moment, expected: Array, u: Array | None = None) -> None:
    model = fb.Model(BODY, [force])
    got = model.wrench(moment.t, moment.x(model), u)
    assert np.abs(got - expected).max() <= ROUNDING * max(1.0, float(np.abs(expected).max()))


def test_uniform_gravity(moment: Moment) -> None:
    weight = moment.rotation.T @ (BODY.mass * 3.7 * np.array([2.0, -1.0, 2.0]) / 3.0)
    force = fb.UniformGravity(3.7, direction=[2.0, -1.0, 2.0])
    assert_wrench(force, moment, applied(weight, np.zeros(3), BODY.com))


@pytest.mark.parametrize("gradient", [False, True])
def test_point_mass_gravity(moment: Moment, gradient: bool) -> None:
    mu, center = 40.0, np.array([1.0, -5.0, 2.0])
    r = moment.rotation.T @ (moment.com - center)
    distance = np.linalg.norm(r)
    torque = 3.0 * mu / distance**5 * np.cross(r, BODY.inertia_about_com @ r)
    pull = -mu * BODY.mass / distance**3 * r
    force = fb.PointMassGravity(mu, center, gradient)
    assert_wrench(force, moment, applied(pull, torque if gradient else np.zeros(3), BODY.com))


def test_gradient_torque_is_that_of_newton_on_each_particle(moment: Moment) -> None:
    rng = np.random.default_rng(11)
    particles, masses = rng.uniform(-0.5, 0.5, (8, 3)), rng.uniform(1.0, 2.0, 8)
    com = masses @ particles / masses.sum()
    particles -= com
    square = np.einsum("n,ni,nj->ij", masses, particles, particles)
    body = fb.RigidBody(masses.sum(), com, inertia_about_com=np.trace(square) * np.eye(3) - square)
    far = 1.0e4 * moment.rotation @ [2.0, -1.0, 2.0] / 3.0
    model = fb.Model(body, [fb.PointMassGravity(1.0e12)])
    wrench = model.wrench(0.0, model.state(far, fb.Attitude.rotation(moment.rotation)))
    r = (moment.rotation.T @ far + com) + particles
    pull = -1.0e12 * masses[:, None] * r / np.linalg.norm(r, axis=1)[:, None] ** 3
    expected = np.cross(particles, pull).sum(axis=0)
    torque = wrench[3:] - np.cross(com, wrench[:3])
    # The next term of the series is smaller by size over distance, 1e-4.
    assert np.abs(torque - expected).max() <= 5e-4 * np.abs(expected).max()


@pytest.mark.parametrize("axes", ["body", "world"])
def test_constant_wrench(moment: Moment, axes: Axes) -> None:
    force, torque, at = np.array([3.0, -2.0, 1.0]), np.array([0.1, 0.2, -0.1]), np.array([0.3, 0.2, -0.1])
    turn = moment.rotation.T if axes == "world" else np.eye(3)
    expected = applied(turn @ force, turn @ torque, at)
    assert_wrench(fb.ConstantWrench(force, torque, axes, at), moment, expected)
    assert_wrench(fb.InputWrench(axes, at), moment, expected, np.concatenate([force, torque]))


@pytest.mark.parametrize("interpolation", ["linear", "hold"])
@pytest.mark.parametrize("axes", ["body", "world"])
def test_tabulated_wrench(moment: Moment, axes: Axes, interpolation: Interpolation) -> None:
    rng = np.random.default_rng(12)
    times, at = np.array([1.0, 1.5, 2.5, 3.0]), np.array([0.3, 0.2, -0.1])
    rows = rng.normal(size=(4, 6))
    force = fb.TabulatedWrench(times, rows[:, :3], rows[:, 3:], axes, at, interpolation)
    turn = moment.rotation.T if axes == "world" else np.eye(3)
    for t in (moment.t, 0.0, 1.0, 2.5, 3.0, 9.0):
        if interpolation == "hold":
            row = rows[max(int(np.searchsorted(times, t, side="right")) - 1, 0)]
        else:
            row = np.array([np.interp(t, times, column) for column in rows.T])
        then = Moment(t, moment.position, moment.rotation, moment.twist)
        assert_wrench(force, then, applied(turn @ row[:3], turn @ row[3:], at))


def test_damping(moment: Moment, rng: np.random.Generator) -> None:
    full, diagonal, v = positive_matrix(rng), np.arange(1.0, 7.0), moment.twist
    assert_wrench(fb.LinearDamping(full), moment, -full @ v)
    assert_wrench(fb.LinearDamping(diagonal), moment, -diagonal * v)
    assert_wrench(fb.QuadraticDamping(full), moment, -full @ (np.abs(v) * v))
    assert_wrench(fb.QuadraticDamping(diagonal), moment, -diagonal * np.abs(v) * v)


def test_wrenches_add(moment: Moment) -> None:
    forces = [
        fb.UniformGravity(),
        fb.PointMassGravity(40.0, [1.0, -5.0, 2.0]),
        fb.ConstantWrench([1.0, 2.0, 3.0], axes="world"),
        fb.LinearDamping(np.arange(1.0, 7.0)),
    ]
    alone = [fb.Model(BODY, [f]) for f in forces]
    together = fb.Model(BODY, forces)
    x = moment.x(together)
    expected = np.sum([m.wrench(moment.t, x) for m in alone], axis=0)
    assert np.abs(together.wrench(moment.t, x) - expected).max() <= ROUNDING * np.abs(expected).max()
    # The wrench is what the derivative is made of. Konoplev (1.8)
    rate = together.derivative(moment.t, x)[7:]
    left = fb.forms.inverse_dynamics(BODY, moment.twist, rate)
    # A solve with the inertia and back.
    assert np.abs(left - expected).max() <= 100 * ROUNDING * np.abs(expected).max()


@pytest.mark.parametrize(
    "force",
    [
        fb.UniformGravity(3.7, [2.0, -1.0, 2.0]),
        fb.PointMassGravity(40.0, [1.0, -5.0, 2.0], gradient_torque=False),
    ],
)
def test_potential_energy_falls_by_the_power_of_its_force(force: fb.Force, moment: Moment) -> None:
    model = fb.Model(BODY, [force])
    x, h = moment.x(model), 1e-5
    rate = model.derivative(moment.t, x)
    near = np.array([x + h * rate, x - h * rate])
    potential = model.energies(np.zeros(2), near, np.zeros((2, model.n_inputs)))[1]
    power = moment.twist @ model.wrench(moment.t, x)
    # A central difference: h² times a third derivative of up to 1e3 W/s², and 1e-16 / h of some 1e2 J.
    assert abs((potential[0] - potential[1]) / (2.0 * h) + power) <= 1e-7 * max(1.0, abs(power))
