"""Laws that call functions which cannot be traced, or use values where they cannot be used."""

from typing import Any

import numpy as np
import pytest

from freebody.tracing import wrench
from python.tracing.wrong_laws import Cases, check

case = CASES = Cases()


# Functions


@case("np.sort is not supported", "fb.callback")
def unsupported_function(s: Any, p: Any) -> Any:
    return wrench(np.sort(s.velocity_body))  # here


@case("np.linalg.eigvals is not supported", "fb.callback")
def unsupported_linear_algebra(s: Any, p: Any) -> Any:
    return wrench(np.linalg.eigvals(s.world_from_body))  # here


@case("np.logaddexp is not supported", "np.log")
def unsupported_ufunc(s: Any, p: Any) -> Any:
    return wrench([np.logaddexp(s.time, 1.0), 0.0, 0.0])  # here


@case("np.isnan is not supported", "np.where")
def unsupported_test(s: Any, p: Any) -> Any:
    return wrench(np.where(np.isnan(s.velocity_body), 0.0, 1.0))  # here


@case("np.linalg.det came with a matrix of shape (6, 6)", "(3, 3)")
def large_matrix(s: Any, p: Any) -> Any:
    return wrench([np.linalg.det(np.outer(s.twist, s.twist)), 0.0, 0.0])  # here


@case("another norm", "np.abs")
def norm_of_another_order(s: Any, p: Any) -> Any:
    return wrench([np.linalg.norm(s.velocity_body, 1), 0.0, 0.0])  # here


@case("loop of ufunc", "np.stack([...])")
def sine_of_objects(s: Any, p: Any) -> Any:
    return wrench(np.sin(np.array([s.inputs.rudder, 0.0, 0.0])))  # here


@case("table of traced values", "plain numbers")
def traced_table(s: Any, p: Any) -> Any:
    return wrench([np.interp(1.0, s.velocity_body, [0.0, 1.0, 2.0]), 0.0, 0.0])  # here


@case("where= or initial=", "np.where")
def masked_operation(s: Any, p: Any) -> Any:
    return wrench(np.add(s.velocity_body, 1.0, where=[True, False, True]))  # here


@case("without values", "np.where(condition, a, b)")
def places_of_a_condition(s: Any, p: Any) -> Any:
    return wrench(np.where(s.velocity_body > 0))  # here


@case("chooses by a number", "np.where(x > 0, a, b)")
def choice_by_a_number(s: Any, p: Any) -> Any:
    return wrench(np.where(s.velocity_body, 1.0, 0.0))  # here


@case("joins conditions with a number", "np.logical_and(a > 0, b > 0)")
def number_among_conditions(s: Any, p: Any) -> Any:
    return wrench(np.where((s.time > 0) & s.time, 1.0, [0.0, 0.0, 0.0]))  # here


@case("computes with a condition", "np.where(condition, 1.0, 0.0)")
def number_of_a_condition(s: Any, p: Any) -> Any:
    return wrench([(s.time > 0) + 1.0, 0.0, 0.0])  # here


@case("computes with", "real numbers")
def complex_number(s: Any, p: Any) -> Any:
    return wrench([s.time * 1j, 0.0, 0.0])  # here


# Writing and indices


@case("read-only", "s.twist.copy()")
def written_situation(s: Any, p: Any) -> Any:
    s.twist[0] = 0.0  # here
    return wrench()


@case("read-only", "s.twist.copy()")
def added_to_the_situation(s: Any, p: Any) -> Any:
    v = s.velocity_body
    v += 1.0  # here
    return wrench(v)


@case("s.mass is assigned", "copy")
def assigned_situation(s: Any, p: Any) -> Any:
    s.mass = 1.0  # here
    return wrench()


@case("the parameter area is assigned", "copy")
def assigned_parameter(s: Any, p: Any) -> Any:
    p.area = 1.0  # here
    return wrench()


@case("range()", "fixed range")
def traced_loop(s: Any, p: Any) -> Any:
    for _ in range(s.time):  # here
        pass
    return wrench()


@case("as an index", "np.where")
def traced_index(s: Any, p: Any) -> Any:
    return wrench([[1.0, 2.0][s.time], 0.0, 0.0])  # here


@case("no index", "np.interp")
def traced_index_of_an_array(s: Any, p: Any) -> Any:
    return wrench([np.arange(3.0)[s.time], 0.0, 0.0])  # here


@case("as an index", "np.where")
def condition_as_index(s: Any, p: Any) -> Any:
    v = s.velocity_body.copy()
    v[v < 0] = 0.0  # here
    return wrench(v)


@case("as an index", "np.where")
def condition_as_choice(s: Any, p: Any) -> Any:
    return wrench(s.velocity_body[s.velocity_body > 0])  # here


@pytest.mark.parametrize("name", CASES)
def test_wrong_law_is_refused_at_its_line(name: str) -> None:
    check(CASES[name])
