"""Events and outputs as plain data: names, units, parameters, and what they refuse."""

import pickle
from typing import Any

import numpy as np
import pytest

from freebody import TraceError
from freebody.errors import InputError
from freebody.tracing import EventLaw, OutputLaw, event, output


@event(
    direction="rising", terminal=False, parameters={"height": (2.0, "m")}, inputs={"wind": "m/s"}, name="gate"
)
def passes(s: Any, p: Any) -> Any:
    """A height is passed."""
    return s.position_world[2] + p.height + 0.0 * s.inputs.wind


@output(unit="J", take="max")
def energy(s: Any) -> Any:
    return 0.5 * s.mass * (s.velocity_body @ s.velocity_body)


def test_they_say_what_they_are() -> None:
    assert (passes.name, passes.direction, passes.terminal) == ("gate", "rising", False)
    assert passes.__doc__ == "A height is passed."
    assert dict(passes.parameters) == {"height": 2.0}
    assert [tuple(q) for q in passes.inputs] == [("wind", "m/s")]
    assert (energy.name, energy.unit, energy.take) == ("energy", "J", "max")
    assert "height=2 m" in repr(passes)


def test_what_is_not_said_has_a_default() -> None:
    @event
    def plain(s: Any) -> Any:
        return s.time

    @output
    def known(s: Any) -> Any:
        return s.velocity_body[0] * s.time

    @output
    def unknown(s: Any) -> Any:
        return 2.0 * s.time

    assert (plain.terminal, plain.direction) == (True, "both")
    assert (known.unit, known.take, unknown.unit) == ("m", "final", "")


@pytest.mark.parametrize("law", [passes, energy])
def test_they_are_plain_data(law: Any) -> None:
    again = pickle.loads(pickle.dumps(law))
    assert again == law
    assert hash(again) == hash(law)


def test_a_call_gives_another_law() -> None:
    high = passes(height="3 m", name="high gate")
    assert (high.name, dict(high.parameters), high.direction) == ("high gate", {"height": 3.0}, "rising")
    assert high != passes
    assert passes(height=3.0, name="high gate") == high


def test_what_they_are_belongs_to_them() -> None:
    def law(s: Any) -> Any:
        return s.time

    kinds = [EventLaw(law, t, d) for t in (True, False) for d in ("rising", "falling")]
    kinds += [OutputLaw(law, u, take) for u in ("s", None) for take in ("min", "max")]
    for i, a in enumerate(kinds):
        # An output's unit is that of its number when none is given.
        same = [j for j, b in enumerate(kinds) if a == b]
        assert same == ([i] if i < 4 else sorted({i, (i - 4 + 2) % 4 + 4}))


def number(s: Any) -> Any:
    return s.time


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: event(direction="up")(number), ["number: direction", "'up'", "rising"]),  # type: ignore[arg-type]
        (lambda: event(terminal=1)(number), ["number: terminal", "True or False"]),  # type: ignore[arg-type]
        (lambda: output(take="mean")(number), ["number: take", "'mean'", "max"]),  # type: ignore[arg-type]
        (lambda: output(unit="ft")(number), ["number: unit", "'ft'", "SI"]),
        (lambda: event(3), ["fb.event", "3"]),  # type: ignore[call-overload]
        (lambda: output(parameters={"name": (1.0, "m")})(number), ["name"]),
        (lambda: passes(depth=3.0), ["gate", "'depth' is no parameter", "height"]),
    ],
)
def test_wrong_declarations_are_refused(make: Any, words: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        make()
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(
    ("law", "words"),
    [
        (lambda s: None, ["returned None", "return one number"]),
        (lambda s: s.position_world, ["returned", "return one number"]),
        (lambda s: {"height": s.time}, ["returned", "return one number"]),
        (lambda s: s.time > 3.0, ["returned a condition", "return one number"]),
        (lambda s: s.states.servo, ["'servo' is no state"]),
        (lambda s: s.time + s.mass, ["adds s and kg"]),
    ],
)
@pytest.mark.parametrize("decorator", [event, output])
def test_wrong_results_are_refused(decorator: Any, law: Any, words: list[str]) -> None:
    with pytest.raises(TraceError) as caught:
        decorator(law)
    for word in words:
        assert word in str(caught.value)


def test_the_unit_of_an_output_is_that_of_its_number() -> None:
    with pytest.raises(TraceError, match=r"what is returned is in m/s and must be in m;"):
        output(unit="m")(lambda s: s.velocity_body[0])
    assert output(unit="m")(lambda s: 2.0 * s.velocity_body[0]).unit == "m"  # 2.0 has any unit


def test_programs_read_the_situation() -> None:
    given = np.random.default_rng(3).normal(size=(20, 23))
    got = energy.program.run(np.array([]), given)[:, 0]
    np.testing.assert_allclose(got, 0.5 * given[:, 19] * (given[:, 13:16] ** 2).sum(axis=1), rtol=1e-14)
