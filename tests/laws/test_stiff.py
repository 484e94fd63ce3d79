"""Stiff models: what is fast and soon over does not set the steps."""

import numpy as np
import pytest

import freebody as fb

from .scenes import BODY, START, motion_gap


@fb.force(
    parameters={"lag": (1e-5, "s"), "gain": (5.0, "N*m")},
    inputs={"command": "rad"},
    states={"angle": (0.0, "rad")},
)
def servo(s, p):
    """A moment from a servo that follows its command with a short lag."""
    moment = p.gain * s.states.angle * np.stack([0.1, 1.0, 0.2])
    return fb.wrench(moment=moment), {"angle": (s.inputs.command - s.states.angle) / p.lag}


def servo_model(attitude: str) -> fb.Model:
    return fb.Model(BODY, [fb.UniformGravity(), servo], attitude)  # type: ignore[arg-type]


@pytest.mark.parametrize("attitude", ["quaternion", "zyx"])
def test_a_fast_servo_under_a_moving_command(attitude: str) -> None:
    # The command rises, holds, jumps and falls.
    command = fb.InputTable([0.0, 0.5, 1.0, 1.0, 2.0], [[0.0], [0.3], [0.3], [-0.2], [-0.5]])
    model = servo_model(attitude)
    x0, samples = model.state(**START, states={"servo.angle": 0.1}), np.linspace(0.0, 2.0, 41)
    stiff = model.simulate(x0, (0.0, 2.0), method="rodas5p", rtol=1e-8, inputs=command, save_at=samples)
    fine = model.simulate(x0, (0.0, 2.0), method="dop853", rtol=1e-11, inputs=command, save_at=samples)
    assert stiff.ok
    assert fine.ok
    # Some hundred steps of 1e-8.
    assert motion_gap(stiff, fine) <= 1e-6
    lag = np.abs(stiff.x[:, -1] - fine.x[:, -1])
    # Between a jump and the end of the lag the angle depends on the time itself.
    assert lag.max() <= 1e-6
    # Four jumps in slope or value of a lag of 1e-5 s; the explicit method is bound to the lag all the time.
    assert stiff.steps < 500
    assert fine.steps > 2.0 / 1e-5 / 10


def test_strong_damping() -> None:
    brake = fb.LinearDamping([1e6, 1e6, 1e6, 1e5, 1e5, 1e5])
    push = fb.ConstantWrench([3.0, 2.0, 1.0], [0.1, 0.2, 0.3], axes="world")
    model = fb.Model(BODY, [fb.UniformGravity(), brake, push])
    x0, samples = model.state(**START), np.linspace(0.0, 1.0, 11)
    stiff = model.simulate(x0, (0.0, 1.0), method="rodas5p", rtol=1e-8, save_at=samples)
    fine = model.simulate(x0, (0.0, 1.0), method="dop853", rtol=1e-11, save_at=samples)
    assert stiff.steps < 500
    assert fine.steps > 10_000
    assert motion_gap(stiff, fine) <= 1e-7


def test_compiled_elsewhere_or_not() -> None:
    """The Jacobian is the kernel's, wherever the derivative comes from."""
    model = servo_model("quaternion")
    x0 = model.state(**START, states={"servo.angle": 0.1})
    runs = [
        m.simulate(x0, (0.0, 1.0), method="rodas5p", rtol=1e-8, inputs=[0.2])
        for m in (model, fb.compile(model))
    ]
    # Sums in another order may move a step.
    assert abs(runs[0].steps - runs[1].steps) <= 3
    assert np.abs(runs[0].x[-1] - runs[1].x[-1]).max() <= 1e-6


def test_gauss6_is_not_for_stiff_models() -> None:
    model = fb.Model(BODY, [fb.LinearDamping([1e6] * 6)])
    run = model.simulate(model.state(**START), (0.0, 1.0), method="gauss6", step=0.01)
    assert (run.ok, run.outcome.status, run.outcome.time) == (False, "step_too_large", 0.0)
    assert "rodas5p" in run.outcome.message


def test_a_callback_has_no_jacobian_to_be_stiff_with() -> None:
    def push(s):
        return fb.wrench(force=-s.velocity_body)

    model = fb.Model(BODY, [fb.callback(push)])
    x0 = model.state()
    with pytest.raises(fb.InputError, match=r"force 'push' is a callback.*trace it with @fb\.force"):
        model.simulate(x0, (0.0, 1.0), method="rodas5p")
    assert model.simulate(x0, (0.0, 1.0), method="gauss6", step=0.1).ok
