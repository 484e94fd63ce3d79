"""A quick campaign, and what a store is to the last bit."""

from pathlib import Path

import numpy as np

import freebody as fb

SPAN = (0.0, 2.0)
CHUNK = 25


def ensemble(n, **given):
    body = fb.RigidBody(12.5, com=[0.12, -0.05, 0.08], inertia_about_com=np.diag([1.2, 1.9, 2.4]))
    model = fb.Model(body, [fb.UniformGravity(), fb.LinearDamping([2.0, 3.0, 4.0, 0.5, 0.6, 0.7])])
    x0 = model.state(velocity_body=[5.0, 0.5, -0.3], angular_velocity_body=[0.8, -1.1, 1.7])
    dispersions = {
        "velocity_body": fb.Offset(fb.Normal(0.0, 0.5)),
        "mass": fb.Uniform(11.0, 14.0),
        "LinearDamping.coefficients": fb.Factor(fb.LogNormal(1.0, 0.05)),
    }
    return model.ensemble(x0, dispersions, **{"n": n, "seed": 7, **given})


def campaign(path, n, *, chunk=CHUNK, **options):
    return ensemble(n).campaign(path, SPAN, **{"rtol": 1e-6, "chunk": chunk, "threads": 1, **options})


def tree(folder):
    """The bytes of every file."""
    files = [path for path in Path(folder).rglob("*") if path.is_file()]
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}
