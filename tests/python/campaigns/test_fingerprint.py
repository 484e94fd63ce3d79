"""Two objects have one fingerprint when they are made of the same things, in whatever process."""

import pickle
import subprocess
import sys

import numpy as np
import pytest

import freebody as fb
from freebody.campaigns.fingerprint import fingerprint


def spring(k, doc="A spring."):
    def law(s, p):
        return fb.wrench(force=-p.k * s.position_world)

    law.__doc__ = doc
    return fb.force(parameters={"k": (k, "N/m")})(law)


def model(*forces, mass=2.0):
    return fb.Model(fb.RigidBody(mass, inertia_about_com=np.eye(3)), forces)


@pytest.mark.parametrize(
    "thing",
    [model(fb.UniformGravity(), spring(2.0)), fb.Table([0.0, 1.0], [2.0, 3.0]), {"a": (1, 2.5, None)}],
)
def test_a_copy_has_the_same(thing):
    assert fingerprint(pickle.loads(pickle.dumps(thing))) == fingerprint(thing)


@pytest.mark.parametrize(
    "other",
    [
        model(spring(2.0 + 1e-15)),
        model(spring(2.0), mass=2.1),
        model(spring(2.0), spring(2.0)(name="b")),
        model(),
    ],
)
def test_whatever_changes_a_number_changes_it(other):
    assert fingerprint(other) != fingerprint(model(spring(2.0)))


def test_a_docstring_does_not():
    assert fingerprint(model(spring(2.0, "Another."))) == fingerprint(model(spring(2.0)))


def test_another_process_finds_the_same():
    """Hashes of strings differ between processes; and what is one object here may be two there."""
    code = "import numpy as np; from freebody.campaigns.fingerprint import fingerprint as f; "
    code += "print(f({'x': [1.5, 'ab', {'q', 'r', 's'}], 'y': np.arange(3)}))"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert told.strip() == fingerprint({"x": [1.5, "ab", {"q", "r", "s"}], "y": np.arange(3)})
