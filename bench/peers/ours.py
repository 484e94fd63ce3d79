"""freebody itself, beside its peers."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

import case
import freebody as fb
import truth
from freebody import _core
from way import Nothing, Way, decades, difference

CHECKED = 100
ADAPTIVE = ("dop853", "vern8", "vern9", "dp54", "rodas5p")
ORDERS_8_AND_9: Mapping[str, Iterable[float]] = dict.fromkeys(ADAPTIVE[:3], decades(-4, -14, 16))
# Late in a run speeds and heights are large: errors relative to them are what the whole error comes from.
WIDER = ", atol = 10 rtol"
WIND = (3.0, -2.0, 0.5)
PRESSURE_CENTRE = (-0.4, 0.1, 0.05)


@fb.force(parameters={"area": (0.0, "m^2"), "density": (1.225, "kg/m^3"), "turning": (0.0, "N m s^2")})
def drag(s: Any, p: Any) -> Any:
    """The case's damping, and the drag of an area that is none here: no less work, the same motion."""
    air = s.world_from_body.T @ WIND
    v = s.velocity_body - air + np.cross(s.angular_velocity_body, PRESSURE_CENTRE)
    quadratic = -0.5 * p.density * p.area * np.sqrt(v @ v + 0.01) * v
    turning = -p.turning * np.abs(s.angular_velocity_body) * s.angular_velocity_body
    damping = -case.DAMPING * s.twist
    moment = np.cross(PRESSURE_CENTRE, quadratic) + turning
    return fb.wrench(force=damping[:3] + quadratic, moment=damping[3:] + moment)


class Freebody(Nothing):
    name = "freebody"
    runs = case.RUNS

    def __init__(self, damping: fb.Force | None = None) -> None:
        self.version = fb.__version__
        body = fb.RigidBody(case.MASS, case.COM, inertia_about_com=case.INERTIA)
        forces = [
            fb.UniformGravity(case.GRAVITY),
            fb.ConstantWrench(case.FORCE, case.MOMENT),
            damping or fb.LinearDamping(case.DAMPING),
        ]
        self.model = fb.Model(body, forces)

    def derivative(self) -> Iterable[Way]:
        f, x, out = self.model.derivative, truth.start(), np.empty(case.STATES)
        names = {"f": f, "x": x, "u": np.zeros(6), "out": out}
        right = truth.derivative(x[:, None])[:, 0]
        yield Way("into an array", "f(0.0, x, None, out)", names, difference(right, lambda: out))
        yield Way("into an array, with inputs", "f(0.0, x, u, out)", names, difference(right, lambda: out))
        yield Way("a new array", "f(0.0, x)", names, difference(right, lambda: f(0.0, x)))

    def derivatives(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        out = np.empty_like(x)
        names = {"f": self.model.derivative_batch, "x": x, "out": out, "threads": threads}
        error = difference(truth.derivative(x), lambda: out)
        yield Way("derivative_batch", "f(0.0, x, None, out, threads)", names, error, x.shape[1])

    def jacobian(self) -> Iterable[Way]:
        f, x = self.model.jacobian, truth.start()
        out = np.empty((case.STATES, case.STATES)), np.empty((case.STATES, case.INPUTS))
        names = {"f": f, "x": x, "out": out}
        right = truth.jacobian()
        yield Way("into arrays", "f(0.0, x, None, out)", names, difference(right, lambda: np.hstack(out)))
        yield Way("new arrays", "f(0.0, x)", names, difference(right, lambda: np.hstack(f(0.0, x))))

    def jacobians(self, x: np.ndarray, threads: int) -> Iterable[Way]:
        right = truth.jacobians(x[:, :CHECKED])
        out = np.empty((case.STATES, case.STATES + case.INPUTS, x.shape[1]))
        names = {"f": self.model.jacobian_batch, "x": x, "threads": threads}
        error = difference(right, lambda: out[:, :, :CHECKED])
        yield Way("jacobian_batch", "f(0.0, x, None, out, threads)", names | {"out": out}, error, x.shape[1])
        entries = self.model.jacobian_entries
        few = np.empty((len(entries[0]), x.shape[1]))

        def given() -> np.ndarray:
            full = np.zeros_like(right)
            full[entries] = few[:, :CHECKED]
            return full

        statement = "f(0.0, x, None, out, threads, True)"
        sparse = "jacobian_batch, sparse"
        yield Way(sparse, statement, names | {"out": few}, difference(right, given), x.shape[1], True)

    def methods(self) -> Mapping[str, Iterable[float]]:
        steps = [case.SECONDS / round(300 * 1.09**k) for k in range(52)]
        others = dict.fromkeys(ADAPTIVE[3:], decades(-4, -14))
        return {**ORDERS_8_AND_9, **others, "rk4": steps, "gauss6": steps}

    def trajectory(self, method: str, tolerance: float) -> Way:
        x, final, tolerance = truth.start(), np.empty(case.STATES), float(tolerance)
        names: dict[str, Any] = {
            "model": self.model,
            "x": x,
            "final": final,
            "save": np.array([case.SECONDS]),
        }
        names |= {"span": (0.0, case.SECONDS), "method": method, "tolerance": tolerance}
        control = "rtol=tolerance, atol=tolerance" if method in ADAPTIVE else "step=tolerance"
        statement = f"final[:] = model.simulate(x, span, method=method, {control}, save_at=save).x[-1]"
        return Way(method, statement, names, difference(truth.nominal(), lambda: final))

    def ensembles(self) -> Mapping[str, Iterable[float]]:
        return {**ORDERS_8_AND_9, f"vern8{WIDER}": ORDERS_8_AND_9["vern8"]}

    def ensemble(self, method: str, tolerance: float, runs: int, threads: int) -> Way:
        x, bodies = case.dispersed(runs)
        properties = (bodies.mass, bodies.com.T.copy(), np.moveaxis(bodies.inertia, 2, 0).copy())
        states, constants, final = x.T.copy(), np.zeros((1, 6)), np.empty((runs, case.STATES))
        relative = float(tolerance)
        absolute = 10 * relative if method.endswith(WIDER) else relative

        def run() -> None:
            final[:] = _core.run_ensemble(
                self.model,
                states,
                (0.0, case.SECONDS),
                bodies=properties,
                parameters=None,
                constants=constants,
                table=None,
                save_at=None,
                events=(),
                outputs=(),
                method=method.removesuffix(WIDER),
                tolerance=(relative, absolute),
                step=None,
                max_steps=1_000_000,
                threads=threads,
                progress=None,
            ).end_states

        return Way(
            method, "run()", {"run": run}, difference(truth.ensemble()[:, :runs], lambda: final.T), runs
        )


class FreebodyTape(Freebody):
    """The same with its damping written by a user."""

    name = "freebody, damping traced"

    def __init__(self) -> None:
        super().__init__(drag)
        self.operations = drag._program.instruction_count

    def derivative(self) -> Iterable[Way]:
        return ()

    derivatives = jacobians = Nothing.derivatives
    jacobian = Nothing.jacobian

    def methods(self) -> Mapping[str, Iterable[float]]:
        return {}
