"""A body thrown off a tower that bounces, losing half of its upward speed each time."""

import numpy as np

import freebody as fb


@fb.event(direction="rising")
def ground(s):
    return s.position_world[2]  # the third axis points down


@fb.output(unit="m", take="max")
def height(s):
    return -s.position_world[2]


body = fb.RigidBody(0.5, inertia_about_com=np.diag([1e-3, 2e-3, 2e-3]))
model = fb.Model(body, [fb.UniformGravity(10.0)])
x, t, heights = model.state([0.0, 0.0, -5.0], velocity_world=[3.0, 0.0, 0.0]), 0.0, []
for _ in range(5):
    run = model.simulate(x, (t, t + 60.0), events=[ground], outputs=[height])
    t = run.outcome.time
    heights.append(run.outputs["height"])
    print(f"highest {heights[-1]:.4f} m, on the ground at {t:.4f} s, {run.position_world[-1, 0]:.4f} m")
    vx, vy, vz = run.velocity_world[-1]
    x = model.state(run.position_world[-1], velocity_world=[vx, vy, -0.5 * vz])

assert np.allclose(heights, 5.0 * 0.25 ** np.arange(5), rtol=1e-9)
assert np.isclose(t, 1.0 + 1.0 + 0.5 + 0.25 + 0.125, rtol=1e-9)
