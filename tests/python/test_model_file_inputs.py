"""[inputs] of model files: constants and tables over time, by name and with units."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.model_file import LoadedModel

HEAD = """
[model]
name = "pushed"
[body]
mass = 2.0
inertia_about_com = { principal = [1.0, 1.0, 1.0] }
[[forces]]
type = "input_wrench"
[simulation]
end = 3.0
"""


def loaded(tmp_path: Path, inputs: str) -> LoadedModel:
    path = tmp_path / "pushed.toml"
    path.write_text(HEAD + "[inputs]\n" + inputs)
    return fb.load(path)


def test_constants_have_units_and_names(tmp_path):
    model = loaded(tmp_path, 'force_y = "2 kN"\nmoment_z = 3.0')
    assert model.options["inputs"].tolist() == [0.0, 2000.0, 0.0, 0.0, 0.0, 3.0]


def test_impulse_of_tables_is_the_momentum_gained(tmp_path):
    # A triangle of 4 N s and a step of 1 N for two of three seconds; both are integrated piece by piece, so
    # that only rounding is left.
    table = """
    force_x = { times = [0.0, 1.0, 2.0], values = [0.0, 4.0, 0.0] }
    force_y = { times = [0.0, 1.0], values = [0.0, 1.0], interpolation = "hold" }
    """
    run = loaded(tmp_path, table).simulate()
    np.testing.assert_allclose(run.velocity_world[-1], [2.0, 1.0, 0.0], rtol=0.0, atol=1e-12)


def test_jump_is_kept(tmp_path):
    run = loaded(tmp_path, 'force_x = { times = [1.0, 1.0], values = ["-1 N", "1 N"] }').simulate()
    assert run.velocity_world[-1, 0] == pytest.approx(0.5, abs=1e-12)


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ("force_w = 1.0", ("inputs.force_w", "did you mean 'force_")),
        ('force_x = "1 m"', ("inputs.force_x", "force (N)")),
        ("force_x = { times = [0.0, 1.0], values = [1.0] }", ("inputs.force_x", "as many values as times")),
        ("force_x = { times = [0.0], value = [1.0] }", ("inputs.force_x.value", "did you mean 'values'")),
        ("force_x = { values = [1.0] }", ("inputs.force_x", "times is missing")),
        ("force_x = { times = [1.0, 0.0], values = [1.0, 2.0] }", ("inputs.force_x.times", "must rise")),
        (
            'force_x = { times = [0.0], values = [1.0], interpolation = "cubic" }',
            ("inputs.force_x.interpolation", "cubic"),
        ),
    ],
)
def test_wrong_inputs_are_told_with_their_key(tmp_path, inputs, words):
    with pytest.raises(fb.ModelFileError) as error:
        loaded(tmp_path, inputs)
    for word in words:
        assert word in str(error.value)


def test_ensembles_have_the_inputs_of_the_file(tmp_path):
    dispersed = '[dispersions.mass]\nkind = "uniform"\nlow = 1.0\nhigh = 3.0'
    file = loaded(tmp_path, 'force_x = "1 N"\n' + dispersed)
    ensemble = file.ensemble(3)
    runs = ensemble.run(file.t_span)
    masses = [ensemble.model(r).body.mass for r in range(3)]
    np.testing.assert_allclose(runs.chunk["final_state"][:, 7], 3.0 / np.array(masses), rtol=1e-12)
