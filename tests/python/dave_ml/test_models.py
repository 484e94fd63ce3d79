"""Models: a file with every element that is read, its check data, and how models are called."""

import pickle
import re

import numpy as np
import pytest

from freebody.dave_ml import load_dave_ml
from freebody.errors import InputError
from freebody.tracing import ControlLaw
from python.dave_ml.files import DART, calculation, variable, write

MODEL = load_dave_ml(DART)
INPUTS = {"V": 100.0, "alpha": 5.0, "beta": 10.0, "M": 0.25, "q": 72.0}


def dart(V, alpha, beta, M, q, fin=1.5, gust=0.0, damped=1.0, lag=0.25):
    """The outputs that the file is made to have; see its comments."""
    V, alpha = np.maximum(V, 0.5), np.clip(alpha, -90.0, 90.0)
    inside, m = np.clip(alpha, -15.0, 20.0), np.clip(M, 0.0, 2.0)
    lift = 0.1 * inside * (1.0 + m)
    drag = np.interp(M, [0.0, 1.0, 2.0], [0.1, 0.3, 0.2]) + np.select([M < 0.5, M < 2.0], [0.0, 0.01], 0.02)
    used = np.where((M < 1.0) & (damped != 0.0), fin, np.where(M >= 1.0, 0.5 * fin, 0.0))
    qhat = np.minimum(0.02, q * 0.5 * np.pi / (360.0 * V))
    return {
        "totalCoefficientOfLift": lift,
        "totalCoefficientOfDrag": drag + 0.05 * lift**2,
        "aeroBodyForceCoefficient_Y": -0.03 * (beta + gust),
        "aeroBodyMomentCoefficient_Roll": 1e-3 * np.clip(alpha, -10, 20) * np.clip(beta, -20, 20) * (1.0 + m),
        "aeroBodyMomentCoefficient_Pitch": -0.02 * used - 8.0 * qhat - lag,
        "aeroBodyMomentCoefficient_Yaw": np.where(beta < 0.0, 0.02 * np.maximum(beta, -30.0), 0.03 * beta),
    }


def at_random(n, seed=5):
    rng = np.random.default_rng(seed)
    ranges = {
        "V": (0.0, 200.0),
        "alpha": (-30.0, 40.0),
        "beta": (-50.0, 50.0),
        "M": (-0.5, 3.0),
        "q": (-90.0, 90.0),
    }
    return {name: rng.uniform(*ends, n) for name, ends in ranges.items()}


def test_the_check_data_of_the_file_hold():
    """The expected values are worked out by hand, and printed with all digits that a double has."""
    check = MODEL.check()
    assert check.ok
    assert not check.failures
    assert (len(check), {row.kind for row in check}) == (15, {"output", "internal"})
    assert {row.variable for row in check if row.kind == "internal"} == {"used", "CD0", "V", "qhat"}
    assert max(row.residual for row in check) < 1e-12
    assert "output    totalCoefficientOfLift           2" in str(check)


def test_check_data_that_do_not_hold_are_told(tmp_path):
    path = tmp_path / "dart.dml"
    path.write_text(
        DART.read_text().replace("<signalValue>-0.3</signalValue>", "<signalValue>-0.4</signalValue>")
    )
    check = load_dave_ml(path).check()
    assert not check.ok
    (row,) = check.failures
    assert (row.shot, row.variable, row.expected, row.tolerance) == (
        "slow",
        "aeroBodyForceCoefficient_Y",
        -0.4,
        1e-12,
    )
    assert row.residual == pytest.approx(0.1)
    assert "FAILS in 'slow'" in str(check)


def test_no_check_data_is_not_right_but_nothing(tmp_path):
    check = load_dave_ml(write(tmp_path, variable("x"))).check()
    assert (check.ok, len(check), str(check)) == (False, 0, "no check data")


def test_what_the_file_says_of_itself():
    header = MODEL.header
    assert (header.name, header.date, header.version) == ("Dart", "2026-03-14", "2, of spring")
    assert header.description == "A dart & its fins, α in degrees."
    assert [author.name for author in header.authors] == ["Ada Quill", "Ben Reed"]
    (reference,) = header.references
    assert (reference.id, reference.accession, reference.link) == ("R1", "DW-7", "http://example.org/darts")


def test_inputs_and_outputs_have_names_units_and_meanings():
    assert [v.id for v in MODEL.inputs] == ["V", "alpha", "beta", "M", "q", "fin", "gust", "damped", "lag"]
    speed = MODEL.inputs[0]
    assert (speed.name, speed.units, speed.symbol, speed.sign) == (
        "trueAirspeed",
        "ft_s",
        "V",
        "always positive",
    )
    assert (speed.description, speed.standard, speed.minimum) == ("Speed relative to the air", True, 0.5)
    assert (MODEL.variables["fin"].initial, MODEL.variables["fin"].axis_system) == (1.5, "hinge")
    # Cn is no marked output, but nothing uses it; CD0 is used, and its initial value is not.
    assert [v.id for v in MODEL.outputs] == ["S", "b", "c", "CL", "CD", "CY", "Cl", "Cm", "Cn"]
    assert MODEL.variables["CD0"].role == "tabulated"
    assert repr(MODEL) == "<DaveModel 'Dart': 9 inputs, 9 outputs>"


def test_numbers_and_arrays_give_what_the_formulas_do():
    values = at_random(200)
    got, wanted = MODEL(values), dart(**values)
    for name, value in wanted.items():
        np.testing.assert_allclose(got[name], value, rtol=1e-11, atol=1e-11)  # three digits go far outside
        assert MODEL({n: v[7] for n, v in values.items()})[name] == pytest.approx(
            value[7], rel=1e-11, abs=1e-11
        )
    assert got["referenceWingArea"] == 0.2


def test_inputs_broadcast_and_go_by_either_name():
    by_id = MODEL({**INPUTS, "alpha": np.zeros((4, 1)), "M": np.zeros(3)})
    assert by_id["totalCoefficientOfLift"].shape == (4, 3)
    renamed = {MODEL.variables[id].name: value for id, value in INPUTS.items()}
    assert MODEL(renamed, finDeflection=3.0) == MODEL(**INPUTS, fin=3.0)


def test_constants_can_be_others():
    usual, stronger = (MODEL(**INPUTS, Cmq=Cmq)["aeroBodyMomentCoefficient_Pitch"] for Cmq in (-8.0, -16.0))
    assert usual == MODEL(**INPUTS)["aeroBodyMomentCoefficient_Pitch"]
    assert stronger - usual == pytest.approx(-8.0 * 72.0 * 0.5 * np.pi / 36000.0)


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        ({"V": None}, r"the input 'trueAirspeed' (ft_s) is missing"),
        ({"speed": 1.0}, "'speed' is no variable"),
        ({"alhpa": 1.0}, "did you mean 'alpha'?"),
        ({"qhat": 1.0}, "'qhat' is computed by the model, and cannot be given"),
        ({"CL": 1.0}, "'CL' is tabulated by the model"),
        ({"trueAirspeed": 1.0}, "'trueAirspeed' came twice, by name and by varID"),
        ({"M": "fast"}, "M: got 'fast'"),
    ],
)
def test_wrong_calls_are_refused(change, fault):
    values = {n: v for n, v in {**INPUTS, **change}.items() if v is not None}
    with pytest.raises(InputError, match=re.escape(fault)):
        MODEL(values)


def test_a_name_that_two_have_is_none(tmp_path):
    lines = [
        variable("a", "<isInput/>").replace('name="a"', 'name="x"'),
        variable("b", calculation("<ci>a</ci>")).replace('name="b"', 'name="x"'),
        variable("d", calculation("<ci>a</ci>")).replace('name="d"', 'name="x"'),
    ]
    model = load_dave_ml(write(tmp_path, "\n".join(lines)))
    assert model(a=2.0) == {"b": 2.0, "d": 2.0}
    with pytest.raises(InputError, match="several variables have the name 'x'; give the varID, a or b or d"):
        model(x=2.0)


def test_in_laws_it_computes_the_same_over_lanes_and_alone():
    names = ["V", "alpha", "beta", "M", "q"]
    values = at_random(64)
    program = ControlLaw(_law(names), inputs=dict.fromkeys(names, "m")).program
    numbers = np.hstack([np.zeros((64, 23)), np.column_stack(list(values.values()))])
    got, alone = program.run(np.zeros(0), numbers), program.run(np.zeros(0), numbers[3:4])
    wanted = np.column_stack([np.broadcast_to(v, 64) for v in MODEL(values).values()])
    np.testing.assert_allclose(got, wanted, rtol=1e-13, atol=1e-13)
    assert np.array_equal(got[3], alone[0])


def _law(names):
    def law(s):
        return {f"c{i}": v for i, v in enumerate(MODEL({n: getattr(s.inputs, n) for n in names}).values())}

    return law


@pytest.mark.parametrize(
    "change",
    [
        lambda text: re.sub(r' xmlns(:\w+)?="[^"]*"', "", text).replace("xlink:href", "href"),
        lambda text: re.sub(r"(</?)(\w)", r"\1d:\2", text).replace("xmlns=", "xmlns:d="),
        lambda text: re.sub(r"<!DOCTYPE.*?>", "", text, flags=re.DOTALL).replace("\n", "\r\n"),
        lambda text: text.replace("creationDate", "fileCreationDate").replace(
            "DAVEfunc.dtd", "DAVEfunc15.dtd"
        ),
        lambda text: re.sub(r'(\w+ID|name)="([^"]*)"', r'\1=" \2 "', text),
    ],
    ids=["no namespaces", "prefixes", "no document type", "version 1", "spaces"],
)
def test_files_are_written_in_many_ways(change, tmp_path):
    path = tmp_path / "dart.dml"
    path.write_text(change(DART.read_text()), encoding="utf-8")
    model = load_dave_ml(path)
    assert model.check().ok
    assert model(**INPUTS) == MODEL(**INPUTS)


def test_models_pickle():
    again = pickle.loads(pickle.dumps(MODEL))
    assert again(**INPUTS) == MODEL(**INPUTS)
