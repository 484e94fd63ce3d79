"""Winds by altitude and gusts: what they are, and what they do to a body."""

from typing import Any

import numpy as np
import pytest

import freebody as fb
from environment_scenes import BODY, drag, model
from freebody.environment import (
    ConstantWind,
    Environment,
    LogWind,
    OneMinusCosineGust,
    Place,
    PowerLawWind,
    USStandard1976,
    Wind,
    WindShear,
    WindTable,
)


def at(wind: Wind, altitude: float, s: Any = None) -> np.ndarray:
    return np.asarray(wind.here(Place(0.0, 0.0, altitude, np.eye(3)), s, None).velocity_ned, float)


class Moment:
    """A situation of numbers."""

    def __init__(self, time: float = 0.0, air_path: float = 0.0) -> None:
        self.time, self.world_from_body = time, np.eye(3)
        self.inputs = type("Inputs", (), {"air_path": air_path})


def test_velocity_is_where_it_blows_to() -> None:
    # 20 m/s from the west is 20 m/s towards the east; cos(270 deg) is 2e-16 in doubles.
    west = ConstantWind.blowing_from(np.deg2rad(270.0), 20.0)
    np.testing.assert_allclose(at(west, 0.0), [0.0, 20.0, 0.0], atol=1e-14)
    np.testing.assert_allclose(at(ConstantWind([3.0, -4.0, 1.0]), 0.0), [3.0, -4.0, 1.0], rtol=1e-15)


def test_table_is_linear_and_holds_its_ends() -> None:
    table = WindTable([1000.0, 2000.0], [[2.0, 0.0, 0.0], [4.0, 8.0, 1.0]])
    np.testing.assert_allclose(at(table, 1250.0), [2.5, 2.0, 0.25], rtol=1e-15)
    np.testing.assert_allclose(at(table, 0.0), [2.0, 0.0, 0.0])
    np.testing.assert_allclose(at(table, 9999.0), [4.0, 8.0, 1.0])
    sounding = WindTable.blowing_from([0.0, 1000.0], np.deg2rad([270.0, 360.0]), [10.0, 20.0])
    np.testing.assert_allclose(at(sounding, 500.0), [-10.0, 5.0, 0.0], atol=1e-14)


def test_shear_grows_without_end() -> None:
    shear = WindShear([0.0, 0.004, 0.0], velocity=[1.0, 0.0, 0.0], altitude=100.0)
    np.testing.assert_allclose(at(shear, 1100.0), [1.0, 4.0, 0.0], rtol=1e-15)


def test_boundary_layers() -> None:
    log = LogWind(10.0, 0.0, height=6.0, roughness=0.05, top=300.0)
    assert at(log, 6.0)[0] == pytest.approx(10.0, rel=1e-15)
    assert at(log, 60.0)[0] == pytest.approx(10.0 * np.log(1200.0) / np.log(120.0), rel=1e-14)
    assert at(log, 0.01)[0] == at(log, -5.0)[0] == 0.0
    assert at(log, 5000.0)[0] == at(log, 300.0)[0]
    power = PowerLawWind(8.0, np.pi / 2.0, height=10.0, exponent=0.2, ground=100.0)
    assert at(power, 110.0)[1] == pytest.approx(8.0, rel=1e-15)
    assert at(power, 420.0)[1] == pytest.approx(16.0, rel=1e-14)  # 32 times as high, 32^0.2 = 2
    assert at(power, 100.0)[1] == at(power, 90.0)[1] == 0.0


def test_gust_has_its_amplitude_from_its_end_on() -> None:
    ramp = OneMinusCosineGust([0.0, 0.0, -9.0], 5.0, duration=2.0)
    for time, share in ((4.0, 0.0), (5.0, 0.0), (6.0, 0.5), (7.0, 1.0), (50.0, 1.0)):
        np.testing.assert_allclose(at(ramp, 0.0, Moment(time)), [0.0, 0.0, -9.0 * share], atol=1e-15)
    pulse = OneMinusCosineGust([3.0, 0.0, 4.0], 100.0, length=80.0, shape="pulse", axes="body")
    for way, share in ((100.0, 0.0), (140.0, 0.5), (180.0, 1.0), (220.0, 0.5), (260.0, 0.0), (900.0, 0.0)):
        # The cosine of 2π comes out to 1e-16 of one.
        np.testing.assert_allclose(
            at(pulse, 0.0, Moment(air_path=way)), share * np.array([3.0, 0, 4.0]), atol=1e-15
        )


def test_winds_add_up_and_need_names_of_their_own() -> None:
    both = (
        ConstantWind([1.0, 0.0, 0.0])
        + ConstantWind([0.0, 2.0, 0.0], name="other")
        + WindShear([0.0] * 3, name="x")
    )
    np.testing.assert_allclose(at(both, 0.0), [1.0, 2.0, 0.0], atol=1e-15)
    with pytest.raises(fb.InputError, match=r"two have the parameter 'wind_speed'"):
        _ = ConstantWind([1.0, 0.0, 0.0]) + ConstantWind([0.0, 2.0, 0.0])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: ConstantWind([1.0, 2.0]), r"velocity: got shape \(2,\)"),
        (lambda: WindTable([2.0, 1.0], [[0.0] * 3] * 2), "sort the"),
        (lambda: OneMinusCosineGust([1.0, 0, 0], 0.0), "duration, length: give one"),
        (lambda: OneMinusCosineGust([0.0, 0, 0], 0.0, length=5.0), "zero vector"),
        (lambda: LogWind(1.0, 0.0, height=1.0, roughness=2.0), "roughness"),
        (lambda: Environment(wind=USStandard1976()), "wind: got"),  # type: ignore[arg-type]
        (lambda: ConstantWind([1.0, 2.0, 0.0], name="my wind"), "name: got"),
    ],
)
def test_wrong_arguments(make: Any, message: str) -> None:
    with pytest.raises(fb.InputError, match=message):
        make()


def test_a_body_in_steady_wind_moves_as_seen_from_a_moving_frame() -> None:
    wind, t = np.array([6.0, -3.0, 1.0]), 20.0
    velocity, turning = np.array([40.0, 5.0, -10.0]), [0.1, 0.4, -0.2]
    blown = model(Environment(wind=ConstantWind(wind)))
    calm = model(Environment())
    start = blown.state(velocity_world=velocity, angular_velocity_body=turning)
    seen = calm.state(velocity_world=velocity - wind, angular_velocity_body=turning)
    here = blown.simulate(start, (0.0, t), rtol=1e-11)
    there = calm.simulate(seen, (0.0, t), rtol=1e-11)
    # Two integrations of 20 s at 1e-11 a step, some hundred steps, of motions of 40 m/s.
    np.testing.assert_allclose(here.position_world[-1] - wind * t, there.position_world[-1], atol=1e-6)
    np.testing.assert_allclose(here.velocity_world[-1] - wind, there.velocity_world[-1], atol=1e-7)


WINDY = Environment(
    atmosphere=USStandard1976(temperature_offset=3.0),
    wind=WindTable([0.0, 3000.0], [[1.0, 2.0, 0.0], [9.0, -4.0, 0.5]])
    + LogWind(5.0, 1.0, name="low")
    + OneMinusCosineGust([0.0, 3.0, -4.0], 2.0, duration=3.0, axes="body"),
)


def test_moved_and_turned_body_frame() -> None:
    """The same body about another frame, with the drag at the same material point, moves alike."""
    shift, turn = np.array([0.7, -0.4, 0.5]), fb.Attitude.angles("zyx", [0.5, -0.7, 1.1]).as_rotation()
    point = np.array([0.3, -0.1, 0.2])

    def flown(body: fb.RigidBody, at: np.ndarray, origin: np.ndarray, axes: np.ndarray) -> np.ndarray:
        env = Environment(
            atmosphere=WINDY.atmosphere, wind=WindTable([0.0, 3000.0], [[1.0, 2.0, 0.0], [9.0, -4.0, 0.5]])
        )

        @fb.force(parameters=env.parameters)
        def law(s: Any, p: Any) -> Any:
            flow = env.flow(s, p, at)
            return fb.wrench(
                force=-0.05 * flow.air.density * np.linalg.norm(flow.velocity) * flow.velocity, at=at
            )

        made = fb.Model(body, [fb.UniformGravity(), law])
        omega = np.array([0.3, -0.2, 0.5])
        attitude = fb.Attitude.rotation(axes)
        v = np.array([50.0, 3.0, -8.0]) + np.cross(omega, origin)
        x0 = made.state(
            position=np.array([0.0, 0.0, -1500.0]) + origin,
            attitude=attitude,
            velocity_world=v,
            angular_velocity_world=omega,
        )
        return made.simulate(x0, (0.0, 10.0), rtol=1e-11).com_position_world[-1]

    plain = flown(BODY, point, np.zeros(3), np.eye(3))
    moved = flown(BODY.in_frame(shift, turn), turn.T @ (point - shift), shift, turn)
    # Two integrations at 1e-11 of 500 m of way.
    np.testing.assert_allclose(plain, moved, atol=1e-7)


def test_jacobian_is_exact() -> None:
    made = model(WINDY)
    x = made.state(
        position=[0, 0, -1500.0], velocity_world=[60.0, 5.0, 3.0], angular_velocity_body=[0.1, 0.2, 0.3]
    )
    exact, _ = made.jacobian(3.1, x)
    h = 1e-5 * np.maximum(np.abs(x), 1.0)
    rows = [
        (made.derivative(3.1, x + h[i] * e) - made.derivative(3.1, x - h[i] * e)) / (2.0 * h[i])
        for i, e in enumerate(np.eye(len(x)))
    ]
    # Central differences: rounding of derivatives of 1e2 over 1e-5, and h² times third derivatives.
    np.testing.assert_allclose(exact, np.array(rows).T, atol=1e-8, rtol=1e-6)


def test_lanes_are_scalar_runs() -> None:
    made = model(WINDY)
    x0 = made.state(position=[0, 0, -2500.0], velocity_world=[60.0, 5.0, 3.0])
    dispersions = {
        "position": fb.Offset(fb.Normal(0.0, [10.0, 10.0, 800.0])),
        "environment.wind_factor": fb.Uniform(0.5, 2.0),
        "environment.wind_turn": fb.Normal(0.0, 0.2),
        "environment.gust_start": fb.Uniform(1.0, 4.0),
        "environment.air_density_factor": fb.Uniform(0.9, 1.1),
    }
    runs = made.ensemble(x0, dispersions, n=7, seed=3).run((0.0, 12.0))
    for r in range(7):
        assert (runs.trajectory(r).outcome.state == runs.final[r]).all()


def test_gust_marks_keep_long_steps_from_passing_a_gust() -> None:
    gust = OneMinusCosineGust([0.0, 0.0, -30.0], 100.0, duration=0.05, shape="pulse")
    env = Environment(wind=gust)
    terminal = fb.Model(BODY, [drag(env), gust.marks()])
    rest = terminal.simulate(terminal.state(), (0.0, 200.0))
    # It rests until the gust; 0.1 s of a 30 m/s gust leave it moving upwards.
    assert rest.velocity_world[-1][2] < -1e-3
