"""Aerodynamics in model files: the same laws as in Python, and errors that name their key."""

from __future__ import annotations

from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest

import freebody as fb
from freebody import _core
from freebody.elements import Aerodynamics, Drag, Lookup
from freebody.environment import Environment
from freebody.model_file.aerodynamics_schema import SECTIONS
from freebody.model_file.context import Context
from freebody.model_file.problems import Source
from freebody.vehicles import f16, f16_tables

BODY = fb.RigidBody(10.0, inertia_about_com=np.eye(3))
KINDS = {get_args(section.model_fields["type"].annotation)[0]: section for section in SECTIONS}


def built(text: str, folder: Path = Path()) -> Any:
    """The first of [[forces]] of a text."""
    data, lines = _core.toml_parse(text)
    source = Source(folder / "model.toml", data, lines)
    section = KINDS[data["forces"][0]["type"]].model_validate(data["forces"][0])
    return section.element(Context(BODY, Environment(), source, "forces[0]"))


WING = """
[[forces]]
type = "aerodynamics"
name = "wing"
reference_area = "20 m^2"
span = 9.0
chord = "300 cm"
axes = "wind"
reference_point = "[20, 10, 0] cm"
controls = { elevator = "rad", flap = "1" }

[forces.coefficients]
CD = 0.02
CY = { beta = "-0.01 1/deg" }

[forces.coefficients.CL]
"0" = [
    0.1,
    { of = ["alpha"], points = ["[-10, 0, 10] deg"], values = [-0.8, 0.2, 1], interpolation = "cubic" },
]

[forces.coefficients.CL.q_hat]
of = ["alpha", "mach"]
points = ["[-10, 10] deg", [0.0, 0.5, 1.0]]
values = [[4.0, 5.0, 6.0], [3.0, 4.0, 5.0]]
extrapolate = true

[forces.coefficients.Cm]
"0" = 0.01
alpha = -0.5
"alpha^2" = "1e-4 1/deg^2"
q_hat = -12.0
elevator = "-0.02 1/deg"
flap = 0.1
"""


def test_a_file_says_what_python_says() -> None:
    alpha = np.deg2rad([-10.0, 0.0, 10.0])
    grid = fb.Table((alpha[::2], [0.0, 0.5, 1.0]), [[4.0, 5.0, 6.0], [3.0, 4.0, 5.0]])
    law = Aerodynamics(
        Environment(),
        20.0,
        9.0,
        3.0,
        {
            "CD": 0.02,
            "CY": {"beta": -0.01 * (180.0 / np.pi)},
            "CL": {
                "0": [0.1, Lookup(fb.Table(alpha, [-0.8, 0.2, 1.0], "cubic"), "alpha")],
                "q_hat": Lookup(grid, "alpha", "mach", extrapolate=True),
            },
            "Cm": {"0": 0.01, "alpha": -0.5, "alpha^2": 1e-4, "q_hat": -12.0, "elevator": -0.02, "flap": 0.1},
        },
        [0.2, 0.1, 0.0],
        axes="wind",
        controls={"elevator": "rad", "flap": "1"},
        name="wing",
    )
    read = built(WING)
    assert (read.inputs, read.parameter_units) == (law.inputs, law.parameter_units)
    wanted: dict[str, Any] = dict(
        law.parameters, Cm_alpha2=1e-4 * (180.0 / np.pi) ** 2, Cm_elevator=-0.02 * 180.0 / np.pi
    )
    assert read.parameters == pytest.approx(wanted, rel=1e-14)
    # The same numbers, converted by other products.
    models = [fb.Model(BODY, [each]) for each in (read, law(**wanted))]
    x = models[0].state(velocity_body=[80.0, 3.0, 9.0], angular_velocity_body=[0.1, 0.2, 0.3])
    first, second = (model.wrench(0.0, x, [0.1, 0.2]) for model in models)
    assert first == pytest.approx(second, rel=1e-12)


def test_a_table_of_drag() -> None:
    text = '[[forces]]\ntype = "drag"\narea = "0.1 m^2"\nat = [0.0, 0.0, 1.0]\n'
    assert built(text + "coefficient = 0.47") == Drag(Environment(), 0.1, 0.47, [0.0, 0.0, 1.0])
    table = 'coefficient = { of = ["mach"], points = [[0.0, 1.0]], values = [0.4, 1.1] }'
    assert built(text + table) == Drag(Environment(), 0.1, fb.Table([0.0, 1.0], [0.4, 1.1]), [0.0, 0.0, 1.0])


def test_tables_from_csv(tmp_path: Path) -> None:
    """The lines of the grid in any order; several columns for several coefficients."""
    lines = [
        f"{e},{a},{f16_tables.CX[i][j]},{f16_tables.CM[i][j]}"
        for j, a in enumerate(f16_tables.ALPHA)
        for i, e in enumerate(f16_tables.ELEVATOR)
    ]
    (tmp_path / "f16.csv").write_text("\n".join(["elevator [deg],alpha [deg],CX,CM", *lines]))
    text = """
[[forces]]
type = "aerodynamics"
reference_area = "300 ft^2"
span = "30 ft"
chord = "11.32 ft"
controls = { elevator = "rad" }
[forces.coefficients]
CX = { of = ["alpha", "elevator"], csv = "f16.csv", column = "CX", extrapolate = true }
Cm = { of = ["alpha", "elevator"], csv = "f16.csv", column = "CM", extrapolate = true }
"""
    whole = fb.Model(BODY, [built(text, tmp_path)])
    book = fb.Model(BODY, [f16.aerodynamics(Environment())])
    x = whole.state(velocity_body=[100.0, 0.0, 30.0])
    got, wanted = whole.wrench(0.0, x, [0.1]), book.wrench(0.0, x, [0.1, 0.0, 0.0])
    assert got[[0, 4]] == pytest.approx(wanted[[0, 4]], rel=1e-13)


@pytest.mark.parametrize(
    ("line", "key", "words"),
    [
        ("CD = 0.02", "CD = true", "a plain number"),
        ("CD = 0.02", "CX = 0.02", "none in these axes"),
        ('beta = "-0.01 1/deg"', 'beta = "-0.01 deg"', "is no unit of"),
        ('beta = "-0.01 1/deg"', 'bta = "-0.01 1/deg"', "plain numbers"),
        ('beta = "-0.01 1/deg"', "bta = 1.0", "did you mean 'beta'"),
        ("values = [-0.8, 0.2, 1]", "values = [-0.8, 0.2]", "3 numbers"),
        ("values = [-0.8, 0.2, 1]", "value = [-0.8, 0.2, 1.0]", "did you mean 'values'"),
        ('"[-10, 0, 10] deg"', '"[-10, 0, 10] m"', "is no unit of an angle"),
        ('of = ["alpha", "mach"]', 'of = ["alpha", "flp"]', "did you mean 'flap'"),
        ('of = ["alpha", "mach"]', 'of = ["alpha"]', "one for each of alpha"),
        ('interpolation = "cubic"', 'interpolation = "cubic", extrapolate = true', "only linear tables"),
        ('flap = "1"', 'mach = "1"', "means something else"),
    ],
)
def test_errors_name_the_key(line: str, key: str, words: str) -> None:
    assert line in WING
    with pytest.raises(fb.FreebodyError, match=words):
        built(WING.replace(line, key, 1))
