"""DAVE-ML files in model files."""

from __future__ import annotations

import shutil

import numpy as np
import pytest

from freebody.dave_ml import DaveAerodynamics, load_dave_ml
from freebody.environment import Environment
from freebody.errors import ModelFileError
from freebody.model_file.context import Context
from freebody.model_file.dave_ml_schema import SECTIONS, DaveBody
from freebody.model_file.problems import Source
from laws.scenes import BODY
from python.dave_ml.files import DART
from python.dave_ml.test_mass_properties import LINES, write


def source(folder):
    return Source(
        folder / "model.toml", {}, {"forces": 4, "forces[0]": 5, "forces[0].file": 6, "body.file": 2}
    )


def element(folder, **table):
    (section,) = SECTIONS
    shutil.copy(DART, folder / "dart.dml")
    spec = section.model_validate({"type": "dave_ml", "file": "dart.dml", **table})
    return spec.element(Context(BODY, Environment(), source(folder), "forces[0]"))


def test_every_key_reaches_the_element(tmp_path):
    turn = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    law = element(
        tmp_path,
        name="dart",
        mapping={"lag": "wake", "gust": 0.0, "damped": 1.0},
        leave_out=["Cl"],
        reference_point="[1, 2, 3] m",
        flow_point=[0.1, 0.2, 0.3],
        body_from_aero=turn,
        lift_drag_axes="stability",
        reference_area="2 m^2",
        reference_span="3 m",
        reference_chord=1.5,
        constants=["Cmq"],
    )
    wanted = DaveAerodynamics(
        Environment(),
        load_dave_ml(DART),
        {"lag": "wake", "gust": 0.0, "damped": 1.0, "Cl": None},
        [1.0, 2.0, 3.0],
        flow_point=[0.1, 0.2, 0.3],
        body_from_aero=turn,
        lift_drag_axes="stability",
        reference_area=2.0,
        reference_span=3.0,
        reference_chord=1.5,
        constants=["Cmq"],
        name="dart",
    )
    assert law == wanted
    assert element(tmp_path) == DaveAerodynamics(Environment(), load_dave_ml(DART))


def test_a_body_of_a_file(tmp_path):
    path = write(tmp_path, "\n".join(LINES))
    spec = DaveBody.model_validate(
        {"file": path.name, "values": {"fuel": 3.0}, "reference_point": "[1, 0, 0] m", "name": "craft"}
    )
    body = spec.body(source(tmp_path), "body")
    wanted = load_dave_ml(path).rigid_body({"fuel": 3.0}, reference_point=[1.0, 0.0, 0.0])
    assert body.name == "craft"
    np.testing.assert_array_equal(body.spatial_inertia, wanted.spatial_inertia)


def test_faults_name_the_key_and_the_line_in_the_other_file(tmp_path):
    with pytest.raises(
        ModelFileError, match=r"model\.toml:6: forces\[0\]\.file: there is no file .*none\.dml"
    ):
        element(tmp_path, file="none.dml")
    write(tmp_path, "<nothing/>")
    with pytest.raises(
        ModelFileError, match=r"model\.toml:6: forces\[0\]\.file: .*model\.dml:2: has no <variableDef>"
    ):
        element(tmp_path, file="model.dml")
    with pytest.raises(ModelFileError, match=r"model\.toml:2: body\.file: there is no file"):
        DaveBody.model_validate({"file": "none.dml"}).body(source(tmp_path), "body")
