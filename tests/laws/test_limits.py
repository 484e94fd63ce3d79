"""Where tables end, water is deep, fuel runs out and places mean nothing: the run goes on and says so."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import Aerodynamics, Drag, Lookup, Propeller, Propulsion, Tank, Thruster
from freebody.environment import WGS84, Environment, RoundEarth, WindTable

from .scenes import BODY

TABLE = WindTable([0.0, 100.0], [[1.0, 0.0, 0.0], [5.0, 0.0, 0.0]])
AXES = {"alpha": (-0.1, 0.1), "beta": (-0.1, 0.1), "mach": (0.0, 0.2), "altitude": (0.0, 50.0)}


def told(model: fb.Model, x: Any, t: float = 0.1, **options: Any) -> list[str]:
    run = model.simulate(x, (0.0, t), **options)
    assert run.ok, run.outcome.message
    assert all(notice.message in run.outcome.message for notice in run.outcome.notices)
    return [notice.message for notice in run.outcome.notices]


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_tables_of_every_dimension(n: int) -> None:
    names = list(AXES)[:n]
    corners = np.random.default_rng(n).normal(size=(2,) * n)
    table = fb.Table(AXES["alpha"] if n == 1 else tuple(AXES[name] for name in names), corners)
    law = Aerodynamics(Environment(), 0.1, 1.0, 1.0, {"CX": Lookup(table, *names)})
    model = fb.Model(BODY, [law])
    # Above all of the ranges.
    x = model.state([0.0, 0.0, -100.0], velocity_world=[100.0, 50.0, 70.0])
    found = told(model, x, 1e-3)
    assert [m.split()[0] for m in found] == names
    assert all(m.endswith("of the tables of CX, which hold their border values") for m in found)
    pressure = 0.5 * 1.225 * (100.0**2 + 50.0**2 + 70.0**2) * 0.1
    assert model.wrench(0.0, x)[0] == pytest.approx(pressure * corners[(-1,) * n], rel=1e-12)


@pytest.mark.parametrize("given", ["thrust_coefficient", "torque_coefficient"])
@pytest.mark.parametrize("speed", ["speed", 10.0])
def test_the_advance_ratio_of_a_propeller(given: str, speed: str | float) -> None:
    coefficients: dict[str, Any] = {"thrust_coefficient": 0.1, given: fb.Table([0.0, 1.0], [0.1, 0.02])}
    propeller = Propeller(Environment(), [0, 0, 0], [1, 0, 0], 0.5, speed=speed, **coefficients)
    model = fb.Model(BODY, [propeller])
    what = given.removesuffix("_coefficient")
    words = (
        f"propeller: the advance ratio leaves 0 to 1 of the table of {what}, which holds its border values"
    )
    options: dict[str, Any] = {} if isinstance(speed, float) else {"inputs": [10.0]}
    assert told(model, model.state(velocity_body=[10.0, 0.0, 0.0]), **options) == [words]
    assert told(model, model.state(velocity_body=[-1.0, 0.0, 0.0]), **options) == [words]
    assert told(model, model.state(velocity_body=[0.5, 0.0, 0.0]), **options) == []


def tank(mass: float, com: Any = (0.3, 0, 0), **more: Any) -> fb.Model:
    nozzle = Thruster([-1, 0, 0], [1, 0, 0], 10.0, specific_impulse=100.0, tanks="fuel")
    return fb.Model(BODY, [Propulsion([nozzle], [Tank("fuel", mass, com, **more)])])


def test_fuel_that_runs_out_or_was_never_there() -> None:
    words = "the tank 'fuel' runs dry: its flow and its thrust fade"
    full = tank(0.02)
    assert told(full, full.state(), 5.0) == [words]
    # Less than nothing, that a dispersion may draw, flows no more than nothing.
    empty = tank(0.0, capacity=5.0)
    for mass in (0.0, -0.5):
        x = empty.state(states={"propulsion.fuel_mass": mass})
        assert told(empty, x) == [words]
        assert not empty.wrench(0.0, x).any()


def test_a_tank_that_holds_more_than_its_tables() -> None:
    rows: dict[str, Any] = {"com": [[0.3, 0, 0], [0.4, 0, 0]], "masses": [0.0, 5.0]}
    model = tank(5.0, **rows)
    assert told(model, model.state()) == []
    over = model.state(states={"propulsion.fuel_mass": 6.0})
    assert told(model, over) == ["the tank 'fuel' holds more than 5 kg, the last rows of its tables hold"]


def test_a_wind_table_that_ends_below_the_vehicle_is_said_by_whoever_asks_for_the_wind() -> None:
    """Also where the model was not told of the environment."""
    env = Environment(wind=TABLE)
    laws = [Drag(env, 0.1, 1.0), Propeller(env, [0, 0, 0], [1, 0, 0], 0.5, thrust_coefficient=0.1, speed=9.0)]
    model = fb.Model(BODY, laws)
    words = "wind table ends at 100 m, its last row holds"
    assert told(model, model.state([0.0, 0.0, -99.0], velocity_world=[0, 0, -50.0])) == [words]
    assert told(model, model.state([0.0, 0.0, 50.0])) == [
        "wind table begins at 0 m, its first row holds below"
    ]


@pytest.mark.parametrize("planet", [WGS84(), RoundEarth()], ids=["ellipsoid", "sphere"])
def test_the_centre_of_a_planet(planet: WGS84) -> None:
    model = fb.Model(BODY, [Drag(Environment(planet), 0.1, 1.0)])
    for position in (np.zeros(3), [1.0, 0.5, -0.2]):
        (words,) = told(model, model.state(position))
        assert words.startswith("near the planet's centre")
    # Normals of the ellipse meet no farther than this from the centre.
    e2 = 1.0 - (1.0 - planet.flattening) ** 2
    evolute = planet.radius * e2 / np.sqrt(1.0 - e2)
    for direction in (*np.eye(3), np.array([0.6, 0.0, 0.8])):
        assert told(model, model.state((evolute + 3e4) * direction)) == []
        assert len(told(model, model.state(0.999 * evolute * direction))) == 1
