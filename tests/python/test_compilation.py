"""Derivatives in compiled C: the same answer."""

import os
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb

INERTIA = np.array([[0.42, 0.01, -0.02], [0.01, 0.91, 0.03], [-0.02, 0.03, 1.10]])
BODY = fb.RigidBody(12.5, (0.12, -0.05, 0.08), inertia_about_com=INERTIA)
SLOPE = fb.Table([-2.0, -0.5, 0.5, 2.0], [0.0, -1.0, 1.0, 0.0], "cubic")


@fb.force(inputs={"rudder": "rad"}, states={"servo": (0.1, "rad")})
def fin(s: Any) -> Any:
    v = s.velocity_body
    side = -2.0 * np.sqrt(v @ v + 1.0) * SLOPE(np.arctan2(v[1], v[0]) + s.states.servo)
    return fb.wrench(force=np.stack([0.0, side, 0.0]), at=(-1, 0, 0)), {
        "servo": (s.inputs.rudder - s.states.servo) / 0.2
    }


@fb.control(inputs={"course": "rad/s"})
def pilot(s: Any) -> Any:
    return {"rudder": 0.3 * (s.inputs.course - s.angular_velocity_body[2])}


FORCES = (fb.UniformGravity(), fb.LinearDamping([1, 2, 3, 0.1, 0.2, 0.3]), fin)
MODELS = {
    f"{attitude}, {form}, {'closed' if control else 'open'} loop": fb.Model(
        BODY, FORCES, attitude, form, control=control
    )
    for attitude in ("quaternion", "zyx", "zxz")
    for form in ("quasi_velocity", "generalized")
    for control in (None, pilot)
}


@pytest.fixture(autouse=True)
def _own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.getbasetemp() / "cache"))


def start(model: fb.Model) -> np.ndarray:
    attitude = fb.Attitude.angles("zyx", [0.5, 0.4, -0.3])
    return model.state(
        (1, 2, 3), attitude, velocity_body=(4, 0.3, -0.2), angular_velocity_body=(0.5, 1.2, 0.4)
    )


@pytest.mark.parametrize("which", MODELS)
def test_the_answer_is_the_same(which: str) -> None:
    model = MODELS[which]
    compiled = fb.compile(model)
    assert compiled.compiled
    assert not model.compiled
    x = start(model)
    rate = model.derivative(0.3, x, [0.2])
    # Products and sums are rounded in another order.
    np.testing.assert_allclose(compiled.derivative(0.3, x, [0.2]), rate, rtol=1e-12, atol=1e-13)
    for mine, its in zip(compiled.jacobian(0.3, x, [0.2]), model.jacobian(0.3, x, [0.2]), strict=True):
        assert np.array_equal(mine, its)
    # Steps of one size, so that nothing but rounding differs, which 300 steps may add up.
    how: dict[str, Any] = {"method": "rk4", "step": 0.01, "inputs": [0.1], "save_every": 0.5}
    runs = [m.simulate(x, (0.0, 3.0), **how) for m in (model, compiled)]
    np.testing.assert_allclose(runs[1].x, runs[0].x, rtol=1e-11, atol=1e-11)
    assert len(runs[0].chart_changes) == len(runs[1].chart_changes)


def test_it_is_built_once() -> None:
    folder = Path(os.environ["XDG_CACHE_HOME"]) / "freebody"
    model = fb.Model(BODY, [fb.UniformGravity(1.625)])
    fb.compile(model)
    built = {path: path.stat().st_mtime_ns for path in folder.iterdir()}
    fb.compile(model)
    assert {path: path.stat().st_mtime_ns for path in folder.iterdir()} == built


def test_a_pickled_model_is_the_one_without_it() -> None:
    compiled = fb.compile(MODELS["zyx, generalized, closed loop"])
    assert not pickle.loads(pickle.dumps(compiled)).compiled


def test_without_a_compiler_it_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(fb.InputError, match=r"no C compiler 'no-such-compiler' here; install one"):
        fb.compile(MODELS["quaternion, generalized, open loop"])


def test_a_compiler_that_fails_is_quoted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "broken"
    broken.write_text("#!/bin/sh\necho out of order >&2\nexit 3\n")
    broken.chmod(0o755)
    monkeypatch.setenv("CC", str(broken))
    with pytest.raises(fb.InputError, match="failed:\nout of order"):
        fb.compile(MODELS["quaternion, generalized, open loop"])


def test_what_is_no_expression_is_refused() -> None:
    sail = fb.callback(lambda s: np.zeros((len(s.time), 6)), name="sail")
    with pytest.raises(fb.InputError, match=r"'sail' is a callback, which is no expression"):
        fb.compile(fb.Model(BODY, [sail]))
    with pytest.raises(fb.InputError, match=r"^model: got"):
        fb.compile(BODY)  # type: ignore[arg-type]
