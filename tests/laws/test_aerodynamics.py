"""Aerodynamic elements by law: any body frame, power, direction of drag, exact Jacobians, air at rest."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import simpson

import freebody as fb
from freebody.elements import Aerodynamics, Drag
from freebody.environment import Environment

from .airs import DAMPING, LIFT, PITCH, WINDY, element
from .scenes import BODY, START

Array = NDArray[np.float64]
# Some hundred operations between numbers of order one, in another order.
ROUNDING = 1e-13


@pytest.mark.parametrize("axes", ["body", "stability", "wind"])
def test_the_wrench_is_that_of_the_formulas(axes: str, rng: np.random.Generator) -> None:
    law, at = element(axes), np.array([0.4, -0.1, 0.2])
    model = fb.Model(BODY, [law])
    for _ in range(20):
        q = rng.normal(size=4)
        r = fb.Attitude.quaternion(q / np.linalg.norm(q)).as_rotation()
        position, v, w, rudder = *rng.normal(size=(3, 3)), rng.normal()
        x = model.state(position, fb.Attitude.rotation(r), velocity_body=v, angular_velocity_body=w)
        altitude = -(position + r @ at)[2]
        air = v + np.cross(w, at) - r.T @ [1.5 + 0.1 * altitude, -0.7, 0.2]
        speed = np.linalg.norm(air)
        alpha, beta = np.arctan2(air[2], air[0]), np.arcsin(air[1] / speed)
        p, q, r_ = (w - r.T @ [0.01, -0.02, 0.03]) * [1.2, 0.4, 1.2] / (2.0 * speed)
        first = 0.4 + 0.9 * alpha**2 + 0.5 * beta**2
        third = LIFT(alpha) + q * DAMPING(alpha)
        side = -0.6 * beta + 0.2 * alpha * rudder
        lift = np.array([np.sin(alpha), 0.0, -np.cos(alpha)])
        along = {
            "body": np.array([first, side, third]),
            "stability": -first * np.array([np.cos(alpha), 0.0, np.sin(alpha)])
            + side * np.eye(3)[1]
            + third * lift,
            "wind": -first * air / speed + side * np.cross(-lift, air / speed) + third * lift,
        }[axes]
        turning = [
            1.2 * (PITCH(alpha, beta) + 0.01 + p * DAMPING(alpha)),
            0.4 * (np.sin(alpha) * rudder - 4.0 * q),
            1.2 * (0.1 * beta - 0.4 * r_ + 0.2 * speed / 340.294),
        ]
        scale = 0.5 * 1.225 * speed**2 * 0.3
        force, moment = scale * along, scale * np.array(turning)
        wanted = np.concatenate([force, moment + np.cross(at, force)])
        assert np.abs(model.wrench(0.0, x, [rudder]) - wanted).max() <= ROUNDING * max(1.0, speed**2)


class Frame:
    """Body, forces and states described in the frame at `origin` with axes `turn` (old from new)."""

    def __init__(self, origin: Array, turn: Array) -> None:
        self.origin, self.turn = origin, turn
        laws = [
            element("body", self.place([0.4, -0.1, 0.2]), turn=turn.T),
            element("wind", self.place([-0.4, 0.3, 0.1]), turn=turn.T)(name="tail"),
            Drag(WINDY, 0.2, 0.5, at=self.place([0.1, 0.2, 0.3])),
        ]
        self.model = fb.Model(BODY.in_frame(origin, turn), [fb.UniformGravity(), *laws])

    def place(self, point: list[float]) -> Array:
        return self.turn.T @ (np.array(point) - self.origin)

    def state(self, position: Any, attitude: fb.Attitude, velocity: Any, spin: Any) -> Array:
        rotation = attitude.as_rotation()
        return self.model.state(
            np.asarray(position) + rotation @ self.origin,
            fb.Attitude.rotation(rotation @ self.turn),
            velocity_body=self.turn.T @ (np.asarray(velocity) + np.cross(spin, self.origin)),
            angular_velocity_body=self.turn.T @ np.asarray(spin),
        )


OLD = Frame(np.zeros(3), np.eye(3))
NEW = Frame(np.array([-0.7, 0.4, 0.9]), fb.Attitude.angles("zyx", [0.7, -0.4, 1.9]).as_rotation())


def test_in_a_moved_and_turned_frame_the_wrench_is_the_same(rng: np.random.Generator) -> None:
    for _ in range(50):
        q = rng.normal(size=4)
        motion = (
            rng.normal(size=3),
            fb.Attitude.quaternion(q / np.linalg.norm(q)),
            *3.0 * rng.normal(size=(2, 3)),
        )
        wanted, got = (frame.model.wrench(0.0, frame.state(*motion), [0.2]) for frame in (OLD, NEW))
        force, moment = NEW.turn @ got[:3], NEW.turn @ got[3:]
        same = np.concatenate([force, moment + np.cross(NEW.origin, force)])
        assert np.abs(same - wanted).max() <= 1e2 * ROUNDING * np.abs(wanted).max()


def test_the_power_of_drag_is_minus_drag_times_airspeed(rng: np.random.Generator) -> None:
    calm = Environment()
    at = np.array([0.3, 0.1, -0.2])
    for law in (Drag(calm, 0.2, 0.5, at=at), Aerodynamics(calm, 0.2, 1.0, 1.0, {"CD": 0.5}, at, axes="wind")):
        model = fb.Model(BODY, [law])
        for _ in range(20):
            twist = rng.normal(size=6)
            x = model.state(velocity_body=twist[:3], angular_velocity_body=twist[3:])
            air = twist[:3] + np.cross(twist[3:], at)
            drag = 0.5 * 1.225 * 0.2 * 0.5 * (air @ air)
            wrench = model.wrench(0.0, x)
            assert wrench @ twist == pytest.approx(-drag * np.linalg.norm(air), rel=ROUNDING)
            assert np.abs(wrench[:3] + drag * air / np.linalg.norm(air)).max() <= ROUNDING * drag


def test_energy_falls_by_the_work_of_the_air() -> None:
    """Power by Simpson's rule over samples 1 ms apart; where tables have corners it errs by (1 ms)²."""
    law = element(environment=Environment())
    model, alone = fb.Model(BODY, [fb.UniformGravity(), law]), fb.Model(BODY, [law])
    run = model.simulate(
        model.state(**dict(START, velocity_body=[9.0, -2.0, 3.0])), (0.0, 0.4), rtol=1e-12, save_every=0.001
    )
    power = np.array([alone.wrench(t, x) @ x[7:13] for t, x in zip(run.t.tolist(), run.x, strict=True)])
    work = simpson(power, x=run.t)
    assert run.energy[-1] - run.energy[0] == pytest.approx(work, rel=1e-6)


def test_at_zero_airspeed_nothing_acts_and_the_jacobian_is_finite() -> None:
    """Moving along an axis only, too: where angles have their singular directions."""
    calm = Environment()
    model = fb.Model(
        BODY, [element(axes, environment=calm)(name=axes) for axes in ("body", "stability", "wind")]
    )
    still = model.state()
    assert not model.wrench(0.0, still, [0.3]).any()
    for velocity in (np.zeros(3), 1e-9 * np.ones(3), *np.eye(3), *-np.eye(3)):
        x = model.state(velocity_body=velocity)
        assert np.isfinite(model.wrench(0.0, x, [0.3])).all()
        assert all(np.isfinite(m).all() for m in model.jacobian(0.0, x, [0.3]))


# Central differences of order 8.
STENCIL = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
