"""What cannot be read is refused: file, line, which variable or function, what came, what is allowed."""

import pytest

from freebody.dave_ml import load_dave_ml
from freebody.errors import ModelFileError
from python.dave_ml.files import calculation, variable, write

X, OUT = variable("x", "<isInput/>"), variable("out")
POINTS = '<independentVarPts varID="x">0 1 2</independentVarPts>'
VALUES = '<dependentVarPts varID="out">5 6 7</dependentVarPts>'
REFERENCE, RESULT = '<independentVarRef varID="x"/>', '<dependentVarRef varID="out"/>'
BREAKPOINTS = '<breakpointDef bpID="B"><bpVals>0 1 2</bpVals></breakpointDef>'


def function(*parts, name="f"):
    return f'<function name="{name}">{"".join(parts)}</function>'


def grid(values, bound='<bpRef bpID="B"/>', **attributes):
    more = "".join(f' {name}="{value}"' for name, value in attributes.items())
    return (
        f'<functionDefn><griddedTableDef gtID="T"{more}><breakpointRefs>{bound}</breakpointRefs>'
        f"<dataTable>{values}</dataTable></griddedTableDef></functionDefn>"
    )


def scattered(*points):
    rows = "".join(f"<dataPoint>{point}</dataPoint>" for point in points)
    return f"<functionDefn><ungriddedTable>{rows}</ungriddedTable></functionDefn>"


def shot(*signals):
    outputs = f"<checkOutputs>{''.join(signals)}</checkOutputs>"
    return f"<checkData><staticShot name='s'>{outputs}</staticShot></checkData>"


def points(**attributes):
    more = "".join(f' {name}="{value}"' for name, value in attributes.items())
    return POINTS.replace('"x"', f'"x"{more}')


LOOP = [variable(a, calculation(f"<ci>{b}</ci>")) for a, b in ("ab", "bc", "ca")]
FUNCTIONS = {  # fault, and what stands on the line behind x, out and the breakpoints 0, 1, 2
    "needs <independentVarPts> or <independentVarRef> elements, of one kind": function(VALUES),
    "<function> has no <dependentVarPts>": function(POINTS),
    "<function> has no <functionDefn>": function(REFERENCE, RESULT),
    "<functionDefn> has no <griddedTableRef> or": function(REFERENCE, RESULT, "<functionDefn/>"),
    "<independentVarPts> refers to 'y', which is no varID": function(POINTS.replace('"x"', '"y"'), VALUES),
    "<independentVarPts> has no attribute varID": function(POINTS.replace('varID="x"', ""), VALUES),
    "<dependentVarPts> has 2 numbers; the breakpoints need 3": function(POINTS, VALUES.replace("7", "")),
    "<dependentVarPts> has no numbers": function(POINTS, VALUES.replace("5 6 7", "")),
    "<dependentVarPts>: came 'six'; give one finite number": function(POINTS, VALUES.replace("6", "six")),
    "<dependentVarPts>: came 'nan'; give one finite number": function(POINTS, VALUES.replace("6", "nan")),
    "breakpoint 1 follows 2; they must rise": function(POINTS.replace("1 2", "2 1"), VALUES),
    "interpolate='spline'; allowed are linear, cubicSpline": function(points(interpolate="spline"), VALUES),
    "interpolate='quadraticSpline' is not read": function(points(interpolate="quadraticSpline"), VALUES),
    "extrapolate='up'; allowed are neither, min, max, both": function(points(extrapolate="up"), VALUES),
    "min='low'; give one finite number": function(points(min="low"), VALUES),
    "min=2 is above max=1": function(points(min="2", max="1"), VALUES),
    "extrapolate='both' is read with linear interpolation only": function(
        points(interpolate="cubicSpline", extrapolate="both"), VALUES
    ),
    "extrapolate='max' needs two breakpoints": function(
        points(extrapolate="max").replace("0 1 2", "1"), VALUES.replace("5 6 7", "6")
    ),
    "gtID 'T' is no table of this file": function(
        REFERENCE, RESULT, '<functionDefn><griddedTableRef gtID="T"/></functionDefn>'
    ),
    "utID 'U' is no table of this file": function(
        REFERENCE, RESULT, '<functionDefn><ungriddedTableRef utID="U"/></functionDefn>'
    ),
    "2 <independentVarRef> for a table of 1 breakpoint sets": function(
        REFERENCE, REFERENCE, RESULT, grid("5 6 7")
    ),
    "bpID 'C' is no <breakpointDef> of this file": function(
        REFERENCE, RESULT, grid("5 6 7", '<bpRef bpID="C"/>')
    ),
    "<dataTable> has 4 numbers; the breakpoints need 3": function(REFERENCE, RESULT, grid("5 6 7 8")),
    "<griddedTableDef> is in 'deg', 'out' in 'nd'; they must agree": function(
        REFERENCE, RESULT, grid("5 6 7", units="deg")
    ),
    "an ungridded table of 2 variables is not read; give a griddedTableDef": function(
        REFERENCE, REFERENCE, RESULT, scattered("0 1 5")
    ),
    "<dataPoint> has 3 numbers; give the argument and the value": function(
        REFERENCE, RESULT, scattered("0 1 5")
    ),
    "has no <dataPoint>": function(REFERENCE, RESULT, scattered()),
    "breakpoint 1 follows 1; they must rise": function(REFERENCE, RESULT, scattered("1 5", "1 6")),
}


@pytest.mark.parametrize("fault", FUNCTIONS)
def test_wrong_functions_are_refused(fault, tmp_path):
    path = write(tmp_path, "\n".join([X, OUT, BREAKPOINTS, FUNCTIONS[fault]]))
    with pytest.raises(ModelFileError) as refusal:
        load_dave_ml(path)
    assert fault in str(refusal.value)
    assert (refusal.value.file, refusal.value.line) == (str(path), 6)


SIGNAL = (
    "<signal><signalName>{}</signalName><signalUnits>{}</signalUnits><signalValue>{}</signalValue></signal>"
)
OTHERS = {  # fault: the lines, and which of them it is about
    "has no <variableDef>": (["<fileHeader/>"], 2),
    "<variableDef> has no attribute varID": (['<variableDef name="x" units="nd"/>'], 3),
    "x: the varID stands on line 3 already": ([X, X], 4),
    "x: initialValue='(2/5)'; give one finite number": ([variable("x", initialValue="(2/5)")], 3),
    "x: minValue 2 is above maxValue 1": ([variable("x", minValue=2, maxValue=1)], 3),
    "x: is an input, and has a calculation or a function": (
        [variable("x", calculation("<cn>1</cn>") + "<isInput/>")],
        3,
    ),
    "<variableDef> of line 3 has another <calculation>; one": (
        [variable("x", 2 * calculation("<cn>1</cn>"))],
        3,
    ),
    "<calculation> has no <math>": ([variable("x", "<calculation/>")], 3),
    "out: has a calculation, and the function 'f' of line 5": (
        [X, variable("out", calculation("<ci>x</ci>")), function(POINTS, VALUES)],
        4,
    ),
    "out: the function of line 5 gives this variable already": ([X, OUT, *[function(POINTS, VALUES)] * 2], 6),
    "comes from itself: a from b from c from a": (LOOP, 3),
    "gtID 'T' stands on line 6 already": (
        [X, OUT, BREAKPOINTS, *[function(REFERENCE, RESULT, grid("5 6 7"))] * 2],
        7,
    ),
    "<signalName> 'y' is no variable of this file": ([X, shot(SIGNAL.format("y", "nd", 1))], 4),
    "the check data are in 'deg_s', the variable in 'nd', another quantity": (
        [X, shot(SIGNAL.format("x", "deg_s", 1))],
        4,
    ),
    "<signalValue>: came 'one'; give one finite number": ([X, shot(SIGNAL.format("x", "nd", "one"))], 4),
    "<signal> has no <signalValue>": ([X, shot("<signal><varID>x</varID></signal>")], 4),
}


@pytest.mark.parametrize("fault", OTHERS)
def test_wrong_elements_are_refused(fault, tmp_path):
    lines, line = OTHERS[fault]
    path = write(tmp_path, "\n".join(lines))
    with pytest.raises(ModelFileError) as refusal:
        load_dave_ml(path)
    assert fault in str(refusal.value)
    assert str(refusal.value).startswith(f"{path}:{line}: ")


ENTITY = '<!DOCTYPE DAVEfunc [\n<!ENTITY one "1">]>'
BOMB = '<!DOCTYPE DAVEfunc [<!ENTITY % remote SYSTEM "http://example.org/remote.dtd">%remote;]>'
FILES = {
    "no XML: mismatched tag": ("<DAVEfunc>\n<a></b></DAVEfunc>", 2),
    "no XML: no element found": ("", 1),
    "no XML: undefined entity": ("<DAVEfunc>&pi;</DAVEfunc>", 1),
    "the root is <html>; a DAVE-ML file has <DAVEfunc>": ("<html/>", 1),
    "declares the entity one; entities are not read": (f"{ENTITY}\n<DAVEfunc>&one;</DAVEfunc>", 2),
    "declares the entity remote; entities are not read": (f"{BOMB}<DAVEfunc/>", 1),
    "stands more than 200 levels deep": (f"<DAVEfunc>{'<a>' * 300}{'</a>' * 300}</DAVEfunc>", 1),
}


@pytest.mark.parametrize("fault", FILES)
def test_what_is_no_such_file_is_refused_and_nothing_is_expanded(fault, tmp_path):
    text, line = FILES[fault]
    path = tmp_path / "model.dml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ModelFileError) as refusal:
        load_dave_ml(path)
    assert fault in str(refusal.value)
    assert str(refusal.value).startswith(f"{path}:{line}: ")


def test_an_entity_of_a_document_type_that_is_not_loaded_is_no_number(tmp_path):
    head = '<!DOCTYPE DAVEfunc SYSTEM "http://example.org/DAVEfunc.dtd">'
    described = variable("x", "<description>5 &deg;</description><isInput/>")
    assert load_dave_ml(write(tmp_path, described, head)).inputs[0].description == "5 &deg;"
    with pytest.raises(ModelFileError, match="came '6&middot;5'; give one finite number"):
        load_dave_ml(
            write(tmp_path, "\n".join([X, OUT, function(POINTS, VALUES.replace("6", "6&middot;5"))]), head)
        )


def test_a_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ModelFileError, match="cannot be read: No such file"):
        load_dave_ml(tmp_path / "none.dml")
