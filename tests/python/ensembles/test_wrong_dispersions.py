"""Wrong distributions, quantities and samplings: errors that name the field and what to do."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb

from .scene import fin, model, state

MODEL = model()
X = state(MODEL)


def ensemble(dispersions: Any = None, **options: Any) -> object:
    given = {"mass": fb.Uniform(11.0, 14.0)} if dispersions is None else dispersions
    arguments: dict[str, Any] = {"n": 10, **options}
    return MODEL.ensemble(X, given, **arguments)


WRONG: dict[str, tuple[Callable[[], object], str]] = {
    "sd": (lambda: fb.Normal(1.0, 0.0), "sd: got 0.0; it must be positive; leave out what is not dispersed"),
    "text": (
        lambda: fb.Normal("1", 1.0),  # type: ignore[arg-type]
        "mean: got '1' of dtype <U1; give real numbers of shape ()",
    ),
    "matrix": (
        lambda: fb.Normal(np.eye(2), 1.0),
        "mean: got shape (2, 2); give one number, or a vector (k,)",
    ),
    "nan": (lambda: fb.Normal(np.nan, 1.0), "mean: got nan; every number must be finite"),
    "lengths": (
        lambda: fb.Normal([1.0, 2.0], [1.0, 2.0, 3.0]),
        "Normal: got mean (2,) and sd (3,); give vectors of one length, or numbers",
    ),
    "order": (lambda: fb.Uniform(2.0, 1.0), "low, high: got 2.0 and 1.0; low must lie below high"),
    "endless": (lambda: fb.Uniform(0.0, np.inf), "high: got inf; every number must be finite"),
    "median": (lambda: fb.LogNormal(-1.0, 0.1), "median: got -1.0; it must be positive"),
    "asymmetric": (
        lambda: fb.MultivariateNormal([0, 0], [[1, 0], [1, 1]]),
        "covariance: it is not symmetric",
    ),
    "negative": (
        lambda: fb.MultivariateNormal([0, 0], [[1, 2], [2, 1]]),
        "covariance: its least eigenvalue is -1; no numbers have a negative variance",
    ),
    "weights": (lambda: fb.Discrete([1, 2], [1, -1]), "weights: got [1, -1]; none may be negative"),
    "nested": (lambda: fb.Offset(fb.Factor(fb.Normal(0, 1))), "distribution: got Factor("),  # type: ignore[arg-type]
    "nothing": (
        lambda: ensemble({}),
        "dispersions: got {}; give a dictionary of quantities and distributions",
    ),
    "unknown": (lambda: ensemble({"mas": fb.Normal(0, 1)}), "dispersions: got 'mas'; did you mean 'mass'?"),
    "unknown parameter": (
        lambda: ensemble({"fin.slop": fb.Normal(0, 1)}),
        "dispersions: got 'fin.slop'; did you mean 'fin.slope'?",
    ),
    "no distribution": (
        lambda: ensemble({"mass": 12.0}),
        "dispersions['mass']: got 12.0; give a distribution, such as fb.Normal(mean, sd), or one in fb.",
    ),
    "size": (
        lambda: ensemble({"com": fb.Normal([0, 0], 1)}),
        "dispersions['com']: got a distribution of 2 numbers; the quantity has 3: com_x, com_y, com_z",
    ),
    "both axes": (
        lambda: ensemble({"velocity_body": fb.Normal(0, 1), "velocity_world": fb.Normal(0, 1)}),
        "dispersions: 'velocity_body' and 'velocity_world' describe the same; give one of them",
    ),
    "two bodies": (
        lambda: ensemble({"mass": fb.Uniform(1, 2), "log_cholesky": fb.Normal(0, 0.1)}),
        "dispersions: 'log_cholesky' and 'mass' describe the same; give one of them",
    ),
    "mass": (
        lambda: ensemble({"mass": fb.Normal(12.0, 3.0)}),
        "dispersions['mass']: mass can become -12.6286 kg, and it must be positive; use fb.TruncatedNormal "
        "or fb.Uniform with a positive low, or fb.LogNormal",
    ),
    "mass by a factor": (
        lambda: ensemble({"mass": fb.Factor(fb.Uniform(-0.1, 1.0))}),
        "mass can become -1.25 kg, and it must be positive",
    ),
    "inertia": (lambda: ensemble({"inertia": fb.Uniform(-1, 1)}), "inertia can become -1 1, and it must be"),
    "moments": (
        lambda: ensemble({"second_moments": fb.Offset(fb.Normal(0, 1))}),
        "dispersions['second_moments']: second_moments_z can become",
    ),
    "discrete": (
        lambda: ensemble({"mass": fb.Discrete([1, 0])}),
        "mass can become 0 kg, and it must be positive; leave out the values that are not",
    ),
    "mu": (lambda: ensemble({"moon.mu": fb.Normal(0, 1)}), "moon.mu can become -8.20954 m^3/s^2"),
    "overflow": (
        lambda: ensemble({"position": fb.LogNormal(1.0, 1e3)}),
        "dispersions['position']: position_x can leave the range of doubles; give a narrower one",
    ),
    "factor of zero": (
        lambda: ensemble({"yaw_rate": fb.Factor(fb.Uniform(1, 2))}),
        "dispersions['yaw_rate']: the nominal value is zero, whatever the factor; use fb.Offset",
    ),
    "factor of an attitude": (
        lambda: ensemble({"attitude": fb.Factor(fb.Uniform(1, 2))}),
        "dispersions['attitude']: draws are added to what is nominal already, a factor has nothing to",
    ),
    "rows": (
        lambda: ensemble({"mass": fb.Samples([1.0, 2.0])}),
        "dispersions['mass']: it has values for 2 runs, n is 10; give n of up to 2",
    ),
    "rows exchanged": (
        lambda: ensemble({"mass": fb.Samples(np.ones(10))}, sampling="saltelli"),
        "dispersions['mass']: values that are given cannot be exchanged, as saltelli sampling does",
    ),
    "groups": (
        lambda: ensemble({"com": fb.Normal(0, 1)}, n=12, sampling="saltelli"),
        "n: got 12; saltelli sampling of 3 independent factors takes groups of 5 runs: give 10 or 15, best 5",
    ),
    "sampling": (
        lambda: ensemble(sampling="halton"),
        "sampling: got 'halton'; allowed are 'random', 'latin_hypercube', 'sobol', 'saltelli'",
    ),
    "n": (lambda: ensemble(n=0), "n: got 0; give a whole number from 1 to 2^53"),
    "seed": (lambda: ensemble(seed=-1), "seed: got -1; give a whole number from 0 to 2^64 - 1"),
    "seed of parts": (lambda: ensemble(seed=1.5), "seed: got 1.5; give a whole number from 0 to 2^64 - 1"),
    "seed true": (lambda: ensemble(seed=True), "seed: got True; give a whole number from 0 to 2^64 - 1"),
    "x0": (lambda: MODEL.ensemble(X[:3], {"mass": fb.Uniform(1, 2)}, n=1), "x0: got shape (3,)"),
    "inputs": (lambda: ensemble(inputs=[1.0, 2.0]), "inputs: got shape (2,); allowed is (1,)"),
    "run": (
        lambda: MODEL.ensemble(X, {"mass": fb.Uniform(1, 2)}, n=3).model(3),
        "r: got 3; the ensemble has runs",
    ),
}


@pytest.mark.parametrize(("call", "message"), WRONG.values(), ids=WRONG)
def test_what_is_wrong_is_said(call: Callable[[], object], message: str):
    with pytest.raises(fb.InputError) as caught:
        call()
    assert message in str(caught.value)


def test_two_forces_of_one_name_cannot_be_told_apart():
    twins = fb.Model(MODEL.body, [fin, fb.LinearDamping(np.ones(6)), fb.LinearDamping(np.ones(6))])
    with pytest.raises(fb.InputError) as caught:
        twins.ensemble(twins.state(), {"LinearDamping.coefficients": fb.Uniform(1.0, 2.0)}, n=2)
    assert "it belongs to forces[1] and to forces[2]; give each law its own name" in str(caught.value)
    twins.ensemble(twins.state(), {"fin.slope": fb.Uniform(1.0, 2.0)}, n=2)


def test_a_flat_body_says_what_to_disperse_instead():
    disc = fb.RigidBody(1.0, inertia_about_com=np.diag([1.0, 1.0, 2.0]))
    flat = fb.Model(disc)
    with pytest.raises(fb.InputError, match="flat or a rod: disperse 'inertia' and 'principal_axes' instead"):
        flat.ensemble(flat.state(), {"second_moments": fb.Factor(fb.Uniform(0.9, 1.1))}, n=2)
    with pytest.raises(fb.InputError, match="flat or a rod"):
        flat.ensemble(flat.state(), {"log_cholesky": fb.Normal(0.0, 0.1)}, n=2)


def test_a_factor_is_refused_where_a_table_gives_the_inputs():
    table = fb.InputTable([0.0, 1.0], [[0.1], [0.2]])
    with pytest.raises(fb.InputError, match="draws are added to what is nominal already"):
        ensemble({"yaw_rate": fb.Factor(fb.Uniform(0.9, 1.1))}, inputs=table)


def test_files_that_cannot_be_read(tmp_path: Path):
    file = tmp_path / "flights.csv"
    with pytest.raises(fb.InputError, match=r"path: cannot read .*flights.csv: No such file"):
        fb.FromFile(file, "mass")
    file.write_text("mass,thrust\n1,2\n3,x\n")
    with pytest.raises(
        fb.InputError, match=r"columns: .* has no 'mas'; it has 'mass', 'thrust', did you mean 'mass'"
    ):
        fb.FromFile(file, ["mas"])
    with pytest.raises(fb.InputError, match=r"flights.csv:3: thrust: got 'x'; give a number"):
        fb.FromFile(file, ["mass", "thrust"])
    file.write_text("mass\n")
    with pytest.raises(fb.InputError, match=r"flights.csv.* no rows"):
        fb.FromFile(file, "mass")
