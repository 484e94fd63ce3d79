"""Parameters of the environment belong to all laws that ask for the flow, and are dispersed at once."""

from typing import Any

import numpy as np
import pytest

import freebody as fb
from environment_scenes import BODY, drag
from freebody.environment import ConstantWind, Environment, UniformAtmosphere, USStandard1976


def pieces(speed: float, density: float = 1.0) -> tuple[fb.Model, Any, Any]:
    env = Environment(atmosphere=USStandard1976(density_factor=density), wind=ConstantWind([speed, 0.0, 0.0]))

    @fb.output(parameters=env.parameters, unit="Pa", take="max")
    def pressure(s: Any, p: Any) -> Any:
        flow = env.flow(s, p)
        return 0.5 * flow.air.density * (flow.velocity @ flow.velocity)

    @fb.event(parameters={"limit": (2000.0, "Pa"), **env.parameters}, terminal=False)
    def loaded(s: Any, p: Any) -> Any:
        flow = env.flow(s, p)
        return 0.5 * flow.air.density * (flow.velocity @ flow.velocity) - 1.0 * p.limit

    made = fb.Model(BODY, [fb.UniformGravity(), drag(env, "front", 0.02), drag(env, "back", 0.01)])
    return made, pressure, loaded


WATER = UniformAtmosphere.water()
DISPERSED = {
    "environment.wind_speed": fb.Uniform(2.0, 20.0),
    "environment.air_density_factor": fb.Uniform(0.9, 1.1),
}


def test_an_ensemble_over_the_wind_is_models_made_with_that_wind() -> None:
    made, pressure, loaded = pieces(10.0)
    x0 = made.state(position=[0.0, 0.0, -2000.0], velocity_world=[60.0, 0.0, 0.0])
    ensemble = made.ensemble(x0, DISPERSED, n=6, seed=2, outputs=[pressure], events=[loaded])
    runs = ensemble.run((0.0, 10.0), save_every=5.0)
    assert runs.samples is not None
    for r, (speed, density) in enumerate(runs.dispersed):
        own, own_pressure, own_loaded = pieces(speed, density)
        run = own.simulate(x0, (0.0, 10.0), outputs=[own_pressure], events=[own_loaded], save_every=5.0)
        # The same programs with the same numbers.
        assert (run.outcome.state == runs.final[r]).all()
        assert (run.x == runs.samples[r]).all()
        assert run.outputs["pressure"] == runs.outputs["pressure"][r]
        alone = runs.trajectory(r)
        assert alone.outputs["pressure"] == runs.outputs["pressure"][r]
        assert [e.time for e in alone.events] == [e.time for e in run.events]
    first = [runs.event_times["loaded"][r] for r in range(6)]
    assert np.ptp(first) > 0.0


def test_chunks_are_alike() -> None:
    made, pressure, _ = pieces(10.0)
    x0 = made.state(position=[0.0, 0.0, -2000.0], velocity_world=[60.0, 0.0, 0.0])
    ensemble = made.ensemble(x0, DISPERSED, n=4, seed=2, outputs=[pressure])
    runs, told = ensemble.run((0.0, 2.0)), []
    parts = [ensemble.chunk(first, 2, runs.settings, progress=told.append) for first in (0, 2)]
    for name in runs.chunk:
        np.testing.assert_array_equal(np.concatenate([part[name] for part in parts]), runs.chunk[name])
    assert told == [1, 2, 1, 2]


def test_shared_parameters_have_one_name() -> None:
    made, *_ = pieces(10.0)
    with pytest.raises(fb.InputError, match=r"did you mean 'environment.wind_speed'"):
        made.ensemble(made.state(), {"front.wind_speed": fb.Uniform(0.0, 1.0)}, n=2)
    own = drag(Environment(wind=ConstantWind([1.0, 2.0, 0.0])))
    assert own.shared == {"air_density_factor", "wind_speed", "wind_direction", "wind_down"}
    assert own(wind_speed=5.0).shared == own.shared


def test_two_environments_are_told_apart() -> None:
    air = Environment(wind=ConstantWind([5.0, 0.0, 0.0]))
    clash = Environment(atmosphere=WATER, wind=ConstantWind([1.0, 0.0, 0.0]))
    apart = Environment(atmosphere=WATER, wind=ConstantWind([1.0, 0.0, 0.0], name="current"))
    both = fb.Model(BODY, [drag(air, "sail"), drag(clash, "hull")])
    with pytest.raises(
        fb.InputError, match=r"the environment of forces\[0\] and to the environment of forces\[1\]"
    ):
        both.ensemble(both.state(), {"environment.wind_speed": fb.Uniform(0.0, 1.0)}, n=2)
    named = fb.Model(BODY, [drag(air, "sail"), drag(apart, "hull")])
    dispersed = {
        "environment.wind_speed": fb.Uniform(0.0, 9.0),
        "environment.current_speed": fb.Uniform(0.0, 1.0),
    }
    runs = named.ensemble(named.state(), dispersed, n=2).run((0.0, 1.0))
    own = named.ensemble(named.state(), dispersed, n=2).model(1)
    assert own.forces[0].parameters["wind_speed"] == runs.dispersed[1, 0]  # type: ignore[attr-defined]
    assert own.forces[1].parameters["current_speed"] == runs.dispersed[1, 1]  # type: ignore[attr-defined]


def test_water_has_the_figures_of_its_sources() -> None:
    sea, fresh = UniformAtmosphere.water().at(0.0), UniformAtmosphere.water("fresh").at(-50.0)
    assert (sea.density, fresh.density) == (1026.021, 999.1026)
    # Mackenzie's nine terms at 15 °C, salinity 35, the surface.
    t = 15.0
    sound = 1448.96 + 4.591 * t - 5.304e-2 * t**2 + 2.374e-4 * t**3
    assert sea.speed_of_sound == pytest.approx(sound, abs=0.05)  # printed with one decimal
    with pytest.raises(fb.InputError, match="kind: got 'salt'"):
        UniformAtmosphere.water("salt")  # type: ignore[arg-type]
    with pytest.raises(fb.InputError, match="density: got"):
        UniformAtmosphere(density=-1.0)
