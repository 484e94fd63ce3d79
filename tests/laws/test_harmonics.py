"""Gravity by spherical harmonics: what its field, its gradient and its torque must be."""

from typing import Any

import mpmath
import numpy as np
import pytest

import freebody as fb
from freebody.elements import HarmonicGravity
from freebody.ensembles.law_parameters import parameters, with_parameters

# EGM96 to degree 4, fully normalised: Lemoine et al., NASA/TP-1998-206861.
MU, RADIUS = 3.986004415e14, 6378136.3
EGM96 = {
    (2, 0): (-0.484165371736e-3, 0.0),
    (2, 1): (-0.186987635955e-9, 0.119528012031e-8),
    (2, 2): (0.243914352398e-5, -0.140016683654e-5),
    (3, 0): (0.957254173792e-6, 0.0),
    (3, 1): (0.202998882184e-5, 0.248513158716e-6),
    (3, 2): (0.904627768605e-6, -0.619025944205e-6),
    (3, 3): (0.721072657057e-6, 0.141435626958e-5),
    (4, 0): (0.539873863789e-6, 0.0),
    (4, 1): (-0.536321616971e-6, -0.473440265853e-6),
    (4, 2): (0.350694105785e-6, 0.662671572540e-6),
    (4, 3): (0.990771803829e-6, -0.200928369177e-6),
    (4, 4): (-0.188560802735e-6, 0.308853169333e-6),
}
BALL = fb.RigidBody(2.0, inertia_about_com=np.eye(3))
BODY = fb.RigidBody(
    3.0, (0.1, -0.2, 0.3), inertia_about_com=[[2.0, 0.1, 0.2], [0.1, 1.5, -0.3], [0.2, -0.3, 2.2]]
)


def arrays(coefficients: dict[tuple[int, int], tuple[float, float]]) -> tuple[np.ndarray, np.ndarray]:
    size = max(n for n, _ in coefficients) + 1
    C, S = np.zeros((2, size, size))
    C[0, 0] = 1.0
    for place, (c, s) in coefficients.items():
        C[place], S[place] = c, s
    return C, S


EARTH = arrays(EGM96)


def lumpy(degree: int, seed: int = 5) -> tuple[np.ndarray, np.ndarray]:
    """Random coefficients, none small."""
    rng = np.random.default_rng(seed)
    C, S = np.tril(rng.normal(size=(2, degree + 1, degree + 1)))
    S[:, 0] = 0.0
    return C, S


def points(count: int, low: float = 1.1, high: float = 3.0) -> np.ndarray:
    """Outside of the unit sphere; the first four above and below the poles and on the equator."""
    rng = np.random.default_rng(6)
    directions = rng.normal(size=(count, 3))
    directions[:4] = [[0, 0, 1], [0, 0, -1], [1, 0, 0], [0, -1, 0]]
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return directions * rng.uniform(low, high, (count, 1))


def acceleration(force: fb.Force, position: Any, time: float = 0.0) -> np.ndarray:
    model = fb.Model(BALL, [force])
    return model.derivative(time, model.state(position=position))[7:10]


def gradient(force: fb.Force, position: Any, time: float = 0.0) -> np.ndarray:
    """The derivative of the acceleration by the position, by duals."""
    model = fb.Model(BALL, [force])
    return model.jacobian(time, model.state(position=position))[0][7:10, :3]


def legendre_function(n: int, m: int, t: Any) -> Any:
    """By powers: Heiskanen and Moritz, Physical Geodesy (1967), (1-62)."""
    f = mpmath.factorial
    terms = (
        (-1) ** k * f(2 * n - 2 * k) / (f(k) * f(n - k) * f(n - m - 2 * k)) * t ** (n - m - 2 * k)
        for k in range((n - m) // 2 + 1)
    )
    return mpmath.sqrt(1 - t * t) ** m * mpmath.fsum(terms) / mpmath.mpf(2) ** n


def potential(x: Any, y: Any, z: Any, mu: float, radius: float, C: np.ndarray, S: np.ndarray) -> Any:
    """By Legendre functions of the latitude and multiples of the longitude, in many digits."""
    r = mpmath.sqrt(x * x + y * y + z * z)
    t, longitude = z / r, mpmath.atan2(y, x)
    total = mpmath.mpf(0)
    for n in range(len(C)):
        for m in range(n + 1):
            if C[n, m] == 0.0 and S[n, m] == 0.0:
                continue
            legendre = legendre_function(n, m, t)
            factorials = mpmath.factorial(n - m) / mpmath.factorial(n + m)
            normalisation = mpmath.sqrt((1 if m == 0 else 2) * (2 * n + 1) * factorials)
            wave = C[n, m] * mpmath.cos(m * longitude) + S[n, m] * mpmath.sin(m * longitude)
            total += (radius / r) ** n * normalisation * legendre * wave
    return mu / r * total


def attraction(position: np.ndarray, *field: Any) -> np.ndarray:
    """The gradient of that potential by differences, in digits of which enough are left."""
    with mpmath.workdps(150):
        at = [mpmath.mpf(float(x)) for x in position]
        h = mpmath.mpf(10) ** -20 * mpmath.norm(at)

        def slope(k: int) -> Any:
            step = [h if i == k else 0 for i in range(3)]
            plus = potential(*(a + d for a, d in zip(at, step, strict=True)), *field)
            minus = potential(*(a - d for a, d in zip(at, step, strict=True)), *field)
            return (plus - minus) / (2 * h)

        return np.array([float(slope(k)) for k in range(3)])


def test_the_earth_to_degree_four_is_that_of_legendre_functions() -> None:
    force = HarmonicGravity(MU, RADIUS, *EARTH)
    for position in RADIUS * points(12)[4:]:
        wanted = attraction(position, MU, RADIUS, *EARTH)
        # Some roundings of the largest component.
        assert np.abs(acceleration(force, position) - wanted).max() < 2e-15 * np.abs(wanted).max()


@pytest.mark.parametrize(("n", "m"), [(5, 3), (30, 0), (60, 31), (120, 60), (120, 120)])
def test_single_harmonics_of_high_degree_are_those_of_legendre_functions(n: int, m: int) -> None:
    C, S = arrays({(n, m): (0.7, -0.4 if m else 0.0)})
    C[0, 0] = 0.0
    force = HarmonicGravity(1.0, 1.0, C, S)
    for position in points(7, 1.0, 1.1)[4:]:
        wanted = attraction(position, 1.0, 1.0, C, S)
        # A recursion over as many degrees, and functions that are small beside their neighbours.
        assert np.abs(acceleration(force, position) - wanted).max() < 1e-14 * (n + 2) * np.abs(wanted).max()


@pytest.mark.parametrize("torque", [False, True])
def test_degree_zero_is_a_point_mass(torque: bool) -> None:
    center = [2.0, -3.0, 1.0]
    one = HarmonicGravity(5.0, 0.7, [[1.0]], [[0.0]], center=center, gradient_torque=torque)
    other = fb.PointMassGravity(5.0, center, gradient_torque=torque)
    models = [fb.Model(BODY, [force]) for force in (one, other)]
    attitude = fb.Attitude.angles("zyx", [0.3, -0.4, 0.9])
    x = models[0].state([4.0, 1.0, -1.0], attitude)
    a, b = (model.wrench(0.0, x) for model in models)
    # The same in another order of rounding.
    np.testing.assert_allclose(a, b, rtol=1e-14, atol=1e-16)
    energies = [m.simulate(x, (0.0, 1e-3)).potential_energy[0] for m in models]
    assert energies[0] == pytest.approx(energies[1], rel=1e-15)


def test_second_zonal_alone_is_the_formula_of_j2() -> None:
    """Montenbruck and Gill, Satellite Orbits (2000), section 3.2: the gradient of -μ J2 R²/r³ P2(z/r)."""
    j2 = 1.08262982e-3
    C, S = arrays({(2, 0): (-j2 / np.sqrt(5.0), 0.0)})
    force = HarmonicGravity(MU, RADIUS, C, S)
    for position in RADIUS * points(30):
        x, y, z = position
        square = position @ position
        plane = 1.0 + 1.5 * j2 * RADIUS**2 / square * (1.0 - 5.0 * z * z / square)
        axis = 1.0 + 1.5 * j2 * RADIUS**2 / square * (3.0 - 5.0 * z * z / square)
        wanted = -MU / square**1.5 * np.array([plane * x, plane * y, axis * z])
        assert np.abs(acceleration(force, position) - wanted).max() < 2e-15 * np.abs(wanted).max()


def test_the_field_has_neither_sources_nor_curl() -> None:
    force = HarmonicGravity(1.0, 1.0, *lumpy(9), rotation_rate=0.3, angle=-1.0)
    for position in points(30):
        g = gradient(force, position, 0.8)
        size = np.abs(g).max()
        # Sums of fifty harmonics, which cancel in part.
        assert abs(np.trace(g)) < 1e-13 * size
        assert np.abs(g - g.T).max() < 1e-13 * size


def test_the_gradient_is_that_of_differences() -> None:
    force = HarmonicGravity(1.0, 1.0, *lumpy(6))
    h = 1e-5
    for position in points(8):
        steps = h * np.eye(3)
        rows = [acceleration(force, position + d) - acceleration(force, position - d) for d in steps]
        wanted = np.transpose(rows) / (2.0 * h)
        # Differences of second order, over a field that varies over a sixth of the distance.
        np.testing.assert_allclose(gradient(force, position), wanted, atol=1e-7 * np.abs(wanted).max())


def test_the_torque_is_that_of_the_whole_gradient() -> None:
    """∫ ρ × (G ρ) dm with the second moments of mass, G by duals from the attraction."""
    field = HarmonicGravity(7.0, 1.0, *lumpy(5), angle=0.4, center=(0.5, 0.0, -0.2))
    twisting = HarmonicGravity(7.0, 1.0, *lumpy(5), angle=0.4, center=(0.5, 0.0, -0.2), gradient_torque=True)
    model = fb.Model(BODY, [twisting])
    rng = np.random.default_rng(8)
    for position in points(12) + field.center:
        attitude = fb.Attitude.angles("zyx", rng.uniform(-1.5, 1.5, 3))
        x = model.state(position, attitude)
        c = attitude.as_rotation()
        g = c.T @ gradient(field, position + c @ BODY.com) @ c
        tensor = BODY.inertia_about_com
        e = 0.5 * np.trace(tensor) * np.eye(3) - tensor
        moments = np.einsum("ijk,kl,jl->i", levi_civita(), g, e)
        wrench = model.wrench(0.0, x)
        about_com = wrench[3:] - np.cross(BODY.com, wrench[:3])
        np.testing.assert_allclose(about_com, moments, rtol=0, atol=1e-12 * np.abs(g).max())


def levi_civita() -> np.ndarray:
    e = np.zeros((3, 3, 3))
    e[[0, 1, 2], [1, 2, 0], [2, 0, 1]] = 1.0
    e[[0, 1, 2], [2, 0, 1], [1, 2, 0]] = -1.0
    return e


def test_a_planet_that_turns_turns_its_attraction() -> None:
    field, center = lumpy(4), np.array([0.3, -0.2, 0.1])
    still = HarmonicGravity(1.0, 1.0, *field)
    turning = HarmonicGravity(1.0, 1.0, *field, rotation_rate=0.7, angle=-0.4, center=center)
    for time, position in zip([0.0, 1.0, 5.0, -3.0, 0.1], points(9)[4:], strict=True):
        turn = fb.Attitude.angles("zyx", [-0.4 + 0.7 * time, 0.0, 0.0]).as_rotation()
        got = acceleration(turning, turn @ position + center, time)
        wanted = turn @ acceleration(still, position)
        # Roundings of the position and of the angle.
        assert np.abs(got - wanted).max() < 1e-13 * np.abs(wanted).max()


def test_no_work_around_a_closed_path() -> None:
    force = HarmonicGravity(1.0, 1.0, *lumpy(5), angle=1.0)
    angles = np.linspace(0.0, 2.0 * np.pi, 400, endpoint=False)
    path = np.transpose(
        [1.5 * np.cos(angles), 1.8 * np.sin(angles), 0.9 * np.sin(2.0 * angles) + 0.3 * np.cos(angles)]
    )
    along = np.transpose(
        [-1.5 * np.sin(angles), 1.8 * np.cos(angles), 1.8 * np.cos(2.0 * angles) - 0.3 * np.sin(angles)]
    )
    work = np.array([acceleration(force, x) @ v for x, v in zip(path, along, strict=True)])
    # Equal steps around a smooth closed path converge faster than any power; what stays is rounding.
    assert abs(work.mean()) < 1e-13 * np.abs(work).max()


def test_energy_is_kept_while_the_planet_stands() -> None:
    force = HarmonicGravity(MU, RADIUS, *EARTH)
    model = fb.Model(BALL, [force])
    x0 = model.state([7.0e6, 0.0, 1.0e6], velocity_world=[0.0, 5.0e3, 5.5e3])
    run = model.simulate(x0, (0.0, 12000.0), rtol=1e-12)
    assert run.outcome.ok
    # Two revolutions at the tolerance; the coefficients alone make up a thousandth.
    assert np.abs(run.energy / run.energy[0] - 1.0).max() < 1e-10
    for position, energy in zip(run.position_world[::20], run.potential_energy[::20], strict=True):
        x, y, z = (mpmath.mpf(float(k)) for k in position)
        assert energy == pytest.approx(-BALL.mass * float(potential(x, y, z, MU, RADIUS, *EARTH)), rel=1e-14)


def test_many_states_at_once_are_each_state_alone() -> None:
    force = HarmonicGravity(MU, RADIUS, *EARTH, rotation_rate=7.292115e-5, gradient_torque=True)
    model = fb.Model(BODY, [force])
    x = np.array([model.state(position, velocity_body=[1.0, 2.0, 3.0]) for position in RADIUS * points(37)])
    t = np.linspace(0.0, 9e4, 37)
    u = np.zeros((model.n_inputs, 37))
    together = model.derivative_batch(t, np.ascontiguousarray(x.T), u)
    np.testing.assert_array_equal(together.T, [model.derivative(*at) for at in zip(t, x, strict=True)])


def test_its_parameters_can_be_dispersed() -> None:
    force = HarmonicGravity(7.0, 1.0, *lumpy(3), center=(1.0, 2.0, 3.0))
    known = {p.attribute: p for p in parameters(force)}
    assert known.keys() == {"mu", "center"}
    assert known["mu"].places == (0,)
    assert known["center"].places == (1, 2, 3)
    other = with_parameters(force, {"mu": np.array([14.0])})
    position = [4.0, 4.0, 1.0]
    np.testing.assert_allclose(acceleration(other, position), 2.0 * acceleration(force, position), rtol=1e-14)


def test_a_moved_and_turned_body_frame_changes_nothing() -> None:
    force = HarmonicGravity(MU, RADIUS, *EARTH, rotation_rate=7.292115e-5, gradient_torque=True)
    origin, turn = np.array([0.4, -0.3, 0.8]), fb.Attitude.angles("zyx", [0.7, -0.2, 0.4])
    moved = BODY.in_frame(origin, turn.as_rotation())
    position, rotation = (
        np.array([6.9e6, 3.0e5, -8.0e5]),
        fb.Attitude.angles("zyx", [1.0, 0.3, -2.0]).as_rotation(),
    )
    here = fb.Model(BODY, [force])
    there = fb.Model(moved, [force])
    w = here.wrench(50.0, here.state(position, fb.Attitude.rotation(rotation)))
    c = turn.as_rotation()
    v = there.wrench(50.0, there.state(position + rotation @ origin, fb.Attitude.rotation(rotation @ c)))
    force_here, moment_here = w[:3], w[3:] - np.cross(origin, w[:3])
    np.testing.assert_allclose(c @ v[:3], force_here, rtol=0, atol=1e-13 * np.abs(w[:3]).max())
    np.testing.assert_allclose(c @ v[3:], moment_here, rtol=0, atol=1e-13 * np.abs(w[:3]).max())
