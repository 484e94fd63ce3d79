"""The motion does not depend on where the body frame sits: one body, two descriptions, one path."""

import numpy as np

import freebody as fb

body = fb.RigidBody(12.5, [0.12, -0.05, 0.08], inertia_about_com=np.diag([0.42, 0.91, 1.10]))
origin = np.array([2.0, -3.0, 1.0])  # of the other frame, metres away from the body
turn = fb.Attitude.angles("zxz", [0.4, 1.1, -0.7]).as_rotation()  # first axes from its axes
other = body.in_frame(origin, turn)

gravity = fb.UniformGravity(9.81)
velocity, spin = np.array([5.0, 0.5, -0.3]), np.array([0.8, -1.1, 1.7])

first = fb.Model(body, [gravity])
start = first.state(velocity_body=velocity, angular_velocity_body=spin)
run = first.simulate(start, (0.0, 10.0), rtol=1e-12, save_every=0.1)

second = fb.Model(other, [gravity])
start = second.state(
    position=origin,
    attitude=fb.Attitude.rotation(turn),
    velocity_body=turn.T @ (velocity + np.cross(spin, origin)),
    angular_velocity_body=turn.T @ spin,
)
same = second.simulate(start, (0.0, 10.0), rtol=1e-12, save_every=0.1)

point = np.array([0.3, 0.1, -0.2])  # of the body, in the first frame
gap = run.point(point) - same.point(turn.T @ (point - origin))
print(f"a point's two paths differ by {np.abs(gap).max():.1e} m over {np.ptp(run.point(point)):.0f} m")
assert np.abs(gap).max() < 1e-9 * np.ptp(run.point(point))
