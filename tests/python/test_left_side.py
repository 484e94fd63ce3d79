"""Published states, wheels, added mass and contents as users give them: what is refused, and what pickles."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.environment import Environment

BODY = fb.RigidBody(10.0, (0.1, 0.0, -0.1), inertia_about_com=np.diag([1.0, 2.0, 2.5]))


@fb.force(inputs={"fin": "rad"})
def side(s: Any) -> Any:
    return fb.wrench(force=np.stack([0.0, 5.0 * s.inputs.fin, 0.0]))


@fb.force
def nothing(s: Any) -> Any:
    return fb.wrench()


def refused(match: str, *forces: fb.Force, control: fb.Control | None = None) -> None:
    with pytest.raises(fb.InputError, match=match):
        fb.Model(BODY, forces, control=control)


def steady(name: str = "servo") -> fb.ForceLaw:
    """A state that follows nothing."""

    @fb.force(states={"fin": (0.3, "rad")}, publishes=("fin",))
    def servo(s: Any) -> Any:
        return fb.wrench(), {"fin": -s.states.fin / 2.0}

    return servo(name=name)


def test_a_published_state_is_read_and_is_no_input() -> None:
    @fb.control(inputs={"fin": "rad", "wish": "rad"}, parameters={"gain": (1.0, "1/s")})
    def pilot(s: Any, p: Any) -> Any:
        return {"wanted": p.gain * (s.inputs.wish - s.inputs.fin)}

    @fb.force(states={"fin": (0.3, "rad")}, inputs={"wanted": "rad/s"}, publishes=("fin",))
    def servo(s: Any) -> Any:
        return fb.wrench(), {"fin": s.inputs.wanted}

    model = fb.Model(BODY, [side, servo], control=pilot)
    assert model.input_names == ("wish",)
    assert set(model.sources) == {"wish", "wanted", "fin"}
    run = model.simulate(model.state(), (0.0, 2.0), rtol=1e-12, save_every=0.5)
    exact = 0.3 * np.exp(-run.t)
    np.testing.assert_allclose(run.states["servo.fin"], exact, rtol=1e-11)
    np.testing.assert_allclose(run.commands["wanted"], -exact, rtol=1e-11)
    assert model.wrench(0.0, model.state())[1] == pytest.approx(1.5)


def test_without_inputs_of_u_there_is_the_applied_wrench() -> None:
    model = fb.Model(BODY, [steady(), side])
    assert model.input_names[:2] == ("force_x", "force_y")
    assert fb.Model(BODY, [side]).input_names == ("fin",)


def test_callbacks_read_published_states() -> None:
    def push(s: Any) -> Any:
        return fb.wrench(force=np.stack([0.0 * s.time, 5.0 * s.inputs.fin, 0.0 * s.time], axis=-1))

    callback = fb.callback(push, inputs={"fin": "rad"})
    traced, called = (fb.Model(BODY, [steady(), law]) for law in (side, callback))
    x = traced.state(velocity_body=(1.0, 2.0, 3.0))
    assert np.array_equal(traced.derivative(0.0, x), called.derivative(0.0, x))


def test_names_and_units_must_fit() -> None:
    refused("both publish it", steady("one"), steady("other"))
    refused("publishes it in 'rad', force 'side' reads it in 'm'", steady(), _reads("m"))
    refused("publishes a state of this name", fb.InputWrench(), _publishes("force_x", "N"))
    refused(
        "publishes 'fins', which is no state of it; its states are 'fin'",
        _with(steady(), publishes=("fins",)),
    )

    @fb.control
    def pilot(s: Any) -> Any:
        return {"fin": 0.1}

    refused("a state that force 'servo' publishes", steady(), side, control=pilot)

    @fb.event(inputs={"fin": "m"})
    def gone(s: Any) -> Any:
        return s.inputs.fin

    model = fb.Model(BODY, [steady(), side])
    with pytest.raises(fb.InputError, match="reads the input 'fin' in 'm'; the model has it in 'rad'"):
        model.simulate(model.state(), (0.0, 1.0), events=[gone])


def _reads(unit: str) -> fb.ForceLaw:
    return fb.ForceLaw(lambda s: fb.wrench(), inputs={"fin": unit}, name="side")


def _publishes(state: str, unit: str) -> fb.ForceLaw:
    def law(s: Any, p: Any) -> Any:
        return fb.wrench(), {state: -s.states[state] / p.lag}

    return fb.ForceLaw(law, {"lag": (1.0, "s")}, states={state: (0.0, unit)}, publishes=(state,))


def _with(law: fb.ForceLaw, **attributes: Any) -> fb.ForceLaw:
    vars(law).update(attributes)
    return law


def test_what_stands_on_the_left_is_checked() -> None:
    skew = np.zeros((6, 6))
    skew[0, 4] = 1.0
    refused(r"added_mass: entry \(1, 5\) is 1 and \(5, 1\) is 0", _with(nothing(), added_mass=skew))
    refused("added_mass: got shape", _with(nothing(), added_mass=np.eye(3)))
    refused(
        "with its added mass the mass matrix is not positive", _with(nothing(), added_mass=-11.0 * np.eye(6))
    )
    refused("spins: got 3", _with(nothing(), spins=(3,)))
    refused(
        "has the state 'speed', which the force has not",
        _with(nothing(), spins=(fb.Spin((0, 0, 1), 0.1, "speed"),)),
    )
    refused("'fin' is in 'rad'", _with(steady(), spins=(fb.Spin((0, 0, 1), 0.1, "fin"),)))
    wheel = _wheel(3.0)
    refused("without its wheels' inertia the mass matrix is not positive definite", wheel)
    refused("contents: got 'fuel'; make them with @fb.contents", _with(nothing(), contents=("fuel",)))
    for wrong in ({"axis": (0, 0, 0)}, {"axis": (0, 1)}, {"inertia": -1.0}, {"state": 3}):
        with pytest.raises(fb.InputError):
            fb.Spin(**{"axis": (0, 0, 1), "inertia": 1.0, "state": "speed", **wrong})  # type: ignore[arg-type]


def _wheel(inertia: float) -> fb.ForceLaw:
    @fb.force(states={"speed": (10.0, "rad/s")}, spins=(fb.Spin((0.0, 0.0, 2.0), inertia, "speed"),))
    def wheel(s: Any) -> Any:
        h = inertia * s.states.speed
        return fb.wrench(moment=-np.cross(s.angular_velocity_body, np.stack([0.0, 0.0, h]))), {
            "speed": 0.0 * s.states.speed / s.time
        }

    return wheel


def test_contents_are_checked() -> None:
    with pytest.raises(fb.TraceError, match=r"return fb.mass_properties"):

        @fb.contents
        def wrong(s: Any) -> Any:
            return 3.0

    with pytest.raises(fb.TraceError, match="mass is in m and must be in kg"):

        @fb.contents
        def length(s: Any) -> Any:
            return fb.mass_properties(mass=s.com[0])

    with pytest.raises(fb.TraceError, match=r"inertia_about_com of shape \(2,\)"):

        @fb.contents
        def flat(s: Any) -> Any:
            return fb.mass_properties(mass=1.0, inertia_about_com=(1.0, 2.0))

    @fb.contents(inputs={"fin": "rad"})
    def tank(s: Any) -> Any:
        return fb.mass_properties(mass=2.0 * np.sin(s.inputs.fin) ** 2 * s.mass)

    @fb.control
    def pilot(s: Any) -> Any:
        return {"fin": 0.1}

    carrier = _with(nothing(name="carrier"), contents=(tank,))
    refused("contents: 'tank' reads 'fin', which a control law commands", side, carrier, control=pilot)


def test_contents_of_inputs_and_of_nothing() -> None:
    @fb.contents(inputs={"load": "kg"}, parameters={"reach": (2.0, "m")})
    def cargo(s: Any, p: Any) -> Any:
        half = 0.1 * s.inputs.load
        tensor = np.array([[1.0, 0.1, 0.0], [0.1, 1.0, 0.0], [0.0, 0.0, 2.0]]) * half
        return fb.mass_properties(s.inputs.load, (0.0, p.reach, 0.0), tensor)

    # Of every kind that the kernel keeps ready for arms that do not change.
    others = [
        fb.UniformGravity(),
        fb.LinearDamping([1.0, 2.0, 3.0, 0.1, 0.2, 0.3]),
        fb.ConstantWrench((1.0, 2.0, 3.0), (0.1, 0.2, 0.3), at=(0.2, -0.3, 0.4)),
        fb.InputWrench(at=(0.5, 0.1, -0.2)),
    ]
    model = fb.Model(BODY, [_with(nothing(), contents=(cargo(reach=3.0),)), *others])
    assert model.input_names[-1] == "load"
    x = model.state(velocity_body=(1.0, 0.0, 0.0), angular_velocity_body=(0.0, 0.3, 0.4))
    load = fb.RigidBody(
        5.0, (0.0, 3.0, 0.0), inertia_about_com=[[0.5, 0.05, 0.0], [0.05, 0.5, 0.0], [0.0, 0.0, 1.0]]
    )
    for weight, whole in ((0.0, BODY), (5.0, BODY + load)):
        push = [0.5, -0.4, 0.3, 0.02, 0.03, -0.05]
        u = [*push, weight]
        bare = fb.Model(whole, others)
        np.testing.assert_allclose(
            model.derivative(0.0, x, u), bare.derivative(0.0, x, push), rtol=1e-13, atol=1e-14
        )
        run, other = model.simulate(x, (0.0, 1.0), inputs=u), bare.simulate(x, (0.0, 1.0), inputs=push)
        for name in ("momentum_world", "energy", "com_position_world", "com_velocity_world"):
            np.testing.assert_allclose(getattr(run, name)[-1], getattr(other, name)[-1], rtol=1e-7)
        np.testing.assert_allclose(run.inertia_about_com[0], whole.inertia_about_com, rtol=1e-13, atol=1e-14)
        assert run.mass[0] == whole.mass
        np.testing.assert_allclose(run.com[0], whole.com)


def test_models_pickle_with_all_of_it() -> None:
    model = fb.Model(BODY, [_wheel(0.2), steady(), side], environment=Environment(), name="all")
    again = pickle.loads(pickle.dumps(model))
    x = model.state(angular_velocity_body=(0.1, 0.2, 0.3))
    assert np.array_equal(model.derivative(1.0, x), again.derivative(1.0, x))
    assert isinstance(again.environment, Environment)
    assert again.forces == model.forces
    assert _wheel(0.2) == _wheel(0.2) != _wheel(0.3)
    assert hash(_wheel(0.2)) == hash(_wheel(0.2))
    assert fb.compile(model).environment is model.environment
    with pytest.raises(fb.InputError, match="environment: got 'earth'"):
        fb.Model(BODY, environment="earth")  # type: ignore[arg-type]
