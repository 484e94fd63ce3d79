"""Laws that ask a traced value whether it is true, or which number it is."""

import math
from typing import Any

import numpy as np
import pytest

from freebody.tracing import wrench
from python.tracing.wrong_laws import Cases, check

case = CASES = Cases()


# Truth


@case("`if`", "np.where(condition, a, b)")
def python_if(s: Any, p: Any) -> Any:
    if s.time > 1.0:  # here
        return wrench()
    return wrench()


@case("`if`", "np.where(condition, a, b)")
def truth_of_a_number(s: Any, p: Any) -> Any:
    if s.time:  # here
        return wrench()
    return wrench()


@case("`if`", "np.where(condition, a, b)")
def python_choice(s: Any, p: Any) -> Any:
    x = 1.0 if s.time > 1.0 else 2.0  # here
    return wrench([x, 0.0, 0.0])


@case("`if`", "np.where(condition, a, b)")
def truth_of_an_array(s: Any, p: Any) -> Any:
    if s.twist > 0.0:  # here
        return wrench()
    return wrench()


@case("`if` in a comprehension", "np.where(condition, a, b)")
def comprehension(s: Any, p: Any) -> Any:
    return wrench([x for x in s.velocity_body if x > 0])  # here


@case("`while`", "fixed range")
def python_while(s: Any, p: Any) -> Any:
    x = s.time
    while x > 1.0:  # here
        x = x - 1.0
    return wrench()


@case("`assert`", "leave it out")
def python_assert(s: Any, p: Any) -> Any:
    assert p.area > 0.0  # here
    return wrench()


@case("`and`", "np.logical_and")
def python_and(s: Any, p: Any) -> Any:
    x = np.where(s.time > 1.0 and s.time < 2.0, 1.0, 0.0)  # here
    return wrench([x, 0.0, 0.0])


@case("`or`", "np.logical_or")
def python_or(s: Any, p: Any) -> Any:
    x = np.where(s.time > 1.0 or s.time < 0.0, 1.0, 0.0)  # here
    return wrench([x, 0.0, 0.0])


@case("`not`", "np.logical_not")
def python_not(s: Any, p: Any) -> Any:
    x = np.where(not s.time > 1.0, 1.0, 0.0)  # here
    return wrench([x, 0.0, 0.0])


@case("chained comparison", "np.logical_and(a < b, b < c)")
def chained(s: Any, p: Any) -> Any:
    x = np.where(0.0 < s.time < 1.0, 1.0, 0.0)  # here
    return wrench([x, 0.0, 0.0])


@case("chained comparison", "np.logical_and(a < b, b < c)")
def chained_if(s: Any, p: Any) -> Any:
    if 0.0 < s.time < 1.0:  # here
        return wrench()
    return wrench()


@case("np.equal", "np.abs(a - b) < tolerance")
def equality(s: Any, p: Any) -> Any:
    x = np.where(s.time == 1.0, 1.0, 0.0)  # here
    return wrench([x, 0.0, 0.0])


@case("np.not_equal", "np.abs(a - b) > tolerance")
def inequality(s: Any, p: Any) -> Any:
    if s.time != 1.0:  # here
        return wrench()
    return wrench()


@case("max()", "np.maximum(a, b)")
def python_max(s: Any, p: Any) -> Any:
    x = max(s.time, 1.0)  # here
    return wrench([x, 0.0, 0.0])


@case("min()", "np.minimum(a, b)")
def python_min(s: Any, p: Any) -> Any:
    x = min(s.velocity_body)  # here
    return wrench([x, 0.0, 0.0])


@case("any()", "np.any")
def python_any(s: Any, p: Any) -> Any:
    x = np.where(any(s.velocity_body > 0), 1.0, 0.0)  # here
    return wrench([x, 0.0, 0.0])


@case("bool()", "np.where")
def python_bool(s: Any, p: Any) -> Any:
    x = bool(s.time > 0)  # here
    return wrench([x, 0.0, 0.0])


@case("sorted()", "np.maximum")
def python_sorted(s: Any, p: Any) -> Any:
    return wrench(sorted(s.velocity_body))  # here


@case("depends on a traced value", "np.stack([...])")
def comparison_of_objects(s: Any, p: Any) -> Any:
    x = np.array([s.time, 1.0]) > 0.5  # here
    return wrench([x[0], 0.0, 0.0])


@case("depends on a traced value", "np.stack([...])")
def maximum_of_objects(s: Any, p: Any) -> Any:
    return wrench(np.maximum(np.array([s.time, 1.0, 2.0]), 0.5))  # here


# Numbers


@case("math.sin()", "use np.sin")
def of_math(s: Any, p: Any) -> Any:
    return wrench([math.sin(s.inputs.rudder), 0.0, 0.0])  # here


@case("math.atan2()", "use np.arctan2")
def of_math_with_another_name(s: Any, p: Any) -> Any:
    return wrench([math.atan2(s.inputs.rudder, 1.0), 0.0, 0.0])  # here


@case("math.floor()", "use np.floor")
def floor_of_math(s: Any, p: Any) -> Any:
    return wrench([math.floor(s.inputs.rudder), 0.0, 0.0])  # here


@case("float()", "leave float() out")
def python_float(s: Any, p: Any) -> Any:
    return wrench([float(s.inputs.thrust), 0.0, 0.0])  # here


@case("int()", "np.floor")
def python_int(s: Any, p: Any) -> Any:
    return wrench([int(s.inputs.thrust), 0.0, 0.0])  # here


@case("round()", "np.floor(x + 0.5)")
def python_round(s: Any, p: Any) -> Any:
    return wrench([round(s.inputs.thrust), 0.0, 0.0])  # here


@case("np.round", "np.floor(x + 0.5)")
def numpy_round(s: Any, p: Any) -> Any:
    return wrench(np.round(s.velocity_body))  # here


@case("np.array()", "without dtype")
def array_of_floats(s: Any, p: Any) -> Any:
    return wrench(np.array([s.inputs.thrust, 0.0, 0.0], dtype=float))  # here


@case("np.float64()", "without dtype")
def number_of_numpy(s: Any, p: Any) -> Any:
    return wrench([np.float64(s.inputs.thrust), 0.0, 0.0])  # here


@case("written into an array", "np.stack")
def assignment_to_floats(s: Any, p: Any) -> Any:
    f = np.zeros(3)
    f[2] = s.inputs.thrust  # here
    return wrench(f)


@case("written into an array", "np.stack")
def assignment_of_an_array_to_floats(s: Any, p: Any) -> Any:
    f = np.zeros(3)
    f[:] = s.velocity_body  # here
    return wrench(f)


@case("written into an array of float64", "np.zeros_like(traced)")
def addition_to_floats(s: Any, p: Any) -> Any:
    f = np.zeros(3)
    f += s.velocity_body  # here
    return wrench(f)


@case("unsupported format string", "without a format")
def format_of_a_number(s: Any, p: Any) -> Any:
    _ = f"{s.time:.3f}"  # here
    return wrench()


@pytest.mark.parametrize("name", CASES)
def test_wrong_law_is_refused_at_its_line(name: str) -> None:
    check(CASES[name])
