"""Exact Jacobians at work: a regulator that brings a tumbling body to rest at the origin."""

import numpy as np
from scipy.linalg import solve_continuous_are

import freebody as fb

body = fb.RigidBody(12.5, [0.12, -0.05, 0.08], inertia_about_com=np.diag([0.42, 0.91, 1.10]))
model = fb.Model(body, attitude="zyx")
A, B = model.jacobian(0.0, model.state())  # 12 states, the wrench on the body as six inputs
weight = np.eye(12)
gain = B.T @ solve_continuous_are(A, B, weight, np.eye(6))

x = model.state(
    position=[1.0, -0.5, 0.8],
    attitude=fb.Attitude.angles("zyx", [0.3, -0.2, 0.4]),
    angular_velocity_body=[0.2, -0.1, 0.3],
)
print(f"start: {np.linalg.norm(x):.2f}")
for k in range(2000):  # a sampled controller: the wrench holds for 20 ms
    x = model.simulate(x, (0.02 * k, 0.02 * (k + 1)), inputs=-gain @ x).x[-1]
print(f"after 40 s: {np.linalg.norm(x):.1e}")

assert np.linalg.eigvals(A - B @ gain).real.max() < 0.0
assert np.linalg.norm(x) < 1e-3
