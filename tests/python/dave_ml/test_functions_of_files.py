"""Tables: between the samples, beyond them, in any number of dimensions."""

import itertools

import numpy as np
import pytest
from scipy.interpolate import CubicSpline, RegularGridInterpolator

from python.dave_ml.files import tabulated

POINTS, VALUES = [1.0, 3.0, 4.0, 6.0, 7.5], [2.0, 6.0, 5.0, 7.0, 1.5]  # the example of the DAVE-ML reference
PLACES = np.concatenate([np.linspace(-2.0, 12.0, 57), POINTS])


def curve(folder, **attributes):
    """The output of a function of one variable at PLACES."""
    more = "".join(f' {name}="{value}"' for name, value in attributes.items())
    points, values = (" ".join(map(str, numbers)) for numbers in (POINTS, VALUES))
    function = (
        f'<function name="f"><independentVarPts varID="x"{more}>{points}</independentVarPts>'
        f'<dependentVarPts varID="out">{values}</dependentVarPts></function>'
    )
    return tabulated(folder, function, "x")(x=PLACES)["out"]


def line(x):
    """Linear, and on beyond both ends."""
    inside = np.interp(x, POINTS, VALUES)
    return np.where(x < 1.0, 2.0 + 2.0 * (x - 1.0), np.where(x > 7.5, 1.5 - 5.5 / 1.5 * (x - 7.5), inside))


def steps(x, places):
    """The value of the sample whose place was passed last."""
    return np.array(VALUES)[np.clip(np.searchsorted(places, x, side="right") - 1, 0, 4)]


INSIDE = np.clip(PLACES, 1.0, 7.5)
CURVES = [
    ({}, line(INSIDE)),
    ({"interpolate": "linear", "extrapolate": "neither"}, line(INSIDE)),
    ({"extrapolate": "both"}, line(PLACES)),
    ({"extrapolate": "min"}, line(np.minimum(PLACES, 7.5))),
    ({"extrapolate": "max"}, line(np.maximum(PLACES, 1.0))),
    ({"extrapolate": "both", "min": "0", "max": "9"}, line(np.clip(PLACES, 0.0, 9.0))),
    ({"min": "2", "max": "9"}, line(np.clip(PLACES, 2.0, 7.5))),
    ({"max": "5", "extrapolate": "both"}, line(np.minimum(PLACES, 5.0))),
    ({"interpolate": "floor"}, steps(INSIDE, POINTS)),
    ({"interpolate": "floor", "extrapolate": "both", "max": "5"}, steps(np.minimum(INSIDE, 5.0), POINTS)),
    ({"interpolate": "discrete"}, steps(INSIDE, [1.0, 2.0, 3.5, 5.0, 6.75])),
    ({"interpolate": "ceiling"}, np.array(VALUES)[np.searchsorted(POINTS, INSIDE, side="left")]),
    (
        {"interpolate": "ceiling", "min": "3.5"},
        np.array(VALUES)[np.searchsorted(POINTS, np.maximum(INSIDE, 3.5))],
    ),
    ({"interpolate": "cubicSpline"}, CubicSpline(POINTS, VALUES)(INSIDE)),
]


@pytest.mark.parametrize(
    ("attributes", "wanted"), CURVES, ids=lambda a: str(a) if isinstance(a, dict) else ""
)
def test_one_variable(attributes, wanted, tmp_path):
    # What is continued goes through a sample 1000 intervals away: three digits of sixteen.
    np.testing.assert_allclose(curve(tmp_path, **attributes), wanted, rtol=1e-12, atol=1e-12)


def grid(folder, rules):
    """A function of as many variables as there are rules, and its samples."""
    rng = np.random.default_rng(len(rules))
    axes = [np.sort(rng.uniform(-1.0, 1.0, 3 + i % 3)) for i in range(len(rules))]
    values = rng.normal(size=[len(axis) for axis in axes])
    names = [f"x{i}" for i in range(len(rules))]
    parts = []
    for i, axis in enumerate(axes):
        numbers = " ".join(repr(float(x)) for x in axis)
        parts.append(f'<breakpointDef bpID="B{i}"><bpVals>{numbers}</bpVals></breakpointDef>')
    parts.append('<function name="f">')
    for name, rule in zip(names, rules, strict=True):
        parts.append(f'<independentVarRef varID="{name}" interpolate="{rule}"/>')
    parts += [
        '<dependentVarRef varID="out"/><functionDefn><griddedTableDef gtID="T"><breakpointRefs>',
        *(f'<bpRef bpID="B{i}"/>' for i in range(len(rules))),
        f"</breakpointRefs><dataTable>{' '.join(repr(float(v)) for v in values.ravel())}</dataTable>",
        "</griddedTableDef></functionDefn></function>",
    ]
    return tabulated(folder, "".join(parts), *names), axes, values


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5])
def test_several_variables_are_multilinear_and_hold_their_borders(n, tmp_path):
    rng = np.random.default_rng(7)
    model, axes, values = grid(tmp_path, ["linear"] * n)
    at = rng.uniform(-1.5, 1.5, (40, n))
    inside = np.clip(at, [a[0] for a in axes], [a[-1] for a in axes])
    got = model({f"x{i}": at[:, i] for i in range(n)})["out"]
    np.testing.assert_allclose(got, RegularGridInterpolator(axes, values)(inside), rtol=0, atol=1e-13)


def test_each_variable_has_its_own_rule(tmp_path):
    rng = np.random.default_rng(7)
    """Linear along the second, spline along the third, for each sample of the first that was passed last."""
    model, axes, values = grid(tmp_path, ["floor", "linear", "cubicSpline"])
    for _ in range(20):
        x, y, z = (rng.uniform(a[0], a[-1]) for a in axes)
        rows = values[np.searchsorted(axes[0], x, side="right") - 1]
        wanted = CubicSpline(axes[2], [np.interp(y, axes[1], column) for column in rows.T])(z)
        assert model(x0=x, x1=y, x2=z)["out"] == pytest.approx(wanted, abs=1e-13)


def test_continued_in_two_variables_is_the_bilinear_form_of_the_corner(tmp_path):
    function = (
        '<function name="f"><independentVarPts varID="x" extrapolate="both">0 1</independentVarPts>'
        '<independentVarPts varID="y" extrapolate="both">2 4</independentVarPts>'
        '<dependentVarPts varID="out">1 2 3 7</dependentVarPts></function>'
    )
    model = tabulated(tmp_path, function, "x", "y")
    for x, y in itertools.product((-3.0, 0.5, 8.0), repeat=2):
        t = (y - 2.0) / 2.0
        wanted = (1.0 - x) * ((1.0 - t) * 1.0 + t * 2.0) + x * ((1.0 - t) * 3.0 + t * 7.0)
        assert model(x=x, y=y)["out"] == pytest.approx(wanted, rel=1e-11)
