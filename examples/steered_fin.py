"""A force law and a control law of one's own: a fin with a servo, steered against yaw."""

import numpy as np

import freebody as fb


@fb.force(
    parameters={
        "density": (1.225, "kg/m^3"),
        "area": (0.02, "m^2"),
        "slope": (5.0, "1"),
        "arm": (1.0, "m"),
        "lag": (0.05, "s"),
    },
    inputs={"rudder": "rad"},
    states={"servo": (0.0, "rad")},
)
def fin(s, p):
    at = np.stack([-p.arm, 0.0, 0.0])
    v = s.velocity_body + np.cross(s.angular_velocity_body, at)
    angle = np.arctan2(v[1], v[0]) + s.states.servo
    lift = 0.5 * p.density * p.area * p.slope * (v @ v) * angle
    return fb.wrench(force=[0.0, -lift, 0.0], at=at), {"servo": (s.inputs.rudder - s.states.servo) / p.lag}


@fb.control(parameters={"gain": (0.4, "s")}, inputs={"yaw_rate": "rad/s"})
def yaw_damper(s, p):
    return {"rudder": np.clip(p.gain * (s.inputs.yaw_rate - s.angular_velocity_body[2]), -0.35, 0.35)}


body = fb.RigidBody(12.5, [0.05, 0.0, 0.02], inertia_about_com=np.diag([0.4, 2.9, 3.1]))
free = fb.Model(body, [fin])
steered = fb.Model(body, [fin], control=yaw_damper)
cruise, gust = [30.0, 0.0, 0.0], [30.0, 1.0, 0.0]  # m/s, the second from the side


def slowest_mode(model: fb.Model) -> float:
    """How fast the slowest mode about level cruise that moves at all dies, 1/s."""
    A, _ = model.jacobian(0.0, model.state(velocity_body=cruise))
    rates = np.linalg.eigvals(A)
    return -rates[np.abs(rates) > 1e-6].real.max()


print(f"the slowest mode dies with {slowest_mode(free):.2f} /s free, {slowest_mode(steered):.2f} /s steered")
assert slowest_mode(steered) > 3.0 * slowest_mode(free) > 0.0

last = {}
for model in (free, steered):
    run = model.simulate(model.state(velocity_body=gust), (0.0, 2.0), rtol=1e-10)
    assert run.ok
    last[model] = abs(run.angular_velocity_body[-1, 2])
    print(f"yaw rate after 2 s: {last[model]:.1e} rad/s; the servo at {run.states['fin.servo'][-1]:.1e} rad")
assert last[steered] < 0.1 * last[free]

# The same model in scalar form has the same Jacobian.
x = steered.state(velocity_body=gust)
A, B = steered.jacobian(0.0, x, [0.1])
printed = fb.equations("3.2", model=steered).jacobian("x").evaluate(t=0.0, x=x, u=[0.1])["jacobian"]
assert np.abs(printed - A).max() < 1e-12
assert B.shape == (14, 1)
