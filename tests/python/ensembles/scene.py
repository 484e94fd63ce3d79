"""A model in which everything can be dispersed, and dispersions of all of it."""

from typing import Any

import numpy as np

import freebody as fb


@fb.force(
    parameters={"slope": (5.0, "N s/m"), "lag": (0.2, "s")},
    inputs={"rudder": "rad"},
    states={"servo": (0.1, "rad")},
)
def fin(s, p):
    side = p.slope * s.velocity_body[1] + 3.0 * s.states.servo
    return fb.wrench(force=np.stack([0.0, -side, 0.0])), {"servo": (s.inputs.rudder - s.states.servo) / p.lag}


@fb.control(parameters={"gain": (0.4, "s")}, inputs={"yaw_rate": "rad/s"})
def damper(s, p):
    return {"rudder": p.gain * (s.inputs.yaw_rate - s.angular_velocity_body[2])}


BODY = fb.RigidBody(
    12.5,
    [0.12, -0.05, 0.08],
    inertia_about_com=[[1.2, 0.05, -0.02], [0.05, 1.9, 0.04], [-0.02, 0.04, 2.4]],
    name="case",
)
ATTITUDE = fb.Attitude.angles("zyx", [0.5, -0.2, 0.3])
DRAG = [[2.0 + i + 0.1 * j if i == j else 0.01 * (6 * i + j) for j in range(6)] for i in range(6)]


def model(attitude: str = "quaternion", form: Any = "quasi_velocity") -> fb.Model:
    """A model with every kind of force that has parameters, a law of its own and a control law."""
    forces = [
        fb.UniformGravity(9.81, [0.1, 0.2, 1.0]),
        fb.LinearDamping(DRAG, name="drag"),
        fin,
        fb.ConstantWrench([3.0, -1.0, 2.0], [0.4, -0.3, 0.2], at=[0.1, 0.0, 0.0], name="push"),
        fb.QuadraticDamping([0.2, 0.3, 0.4, 0.01, 0.02, 0.03], name="square"),
        fb.TabulatedWrench(
            [0.0, 1.0], [[0.0, 0.1, 0.2], [0.3, 0.4, 0.5]], at=[0.0, 0.2, 0.0], name="thruster"
        ),
        fb.PointMassGravity(50.0, [10.0, 20.0, 30.0], name="moon"),
    ]
    return fb.Model(BODY, forces, attitude, form, control=damper, name="everything")


def state(of: fb.Model) -> np.ndarray:
    """A motion of it."""
    return of.state(
        [1.0, 2.0, 3.0],
        ATTITUDE,
        velocity_body=[5.0, 0.5, -0.3],
        angular_velocity_body=[0.8, -1.1, 1.7],
        states={"fin.servo": 0.05},
    )


def dispersions() -> dict[str, Any]:
    """Distributions for every quantity of the model that can be dispersed beside the others."""
    return {
        "position": fb.Offset(fb.Uniform(-1.0, [1.0, 2.0, 3.0])),
        "velocity_world": fb.MultivariateNormal(
            [5.0, 1.0, 0.0], [[0.2, 0.1, 0.0], [0.1, 0.2, 0.0], [0.0, 0.0, 0.0]]
        ),
        "angular_velocity_body": fb.Factor(fb.LogNormal(1.0, 0.1)),
        "attitude": fb.Normal(0.0, 0.1),
        "fin.servo": fb.Uniform(-0.1, 0.1),
        "yaw_rate": fb.Discrete([0.0, 0.1], weights=[3.0, 1.0]),
        "mass": fb.TruncatedNormal(12.5, 1.0, 10.0, 15.0),
        "com": fb.Offset(fb.Normal(0.0, 0.01)),
        "inertia": fb.Uniform(0.9, 1.1),
        "second_moments": fb.Factor(fb.Uniform(0.9, 1.1)),
        "principal_axes": fb.Normal(0.0, 0.05),
        "UniformGravity.acceleration": fb.Normal(9.81, 0.01),
        "drag.coefficients": fb.Factor(fb.Uniform(0.9, 1.1)),
        "fin.slope": fb.Uniform(4.0, 6.0),
        "push.force": fb.Normal([3.0, -1.0, 2.0], [0.1, 0.2, 0.3]),
        "push.at": fb.Offset(fb.Normal(0.0, 0.01)),
        "square.coefficients": fb.Factor(fb.Uniform(0.9, 1.1)),
        "thruster.at": fb.Offset(fb.Normal(0.0, 0.01)),
        "moon.mu": fb.LogNormal(50.0, 0.1),
        "moon.center": fb.Discrete([[10.0, 20.0, 30.0], [11.0, 20.0, 30.0]]),
        "damper.gain": fb.Samples(np.linspace(0.3, 0.5, 2000)),
    }


def everything(
    n: int = 500, sampling: Any = "random", attitude: str = "quaternion", form: Any = "quasi_velocity"
) -> fb.Ensemble:
    """An ensemble in which all of it is dispersed."""
    base = model(attitude, form)
    return base.ensemble(state(base), dispersions(), n=n, seed=7, sampling=sampling)
