"""Laws that depend on more than their arguments, or that are no laws."""

import pickle
import random
from collections.abc import Callable
from itertools import count
from typing import Any

import numpy as np
import pytest

from freebody import TraceError
from freebody.errors import InputError
from freebody.tracing import ForceLaw, control, force, wrench
from python.tracing.wrong_laws import Cases, check

case = CASES = Cases()


# Side effects and numbers that are none


COUNTER = count(1.0)
KEPT: list[Any] = []


@case("two runs of the function differ", "no side effects")
def random_force(s: Any, p: Any) -> Any:
    x = random.random() * s.inputs.thrust  # here
    return wrench([x, 0.0, 0.0])


@case("two runs of the function differ", "no side effects")
def counting_force(s: Any, p: Any) -> Any:
    n = next(COUNTER)
    return wrench([0.0, 0.0, n])  # here


@case("used after its trace has ended", "keep nothing")
def remembering_force(s: Any, p: Any) -> Any:
    KEPT.append(s.inputs.thrust)
    return wrench([KEPT[0] + 1.0, 0.0, 0.0])  # here


@case("a traced value is pickled", "no side effects")
def pickling_force(s: Any, p: Any) -> Any:
    pickle.dumps(s.time)  # here
    return wrench()


@case("divides by the constant zero", "finite numbers")
def division_by_zero(s: Any, p: Any) -> Any:
    return wrench(s.velocity_body / 0.0)  # here


@case("the logarithm of 0 is not finite", "finite numbers")
def logarithm_of_zero(s: Any, p: Any) -> Any:
    return wrench(np.log(np.zeros_like(s.velocity_body)))  # here


@case("constant inf", "leave out a bound")
def infinite_bound(s: Any, p: Any) -> Any:
    return wrench(np.clip(s.velocity_body, 0.0, np.inf))  # here


# Whatever else happens


@case("NameError: name 'density' is not defined", "")
def unknown_name(s: Any, p: Any) -> Any:
    return wrench(density * s.velocity_body)  # noqa: F821  # pyright: ignore  # here


def helper(x: Any) -> Any:
    return 1.0 if x > 0.0 else 0.0  # here


@case("`if`", "np.where")
def choice_in_a_helper(s: Any, p: Any) -> Any:
    return wrench([helper(s.time), 0.0, 0.0])


# Signatures


@case("the signature is without_arguments()", "def without_arguments(s)")
def without_arguments() -> Any:  # here
    return wrench()


@case("the signature is three_arguments(", "def three_arguments(s)")
def three_arguments(s: Any, p: Any, q: Any) -> Any:  # here
    return wrench()


@case("parameters are declared", "write def without_parameters(s, p)")
def without_parameters(s: Any) -> Any:  # here
    return wrench()


@case("no ordinary function", "without yield")
def generator(s: Any, p: Any) -> Any:  # here
    yield wrench()


@pytest.mark.parametrize("name", CASES)
def test_wrong_law_is_refused_at_its_line(name: str) -> None:
    check(CASES[name])


COMMANDS: dict[str, tuple[Callable[..., Any], str, str]] = {
    "no dictionary": (lambda s: s.time, "returned", "commands by name"),
    "empty": (lambda s: {}, "returned {}", "commands by name"),
    "shape": (lambda s: {"rudder": s.twist}, "the command 'rudder' came with shape (6,)", "one number"),
    "if": (lambda s: {"rudder": 1.0 if s.time > 0 else 0.0}, "`if`", "np.where"),
}


@pytest.mark.parametrize("name", COMMANDS)
def test_wrong_control_law_is_refused(name: str) -> None:
    law, happened, remedy = COMMANDS[name]
    with pytest.raises(TraceError) as caught:
        control(law)
    assert happened in str(caught.value)
    assert remedy in str(caught.value)
    assert caught.value.text


def one(s: Any, p: Any) -> Any:
    return wrench([p.area * 1.0, 0.0, 0.0])


DECLARATIONS: dict[str, tuple[dict[str, Any], str]] = {
    "no pair": ({"parameters": {"area": 0.02}}, "parameters['area']: got 0.02; give (value, unit)"),
    "no mapping": ({"parameters": ["area"]}, "parameters: got ['area']; give a dictionary"),
    "no name": ({"parameters": {"my area": (1.0, "m^2")}}, "parameters: got the name 'my area'"),
    "reserved": ({"parameters": {"name": (1.0, "m^2")}}, "name of the law itself"),
    "no unit": ({"parameters": {"area": (1.0, "")}}, 'has the unit "1"'),
    "unit of another system": ({"parameters": {"area": (1.0, "ft^2")}}, "cannot use the unit 'ft^2'"),
    "degrees": ({"inputs": {"rudder": "deg"}}, "inputs['rudder']: cannot use the unit 'deg'"),
    "unit that is none": ({"inputs": {"rudder": 3}}, "inputs['rudder']: got 3; give its unit as a string"),
    "value that is none": ({"parameters": {"area": (None, "m^2")}}, "parameters['area']: got None"),
    "not finite": ({"states": {"servo": (np.nan, "rad")}}, "states['servo']: got nan"),
    "start in another unit": ({"states": {"servo": ("1 m", "rad")}}, "'m' does not measure what 'rad' does"),
}


@pytest.mark.parametrize("name", DECLARATIONS)
def test_wrong_declaration_is_refused(name: str) -> None:
    declared, message = DECLARATIONS[name]
    with pytest.raises(InputError) as caught:
        force(**declared)(one)
    assert "one: " in str(caught.value)
    assert message in str(caught.value)


@pytest.mark.parametrize("function", [3, "fin", np.sin, None])
def test_only_functions_are_laws(function: Any) -> None:
    with pytest.raises(InputError, match="decorate a Python function"):
        ForceLaw(function)
