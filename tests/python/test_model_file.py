"""Model files: what they mean, and what their errors say."""

import re
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import get_args

import numpy as np
import pytest
from pydantic import BaseModel

import freebody as fb
from freebody import model_file
from freebody.errors import InputError, ModelFileError
from freebody.model_file import load_model, shipped_model, shipped_names
from freebody.model_file.sections import SECTIONS
from freebody.model_file.units import FieldError, to_si

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "model-file.md").read_text()

BRICK = """\
[model]
name = "brick"
[body]
mass = 2.0
com = [0.1, 0.0, 0.0]
inertia_about_com = { principal = [2.0, 3.0, 4.0] }
[[forces]]
type = "constant_wrench"
moment = [1.0, 0.0, 0.0]
[initial]
angular_velocity_body = "[10, 20, 30] deg/s"
[simulation]
end = "2 s"
rtol = 1e-10
"""


@pytest.fixture
def load(tmp_path):
    """Loads a text as the model file brick.toml."""

    def load(text):
        path = tmp_path / "brick.toml"
        path.write_text(text)
        return load_model(path)

    return load


# A compound unit's factor is a product of some ten definitions, each rounded (1e-16).
@pytest.mark.parametrize(
    ("text", "unit", "shape", "si"),
    [
        ("2 kg", "kg", (), 2.0),
        ("-1.5e3 g", "kg", (), -1.5),
        ("1 slug", "kg", (), 4.4482216152605 / 0.3048),
        ("[10, 20, 30] deg/s", "rad/s", (3,), np.deg2rad([10.0, 20.0, 30.0])),
        (["180 deg", 1, "0.5 turn"], "rad", (3,), [np.pi, 1.0, np.pi]),
        ("60 rpm", "rad/s", (), 2 * np.pi),
        ("1 slug ft^2", "kg m^2", (), 4.4482216152605 * 0.3048),
        ("[[1, 0], [0, 2]] lbf ft", "N m", (2, 2), 4.4482216152605 * 0.3048 * np.diag([1.0, 2.0])),
        ("1 day", "s", (), 86400.0),
        ("2 ft³/s²", "m^3/s^2", (), 2 * 0.3048**3),
        ([1, 2], "", (None,), [1.0, 2.0]),
    ],
)
def test_units_become_si(text, unit, shape, si):
    np.testing.assert_allclose(to_si(text, unit, shape), si, rtol=2e-15)


@pytest.mark.parametrize(
    ("value", "unit", "says"),
    [
        ("3 Hz", "rad/s", "'Hz' is no unit of an angular velocity (rad/s)"),
        ("3 ft", "kg", "'ft' is no unit of a mass (kg)"),
        ("3 slugg", "kg", "unknown unit 'slugg'"),
        ("3 kg/", "kg", "cannot read the unit 'kg/'"),
        ("3", "kg", 'write "3 kg", or 3 without quotes'),
        ("heavy", "kg", "came 'heavy', which does not start with a number"),
        ("[1, 2] kg", "kg", "needs one number, a mass (kg); came 2 numbers"),
        ("[1, x] kg", "kg", "'[1, x]' is not an array of numbers"),
        (True, "kg", "came True"),
        (float("nan"), "kg", "needs a finite number; came nan"),
        ("1e999 kg", "kg", "needs a finite number; came inf"),
        ("1 kg", "", "needs plain numbers, without quotes and units"),
        ([], "kg", "came 0 numbers"),
        ([[1.0], [1.0, 2.0]], "kg", "the rows differ in length"),
    ],
)
def test_what_is_no_quantity_is_refused(value, unit, says):
    with pytest.raises(FieldError, match=re.escape(says)):
        to_si(value, unit, ())


# (what stands in BRICK, what replaces it, line, key, what the message says)
FAULTS = [
    ("mass =", "mas =", 4, "body.mas", "unknown key; did you mean 'mass'?"),
    ("mass = 2.0\n", "", 3, "body.mass", "this key is missing: the mass"),
    ("mass = 2.0", 'mass = "2 m"', 4, "body.mass", "'m' is no unit of a mass (kg)"),
    ("mass = 2.0", "mass = -2.0", 3, "body", "mass"),
    ("[0.1, 0.0, 0.0]", '[0.1, "2 s", 0.0]', 5, "body.com[1]", "'s' is no unit of a length (m)"),
    ("[0.1, 0.0, 0.0]", "[0.1, 0.0]", 5, "body.com", "needs 3 numbers, a length (m); came 2 numbers"),
    ("principal", "principle", 6, "body.inertia_about_com.principle", "did you mean 'principal'?"),
    ("{ principal = [2.0, 3.0, 4.0] }", "[2, 3, 4]", 6, "body.inertia_about_com", "needs 3 x 3 numbers"),
    ("{ principal = [2.0, 3.0, 4.0] }", "{ Ixx = 2, Iyy = 3 }", 6, "body.inertia_about_com", "came Ixx, Iyy"),
    ("[2.0, 3.0, 4.0]", "[2.0, 3.0, 40.0]", 3, "body", "40"),
    (
        "0.1, 0.0, 0.0]\ninertia_about_com",
        "5, 0, 0]\ninertia_about_origin",
        3,
        "body",
        "inertia_about_origin",
    ),
    ("inertia_about_com = { principal = [2.0, 3.0, 4.0] }\n", "", 3, "body", "needs exactly one of"),
    ('"constant_wrench"', '"constant_wrnch"', 8, "forces[0].type", "did you mean 'constant_wrench'?"),
    ('type = "constant_wrench"\n', "", 7, "forces[0].type", "this key is missing"),
    ("moment = [1", 'axes = "bod"\nmoment = [1', 9, "forces[0].axes", "did you mean 'body'?"),
    ("[[forces]]", "[forces]", 7, "forces", "needs an array"),
    (
        "[initial]",
        "[initial]\nvelocity_body = [1,2,3]\nvelocity_world = [1,2,3]",
        10,
        "initial",
        "takes one of",
    ),
    ("[initial]", "[initial]\nattitude = { angles = [1,2,3] }", 11, "initial.attitude", "go together"),
    ("[initial]", "[initial]\nattitude = { quaternion = [2,0,0,0] }", 11, "initial.attitude", "length is 2"),
    ('"2 s"', '"-2 s"', 12, "simulation", "end must be later than start"),
    ("rtol = 1e-10", "rtol = 0", 14, "simulation.rtol", "must be positive; came 0"),
    ("rtol = 1e-10", 'method = "rk4"', 12, "simulation", "needs a step"),
    ("rtol = 1e-10", 'method = "gauss6"', 12, "simulation", "needs a step"),
    ("rtol = 1e-10", 'method = "dop85"', 14, "simulation.method", "did you mean 'dop853'?"),
    ("rtol = 1e-10", "max_steps = 2.5", 14, "simulation.max_steps", "needs a whole number; came 2.5"),
    ("rtol = 1e-10", 'max_steps = "2"', 14, "simulation.max_steps", "needs a whole number; came '2'"),
    ("rtol = 1e-10", "max_steps = 0", 14, "simulation.max_steps", "greater than or equal to 1"),
    ("[initial]", "[output]\nsave_at = [1, 3]\n[initial]", 11, "output.save_at", "must rise from 0 to 2 s"),
    ("[body]", "parts = []\n[body]", 3, "model.parts", "unknown key"),
    ('name = "brick"', "name = 3", 2, "model.name", "needs a string in quotes; came 3"),
    ("[model]", "[model", 1, None, "not valid TOML"),
    ("mass = 2.0", "mass = 2.0\nmass = 3.0", 5, None, "not valid TOML: duplicate key"),
    ("[body]", "[bdy]", 3, "bdy", "did you mean 'body'?"),
]


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault[1])
def test_errors_name_file_line_and_key(load, fault):
    old, new, line, key, says = fault
    assert BRICK.count(old) == 1
    with pytest.raises(ModelFileError) as caught:
        load(BRICK.replace(old, new))
    error = caught.value
    assert error.file is not None
    assert (Path(error.file).name, error.line, error.key) == ("brick.toml", line, key)
    assert says in str(error)
    assert f"brick.toml:{line}: " in str(error)


def test_all_faults_are_told_at_once(load):
    with pytest.raises(
        ModelFileError, match=r"(?s)brick.toml:5: body.com.*\n.*brick.toml:14: simulation.rtol"
    ):
        load(BRICK.replace("[0.1, 0.0, 0.0]", "[1, 2]").replace("1e-10", "0"))


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(ModelFileError, match=r"nothing.toml: cannot be read"):
        load_model(tmp_path / "nothing.toml")


def test_a_file_that_is_no_text(tmp_path):
    path = tmp_path / "binary.toml"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ModelFileError, match="UTF-8"):
        load_model(path)


@pytest.mark.parametrize("name", shipped_names())
def test_shipped_models_are_valid_and_say_their_sources(name):
    loaded = load_model(shipped_model(name))
    assert loaded.header.sources
    assert loaded.header.description
    assert loaded.x0.shape == (len(loaded.model.state_names),)


def test_an_unknown_shipped_name_is_refused():
    with pytest.raises(InputError, match="did you mean 'toutatis'"):
        shipped_model("toutatus")


@pytest.mark.parametrize("name", ["jeod_9b", "heavy_top"])
def test_a_start_given_for_the_mass_centre_is_its_start(name):
    loaded = load_model(shipped_model(name))
    run = loaded.model.simulate(loaded.x0, (0.0, 1e-3))
    text = loaded.text.split("[initial]")[1]
    numbers = {
        key: re.search(rf"^{key} = \[(.*)\]", text, re.MULTILINE) for key in ("position", "velocity_world")
    }
    given = {key: np.array(match[1].split(","), dtype=float) for key, match in numbers.items() if match}
    assert np.linalg.norm(loaded.model.body.com) > 1
    # From the mass centre to the origin and back: a few roundings of numbers up to the size of the vector.
    for got, key in ((run.com_position_world[0], "position"), (run.com_velocity_world[0], "velocity_world")):
        np.testing.assert_allclose(
            got, given[key], rtol=0, atol=float(1e-15 * np.linalg.norm(given[key]) + 1e-14)
        )


def test_three_ways_to_write_an_inertia(load):
    ways = (
        "[[2.0, 0.5, 0.0], [0.5, 2.0, 0.0], [0.0, 0.0, 3.0]]",
        "{ principal = [2.5, 1.5, 3.0], axes = [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]] }",
        "{ Ixx = 2.0, Iyy = 2.0, Izz = 3.0, Pxy = -0.5 }",
    )
    tensors = [
        load(BRICK.replace("{ principal = [2.0, 3.0, 4.0] }", way)).model.body.inertia_about_com
        for way in ways
    ]
    np.testing.assert_allclose(tensors[0], [[2.0, 0.5, 0.0], [0.5, 2.0, 0.0], [0.0, 0.0, 3.0]], rtol=1e-15)
    np.testing.assert_allclose(tensors[2], tensors[0], rtol=1e-15)
    axes = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
    np.testing.assert_allclose(tensors[1], axes @ np.diag([2.5, 1.5, 3.0]) @ axes.T, rtol=1e-14)


def test_parts_are_joined(load):
    parts = BRICK.replace("[body]", "[[parts]]").replace(
        "[[forces]]",
        "[[parts]]\nmass = 1\ncom = [1, 0, 0]\ninertia_about_origin = { principal = [1, 3, 3] }\n[[forces]]",
    )
    one, both = load(BRICK).model.body, load(parts).model.body
    assert both.mass == one.mass + 1.0
    np.testing.assert_allclose(both.com, [(2 * 0.1 + 1.0) / 3, 0, 0], rtol=1e-15)
    expected = one.inertia_about_origin + np.diag([1.0, 3.0, 3.0])
    np.testing.assert_allclose(both.inertia_about_origin, expected, rtol=1e-15)


def test_a_table_from_csv_is_the_table(load, tmp_path):
    (tmp_path / "thrust.csv").write_text("time [min],moment_x [lbf ft],force_z\n0,0,1\n1,2,3\n2,4,0\n")
    table = 'type = "tabulated_wrench"\nat = [0.0, 1.0, 0.0]\n'
    inline = table + (
        'times = "[0, 1, 2] min"\n'
        "force = [[0, 0, 1], [0, 0, 3], [0, 0, 0]]\n"
        'moment = "[[0, 0, 0], [2, 0, 0], [4, 0, 0]] lbf ft"\n'
    )
    wrench = 'type = "constant_wrench"\nmoment = [1.0, 0.0, 0.0]\n'
    from_csv, from_file = (
        load(BRICK.replace(wrench, table + 'csv = "thrust.csv"\n')),
        load(BRICK.replace(wrench, inline)),
    )
    for t in (0.0, 30.0, 75.0, 500.0):
        got, expected = (loaded.model.wrench(t, loaded.x0) for loaded in (from_csv, from_file))
        np.testing.assert_allclose(got, expected, rtol=1e-15)
        assert np.any(expected)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("time,moment_w\n0,1\n", "unknown column 'moment_w'; did you mean 'moment_"),
        ("time,moment_x [m]\n0,1\n", "column 'moment_x [m]': 'm' is no unit of a moment"),
        ("moment_x\n1\n", "has no column 'time'"),
        ("time,moment_x\n0,1\n2\n", "is no table of numbers"),
        ("time,moment_x\n0,a\n", "is no table of numbers"),
        ("time,moment_x\n", "has headings but no rows"),
        ("", "is no table of numbers"),
        (None, "No such file"),
    ],
)
def test_a_bad_csv_is_told_at_its_key(load, tmp_path, text, says):
    if text is not None:
        (tmp_path / "thrust.csv").write_text(text)
    wrench = 'type = "constant_wrench"\nmoment = [1.0, 0.0, 0.0]\n'
    with pytest.raises(ModelFileError, match=re.escape(says)) as caught:
        load(BRICK.replace(wrench, 'type = "tabulated_wrench"\ncsv = "thrust.csv"\n'))
    assert (caught.value.line, caught.value.key) == (9, "forces[0].csv")


def test_the_pages_have_every_key():
    """On the page of model files, or on one that it leads to."""
    pages = PAGE + "".join(
        (DOCS / name).read_text() for name in sorted(set(re.findall(r"\]\(([\w-]+\.md)", PAGE)))
    )
    modules = [import_module(f"freebody.model_file.{m.name}") for m in iter_modules(model_file.__path__)]
    sections = {
        kind
        for module in modules
        for kind in vars(module).values()
        if isinstance(kind, type) and issubclass(kind, BaseModel)
    }
    keys = {key for section in sections for key in section.model_fields}
    assert len(keys) > 200
    ways = ("`{}`", "{} = ", "[{}]", ".{}]")
    assert {key for key in keys if not any(way.format(key) in pages for way in ways)} == set()


def test_the_page_names_every_force():
    types = {get_args(section.model_fields["type"].annotation)[0] for section in SECTIONS}
    assert {word for word in types if f"`{word}`" not in PAGE} == set()


def test_the_example_of_the_page_runs(tmp_path):
    (example, *_) = re.findall(r"^```toml\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE)
    path = tmp_path / "brick.toml"
    path.write_text(example)
    assert fb.load(path).simulate().ok
