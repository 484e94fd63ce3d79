"""Forces and inputs over time: jumps cost nothing, and however they are given they are the same."""

import numpy as np
import pytest

import freebody as fb
from freebody.simulation import Method
from freebody.tables import Interpolation

from .scenes import BODY, START, Array, motion_gap

TIMES = [0.0, 1.0, 2.5, 4.0]
VALUES = np.random.default_rng(8).normal(size=(4, 6)) * [3.0, 3.0, 3.0, 0.3, 0.3, 0.3]
AT = [0.1, 0.1, 0.1]
END = 6.0
SAMPLES = np.linspace(0.0, END, 61)


def tabulated(times: Array | list[float], values: Array, interpolation: Interpolation) -> fb.Model:
    force = fb.TabulatedWrench(times, values[:, :3], values[:, 3:], at=AT, interpolation=interpolation)
    return fb.Model(BODY, [fb.UniformGravity(1.5), force])


def go(model: fb.Model, method: Method = "dop853", **settings) -> fb.Trajectory:
    settings = {"rtol": 1e-12, "save_at": SAMPLES} | settings
    return model.simulate(model.state(**START), (0.0, END), method=method, **settings)


@pytest.mark.parametrize("method", ["rk4", "dp54", "dop853", "vern8", "vern9"])
def test_steps_end_at_jumps(method: Method) -> None:
    """The run under a held table is that under one constant wrench after the other, to rounding."""
    settings = {"rtol": 1e-10, "method": method, "step": 0.07 if method == "rk4" else None}
    whole = go(tabulated(TIMES, VALUES, "hold"), **settings, save_at=None)
    x, steps = whole.x[0], 0
    for row, begin, end in zip(VALUES, TIMES, [*TIMES[1:], END], strict=True):
        constant = fb.ConstantWrench(row[:3], row[3:], at=AT)
        piece = fb.Model(BODY, [fb.UniformGravity(1.5), constant]).simulate(x, (begin, end), **settings)
        x, steps = piece.x[-1], steps + piece.steps
        there = np.flatnonzero(whole.t == end)
        assert len(there) == 1
        # Steps of other lengths, each to rtol; for rk4 the same steps.
        assert np.abs(whole.x[there[0]] - x).max() <= 100 * 1e-10 * np.abs(whole.x).max()
    # A jump within a step would be found by a dozen rejections each.
    assert whole.steps <= steps
    assert whole.rejected_steps <= 3


def test_a_line_between_two_times_is_linear() -> None:
    """A ramp of force, taken along whole: v = ∫F/m dt of a body that does not turn."""
    body = fb.RigidBody(2.0, inertia_about_com=np.eye(3))
    ramp = fb.TabulatedWrench([1.0, 3.0, 3.0, 4.0], [[0, 0, 2], [0, 0, 6], [0, 0, -4], [0, 0, 0]])
    model = fb.Model(body, [ramp])
    run = model.simulate(model.state(), (0.0, 5.0), save_at=[0.0, 1.0, 2.0, 3.0, 4.0, 5.0])
    # Held before the first and after the last time; quadratic in between, so exact but for rounding.
    assert np.abs(run.velocity_world[:, 2] - [0.0, 1.0, 2.5, 5.0, 4.0, 4.0]).max() <= 1e-12


@pytest.mark.parametrize("interpolation", ["linear", "hold"])
def test_inputs_and_forces_tabulated_alike(interpolation: Interpolation) -> None:
    times = [0.0, 1.0, 1.0, 2.5, 4.0] if interpolation == "linear" else TIMES
    values = VALUES[[0, 1, 2, 2, 3]] if interpolation == "linear" else VALUES
    forced = go(tabulated(times, values, interpolation))
    driven = go(
        fb.Model(BODY, [fb.UniformGravity(1.5), fb.InputWrench(at=AT)]),
        inputs=fb.InputTable(times, values, interpolation),
    )
    assert np.array_equal(forced.x, driven.x)
    assert np.array_equal(driven.u[0], values[0])
    assert np.array_equal(driven.u[-1], values[-1])
    at_jump = driven.u[SAMPLES == 1.0]
    assert np.array_equal(at_jump, values[[2]] if interpolation == "linear" else values[[1]])


def test_constant_inputs_are_a_constant_wrench() -> None:
    constant = go(fb.Model(BODY, [fb.ConstantWrench(VALUES[0, :3], VALUES[0, 3:], at=AT)]))
    given = go(fb.Model(BODY, [fb.InputWrench(at=AT)]), inputs=VALUES[0])
    one_row = go(fb.Model(BODY, [fb.InputWrench(at=AT)]), inputs=fb.InputTable([0.0], VALUES[:1]))
    assert np.array_equal(given.x, constant.x)
    assert np.array_equal(one_row.x, constant.x)


def test_several_inputs_stand_side_by_side() -> None:
    thrusters = [
        fb.InputWrench(at=[1.0, 0.0, 0.0], name="left"),
        fb.InputWrench(axes="world", at=[0.0, 1.0, 0.0], name="right"),
    ]
    model = fb.Model(BODY, thrusters)
    assert model.input_names[5:7] == ("left.moment_z", "right.force_x")
    control = np.arange(1.0, 13.0) * 0.1
    fixed = [
        fb.ConstantWrench(control[:3], control[3:6], at=thrusters[0].at),
        fb.ConstantWrench(control[6:9], control[9:], axes="world", at=thrusters[1].at),
    ]
    # The same wrenches in the same order.
    assert motion_gap(go(model, inputs=control), go(fb.Model(BODY, fixed))) <= 1e-13
