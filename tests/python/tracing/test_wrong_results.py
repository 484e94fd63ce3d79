"""Laws that return, name or measure wrongly."""

from typing import Any

import numpy as np
import pytest

from freebody.tracing import wrench
from python.tracing.wrong_laws import WITH_STATE, Cases, check

case = CASES = Cases()


# Shapes and results


@case("could not be broadcast", "shapes must go together")
def broadcast(s: Any, p: Any) -> Any:
    return wrench(s.twist * s.velocity_body)  # here


@case("mismatch", "shapes must go together")
def product_of_shapes(s: Any, p: Any) -> Any:
    return wrench(np.eye(4) @ s.velocity_body)  # here


@case("force of shape (2,)", "(3,)")
def short_force(s: Any, p: Any) -> Any:
    return wrench(force=s.velocity_body[:2])  # here


@case("moment of shape ()", "(3,)")
def number_as_moment(s: Any, p: Any) -> Any:
    return wrench(moment=s.time)  # here


@case("returned", "return fb.wrench(")
def another_result(s: Any, p: Any) -> Any:
    return s.velocity_body  # here


@case("returned None", "return fb.wrench(")
def no_result(s: Any, p: Any) -> Any:
    wrench()  # here


@case("returned", "return fb.wrench(")
def rates_without_states(s: Any, p: Any) -> Any:
    return wrench(), {"servo": 1.0}  # here


@case("a law with states returns fb.wrench(...)", '{"servo": ...}', **WITH_STATE)
def states_without_rates(s: Any, p: Any) -> Any:
    return wrench()  # here


@case("no rate of the state 'servo'", "all states", **WITH_STATE)
def missing_rate(s: Any, p: Any) -> Any:
    return wrench(), {}  # here


@case("rate of 'srvo', no state of it", "did you mean 'servo'?", **WITH_STATE)
def unknown_rate(s: Any, p: Any) -> Any:
    return wrench(), {"servo": 0.0, "srvo": 0.0}  # here


@case("the rate of servo came with shape (3,)", "one number", **WITH_STATE)
def rate_of_another_shape(s: Any, p: Any) -> Any:
    return wrench(), {"servo": s.velocity_body}  # here


@case("returned the rates", "by name", **WITH_STATE)
def rates_without_names(s: Any, p: Any) -> Any:
    return wrench(), [s.states.servo]  # here


# Names


@case("'positon_world' is nothing that the situation s has", "did you mean 'position_world'?")
def unknown_of_the_situation(s: Any, p: Any) -> Any:
    return wrench(s.positon_world)  # here


@case("'ruder' is no input", "did you mean 'rudder'?")
def unknown_input(s: Any, p: Any) -> Any:
    return wrench([s.inputs.ruder, 0.0, 0.0])  # here


@case("'aera' is no parameter", "did you mean 'area'?")
def unknown_parameter(s: Any, p: Any) -> Any:
    return wrench([p["aera"], 0.0, 0.0])  # here


@case("'servo' is no state", "declare it")
def unknown_state(s: Any, p: Any) -> Any:
    return wrench([s.states.servo, 0.0, 0.0])  # here


# Units


@case("adds m and kg", "units must agree")
def sum_of_units(s: Any, p: Any) -> Any:
    return wrench(s.position_world + s.mass)  # here


@case("compares s and 1", "units must agree")
def comparison_of_units(s: Any, p: Any) -> Any:
    return wrench(np.where(s.time > s.inputs.rudder, 1.0, [0.0, 0.0, 0.0]))  # here


@case("np.where chooses between s and kg", "units must agree")
def choice_of_units(s: Any, p: Any) -> Any:
    return wrench([np.where(s.time > 0, s.time, s.mass), 0.0, 0.0])  # here


@case("np.sin of a value in m", "must have no unit")
def sine_of_a_length(s: Any, p: Any) -> Any:
    return wrench(np.sin(s.position_world))  # here


@case("adds m^2/s^2 and 1/s^2", "units must agree")
def length_of_a_twist(s: Any, p: Any) -> Any:
    return wrench([np.linalg.norm(s.twist), 0.0, 0.0])  # here


@case("force[0] is in kg m/s and must be in N", "a factor is missing")
def momentum_as_force(s: Any, p: Any) -> Any:
    return wrench(s.mass * s.velocity_body)  # here


@case("moment[1] is in N and must be in N m", "a factor is missing")
def force_as_moment(s: Any, p: Any) -> Any:
    return wrench(moment=[0.0, s.inputs.thrust, 0.0])  # here


@case("at[0] is in s and must be in m", "a factor is missing")
def time_as_place(s: Any, p: Any) -> Any:
    return wrench([1.0, 0.0, 0.0], at=[s.time, 0.0, 0.0])  # here


@case("the rate of servo is in 1 and must be in 1/s", "a factor is missing", **WITH_STATE)
def rate_without_time(s: Any, p: Any) -> Any:
    return wrench(), {"servo": s.inputs.rudder - s.states.servo}  # here


@pytest.mark.parametrize("name", CASES)
def test_wrong_law_is_refused_at_its_line(name: str) -> None:
    check(CASES[name])
