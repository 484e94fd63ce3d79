"""Where a capsule comes down: 2000 falls that differ in release, mass properties and drag."""

import numpy as np

import freebody as fb


@fb.force(parameters={"drag_area": (0.4, "m^2"), "arm": (0.15, "m")})
def drag(s, p):
    """Drag that grows thin with height, and acts behind the body's origin."""
    v = s.velocity_body
    density = 1.225 * np.exp(s.position_world[2] / 8500.0)  # the third axis points down
    return fb.wrench(
        force=-0.5 * density * p.drag_area * np.linalg.norm(v) * v, at=np.stack([-p.arm, 0.0, 0.0])
    )


@fb.event(direction="rising")
def ground(s):
    return s.position_world[2]


@fb.output(unit="m")
def downrange(s):
    return s.position_world[0]


@fb.output(unit="m")
def crossrange(s):
    return s.position_world[1]


body = fb.RigidBody(80.0, com=[0.05, 0.0, 0.0], inertia_about_com=np.diag([6.0, 9.0, 9.5]), name="capsule")
model = fb.Model(body, [fb.UniformGravity(), drag, fb.LinearDamping([0, 0, 0, 2, 6, 6], name="spin damping")])
release = model.state(position=[0.0, 0.0, -3000.0], velocity_world=[80.0, 0.0, 0.0])

ensemble = model.ensemble(
    release,
    {
        "position": fb.Offset(fb.Normal(0.0, [20.0, 20.0, 10.0])),
        "velocity_world": fb.MultivariateNormal([80.0, 0.0, 0.0], np.diag([2.0, 2.0, 1.0]) ** 2),
        "attitude": fb.Normal(0.0, 0.05),
        "mass": fb.TruncatedNormal(80.0, 2.0, 70.0, 90.0),
        "com": fb.Offset(fb.Normal(0.0, 0.002)),
        "second_moments": fb.Factor(fb.Uniform(0.9, 1.1)),
        "drag.drag_area": fb.Factor(fb.LogNormal(1.0, 0.05)),
    },
    n=2000,
    seed=7,
    events=[ground],
    outputs=[downrange, crossrange],
)
runs = ensemble.run((0.0, 120.0), rtol=1e-8)
print(runs)

impacts = np.column_stack([runs.outputs["downrange"], runs.outputs["crossrange"]])
mean, covariance = impacts.mean(axis=0), np.cov(impacts.T)
along, across = np.sqrt(np.linalg.eigvalsh(covariance))[::-1]
print(f"impact at {mean[0]:.0f} m +- {along:.0f} m along and {across:.0f} m across the flight")

# Every fall ends on the ground, half of them within the ellipse that holds half of a normal distribution.
assert (runs.status == "event").all()
assert np.abs(runs.final[:, 2]).max() < 1e-6
away = impacts - mean
inside = np.einsum("ni,ij,nj->n", away, np.linalg.inv(covariance), away) < 2.0 * np.log(2.0)
assert abs(inside.mean() - 0.5) < 0.05

# What decides how far it flies: heavy capsules fly farther, those with more drag less far.
column = {name: runs.dispersed[:, i] for i, name in enumerate(runs.names)}
assert np.corrcoef(column["mass"], impacts[:, 0])[0, 1] > 0.1
assert np.corrcoef(column["drag.drag_area"], impacts[:, 0])[0, 1] < -0.3

# The farthest one, alone: the same bits, and a trajectory to look at.
farthest = int(impacts[:, 0].argmax())
alone = runs.trajectory(farthest, save_every=0.5)
assert (alone.outcome.state == runs.final[farthest]).all()
print(f"the farthest: run {farthest}, {alone.model.body.mass:.1f} kg, after {alone.outcome.time:.1f} s")
