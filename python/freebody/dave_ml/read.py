"""From a DAVE-ML file to its definitions; the elements are those of ANSI/AIAA S-119-2011, annex B."""

from __future__ import annotations

import math
from pathlib import Path

from freebody.dave_ml.definitions import Author, Definitions, Header, Reference, Shot, Signal, Variable
from freebody.dave_ml.mathml import read_math
from freebody.dave_ml.numbers import number, optional_number
from freebody.dave_ml.read_functions import read_functions
from freebody.dave_ml.units import si
from freebody.dave_ml.xml_tree import Node, read_xml

__all__ = ["read_dave_ml"]


def read_dave_ml(path: Path) -> Definitions:
    """What a file defines; raises `ModelFileError`."""
    root = read_xml(path)
    if root.tag != "DAVEfunc":
        raise root.error(f"the root is <{root.tag}>; a DAVE-ML file has <DAVEfunc>")
    nodes = _by_id(root)
    functions = read_functions(root, {id: node.attributes.get("units", "") for id, node in nodes.items()})
    tabulated = {function.dependent: function for function in functions}
    for id, function in tabulated.items():
        if nodes[id].child("calculation") is not None:
            raise nodes[id].error(
                f"has a calculation, and the function {function.name!r} of line {function.line}; keep one",
                id,
            )
    variables = tuple(_variable(node, id in tabulated) for id, node in nodes.items())
    return Definitions(str(path), _header(root), variables, functions, _shots(root, variables))


def _by_id(root: Node) -> dict[str, Node]:
    nodes: dict[str, Node] = {}
    for node in root.all("variableDef"):
        id = node.attribute("varID")
        if id in nodes:
            raise node.error(
                f"the varID stands on line {nodes[id].line} already; give each variable its own", id
            )
        nodes[id] = node
    if not nodes:
        raise root.error("has no <variableDef>; a model has variables")
    return nodes


def _variable(node: Node, tabulated: bool) -> Variable:
    id = node.attribute("varID")
    has = {tag: node.child(tag) is not None for tag in ("isInput", "isControl", "isDisturbance", "isState")}
    calculation = node.child("calculation")
    given = any(has.values())
    if (has["isInput"] or has["isControl"] or has["isDisturbance"]) and (
        calculation is not None or tabulated
    ):
        raise node.error("is an input, and has a calculation or a function that gives it; one of the two", id)
    initial = optional_number(node, "initialValue", id)
    if calculation is not None:
        role = "computed"
    elif tabulated:
        role = "tabulated"
    else:
        role = "input" if given or initial is None else "constant"
    minimum, maximum = (optional_number(node, f"{end}Value", id) for end in ("min", "max"))
    if minimum is not None and maximum is not None and minimum > maximum:
        raise node.error(f"minValue {minimum:g} is above maxValue {maximum:g}", id)
    description = node.child("description")
    return Variable(
        name=node.attributes.get("name", id),
        id=id,
        units=node.attributes.get("units", ""),
        role=role,
        output=node.child("isOutput") is not None,
        description="" if description is None else description.words(),
        symbol=node.attributes.get("symbol", ""),
        sign=node.attributes.get("sign", ""),
        axis_system=node.attributes.get("axisSystem", ""),
        standard=node.child("isStdAIAA") is not None,
        initial=initial,
        minimum=minimum,
        maximum=maximum,
        expression=None if calculation is None else read_math(calculation, id),
        line=node.line,
    )


def _header(root: Node) -> Header:
    node = root.child("fileHeader") or Node("fileHeader", {}, root.file, root.line)
    date, version, description = (
        node.child(*tags)
        for tags in (("creationDate", "fileCreationDate"), ("fileVersion",), ("description",))
    )

    def cited(reference: Node) -> Reference:
        get = reference.attributes.get
        keys = ("refID", "author", "title", "date", "accession", "xlink:href")
        return Reference(*(get(key, "") for key in keys))

    return Header(
        name=node.attributes.get("name", ""),
        authors=tuple(
            Author(a.attributes.get("name", ""), a.attributes.get("org", "")) for a in node.all("author")
        ),
        date="" if date is None else date.attributes.get("date", ""),
        version="" if version is None else version.words(),
        description="" if description is None else description.words(),
        references=tuple(map(cited, node.all("reference"))),
    )


def _shots(root: Node, variables: tuple[Variable, ...]) -> tuple[Shot, ...]:
    check_data = root.child("checkData")
    if check_data is None:
        return ()
    ids = {variable.id: variable for variable in variables}
    names = ids | {variable.name: variable for variable in reversed(variables)}

    def signals(shot: Node, tag: str) -> tuple[Signal, ...]:
        group = shot.child(tag)
        return () if group is None else tuple(_signal(node, ids, names) for node in group.all("signal"))

    return tuple(
        Shot(
            shot.attributes.get("name", f"shot {i}"),
            *(signals(shot, tag) for tag in ("checkInputs", "internalValues", "checkOutputs")),
        )
        for i, shot in enumerate(check_data.all("staticShot"), start=1)
    )


def _signal(node: Node, ids: dict[str, Variable], names: dict[str, Variable]) -> Signal:
    """A signal by name, seen from outside, or by ID; in the variable's units."""
    label = node.needed("signalName", "varID", "signalID")
    known = names if label.tag == "signalName" else ids
    variable = known.get(label.words())
    if variable is None:
        raise label.error(f"<{label.tag}> {label.words()!r} is no variable of this file")
    value = number(node.needed("signalValue"), node.needed("signalValue").text, variable.id)
    tolerance = node.child("tol")
    allowed = None if tolerance is None else number(tolerance, tolerance.text, variable.id)
    units = node.child("signalUnits")
    factor = 1.0 if units is None else _factor(units, variable)
    return Signal(variable.id, value * factor, None if allowed is None else math.fabs(allowed * factor))


def _factor(units: Node, variable: Variable) -> float:
    came, own = si(units.words()), si(variable.units)
    if came is None or own is None:
        return 1.0
    if came.dimension != own.dimension:
        raise units.error(
            f"the check data are in {units.words()!r}, the variable in {variable.units!r}, another quantity",
            variable.id,
        )
    return came.factor / own.factor
