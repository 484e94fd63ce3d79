"""What laws are once they are traced: plain data with names, units and values."""

import pickle
from typing import Any

import numpy as np
import pytest

from freebody import TraceError, _core
from freebody.errors import InputError, NonFiniteError
from freebody.tracing import Situation, callback, control, force, wrench

N_SITUATION = 23
RANDOM = np.random.default_rng(5)


@force(
    parameters={"area": (0.02, "m^2"), "density": (1.225, "kg/m^3"), "slope": ("20 deg", "rad")},
    inputs={"rudder": "rad"},
    states={"servo": (0.1, "rad")},
)
def fin(s: Any, p: Any) -> Any:
    """A fin behind the mass centre."""
    v = s.velocity_body
    size = p.density * p.area * v[0] * np.linalg.norm(v)
    force = np.array([0.0, -size * (s.states.servo + p.slope), 0.0])
    return wrench(force=force, moment=0.1 * force, at=[1.0, 0.0, 0.5]), {
        "servo": (s.inputs.rudder - s.states["servo"]) / 0.05
    }


@force
def weight(s: Any) -> Any:
    return wrench(force=s.mass * (s.world_from_body.T @ [0.0, 0.0, 9.81]), at=s.com)


@control(parameters={"gain": (2.0, "1/m")}, inputs={"course": "m"})
def steer(s: Any, p: Any) -> Any:
    """Steers back to the course."""
    return {"rudder": p.gain * (s.inputs.course - s.position_world[1]), "throttle": 0.5}


def run(law: Any, *extra: Any, values: Any = None) -> tuple[np.ndarray, np.ndarray]:
    given = np.hstack([RANDOM.normal(size=(20, N_SITUATION)), *extra])
    parameters = list(law.parameters.values()) if values is None else values
    return given, law._program.run(np.array(parameters), given)


def test_wrench_is_about_the_origin_with_the_rates_behind() -> None:
    given, got = run(fin, RANDOM.normal(size=(20, 2)))
    v, rudder, servo = given[:, 13:16], given[:, 23], given[:, 24]
    force = np.zeros((20, 3))
    force[:, 1] = -1.225 * 0.02 * v[:, 0] * np.linalg.norm(v, axis=1) * (servo + np.radians(20.0))
    moment = 0.1 * force + np.cross([1.0, 0.0, 0.5], force)
    wanted = np.column_stack([force, moment, (rudder - servo) / 0.05])
    np.testing.assert_allclose(got, wanted, rtol=1e-13, atol=1e-13)  # a few roundings


def test_situation_reads_the_layout_of_the_core() -> None:
    @control
    def read(s: Any) -> Any:
        parts = [s.time, s.position_world, s.world_from_body, s.twist, s.mass, s.com]
        return {f"c{i}": x for i, x in enumerate(np.concatenate([np.ravel(part) for part in parts]))}

    @control
    def halves(s: Any) -> Any:
        parts = np.hstack([s.velocity_body, s.angular_velocity_body])
        return {f"c{i}": x for i, x in enumerate(parts)}

    given, got = run(read)
    np.testing.assert_array_equal(got, given)
    given, got = run(halves)
    np.testing.assert_array_equal(got, given[:, 13:19])


def test_weight_acts_at_the_mass_centre() -> None:
    given, got = run(weight)
    rotation, com = given[:, 4:13].reshape(-1, 3, 3), given[:, 20:23]
    down = 9.81 * given[:, 19, None] * rotation[:, 2]
    np.testing.assert_allclose(got, np.hstack([down, np.cross(com, down)]), rtol=1e-13, atol=1e-13)


def test_law_says_what_it_is() -> None:
    assert (fin.name, fin.__doc__) == ("fin", "A fin behind the mass centre.")
    assert dict(fin.parameters) == {"area": 0.02, "density": 1.225, "slope": np.radians(20.0)}
    assert dict(fin.parameter_units) == {"area": "m^2", "density": "kg/m^3", "slope": "rad"}
    assert [tuple(q) for q in fin.inputs] == [("rudder", "rad")]
    assert [tuple(q) for q in fin.states] == [("servo", "rad", 0.1)]
    assert [tuple(q) for q in steer.commands] == [("rudder", "1"), ("throttle", "")]
    assert "area=0.02 m^2" in repr(fin)
    assert "input course (m)" in repr(steer)
    assert (weight.inputs, weight.states, dict(weight.parameters)) == ((), (), {})


def test_call_gives_another_law() -> None:
    large = fin(area=0.04, slope="10 deg", name="tail")
    assert (large.name, fin.name) == ("tail", "fin")
    assert large.parameters["area"] == 0.04
    assert large.parameters["slope"] == pytest.approx(np.radians(10.0), rel=1e-15)  # one product
    assert fin(area="0.04 m^2", slope="10 deg", name="tail") == large
    assert fin(area="1 ft^2").parameters["area"] == pytest.approx(0.3048**2, rel=1e-15)  # one product
    assert fin.parameters["area"] == 0.02


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"aera": 1.0}, "'aera' is no parameter; did you mean 'area'?"),
        ({"area": "1 kg"}, "'kg' does not measure what 'm^2' does"),
        ({"area": "1 lbf"}, "'lbf' does not measure what 'm^2' does"),
        ({"area": "1 florin"}, "cannot read the unit 'florin'"),
        ({"area": "big"}, "give a number, or a string of a number and a unit"),
        ({"area": np.inf}, "got inf"),
        ({"area": [1.0]}, "got [1.0]"),
        ({"name": ""}, "name: got ''"),
    ],
)
def test_wrong_values_are_refused(values: Any, message: str) -> None:
    with pytest.raises(InputError) as caught:
        fin(**values)
    assert message in str(caught.value)


def test_frequency_is_no_angular_velocity() -> None:
    @force(parameters={"rate": (1.0, "rad/s")})
    def turning(s: Any, p: Any) -> Any:
        return wrench([p.rate * 1.0, 0.0, 0.0])

    with pytest.raises(InputError, match="does not measure"):
        turning(rate="5 Hz")
    assert turning(rate="60 rpm").parameters["rate"] == pytest.approx(2.0 * np.pi, rel=1e-15)


def test_law_is_not_called_with_a_situation() -> None:
    with pytest.raises(InputError, match="by name"):
        fin(1.0)


def test_laws_compare_hash_and_pickle_by_content() -> None:
    for law in (fin, weight, steer):
        again = pickle.loads(pickle.dumps(law))
        assert again == law
        assert hash(again) == hash(law)
        assert repr(again) == repr(law)
    assert fin(area=0.03) != fin
    assert fin(name="other") != fin
    assert weight != fin


def test_core_gets_the_program_and_the_values(monkeypatch: pytest.MonkeyPatch) -> None:
    class Recorder:
        traced = staticmethod(lambda *arguments: arguments)

    monkeypatch.setattr(_core, "Force", Recorder)
    monkeypatch.setattr(_core, "Control", lambda *arguments: arguments, raising=False)
    assert fin(area=0.5).core() == (fin._program, [0.5, 1.225, np.radians(20.0)], 1)
    assert steer.core() == (steer._program, [2.0], 2, 0)


def test_units_follow_the_arithmetic() -> None:
    @force(parameters={"k": (1.0, "N s^2/m^2"), "d": (1.0, "N m s"), "lag": (1.0, "s")})
    def consistent(s: Any, p: Any) -> Any:
        v, w = s.velocity_body, s.angular_velocity_body
        drag = -p.k * np.linalg.norm(v) * v
        angle = np.arctan2(v[1], v[0]) + np.hypot(v[0], v[1]) / (1.0 + np.abs(v[2]))
        drag = np.where(s.time > p.lag, drag, 0.0) * np.cos(angle) + s.mass * v / p.lag + 1.0
        root = np.sqrt(s.position_world[0] ** 2 + 3.0) + (s.com[0] ** 3) ** (1 / 3)
        return wrench(force=drag, moment=-p.d * w + np.sign(v) * root * drag[0], at=s.com)

    assert dict(consistent.parameter_units)["k"] == "N s^2/m^2"


def kept_values() -> list[Any]:
    kept: list[Any] = []

    @force
    def keeping(s: Any) -> Any:
        kept.extend([s.time, s.twist, s.time > 1.0])
        return wrench()

    return kept


def test_a_value_that_escaped_cannot_be_used() -> None:
    number, array, condition = kept_values()[:3]
    for use in (
        lambda: number + 1.0,
        lambda: np.sin(array),
        lambda: array[0] * 2.0,
        lambda: np.where(condition, 1.0, 2.0),
        lambda: float(number),
        lambda: bool(condition),
    ):
        with pytest.raises(TraceError, match="used after its trace has ended") as caught:
            use()
        assert caught.value.text is not None
        assert "lambda: " in caught.value.text


def situations(n: int, *, inputs: int = 0) -> np.ndarray:
    return RANDOM.normal(size=(N_SITUATION + inputs, n))


def test_callback_sees_what_a_traced_law_sees() -> None:
    def function(s: Situation) -> Any:
        assert s.time.shape == s.mass.shape == s.inputs.rudder.shape == (7,)
        assert s.twist.shape == (7, 6)
        assert not s.twist.flags.writeable
        force = s.mass[:, None] * np.einsum("nij,i->nj", s.world_from_body, [0.0, 0.0, 9.81])
        return wrench(force=force + s.inputs["rudder"][:, None], at=s.com)

    @force(inputs={"rudder": "N"})
    def same(s: Any) -> Any:
        total = s.mass * (s.world_from_body.T @ [0.0, 0.0, 9.81]) + s.inputs.rudder
        return wrench(force=total, at=s.com)

    called = callback(function, inputs={"rudder": "N"}, name="slow")
    assert called.name == "slow"
    given = situations(7, inputs=1)
    wanted = same._program.run(np.zeros(0), np.ascontiguousarray(given.T)).T
    np.testing.assert_allclose(called._wrenches(given), wanted, rtol=1e-13, atol=1e-13)


def test_callback_may_return_an_array_or_one_wrench() -> None:
    ones = callback(lambda s: np.ones((4, 6)))._wrenches(situations(4))
    np.testing.assert_array_equal(ones, np.ones((6, 4)))
    one = callback(lambda s: wrench([1.0, 2.0, 3.0]))._wrenches(situations(4))
    np.testing.assert_array_equal(one.T, np.tile([1.0, 2.0, 3.0, 0.0, 0.0, 0.0], (4, 1)))


@pytest.mark.parametrize(
    ("result", "error", "message"),
    [
        (lambda s: np.ones((6, 4)), InputError, r"shape \(6, 4\); for 4 situations"),
        (lambda s: None, InputError, "for 4 situations"),
        (lambda s: "no", InputError, "no array of numbers"),
        (lambda s: wrench(np.ones((4, 2))), InputError, r"force: got shape \(4, 2\)"),
        (lambda s: wrench(np.ones((4, 3)), np.ones((5, 3))), InputError, "do not go together"),
        (lambda s: np.full((4, 6), np.nan), NonFiniteError, "returned nan as component 0 of wrench 0"),
        (lambda s: s.inputs.rudder, InputError, "'rudder' is no input"),
        (lambda s: s.velocty_body, InputError, "did you mean 'velocity_body'"),
    ],
)
def test_wrong_callback_is_told(result: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        callback(result)._wrenches(situations(4))


def test_only_functions_are_called_back() -> None:
    with pytest.raises(InputError, match="give a function"):
        callback(3)  # pyright: ignore[reportArgumentType]
