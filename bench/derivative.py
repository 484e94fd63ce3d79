"""How long a derivative, a Jacobian and a run take: `make bench`.

Each figure is the best of several repeats: what else the machine does can only add to it.
"""

import timeit
from collections.abc import Callable

import numpy as np

import freebody as fb


def nanoseconds(call: Callable[[], object], number: int, repeat: int = 7) -> float:
    """The time of one call."""
    return min(timeit.repeat(call, number=number, repeat=repeat)) / number * 1e9


def main() -> None:
    inertia = np.array([[0.42, 0.01, -0.02], [0.01, 0.91, 0.03], [-0.02, 0.03, 1.10]])
    body = fb.RigidBody(mass=12.5, com=[0.12, -0.05, 0.08], inertia_about_com=inertia)
    model = fb.Model(body, forces=[fb.UniformGravity()])
    x = model.state(
        attitude=fb.Attitude.angles("zyx", [0.5, -0.2, 0.3]), angular_velocity_body=[0.1, 2.0, 0.1]
    )
    u, out = np.zeros(6), np.empty_like(x)

    print(f"{len(x)} states, {len(model.input_names)} inputs, uniform gravity; from Python, one thread")
    print(f"derivative                {nanoseconds(lambda: model.derivative(0.0, x, u), 100_000):8.0f} ns")
    print(
        f"derivative into an array  {nanoseconds(lambda: model.derivative(0.0, x, u, out), 100_000):8.0f} ns"
    )
    print(f"jacobian                  {nanoseconds(lambda: model.jacobian(0.0, x, u), 20_000):8.0f} ns")

    run = model.simulate(x, (0.0, 1000.0), rtol=1e-9, save_every=1000.0)
    each = nanoseconds(lambda: model.simulate(x, (0.0, 1000.0), rtol=1e-9, save_every=1000.0), 1)
    print(f"dop853, an evaluation     {each / run.evaluations:8.0f} ns, the method's own work included")


if __name__ == "__main__":
    main()
