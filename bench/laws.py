"""What laws of users cost beside built-in forces, for one trajectory from Python: `make bench`.

A body with gravity, damping and a constant wrench, each written by a user, against the same built in; then
both with a fin, which is no built-in force. Lanes are measured by the core's own benchmark. Each figure is
the best of several repeats: what else the machine does can only add to it.
"""

import timeit
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

import freebody as fb

DAMPING = (2.0, 3.0, 4.0, 0.1, 0.2, 0.3)
SECONDS = 200.0


@fb.force(parameters={"g": (9.80665, "m/s^2")})
def gravity(s: Any, p: Any) -> Any:
    return fb.wrench(force=s.mass * p.g * s.world_from_body[2], at=s.com)


@fb.force
def damping(s: Any) -> Any:
    drag = -np.array(DAMPING) * s.twist
    return fb.wrench(force=drag[:3], moment=drag[3:])


@fb.force
def push(s: Any) -> Any:
    return fb.wrench(force=np.array([0.5, 0.1, -0.2]), moment=np.array([0.05, 0.02, 0.1]))


@fb.force(parameters={"area": (0.02, "m^2"), "density": (1.225, "kg/m^3"), "slope": (5.0, "1")})
def fin(s: Any, p: Any) -> Any:
    v = s.velocity_body + np.cross(s.angular_velocity_body, [-1.0, 0.0, 0.0])
    along = np.sqrt(v @ v + 0.01)
    side = -0.5 * p.density * p.area * p.slope * along * v[1]
    return fb.wrench(force=np.stack([0.0, side, 0.0]), at=(-1.0, 0.0, 0.0))


TRACED = (gravity, damping, push)
BUILT_IN = (
    fb.UniformGravity(),
    fb.LinearDamping(DAMPING),
    fb.ConstantWrench((0.5, 0.1, -0.2), (0.05, 0.02, 0.1)),
)


def best(call: Callable[[], object], number: int, repeat: int = 7) -> float:
    """Seconds of one call."""
    return min(timeit.repeat(call, number=number, repeat=repeat)) / number


def model_of(forces: Sequence[fb.Force]) -> fb.Model:
    inertia = np.array([[0.42, 0.01, -0.02], [0.01, 0.91, 0.03], [-0.02, 0.03, 1.10]])
    return fb.Model(fb.RigidBody(12.5, (0.12, -0.05, 0.08), inertia_about_com=inertia), forces)


def measured(forces: Sequence[fb.Force]) -> tuple[float, float, float]:
    """Nanoseconds of a derivative and of an evaluation in a run, milliseconds of the run."""
    model = model_of(forces)
    x = model.state(velocity_body=[10.0, 0.5, 0.2], angular_velocity_body=[0.1, 2.0, 0.1])
    u, out = np.zeros(6), np.empty_like(x)

    def run() -> fb.Trajectory:
        return model.simulate(x, (0.0, SECONDS), method="dop853", rtol=1e-9, save_every=SECONDS)

    each = best(run, 1)
    return (
        best(lambda: model.derivative(0.0, x, u, out), 50_000) * 1e9,
        each / run().evaluations * 1e9,
        each * 1e3,
    )


def main() -> None:
    operations = sum(law._program.instruction_count for law in (*TRACED, fin))
    print(f"gravity, damping, a constant wrench and a fin: {operations} operations traced; one thread")
    print(f"dop853, rtol 1e-9, {SECONDS:g} s, the end alone saved")
    rows = [
        ("built in, without the fin", measured(BUILT_IN)),
        ("traced, without the fin", measured(TRACED)),
        ("built in, the fin traced", measured([*BUILT_IN, fin])),
        ("all traced", measured([*TRACED, fin])),
    ]
    print(f"{'':28}{'derivative':>12}{'evaluation':>12}{'run':>12}")
    for name, (derivative, evaluation, whole) in rows:
        print(f"{name:28}{derivative:9.0f} ns{evaluation:9.0f} ns{whole:9.2f} ms")
    plain, ours, mixed, every = (figures for _, figures in rows)
    for name, a, b in (("without the fin", ours, plain), ("with it", every, mixed)):
        ratios = " ".join(f"{x / y:8.2f}" for x, y in zip(a, b, strict=True))
        print(f"traced / built in, {name}:  {ratios}")


if __name__ == "__main__":
    main()
