"""The aerodynamics of a DAVE-ML model as a force: any body frame, lanes, exact derivatives, refusals."""

import pickle
import re
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.dave_ml import DaveAerodynamics, load_dave_ml
from freebody.environment import Environment, UniformAtmosphere, Wind, WindHere
from freebody.errors import InputError
from laws.scenes import BODY, START, relative
from python.dave_ml.files import DART, calculation, variable, write
from python.dave_ml.test_models import dart

FOOT, DEGREE = 0.3048, np.pi / 180.0
MODEL = load_dave_ml(DART)
POINT = np.array([0.3, -0.1, 0.2])
TURN = fb.Attitude.angles("zyx", [0.7, -0.4, 1.9]).as_rotation()
DENSITY, SOUND = 1.1, 200.0


class Breeze(Wind):
    """A steady wind whose gust turns."""

    def here(self, place: Any, s: Any, p: Any) -> WindHere:
        return WindHere(np.array([1.5, -0.7, 0.2]), s.world_from_body.T @ np.array([0.01, -0.02, 0.03]))


WINDY = Environment(atmosphere=UniformAtmosphere(DENSITY, speed_of_sound=SOUND), wind=Breeze())


def element(environment: Environment = WINDY, **more: Any) -> DaveAerodynamics:
    return DaveAerodynamics(environment, MODEL, {"lag": "wake"}, **{"reference_point": POINT, **more})


def inputs(model: fb.Model, **values: float) -> list[float]:
    return [values.get(name, 0.0) for name in model.input_names]


def test_what_the_file_calls_standard_is_fed_and_the_rest_are_inputs_in_si():
    law = element()
    assert law.wiring == {
        "V": "trueAirspeed",
        "alpha": "angleOfAttack",
        "beta": "angleOfSideslip",
        "M": "mach",
        "q": "bodyAngularRate_Pitch",
        "fin": "finDeflection",
        "gust": "gust",
        "damped": "damped",
        "lag": "wake",
    }
    assert {q.name: q.unit for q in law.inputs} == {
        "finDeflection": "rad",
        "gust": "1",
        "damped": "1",
        "wake": "1",
    }
    assert law.parameters["reference_area"] == pytest.approx(0.2 * FOOT**2)
    assert law.parameters["reference_y"] == -0.1


@pytest.mark.parametrize("axes", ["wind", "stability"])
@pytest.mark.parametrize("turn", [np.eye(3), TURN], ids=["own axes", "other axes"])
def test_the_wrench_is_that_of_the_formulas(axes, turn):
    model = fb.Model(BODY, [element(body_from_aero=turn, lift_drag_axes=axes)])
    rng = np.random.default_rng(4)
    for _ in range(20):
        attitude = fb.Attitude.angles("zyx", rng.uniform(-1.0, 1.0, 3))
        R = attitude.as_rotation()
        v, w, fin = turn @ [30.0, *rng.uniform(-15.0, 15.0, 2)], rng.normal(size=3), rng.normal()
        x = model.state(attitude=attitude, velocity_body=v, angular_velocity_body=w)
        air = turn.T @ (v + np.cross(w, POINT) - R.T @ [1.5, -0.7, 0.2])
        rates = turn.T @ (w - R.T @ [0.01, -0.02, 0.03])
        speed = np.linalg.norm(air)
        alpha, beta = np.arctan2(air[2], air[0]), np.arcsin(air[1] / speed)
        units = {"V": speed / FOOT, "alpha": alpha / DEGREE, "beta": beta / DEGREE, "M": speed / SOUND}
        c = dart(**units, q=rates[1] / DEGREE, fin=fin / DEGREE, gust=0.3, damped=1.0, lag=0.1)
        lift, drag, side, *moments = (float(value) for value in c.values())
        ahead = air / speed if axes == "wind" else np.array([np.cos(alpha), 0.0, np.sin(alpha)])
        up = np.array([np.sin(alpha), 0.0, -np.cos(alpha)])
        pressure = 0.5 * DENSITY * speed**2 * 0.2 * FOOT**2
        force = pressure * turn @ (lift * up - drag * ahead + [0.0, side, 0.0])
        moment = pressure * turn @ (np.array([0.4, 0.5, 0.4]) * FOOT * moments)
        wanted = np.concatenate([force, moment + np.cross(POINT, force)])
        got = model.wrench(0.0, x, inputs(model, finDeflection=fin, gust=0.3, damped=1.0, wake=0.1))
        # Corners of tables that are continued keep thirteen digits.
        np.testing.assert_allclose(got, wanted, rtol=0, atol=1e-12 * np.abs(wanted).max())


def seen_from(origin, turn):
    """A run described in the frame at `origin` with axes `turn` (old from new), and the path of a point."""
    law = element(reference_point=turn.T @ (POINT - origin), body_from_aero=turn.T)
    model = fb.Model(BODY.in_frame(origin, turn), [fb.UniformGravity(), law])
    rotation, spin = START["attitude"].as_rotation(), np.array(START["angular_velocity_body"])
    x0 = model.state(
        START["position"] + rotation @ origin,
        fb.Attitude.rotation(rotation @ turn),
        velocity_body=turn.T @ (np.array([32.0, -2.0, 3.0]) + np.cross(spin, origin)),
        angular_velocity_body=turn.T @ spin,
    )
    given = inputs(model, finDeflection=0.1, damped=1.0, wake=0.2)
    run = model.simulate(x0, (0.0, 1.0), rtol=1e-11, save_every=0.1, inputs=given)
    assert run.ok
    return run, run.point(turn.T @ (np.array([0.5, 0.6, -0.7]) - origin))


def test_in_a_moved_and_turned_frame_the_motion_is_the_same():
    """Two runs, each to 1e-11 a step; corners of tables are passed at other steps."""
    run, path = seen_from(np.zeros(3), np.eye(3))
    other, same = seen_from(np.array([-0.7, 0.4, 0.9]), TURN)
    assert relative(same, path) < 1e-9
    assert np.abs(other.world_from_body - run.world_from_body @ TURN).max() < 1e-8


def test_drag_takes_power_with_the_airspeed():
    model = fb.Model(BODY, [element(Environment(), reference_point=np.zeros(3))])
    x = model.state(velocity_body=[40.0, 3.0, 5.0])
    wrench, speed = model.wrench(0.0, x, inputs(model)), np.linalg.norm([40.0, 3.0, 5.0])
    angles = {"alpha": np.arctan2(5.0, 40.0) / DEGREE, "beta": np.arcsin(3.0 / speed) / DEGREE}
    c = dart(V=speed / FOOT, **angles, M=speed / 340.294, q=0.0)
    pressure = 0.5 * 1.225 * speed**2 * 0.2 * FOOT**2
    side = c["aeroBodyForceCoefficient_Y"] * 3.0
    assert wrench[:3] @ [40.0, 3.0, 5.0] == pytest.approx(
        pressure * (side - c["totalCoefficientOfDrag"] * speed), rel=1e-12
    )


def test_the_jacobian_is_that_of_differences():
    """Inside the cells of tables: central differences err by h² of curvature and by rounding over h."""
    model = fb.Model(BODY, [element()], "zyx")
    x = np.concatenate([[1.0, 2.0, 3.0], [0.1, -0.05, 0.08], [40.0, -3.0, 4.0], [0.1, 0.2, -0.1]])
    u = np.array(inputs(model, finDeflection=0.1, gust=0.2, damped=1.0, wake=0.1))
    point, h = np.concatenate([x, u]), 1e-5

    def derivative(z):
        return model.derivative(0.0, z[:12], z[12:])

    steps = h * np.eye(16)
    wanted = np.column_stack([(derivative(point + e) - derivative(point - e)) / (2.0 * h) for e in steps])
    assert np.abs(np.hstack(model.jacobian(0.0, x, u)) - wanted).max() <= 1e-8 * np.abs(wanted).max()


def test_lanes_and_single_motions_agree():
    """Bit for bit, with parameters of the file and of the element dispersed."""
    law = element(constants=["pitch damping", "Cmf"], name="dart")
    assert law.parameters["Cmq"] == -8.0
    assert law.parameters["Cmf"] == pytest.approx(-0.02 / DEGREE)  # per degree in the file
    model = fb.Model(BODY, [fb.UniformGravity(), law])
    dispersed = {"dart.Cmq": fb.Uniform(-12.0, -4.0), "dart.reference_x": fb.Normal(0.3, 0.05)}
    x0 = model.state(**dict(START, velocity_body=[32.0, -2.0, 3.0]))
    ensemble = model.ensemble(x0, dispersed, n=9, inputs=inputs(model, finDeflection=0.1, damped=1.0))
    runs = ensemble.run((0.0, 0.5))
    assert np.ptp(runs.final[:, -2]) > 0.0
    for i in (0, 8):
        assert np.array_equal(runs.final[i], ensemble.trajectory(i, (0.0, 0.5)).x[-1])


def test_at_rest_nothing_acts_and_the_jacobian_is_finite():
    """Moving along an axis only, too: where angles have their singular directions."""
    model = fb.Model(
        BODY, [element(Environment(), lift_drag_axes=axes, name=axes) for axes in ("wind", "stability")]
    )
    still, u = model.state(), np.array(inputs(model, finDeflection=0.1))
    assert not model.wrench(0.0, still, u).any()
    for velocity in (np.zeros(3), 1e-9 * np.ones(3), *np.eye(3), *-np.eye(3)):
        x = model.state(velocity_body=velocity)
        assert np.isfinite(model.wrench(0.0, x, u)).all()
        assert all(np.isfinite(m).all() for m in model.jacobian(0.0, x, u))


def test_the_flow_is_met_where_it_is_said():
    """Turning about the flow point, the angles of attack there do not change."""
    model = fb.Model(BODY, [element(Environment(), flow_point=[0.0, 0.0, 0.0])])
    ahead, turning = (
        model.wrench(
            0.0,
            model.state(velocity_body=[40.0, 0.0, 0.0], angular_velocity_body=[0.0, 0.0, r]),
            inputs(model),
        )
        for r in (0.0, 2.0)
    )
    assert np.array_equal(ahead, turning)  # of yaw rate itself the dart feels nothing


def test_where_tables_are_left_is_noticed():
    law = element(name="dart")
    names = [notice.name for notice in law.notices]
    assert "dart: angleOfAttack outside -10 to 20 deg" in names
    assert "dart: angleOfSideslip outside -20 to 20 deg" in names  # of two tables the narrower
    model = fb.Model(BODY, [law])
    x0 = model.state(velocity_body=[450.0, 0.0, 0.0], angular_velocity_body=[0.0, 2.0, 0.0])
    run = model.simulate(x0, (0.0, 0.3), inputs=inputs(model))
    assert (
        "angleOfAttack outside -10 to 20 deg: tables of Dart hold their border values" in run.outcome.message
    )
    assert "from the start: mach outside 0 to 2 nd" in run.outcome.message  # from the start


def test_coefficients_of_body_axes_and_forces_themselves(tmp_path):
    """Thrust in pounds along forward, moment in foot-pounds; body axes coefficients; all add up."""
    lines = [
        variable("aeroBodyForceCoefficient_X", initialValue="-0.5"),
        variable("aeroBodyForceCoefficient_Z", initialValue="-2"),
        variable("thrustBodyForce_X", initialValue="10").replace('"nd"', '"lbf"'),
        variable("aeroBodyMoment_Yaw", initialValue="3").replace('"nd"', '"ftlbf"'),
        variable("referenceWingArea", initialValue="2").replace('"nd"', '"m2"'),
    ]
    law = DaveAerodynamics(Environment(), load_dave_ml(write(tmp_path, "\n".join(lines))))
    model = fb.Model(BODY, [law])
    pound, pressure = 4.4482216152605, 0.5 * 1.225 * 100.0 * 2.0
    wanted = [-0.5 * pressure + 10.0 * pound, 0.0, -2.0 * pressure, 0.0, 0.0, 3.0 * FOOT * pound]
    np.testing.assert_allclose(
        model.wrench(0.0, model.state(velocity_body=[0.0, 10.0, 0.0])), wanted, rtol=1e-15
    )


def test_mappings_name_what_the_file_calls_otherwise(tmp_path):
    lines = [
        variable("a", "<isInput/>").replace('"nd"', '"deg"', 1),
        variable("throttle", "<isInput/>"),
        variable("slope", initialValue="2"),
        variable("up", calculation("<apply><times/><ci>a</ci><ci>slope</ci><ci>throttle</ci></apply>")),
        variable("other", calculation("<ci>a</ci>")),
    ]
    model = load_dave_ml(write(tmp_path, "\n".join(lines)))
    mapping = {"a": "angleOfAttack", "throttle": 3.0, "up": "liftCoefficient"}
    law = DaveAerodynamics(Environment(), model, mapping, reference_area=1.5)
    assert law.wiring == {"throttle": 3.0, "a": "angleOfAttack"}
    body = fb.Model(BODY, [law])
    x = body.state(velocity_body=[10.0, 0.0, 10.0])
    lift = 0.5 * 1.225 * 200.0 * 1.5 * (45.0 * 2.0 * 3.0)
    np.testing.assert_allclose(
        body.wrench(0.0, x)[:3], lift * np.sqrt(0.5) * np.array([1.0, 0.0, -1.0]), rtol=1e-14
    )


AREA = variable("referenceWingArea", initialValue="2").replace('"nd"', '"m2"')
X, LIFT = (
    variable(name, initialValue="1") for name in ("aeroBodyForceCoefficient_X", "totalCoefficientOfLift")
)
SPEED = variable("trueAirspeed", "<isInput/>")
DRAG = variable("totalCoefficientOfDrag", calculation("<ci>trueAirspeed</ci>"))
WRONG = [
    ([variable("mass", initialValue="1")], {}, "gives no force ()"),
    (
        [X, LIFT, AREA],
        {},
        "gives aeroBodyForceCoefficient_X, and totalCoefficientOfLift as well; leave one pair out",
    ),
    ([X], {}, "reference_area: "),
    ([X], {"reference_area": -1.0}, "reference_area: got -1.0; give one finite positive number"),
    (
        [variable("aeroBodyMomentCoefficient_Roll", initialValue="1"), AREA],
        {},
        "has no referenceWingSpan; give",
    ),
    (
        [X.replace('"nd"', '"ft"'), AREA],
        {},
        "'aeroBodyForceCoefficient_X' is in 'ft', which does not measure what '1'",
    ),
    ([SPEED, DRAG, AREA], {}, "'trueAirspeed' is in 'nd', which does not measure what 'm/s' does"),
    (
        [SPEED.replace('"nd"', '"furlong"'), DRAG, AREA],
        {},
        "the units 'furlong' of 'trueAirspeed' are not known",
    ),
    ([X, AREA], {"mapping": {"Y": "mach"}}, "'Y' is no variable"),
    ([X, AREA], {"mapping": {"referenceWingArea": "mach"}}, "mapping['referenceWingArea']: got 'mach'"),
    ([SPEED, DRAG, AREA], {"mapping": {"trueAirspeed": None}}, "None leaves out results; this is an input"),
    ([SPEED, DRAG, AREA], {"mapping": {"trueAirspeed": "my speed"}}, "got the name 'my speed'"),
    ([SPEED, DRAG, AREA], {"constants": ["trueAirspeed"]}, "constants: 'trueAirspeed' is input, in 'nd'"),
    (
        [X, AREA, LIFT],
        {"mapping": {"totalCoefficientOfLift": "aeroBodyForceCoefficient_X"}},
        "both; leave one out",
    ),
    ([X, AREA], {"lift_drag_axes": "body"}, "lift_drag_axes: got 'body'; allowed are 'wind', 'stability'"),
    ([X, AREA], {"reference_point": [1.0]}, "reference_point: got shape (1,); allowed is (3,)"),
    ([X, AREA], {"body_from_aero": 2 * np.eye(3)}, "body_from_aero: not a rotation matrix"),
]


@pytest.mark.parametrize(("lines", "arguments", "fault"), WRONG, ids=[w[2] for w in WRONG])
def test_what_does_not_fit_is_refused(lines, arguments, fault, tmp_path):
    model = load_dave_ml(write(tmp_path, "\n".join(lines)))
    with pytest.raises(InputError, match=re.escape(fault)):
        DaveAerodynamics(Environment(), model, **arguments)


def test_what_is_no_environment_or_model_is_refused():
    with pytest.raises(InputError, match="environment: got 3; give an Environment"):
        DaveAerodynamics(3, MODEL)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"model: got 'dart\.dml'; give what load_dave_ml returns"):
        DaveAerodynamics(Environment(), "dart.dml")  # type: ignore[arg-type]


def test_laws_pickle_and_compare():
    law = element()
    assert pickle.loads(pickle.dumps(law)) == law == element() != element(lift_drag_axes="stability")
