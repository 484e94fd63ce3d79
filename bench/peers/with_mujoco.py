"""MuJoCo: a free joint; damping and wrench as actuators at the body's origin, so that all is its own C."""
# pyright: reportMissingImports=false

from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor

import mujoco
import numpy as np

import case
import truth
from way import Nothing, Way, difference

STEPS = [round(200 * 1.19**k) for k in range(30)]


def _model(mass: float, com: np.ndarray, inertia: np.ndarray) -> "mujoco.MjModel":
    """The wrench (w - d V) is an affine actuator for each axis of a site at the origin."""

    def text(numbers: Iterable) -> str:
        return " ".join(repr(float(number)) for number in numbers)

    wrench = [*case.FORCE, *case.MOMENT]
    actuators = "".join(
        f'<general site="o" gear="{text(axis)}" gainprm="0" biastype="affine" biasprm="{text((w, 0, -d))}"/>'
        for axis, w, d in zip(np.eye(6), wrench, case.DAMPING, strict=True)
    )
    six = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    return mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      <option gravity="0 0 {case.GRAVITY}" integrator="RK4">
        <flag contact="disable" constraint="disable"/>
      </option>
      <worldbody>
        <body>
          <freejoint/>
          <site name="o"/>
          <inertial pos="{text(com)}" mass="{mass!r}" fullinertia="{text(six)}"/>
        </body>
      </worldbody>
      <actuator>{actuators}</actuator>
    </mujoco>""")


def _put(data: "mujoco.MjData", x: np.ndarray) -> None:
    """Its velocities are the origin's in world axes and the angular one in body axes."""
    data.time = 0.0
    data.qpos[:] = x[:7]
    data.qvel[:3] = case.rotation(x[3:7, None])[:, :, 0] @ x[7:10]
    data.qvel[3:] = x[10:]


def _state(data: "mujoco.MjData") -> np.ndarray:
    turned = case.rotation(data.qpos[3:, None])[:, :, 0]
    return np.concatenate([data.qpos, turned.T @ data.qvel[:3], data.qvel[3:]])


class MuJoCo(Nothing):
    name = "MuJoCo"
    runs = 4

    def __init__(self) -> None:
        self.version = mujoco.__version__
        self.model = _model(case.MASS, case.COM, case.INERTIA)

    def derivative(self) -> Iterable[Way]:
        x, data = truth.start(), mujoco.MjData(self.model)
        _put(data, x)

        def acceleration() -> np.ndarray:
            turned = case.rotation(x[3:7, None])[:, :, 0]
            return np.concatenate([turned.T @ data.qacc[:3] - np.cross(x[10:], x[7:10]), data.qacc[3:]])

        names = {"f": mujoco.mj_forward, "model": self.model, "data": data}
        error = difference(truth.derivative(x[:, None])[7:, 0], acceleration)
        yield Way("mj_forward, accelerations alone", "f(model, data)", names, error)

    def methods(self) -> Mapping[str, Iterable[float]]:
        return {"RK4": [case.SECONDS / n for n in STEPS]}

    def trajectory(self, method: str, tolerance: float) -> Way:
        x, data = truth.start(), mujoco.MjData(self.model)

        def run() -> None:
            self.model.opt.timestep = tolerance
            _put(data, x)
            mujoco.mj_step(self.model, data, nstep=round(case.SECONDS / tolerance))

        return Way(method, "run()", {"run": run}, difference(truth.nominal(), lambda: _state(data)))

    def ensembles(self) -> Mapping[str, Iterable[float]]:
        return self.methods()

    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way:
        x, bodies = case.dispersed(runs)
        models = [
            _model(float(bodies.mass[k]), bodies.com[:, k], bodies.inertia[:, :, k]) for k in range(runs)
        ]
        data = [mujoco.MjData(model) for model in models]

        def one(k: int) -> None:
            models[k].opt.timestep = tolerance
            _put(data[k], x[:, k])
            mujoco.mj_step(models[k], data[k], nstep=round(case.SECONDS / tolerance))

        def run() -> None:
            with ThreadPoolExecutor(threads) as pool:
                list(pool.map(one, range(runs)))

        final = difference(truth.ensemble()[:, :runs], lambda: np.stack([_state(d) for d in data], axis=1))
        return Way(method, "run()", {"run": run}, final, runs)
