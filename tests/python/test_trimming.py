"""Steady flights of the F-16: conditions are met, inputs are kept, failures are told."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.environment import WGS84, ConstantWind, Environment, FlatEarth, USStandard1976
from freebody.trimming import trim
from freebody.vehicles import f16

# The solver goes on until rates are of rounding, 1e-15 of some hundreds.
STEADY = 1e-9


@pytest.fixture(scope="module")
def aircraft() -> fb.Model:
    return f16.model(0.3)


def rates(model: fb.Model, found: Any) -> Any:
    """Of the body velocities and the engine."""
    rate = model.derivative(0.0, found.x, found.u)
    return rate[model.state_names.index("velocity_x") :]


@pytest.mark.parametrize(
    "condition",
    [
        {},
        {"altitude": 3000.0, "heading": 2.0},
        {"flight_path": 0.1},
        {"flight_path": -0.05, "turn_rate": 0.1},
        {"turn_rate": -0.1, "altitude": 2000.0},
        {"sideslip": 0.05},
        {"roll": 0.2},
        {"pitch_rate": 0.1},
    ],
    ids=str,
)
def test_a_steady_flight_is_one(aircraft: fb.Model, condition: dict[str, Any]) -> None:
    found = trim(aircraft, airspeed=180.0, bounds=f16.LIMITS, **condition)
    assert found.residual < STEADY
    assert np.abs(rates(aircraft, found)).max() < STEADY
    run = aircraft.simulate(found.x, (0.0, 1e-3), inputs=found.u)
    velocity = run.com_velocity_world[0]
    assert np.linalg.norm(velocity) == pytest.approx(180.0, rel=1e-14)
    assert -velocity[2] / 180.0 == pytest.approx(np.sin(condition.get("flight_path", 0.0)), abs=STEADY)
    assert -run.com_position_world[0, 2] == pytest.approx(condition.get("altitude", 0.0), abs=1e-9)
    yaw, pitch, roll = run.angles("zyx")[0]
    assert (yaw, pitch, roll) == pytest.approx(
        (condition.get("heading", 0.0), found.pitch, found.roll), abs=1e-12
    )
    for name in ("sideslip", "roll"):
        if name in condition:
            assert getattr(found, {"sideslip": "beta"}.get(name, name)) == pytest.approx(
                condition[name], abs=STEADY
            )


def test_a_coordinated_turn_leaves_no_sideward_force(aircraft: fb.Model) -> None:
    found = trim(aircraft, airspeed=180.0, turn_rate=0.1)
    forces = fb.Model(aircraft.body, aircraft.forces[1:])
    wrench = forces.wrench(0.0, found.x, found.u)
    assert abs(wrench[1]) < 1e-9 * abs(wrench[2])


def test_in_every_chart_and_form_it_is_the_same(aircraft: fb.Model) -> None:
    reference = trim(aircraft, airspeed=180.0, turn_rate=0.1)
    for attitude, form in (("zyx", "quasi_velocity"), ("quaternion", "generalized"), ("xyz", "generalized")):
        model = fb.Model(aircraft.body, aircraft.forces, attitude, form)  # type: ignore[arg-type]
        found = trim(model, airspeed=180.0, turn_rate=0.1)
        assert np.array_equal(found.u, reference.u)
        assert model.simulate(found.x, (0.0, 1e-3), inputs=found.u).velocity_body[0] == pytest.approx(
            aircraft.simulate(reference.x, (0.0, 1e-3), inputs=reference.u).velocity_body[0], abs=1e-10
        )


def test_given_inputs_are_kept(aircraft: fb.Model) -> None:
    """Climb with a fixed throttle: the flight path is what it allows, so that it must be right."""
    level = trim(aircraft, airspeed=180.0)
    again = trim(aircraft, airspeed=180.0, inputs={"throttle": level.inputs["throttle"]})
    assert again.u == pytest.approx(level.u, abs=1e-12)
    with pytest.raises(fb.FreebodyError, match=r"no steady flight found; what remains is .*\(SI\)"):
        trim(aircraft, airspeed=180.0, inputs={"throttle": 0.9})


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"airspeed": 0.0}, "airspeed: got 0.0"),
        ({"altitude": "1 km"}, "altitude"),
        ({"roll": 0.1, "sideslip": 0.1}, "both came"),
        ({"inputs": {"trottle": 0.1}}, "did you mean 'throttle'"),
        ({"guess": {"power": 0.1}}, "engine.power"),
        ({"bounds": {"throttle": (1.0, 0.0)}}, "smaller than the second"),
        ({"bounds": {"throttle": 1.0}}, "bounds"),
    ],
)
def test_wrong_arguments_are_told(aircraft: fb.Model, wrong: dict[str, Any], words: str) -> None:
    arguments: dict[str, Any] = {"airspeed": 180.0} | wrong
    with pytest.raises(fb.InputError, match=words):
        trim(aircraft, **arguments)
    with pytest.raises(fb.InputError, match="model: got 3"):
        trim(3, airspeed=1.0)  # type: ignore[arg-type]


def test_altitude_is_that_of_the_environment() -> None:
    """A world origin at 3000 m: the flight is there, in the air of 3000 m."""
    air = USStandard1976()
    models = [f16.model(environment=Environment(FlatEarth(altitude=h), air)) for h in (0.0, 3000.0)]
    low, high = (trim(model, airspeed=180.0, altitude=3000.0, bounds=f16.LIMITS) for model in models)
    assert high.alpha == pytest.approx(low.alpha, abs=1e-10)
    assert high.x[2] - low.x[2] == pytest.approx(3000.0, abs=1e-9)


@pytest.mark.parametrize(
    ("environment", "message"),
    [
        (
            Environment(wind=ConstantWind([9.0, 0.0, 0.0])),
            "model: in ConstantWind; steady flight .* still air",
        ),
        (Environment(WGS84()), "model: over <WGS84"),
        (Environment(FlatEarth(axes="enu")), "model: over <FlatEarth.*enu"),
    ],
    ids=["wind", "ellipsoid", "enu"],
)
def test_other_surroundings_are_refused(environment: Environment, message: str) -> None:
    with pytest.raises(fb.InputError, match=message):
        trim(f16.model(environment=environment), airspeed=180.0)


def test_bounds_are_given_by_name(aircraft: fb.Model) -> None:
    with pytest.raises(fb.InputError, match=r"bounds: got 5; give \(low, high\) by name"):
        trim(aircraft, airspeed=180.0, bounds=5)  # type: ignore[arg-type]
