"""What real vehicles cost beside a plain rigid body, in one run: `make bench`.

The body of case.py with gravity, a constant wrench and damping is the measure. Beside it: an F-16 with its
tables; NASA's sphere that falls through the US Standard Atmosphere 1976 over WGS-84 with J2; an underwater
vehicle with added mass, fins and a propeller. All take turns; the best of several spells of the processor's
time counts. An ensemble's runs of 10 s differ in mass and angular velocity.
"""

import json
import time
import timeit
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import case
import freebody as fb
import page
from freebody.model_file import load_model, shipped_model
from report import instruction_set

STATES, RUNS, SECONDS, TOLERANCE = 1024, 512, 10.0, 1e-6
SPELLS = 9
MEASURES = ("one derivative", f"{STATES} derivatives", "an evaluation in an ensemble", "a run of an ensemble")
PLAIN = "rigid body"


@dataclass(eq=False)
class Vehicle:
    """A model, where it starts, the inputs that it holds; the best seconds of each measure."""

    model: fb.Model
    x0: np.ndarray
    inputs: Mapping[str, float] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)

    @property
    def u(self) -> np.ndarray:
        return np.array([self.inputs.get(name, 0.0) for name in self.model.input_names])

    @property
    def operations(self) -> int:
        """Of the tapes of its laws."""
        programs = [getattr(force, "_program", None) for force in self.model.forces]
        return sum(program.instruction_count for program in programs if program is not None)

    def measures(self) -> dict[str, tuple[Callable[[], Any], float]]:
        """What is timed, and how many derivatives or runs a call makes."""
        model, x0, u, span = self.model, self.x0, self.u, (0.0, SECONDS)
        rng = np.random.default_rng(case.SEED)
        x = np.ascontiguousarray(x0[:, None] * (1.0 + 1e-3 * rng.uniform(-1.0, 1.0, (len(x0), STATES))))
        inputs = np.ascontiguousarray(np.broadcast_to(u[:, None], (len(u), STATES)))
        out, many = np.empty_like(x0), np.empty_like(x)
        spread: dict[str, Any] = {
            "mass": fb.Factor(fb.Uniform(0.95, 1.05)),
            "angular_velocity_body": fb.Offset(fb.Normal(0.0, 0.01)),
        }
        ensemble = model.ensemble(x0, spread, n=RUNS, inputs=u)

        def runs() -> fb.Runs:
            return ensemble.run(span, rtol=TOLERANCE, threads=1)

        some = [ensemble.trajectory(r, span, rtol=TOLERANCE).evaluations for r in range(0, RUNS, 32)]
        calls = (
            (lambda: model.derivative(0.0, x0, u, out), 1),
            (lambda: model.derivative_batch(0.0, x, inputs, many, 1), STATES),
            (runs, RUNS * float(np.mean(some))),
            (runs, RUNS),
        )
        return dict(zip(MEASURES, calls, strict=True))


def vehicles() -> dict[str, Vehicle]:
    """The rigid body first."""
    body = fb.RigidBody(case.MASS, case.COM, inertia_about_com=case.INERTIA)
    forces = [fb.UniformGravity(case.GRAVITY), fb.ConstantWrench(case.FORCE, case.MOMENT)]
    plain = fb.Model(body, [*forces, fb.LinearDamping(case.DAMPING)])
    trimmed = {"elevator": -0.03369400756215531, "throttle": 0.14848607882025966}
    return {
        PLAIN: Vehicle(plain, case.nominal()[0][:, 0].copy()),
        "F-16": _shipped("f16", trimmed),
        "sphere in US-76 over WGS-84": _shipped("nesc_06_sphere_with_drag", {}),
        "underwater vehicle": _shipped("remus_100", {"shaft_speed": 1525.0 * np.pi / 30.0}),
    }


def _shipped(name: str, inputs: Mapping[str, float]) -> Vehicle:
    loaded = load_model(shipped_model(name))
    return Vehicle(loaded.model, np.array(loaded.x0), inputs)


def measure(found: Mapping[str, Vehicle]) -> None:
    """Every vehicle in turn, so that they share whatever else the machine does."""
    timers = []
    for vehicle in found.values():
        for name, (call, count) in vehicle.measures().items():
            timer = timeit.Timer(call, timer=time.process_time)
            timer.timeit(1)
            number = max(1, round(0.02 / max(timer.timeit(1), 1e-7)))
            timers.append((vehicle, name, timer, number, count))
    for _ in range(SPELLS):
        for vehicle, name, timer, number, count in timers:
            each = timer.timeit(number) / number / count
            vehicle.seconds[name] = min(each, vehicle.seconds.get(name, np.inf))


def show(found: Mapping[str, Vehicle]) -> None:
    """Nanoseconds, and how many times the plain body's they are; runs a second."""
    print(f"dop853, rtol {TOLERANCE:g}, {RUNS} runs of {SECONDS:g} s; one thread, {instruction_set()}")
    print(f"{'':28}{'tape':>5}", *(f"{name:>30}" for name in MEASURES))
    plain = found[PLAIN].seconds
    for name, vehicle in found.items():
        cells = [f"{x * 1e9:18.0f} ns x{x / plain[what]:7.2f}" for what, x in vehicle.seconds.items()]
        rate = f"{1.0 / vehicle.seconds[MEASURES[-1]]:10.0f} runs/s"
        print(f"{name:28}{vehicle.operations:5}", *cells, rate)


def main() -> None:
    found = vehicles()
    measure(found)
    show(found)
    plain = found[PLAIN].seconds
    ratios = {
        name: {what: float(f"{seconds / plain[what]:.3g}") for what, seconds in vehicle.seconds.items()}
        for name, vehicle in found.items()
        if name != PLAIN
    }
    operations = {name: vehicle.operations for name, vehicle in found.items() if name != PLAIN}
    content = {"instruction_set": instruction_set(), "operations": operations, "ratios": ratios}
    page.VEHICLES.write_text(json.dumps(content, indent=1) + "\n")
    page.renew()


if __name__ == "__main__":
    main()
