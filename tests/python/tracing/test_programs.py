"""Programs as data that travels."""

import pickle
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody import _core

LAW = fb.Table([0.0, 1.0, 3.0], [0.0, 2.0, 1.0], "cubic")


@fb.force(parameters={"k": (2.0, "N")}, inputs={"flap": "rad"})
def wing(s, p):
    v = s.velocity_body
    return fb.wrench(force=np.stack([0.0, -p.k * np.sin(np.arctan2(v[1], v[0])), LAW(v[0]) * s.inputs.flap]))


def test_bytes_that_are_no_program_are_refused() -> None:
    with pytest.raises(fb.InputError, match="these bytes are no program"):
        _core.Program.from_bytes(b"no program")


def test_damaged_bytes_are_refused() -> None:
    program = wing._program
    reduced: Any = program.__reduce__()
    data: bytes = reduced[1][0]
    given = np.ones((1, program.given_count))
    for place in range(len(data)):
        damaged = bytearray(data)
        damaged[place] ^= 1 << place % 8
        with pytest.raises(fb.InputError, match="these bytes are no program"):
            _core.Program.from_bytes(bytes(damaged))
    with pytest.raises(fb.InputError, match="these bytes are no program"):
        _core.Program.from_bytes(data[:-1])
    assert np.array_equal(program.run([2.0], given), pickle.loads(pickle.dumps(program)).run([2.0], given))


def test_a_law_with_too_many_inputs_is_refused() -> None:
    names = {f"u{i}": "N" for i in range(80)}

    @fb.force(inputs=names)
    def many(s):
        return fb.wrench(force=np.stack([s.inputs[name] for name in list(names)[:3]]))

    with pytest.raises(fb.InputError, match="80 inputs and 0 states has no room"):
        fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [many])
