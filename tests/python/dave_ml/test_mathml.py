"""Calculations in MathML: each operator on arrays and in laws, and what is refused."""

import math

import numpy as np
import pytest

from freebody.errors import ModelFileError
from freebody.tracing import ControlLaw
from python.dave_ml.files import calculated

X, Y = "<ci>x</ci>", "<ci>y</ci>"
ONE = {  # of x
    "minus": lambda x: -x,
    "exp": np.exp,
    "abs": np.abs,
    "floor": np.floor,
    "ceiling": np.ceil,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "sec": lambda x: 1 / np.cos(x),
    "csc": lambda x: 1 / np.sin(x),
    "cot": lambda x: 1 / np.tan(x),
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "sech": lambda x: 1 / np.cosh(x),
    "csch": lambda x: 1 / np.sinh(x),
    "coth": lambda x: 1 / np.tanh(x),
    "arctan": np.arctan,
    "arccot": lambda x: np.arctan(1 / x),
    "arcsinh": np.arcsinh,
    "arccsch": lambda x: np.arcsinh(1 / x),
}
BELOW_ONE = {  # of |x|/2, in (0, 1)
    "ln": np.log,
    "log": np.log10,
    "root": np.sqrt,
    "arcsin": np.arcsin,
    "arccos": np.arccos,
    "arctanh": np.arctanh,
    "arcsech": lambda x: np.arccosh(1 / x),
}
ABOVE_ONE = {  # of 1 + |x|
    "arccosh": np.arccosh,
    "arccsc": lambda x: np.arcsin(1 / x),
    "arcsec": lambda x: np.arccos(1 / x),
    "arccoth": lambda x: np.arctanh(1 / x),
}
TWO = {  # of x and y
    "minus": lambda x, y: x - y,
    "divide": lambda x, y: x / y,
    "quotient": lambda x, y: x / y,  # the authors of DAVE-ML divide, in their basic_functions.dml
    "rem": np.fmod,
    "plus": lambda x, y: x + y,
    "times": lambda x, y: x * y,
    "min": np.minimum,
    "max": np.maximum,
    "eq": lambda x, y: x == y,
    "neq": lambda x, y: x != y,
    "lt": lambda x, y: x < y,
    "gt": lambda x, y: x > y,
    "leq": lambda x, y: x <= y,
    "geq": lambda x, y: x >= y,
    "and": lambda x, y: (x != 0) & (y != 0),
    "or": lambda x, y: (x != 0) | (y != 0),
    "xor": lambda x, y: (x != 0) ^ (y != 0),
    "implies": lambda x, y: (x == 0) | (y != 0),
}
HALF = f"<apply><divide/><apply><abs/>{X}</apply><cn>2</cn></apply>"
MORE = f"<apply><plus/><cn>1</cn><apply><abs/>{X}</apply></apply>"
QUARTER, HALVES = "<cn type='rational'>1<sep/>4</cn>", "<cn type='e-notation'>5<sep/>-1</cn>"
PIECES = (
    f"<apply><piecewise><piece>{X}<apply><gt/>{X}<cn>1</cn></apply></piece><piece>{Y}{X}</piece>"
    "<otherwise><cn>7</cn></otherwise></piecewise></apply>"
)
ALWAYS = f"<piecewise><piece><cn>1</cn><true/></piece><otherwise>{X}</otherwise></piecewise>"
OTHERS = {
    f"<apply><plus/>{X}{Y}<cn>1</cn></apply>": lambda x, y: x + y + 1,
    f"<apply><max/>{X}{Y}<cn>0.5</cn></apply>": lambda x, y: np.maximum(np.maximum(x, y), 0.5),
    f"<apply><lt/><cn>-1</cn>{X}{Y}</apply>": lambda x, y: (x > -1) & (x < y),
    f"<apply><not/>{X}</apply>": lambda x, y: x == 0,
    f"<apply><power/>{X}<cn>3</cn></apply>": lambda x, y: x**3,
    f"<apply><power/>{HALF}<cn>.5</cn></apply>": lambda x, y: np.sqrt(np.abs(x) / 2),
    f"<apply><power/>{MORE}{Y}</apply>": lambda x, y: (1 + np.abs(x)) ** y,
    f"<apply><root/><degree><cn>3</cn></degree>{HALF}</apply>": lambda x, y: np.cbrt(np.abs(x) / 2),
    f"<apply><log/><logbase><cn>2</cn></logbase>{MORE}</apply>": lambda x, y: np.log2(1 + np.abs(x)),
    f"<apply><csymbol encoding='text'> atan2 </csymbol>{X}{Y}</apply>": np.arctan2,
    PIECES: lambda x, y: np.where(x > 1, x, np.where(x != 0, y, 7)),
    ALWAYS: lambda x, y: 1 + 0 * x,
    f"<apply><times/><pi/><exponentiale/>{X}</apply>": lambda x, y: math.pi * math.e * x,
    f"<apply><plus/>{X}{QUARTER}{HALVES}</apply>": lambda x, y: x + 0.75,
    f"<semantics>{X}<annotation>nothing</annotation></semantics>": lambda x, y: x,
}
CASES = {
    **{f"<apply><{name}/>{X}</apply>": (lambda x, y, f=f: f(x)) for name, f in ONE.items()},
    **{
        f"<apply><{name}/>{HALF}</apply>": (lambda x, y, f=f: f(np.abs(x) / 2))
        for name, f in BELOW_ONE.items()
    },
    **{
        f"<apply><{name}/>{MORE}</apply>": (lambda x, y, f=f: f(1 + np.abs(x)))
        for name, f in ABOVE_ONE.items()
    },
    **{f"<apply><{name}/>{X}{Y}</apply>": f for name, f in TWO.items()},
    **OTHERS,
}
RANDOM = np.random.default_rng(3).uniform(-2.0, 2.0, (20, 2))
# Signs, equal numbers and, where they are defined there, zeros.
PLACES = {
    True: np.vstack([RANDOM, [[1, 1], [0, 1], [1, 0], [0, 0]]]),
    False: np.vstack([RANDOM, [[1, 1], [-1, 1]]]),
}


@pytest.mark.parametrize("expression", CASES)
def test_operators_are_those_of_numpy_on_arrays_and_in_laws(expression, tmp_path):
    model, wanted_of = calculated(tmp_path, expression, "x", "y"), CASES[expression]
    with np.errstate(all="ignore"):
        at = PLACES[bool(np.isfinite(wanted_of(*np.zeros((2, 1)))).all())]
        wanted = np.asarray(wanted_of(*at.T), float)
    # Rounding: the core's functions and powers may differ from NumPy's in the last digits.
    np.testing.assert_allclose(
        np.broadcast_to(model(x=at[:, 0], y=at[:, 1])["out"], wanted.shape), wanted, rtol=1e-13, atol=1e-13
    )
    np.testing.assert_allclose(model(x=at[0, 0], y=at[0, 1])["out"], wanted[0], rtol=1e-13, atol=1e-13)

    def law(s):
        return {"out": model(x=s.inputs.x, y=s.inputs.y)["out"]}

    program = ControlLaw(law, inputs={"x": "m", "y": "s"}).program
    got = program.run(np.zeros(0), np.hstack([np.zeros((len(at), 23)), at]))
    np.testing.assert_allclose(got[:, 0], wanted, rtol=1e-13, atol=1e-13)


def test_what_is_not_finite_where_it_is_not_chosen_does_no_harm(tmp_path):
    guarded = (
        f"<piecewise><piece><apply><divide/><cn>1</cn>{X}</apply><apply><gt/>{X}<cn>0</cn></apply></piece>"
        "<otherwise><cn>0</cn></otherwise></piecewise>"
    )
    assert calculated(tmp_path, guarded, "x")(x=0.0) == {"out": 0.0}


@pytest.mark.parametrize(
    ("expression", "fault"),
    [
        ("<apply><factorial/><ci>x</ci></apply>", "<factorial> is no operator; allowed are plus, minus"),
        ("<apply><csymbol>atan3</csymbol><ci>x</ci></apply>", "<csymbol> 'atan3' is no operator"),
        ("<apply><atan2/><ci>x</ci><ci>x</ci></apply>", "<atan2> is no operator"),
        ("<apply><divide/><ci>x</ci></apply>", "<divide> came with 1 arguments; it takes 2"),
        (
            "<apply><minus/><ci>x</ci><ci>x</ci><ci>x</ci></apply>",
            "<minus> came with 3 arguments; it takes 1 to 2",
        ),
        ("<apply><lt/><ci>x</ci></apply>", "<lt> came with 1 arguments; it takes 2 or more"),
        ("<apply><sin/><degree><cn>2</cn></degree><ci>x</ci></apply>", "<sin> takes no <degree>"),
        ("<apply><root/><degree><cn>2</cn></degree></apply>", "<root> came with 0 arguments; it takes 1"),
        ("<apply></apply>", "<apply> is empty"),
        ("<ci>x</ci><ci>x</ci>", "<math> has 2 elements; give one expression"),
        ("<ci>z</ci>", "<ci> refers to 'z', which is no varID"),
        ("<cn>1.0D3</cn>", "<cn> came with '1.0D3'; give a finite number of type real"),
        ("<cn type='rational'>1<sep/>0</cn>", "give a finite number of type rational"),
        ("<cn type='complex-polar'>1<sep/>0</cn>", "<cn> of type 'complex-polar'"),
        ("<cn base='16'>FF</cn>", "base 16; allowed are real"),
        (
            "<vector><ci>x</ci></vector>",
            "<vector> is no expression that is read here; allowed are <apply>, <ci>",
        ),
        ("<piecewise><piece><ci>x</ci><ci>x</ci></piece></piecewise>", "<piecewise> needs a <piece>, and an"),
        ("<piecewise><otherwise><ci>x</ci></otherwise></piecewise>", "<piecewise> needs a <piece>, and an"),
        ("<piecewise><piece><ci>x</ci></piece></piecewise>", "<piece> has 1 elements; give value, condition"),
    ],
)
def test_wrong_calculations_are_refused_with_line_and_variable(expression, fault, tmp_path):
    with pytest.raises(ModelFileError) as refusal:
        calculated(tmp_path, expression, "x")
    assert fault in str(refusal.value)
    assert (refusal.value.line, refusal.value.key) == (4, "out")
