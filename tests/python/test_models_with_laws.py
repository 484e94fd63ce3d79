"""Models with laws of users: inputs by name, auxiliary states, control, callbacks."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import freebody as fb
from freebody import _core
from freebody.forces import Control, Quantity, StateQuantity

BODY = fb.RigidBody(12.5, (0.12, -0.05, 0.08), inertia_about_com=np.diag([0.42, 0.91, 1.1]), name="hull")
LAG = 0.5
TWIST, MASS = 13, 19


class Law:
    """A program of the given numbers, traced by hand."""

    def __init__(self, given: int) -> None:
        self.graph = _core.Graph(False)
        self.given = [self.graph.symbol(f"g{k}", f"g_{k}") for k in range(given)]

    def __call__(self, operation: str, a: int, b: int) -> int:
        return self.graph.binary(operation, a, b)

    def number(self, x: float) -> int:
        return self.graph.constant(x)

    def program(self, outputs: list[int]) -> _core.Program:
        return self.graph.program([], self.given, outputs)


class Fin(fb.Force):
    """A side force of 3 N by a servo that lags behind the rudder: x' = (u - x) / LAG."""

    inputs = (Quantity("rudder", "rad"),)
    states = (StateQuantity("servo", "rad", 0.1),)

    def __init__(self, name: str = "fin") -> None:
        super().__init__(name)

    def core(self) -> _core.Force:
        law = Law(25)
        rudder, servo = law.given[23:]
        zero, side = law.number(0.0), law("mul", law.number(3.0), servo)
        rate = law("div", law("sub", rudder, servo), law.number(LAG))
        return _core.Force.traced(law.program([zero, side, zero, zero, zero, zero, rate]), [], 1)


class InMetres(Fin):
    inputs = (Quantity("rudder", "m"),)
    states = (StateQuantity("other", "rad", 0.0),)


class Pilot(Control):
    """rudder = reference - yaw rate."""

    inputs = (Quantity("reference", "rad/s"),)

    def __init__(self, command: str = "rudder", unit: str = "") -> None:
        super().__init__("pilot")
        self.commands = (Quantity(command, unit),)

    def core(self) -> _core.Control:
        law = Law(24)
        return _core.Control(law.program([law("sub", law.given[23], law.given[TWIST + 5])]), [], 1, 0)


class Looped(Pilot):
    inputs = (Quantity("rudder", "rad"),)


class Called(fb.Force):
    """What a function gives for the given numbers (23, n)."""

    def __init__(self, function: Callable[[np.ndarray], np.ndarray]) -> None:
        super().__init__("called")
        self.function = function

    def core(self) -> _core.Force:
        return _core.Force.callback(self.function, 0)


def weight(given: np.ndarray) -> np.ndarray:
    """Of 9.80665 m/s² along the third world axis, by the layout of the given numbers."""
    third = given[10:13]
    force = 9.80665 * given[MASS] * third
    moment = np.cross(given[20:23].T, force.T).T
    return np.concatenate([force, moment])


def spinning(model: fb.Model, **states: float) -> np.ndarray:
    own = {name.replace("_", "."): value for name, value in states.items()}
    return model.state(angular_velocity_body=[0.1, 0.2, 1.0], states=own)


@pytest.mark.parametrize("attitude", ["quaternion", "zyx"])
@pytest.mark.parametrize("form", ["quasi_velocity", "generalized"])
def test_auxiliary_states_stand_behind_the_rigid_ones(attitude: str, form: str) -> None:
    model = fb.Model(BODY, [fb.UniformGravity(), Fin()], attitude, form)  # type: ignore[arg-type]
    plain = fb.Model(BODY, [fb.UniformGravity()], attitude, form)  # type: ignore[arg-type]
    assert model.state_names == (*plain.state_names, "fin.servo")
    assert model.state_units == (*plain.state_units, "rad")
    assert (model.input_names, model.input_units) == (("rudder",), ("rad",))
    assert model.n_states == plain.n_states + 1
    assert model.n_inputs == 1
    assert model.state()[-1] == 0.1
    x = spinning(model, fin_servo=0.3)
    assert np.array_equal(x[:-1], spinning(plain))
    assert x[-1] == 0.3
    rate = model.derivative(0.0, x, [0.5])
    assert rate[-1] == (0.5 - 0.3) / LAG
    push = plain.derivative(0.0, x[:-1], [0.0, 0.9, 0.0, 0.0, 0.0, 0.0])
    np.testing.assert_allclose(rate[:-1], push, rtol=0, atol=1e-13)
    a, b = model.jacobian(0.0, x, [0.5])
    assert (a[-1, -1], b[-1, 0]) == (-1.0 / LAG, 1.0 / LAG)
    assert not a[-1, :-1].any()


def test_a_lag_follows_its_exponential() -> None:
    model = fb.Model(BODY, [Fin()], "zyx")
    run = model.simulate(spinning(model, fin_servo=0.3), (0.0, 3.0), inputs=[0.2], save_every=0.25)
    # The tolerance of 1e-9 a step, some tens of steps.
    np.testing.assert_allclose(run.states["fin.servo"], 0.2 + 0.1 * np.exp(-run.t / LAG), rtol=0, atol=1e-8)
    assert list(run.states) == ["fin.servo"]
    assert run.conserved() == []


def test_laws_of_one_input_share_it() -> None:
    model = fb.Model(BODY, [Fin("left"), Fin("right")])
    assert model.input_names == ("rudder",)
    assert model.state_names[-2:] == ("left.servo", "right.servo")
    assert np.array_equal(model.derivative(0.0, model.state(), [0.6])[-2:], [1.0, 1.0])


def test_wrench_inputs_beside_a_law_keep_their_places() -> None:
    both = fb.Model(BODY, [Fin(), fb.InputWrench()])
    assert both.input_names[:2] == ("rudder", "force_x")
    x = both.state()
    u = np.array([0.0, 1.0, 2.0, 3.0, 0.4, 0.5, 0.6])
    wrench = both.wrench(0.0, x, u) - both.wrench(0.0, x)
    np.testing.assert_allclose(wrench, u[1:], rtol=0, atol=1e-14)


def test_control_closes_the_loop() -> None:
    model = fb.Model(BODY, [Fin()], control=Pilot())
    assert (model.input_names, model.input_units) == (("reference",), ("rad/s",))
    assert (model.command_names, model.command_units) == (("rudder",), ("rad",))
    assert "control: pilot" in repr(model)
    run = model.simulate(spinning(model), (0.0, 2.0), inputs=[0.4], save_every=0.5)
    commanded = 0.4 - run.angular_velocity_body[:, 2]
    assert np.array_equal(run.commands["rudder"], commanded)
    assert np.array_equal(run.u, np.full((5, 1), 0.4))
    rate = model.derivative(0.0, run.x[1], [0.4])
    assert rate[-1] == pytest.approx((commanded[1] - run.x[1, -1]) / LAG, rel=1e-15)
    opened = fb.Model(BODY, [Fin()])
    np.testing.assert_allclose(rate, opened.derivative(0.0, run.x[1], [commanded[1]]), rtol=0, atol=1e-15)


def test_control_may_command_the_applied_wrench() -> None:
    model = fb.Model(BODY, [fb.UniformGravity()], control=Pilot("moment_y"))
    assert model.input_names == ("force_x", "force_y", "force_z", "moment_x", "moment_z", "reference")
    x = model.state(angular_velocity_body=[0.0, 0.0, 0.25])
    plain = fb.Model(BODY, [fb.UniformGravity()])
    expected = plain.wrench(0.0, x, [1.0, 2.0, 3.0, 4.0, 0.75, 5.0])
    np.testing.assert_allclose(model.wrench(0.0, x, [1.0, 2.0, 3.0, 4.0, 5.0, 1.0]), expected, atol=1e-13)
    assert model.simulate(x, (0.0, 0.1)).conserved() == []


def test_results_hold_states_and_commands() -> None:
    run = fb.Model(BODY, [Fin()], control=Pilot()).simulate(
        spinning(fb.Model(BODY, [Fin()])), (0.0, 1.0), save_every=0.5
    )
    data = run.to_xarray()
    assert np.array_equal(data["state_fin.servo"], run.states["fin.servo"])
    assert np.array_equal(data["command_rudder"], run.commands["rudder"])
    assert data["state_fin.servo"].attrs["units"] == data["command_rudder"].attrs["units"] == "rad"


def test_a_callback_gets_the_given_numbers() -> None:
    calls: list[tuple[int, ...]] = []

    def function(given: np.ndarray) -> np.ndarray:
        calls.append(given.shape)
        return weight(given)

    called, plain = fb.Model(BODY, [Called(function)]), fb.Model(BODY, [fb.UniformGravity()])
    x = spinning(plain)
    # A moment about the origin and back loses what its arm is long.
    np.testing.assert_allclose(called.derivative(0.3, x), plain.derivative(0.3, x), rtol=0, atol=1e-14)
    assert calls == [(23, 1)]
    np.testing.assert_allclose(called.wrench(0.3, x), plain.wrench(0.3, x), rtol=0, atol=1e-14)
    ends = [model.simulate(x, (0.0, 1.0)).x[-1] for model in (called, plain)]
    np.testing.assert_allclose(*ends, rtol=0, atol=1e-9)
    with pytest.raises(fb.InputError, match=r"^force 'called' is a callback.*trace it with @fb\.force$"):
        called.jacobian(0.0, x)


class OutOfOrderError(Exception):
    pass


def test_what_a_callback_raises_ends_the_run() -> None:
    error = OutOfOrderError("the pump is out of order")
    calls = []

    def function(given: np.ndarray) -> np.ndarray:
        calls.append(given[0, 0])
        if given[0, 0] > 0.5:
            raise error
        return weight(given)

    model = fb.Model(BODY, [Called(function)])
    x = model.state()
    for method, step in (("dop853", None), ("dp54", None), ("rk4", 0.01)):
        calls.clear()
        with pytest.raises(OutOfOrderError) as raised:
            model.simulate(x, (0.0, 1.0), method=method, step=step)  # type: ignore[arg-type]
        assert raised.value is error
        # Nothing is asked after it.
        assert sum(t > 0.5 for t in calls) == 1
    for ask in (model.derivative, model.wrench):
        with pytest.raises(OutOfOrderError):
            ask(1.0, x)
        ask(0.1, x)
    # Another run of the same model knows nothing of it.
    assert model.simulate(x, (0.0, 0.2)).ok


@pytest.mark.parametrize("returned", [np.zeros((5, 1)), np.zeros(6), [0.0] * 6, "wrench", None])
def test_what_is_no_wrench_is_refused(returned: object) -> None:
    model = fb.Model(BODY, [Called(lambda given: returned)])  # type: ignore[arg-type, return-value]
    with pytest.raises((fb.InputError, TypeError)):
        model.derivative(0.0, model.state())


def test_a_law_that_is_not_finite_is_named() -> None:
    fin, looped = fb.Model(BODY, [fb.UniformGravity(), Fin()]), fb.Model(BODY, [Fin()], control=Pilot())
    with pytest.raises(
        fb.NonFiniteError, match=r"force 'fin', its wrench or its states' rates, is not finite$"
    ):
        fin.derivative(0.0, spinning(fin, fin_servo=-1e308), [1.5e308])
    x = looped.state(angular_velocity_body=[0.0, 0.0, -1.5e308])
    with pytest.raises(fb.NonFiniteError, match=r"control law 'pilot' is not finite$"):
        looped.derivative(0.0, x, [1.5e308])


REFUSED = {
    "two laws of one name": (
        lambda: fb.Model(BODY, [Fin(), Fin()]),
        r"^state 'fin\.servo': two laws called 'fin' have it; give each its own name",
    ),
    "two units of one input": (
        lambda: fb.Model(BODY, [Fin(), InMetres("tail")]),
        r"^input 'rudder': force 'fin' reads it in 'rad', force 'tail' in 'm'; inputs of one name",
    ),
    "unknown command": (
        lambda: fb.Model(BODY, [Fin()], control=Pilot("ruder")),
        r"^control: 'pilot' commands 'ruder', which no force reads; .*, did you mean 'rudder'\?$",
    ),
    "command in another unit": (
        lambda: fb.Model(BODY, [Fin()], control=Pilot(unit="m")),
        r"^control: 'pilot' commands 'rudder' in 'm', force 'fin' reads it in 'rad'$",
    ),
    "reads what it commands": (
        lambda: fb.Model(BODY, [Fin()], control=Looped()),
        r"^control: 'pilot' reads 'rudder', the input that it commands",
    ),
    "no control law": (
        lambda: fb.Model(BODY, [Fin()], control=Fin()),  # type: ignore[arg-type]
        r"^control: got <Fin 'fin'>; give a control law, made by @fb\.control$",
    ),
    "unknown state": (
        lambda: fb.Model(BODY, [Fin()]).state(states={"servo": 0.1}),
        r"^states: got 'servo'; allowed are 'fin\.servo'$",
    ),
    "state of a model without": (
        lambda: fb.Model(BODY).state(states={"servo": 0.1}),
        r"^states: got 'servo'; allowed are none, for no law of this model has states$",
    ),
    "states that are none": (
        lambda: fb.Model(BODY, [Fin()]).state(states=[0.1]),  # type: ignore[arg-type]
        r"^states: got \[0\.1\]; give a dictionary",
    ),
    "state that is no number": (
        lambda: fb.Model(BODY, [Fin()]).state(states={"fin.servo": np.nan}),
        r"^states\['fin\.servo'\]: got nan; give one finite number$",
    ),
}


@pytest.mark.parametrize("which", REFUSED)
def test_laws_that_do_not_fit_are_refused(which: str) -> None:
    make, message = REFUSED[which]
    with pytest.raises(fb.InputError, match=message):
        make()
