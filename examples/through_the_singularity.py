"""Yaw, pitch, roll driven through a pitch of 90 deg: the run changes its chart, goes on, and says so."""

import numpy as np

import freebody as fb

body = fb.RigidBody(2.0, inertia_about_com=np.diag([1.0, 2.0, 2.5]))
model = fb.Model(body, attitude="zyx")
start = model.state(angular_velocity_body=[0.0, 1.0, 0.0])
run = model.simulate(start, (0.0, 3.0), rtol=1e-10, save_every=0.5)

for change in run.chart_changes:
    left = f"{np.rad2deg(change.distance):.1f} deg from the singularity"
    print(f"{change.time:.2f} s: {change.from_chart} to {change.to_chart}, {left}")
for t, (yaw, pitch, roll) in zip(run.t, np.rad2deg(run.angles()), strict=True):
    print(f"{t:.1f} s: yaw {yaw:6.1f}, pitch {pitch:6.1f}, roll {roll:6.1f} deg")

assert run.ok
assert len(run.chart_changes) == 2
assert np.allclose(run.angles(), np.outer(run.t, [0.0, 1.0, 0.0]), atol=1e-8)
