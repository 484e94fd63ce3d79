"""Stages and events in model files: the same as in Python, and what their errors say."""

import re

import numpy as np
import pytest
import xarray as xr

import freebody as fb
from freebody import plots, report, results
from freebody.elements import Propulsion, Tank, Thruster
from freebody.environment import Environment
from freebody.errors import ModelFileError
from freebody.model_file import load_model, shipped_model

FILE = """\
[model]
name = "two stages"
[environment]
planet = "flat"
[body]
name = "both"
mass = 42.0
com = [0.2, 0.0, 0.01]
inertia_about_com = { principal = [1.0, 8.0, 8.5] }
[[forces]]
type = "propulsion"
[[forces.thrusters]]
at = [-1.0, 0.0, 0.0]
direction = [1.0, 0.0, 0.0]
thrust = 6000.0
specific_impulse = 250.0
tanks = "fuel"
[[forces.tanks]]
name = "fuel"
mass = 60.0
com = [0.1, 0.0, 0.0]
[[stages]]
name = "upper"
begins = { signal = "fuel_mass", below = "100 g" }
origin = "[100, 0, 0] cm"
rotation = { angles = "[90, 0, 0] deg", sequence = "zyx" }
velocity_increment = [0.0, 1.5, 0.0]
angular_velocity_increment = "[0, 1, 0] deg/s"
states = { "propulsion.fuel_mass" = "20 kg" }
[stages.body]
mass = 12.0
inertia_about_com = { principal = [0.4, 1.5, 1.4] }
[[stages.forces]]
type = "propulsion"
[[stages.forces.thrusters]]
at = [0.0, -1.0, 0.0]
direction = [0.0, 1.0, 0.0]
thrust = 2000.0
specific_impulse = 280.0
tanks = "fuel"
throttle = "throttle"
[[stages.forces.tanks]]
name = "fuel"
mass = 25.0
com = [0.0, 0.0, 0.0]
[stages.inputs]
throttle = 0.5
[[stages]]
name = "payload"
begins = "50 s"
[stages.body]
mass = 5.0
inertia_about_com = { principal = [0.4, 1.5, 1.4] }
[[events]]
name = "far"
distance = [0.0, 0.0, 1.0]
above = "20 km"
terminal = false
[[events]]
name = "throttled"
signal = "throttle"
above = 0.9
[initial]
angular_velocity_body = [0.1, 0.02, 0.0]
[simulation]
end = "100 s"
[output]
save_every = 2.0
points = { tip = [1.0, 0.0, 0.0] }
tracks = { com = { point = "com" } }
"""


@pytest.fixture
def load(tmp_path):
    """Loads a text as the model file stages.toml."""

    def load(text=FILE):
        path = tmp_path / "stages.toml"
        path.write_text(text)
        return load_model(path)

    return load


def in_python():
    """What the file says."""

    def engine(at, thrust, impulse, mass, com, throttle):
        thruster = Thruster(
            at, -np.asarray(at), thrust, specific_impulse=impulse, tanks="fuel", throttle=throttle
        )
        return Propulsion([thruster], [Tank("fuel", mass, com)], env)

    @fb.event(direction="falling", inputs={"fuel_mass": "kg"})
    def burnout(s):
        return s.inputs.fuel_mass - 0.1

    env = Environment()
    bodies = [
        fb.RigidBody(m, com, inertia_about_com=np.diag(moments))
        for m, com, moments in (
            (42.0, (0.2, 0.0, 0.01), (1.0, 8.0, 8.5)),
            (12.0, (0.0, 0.0, 0.0), (0.4, 1.5, 1.4)),
            (5.0, (0.0, 0.0, 0.0), (0.4, 1.5, 1.4)),
        )
    ]
    both = fb.Model(bodies[0], [engine([-1, 0, 0], 6e3, 250.0, 60.0, [0.1, 0, 0], 1.0)], environment=env)
    upper = fb.Model(
        bodies[1], [engine([0, -1, 0], 2e3, 280.0, 25.0, [0, 0, 0], "throttle")], environment=env
    )
    stages = [
        fb.Stage(both, until=burnout),
        fb.Stage(
            upper,
            until=50.0,
            origin=[1.0, 0.0, 0.0],
            rotation=fb.Attitude.angles("zyx", np.deg2rad([90.0, 0.0, 0.0])).as_rotation(),
            velocity_increment=[0.0, 1.5, 0.0],
            angular_velocity_increment=np.deg2rad([0.0, 1.0, 0.0]),
            states={"propulsion.fuel_mass": 20.0},
            inputs=[0.5],
        ),
        fb.Stage(fb.Model(bodies[2], environment=env)),
    ]
    start = both.state(angular_velocity_body=[0.1, 0.02, 0.0])
    return fb.simulate_stages(stages, start, (0.0, 100.0), save_every=2.0)


def test_a_file_is_what_simulate_stages_does_bit_for_bit(load):
    ours, theirs = load().simulate(), in_python()
    assert [len(stage) for stage in ours.stages] == [len(stage) for stage in theirs.stages]
    for stage, other in zip(ours.stages, theirs.stages, strict=True):
        np.testing.assert_array_equal(stage.t, other.t)
        np.testing.assert_array_equal(stage.x, other.x)
        np.testing.assert_array_equal(stage.u, other.u)


def test_at_a_separation_that_pushes_nothing_both_parts_have_the_momentum_of_the_whole(load):
    pushes = re.compile(r"^(angular_)?velocity_increment.*\n", re.MULTILINE)
    run = load(pushes.sub("", FILE)).simulate()
    whole, upper = run.stages[0], run.stages[1]
    # The point of the whole that is the new origin moves as the new origin does.
    arm = whole.world_from_body[-1] @ [1.0, 0.0, 0.0]
    np.testing.assert_allclose(upper.position_world[0], whole.position_world[-1] + arm, rtol=1e-15)
    velocity = whole.velocity_world[-1] + np.cross(whole.angular_velocity_world[-1], arm)
    # Two rotations of a velocity of 2 km/s, each rounded.
    np.testing.assert_allclose(upper.velocity_world[0], velocity, atol=1e-11)
    np.testing.assert_allclose(upper.angular_velocity_world[0], whole.angular_velocity_world[-1], atol=1e-15)
    # What is left behind, with the rest of the fuel: together they have the momentum of the whole.
    left_mass = whole.mass[-1] - upper.mass[0]
    left_com = (
        whole.mass[-1] * whole.com_position_world[-1] - upper.mass[0] * upper.com_position_world[0]
    ) / left_mass
    left_velocity = whole.velocity_world[-1] + np.cross(
        whole.angular_velocity_world[-1], left_com - whole.position_world[-1]
    )
    momentum = left_mass * left_velocity + upper.mass[0] * upper.com_velocity_world[0]
    np.testing.assert_allclose(momentum, whole.momentum_world[-1, :3], rtol=1e-12, atol=1e-9)


def test_events_are_watched_by_the_stages_that_have_their_signals(load):
    loaded = load()
    names = [[event.name for event in stage.events] for stage in loaded.stages]
    assert names == [["far"], ["far", "throttled"], ["far"]]
    run = loaded.simulate()
    assert [event.name for event in run.events] == ["fuel_mass below 0.1 kg", "far"]
    ending, far = run.events
    assert np.isclose(ending.state[-1], 0.1, rtol=1e-12)
    seen = np.linalg.norm(far.state[:3])
    assert abs(seen - 20e3) < 1.5  # the point is a metre from the origin, and the body turns


def test_a_terminal_event_ends_the_whole_run(load):
    run = load(FILE.replace('above = "20 km"\nterminal = false', 'above = "1 km"')).simulate()
    assert (run.outcome.status, run.outcome.event, len(run.stages)) == ("event", "far", 1)


def test_a_fall_ends_at_the_ground_and_an_ensemble_of_falls_too(load):
    text = """\
[model]
name = "fall"
[environment]
planet = { type = "flat", altitude = "10 m" }
[body]
mass = 1.0
com = [0.0, 0.0, 0.5]
inertia_about_com = { principal = [1.0, 1.0, 1.0] }
[[forces]]
type = "gravity"
[[events]]
name = "ground"
altitude = "com"
below = 0.0
[dispersions.mass]
kind = "uniform"
low = 1.0
high = 2.0
[simulation]
end = 60.0
"""
    loaded = load(text)
    run = loaded.simulate()
    # The mass centre falls 9.5 m; the method is exact for parabolas.
    assert run.outcome.event == "ground"
    assert np.isclose(run.outcome.time, np.sqrt(2.0 * 9.5 / 9.80665), rtol=1e-12)
    runs = loaded.ensemble(3).run(loaded.t_span)
    np.testing.assert_allclose(runs.event_times["ground"], run.outcome.time, rtol=1e-12)


def test_an_ensemble_says_what_to_do_instead(load):
    with pytest.raises(ModelFileError, match="simulate_stages") as caught:
        load().ensemble(10)
    assert caught.value.key == "stages"


def test_the_dataset_has_all_stages_one_after_another(load, tmp_path):
    loaded = load()
    run = loaded.simulate()
    tracks = [loaded.tracks(stage) for stage in run.stages]
    dataset = results.to_dataset(run, points=loaded.output.points, tracks=tracks)
    results.save(dataset, tmp_path / "run.nc")
    with xr.open_dataset(tmp_path / "run.nc", engine="h5netcdf") as stored:
        assert stored["stage"].attrs["flag_meanings"] == "both upper payload"
        for number, stage in enumerate(run.stages, 1):
            part = stored.isel(time=stored["stage"].values == number)
            np.testing.assert_array_equal(part["time"], stage.t)
            np.testing.assert_array_equal(part["position_world"], stage.position_world)
            np.testing.assert_array_equal(part["mass"], stage.mass)
            np.testing.assert_array_equal(part["com_altitude"], tracks[number - 1]["com"].altitude)
            np.testing.assert_array_equal(part["point_tip"], stage.point([1.0, 0.0, 0.0]))
            fuel = stage.states.get("propulsion.fuel_mass", np.full(len(stage), np.nan))
            np.testing.assert_array_equal(part["state_propulsion.fuel_mass"], fuel)
        np.testing.assert_array_equal(stored["separation_time"], [s.time for s in run.separations])
        x = stored["separation_after"].isel(separation=1)
        np.testing.assert_array_equal(x.dropna("state"), run.separations[1].after)
        assert list(stored["event"].values) == [event.name for event in run.events]
    results.save(run.to_xarray(), tmp_path / "run.csv")
    assert "stage [1]" in (tmp_path / "run.csv").read_text().splitlines()[0]


def test_the_figure_marks_the_separations_and_the_summary_says_them(load):
    run = load().simulate()
    drawing = plots.figure(run, title="two stages")
    dashed = [line for line in drawing.axes[0].lines if line.get_linestyle() == "--"]
    assert [np.asarray(line.get_xdata())[0] for line in dashed] == [s.time for s in run.separations]
    assert {"Altitude", "Mass"} <= {axes.get_title(loc="left") for axes in drawing.axes}
    cells = [str(cell) for column in report.summary(run).columns for cell in column.cells]
    assert cells.count("separation") == 2
    assert any(cell.startswith("upper: ") and "32 to" in cell for cell in cells)


def test_check_and_run_say_the_stages(freebody, tmp_path):
    (tmp_path / "stages.toml").write_text(FILE)
    status, out, _ = freebody("check", "stages.toml")
    assert status == 0
    for part in ("stage 1", "stage 3", "upper, when fuel_mass below 0.1 kg", "payload, from 50 s on", "far"):
        assert part in out
    status, out, _ = freebody("run", "stages.toml")
    assert status == 0
    assert "stage 3 of 3 ('payload')" in out
    assert freebody("ensemble", "stages.toml", "-n", "3")[0] == 2


@pytest.mark.parametrize(
    ("old", "new", "key", "says"),
    [
        ('signal = "fuel_mass"', 'signal = "fuel"', "stages[0].begins.signal", "did you mean 'fuel_mass'"),
        ('below = "100 g"', 'below = "1 m"', "stages[0].begins.below", "'m' is no unit of a mass"),
        ('below = "100 g"', "", "stages[0].begins", "needs exactly one of below, above; came none"),
        ('begins = "50 s"', 'begins = "500 s"', "stages[1].begins", "before the end, 100 s"),
        ('begins = "50 s"', 'begins = "50 m"', "stages[1].begins", "'m' is no unit of a time"),
        ('begins = "50 s"\n', "", "stages[1].begins", "this key is missing"),
        ('name = "payload"', 'name = "upper"', "stages[1].name", "stands twice"),
        ("[stages.inputs]\nthrottle", "[stages.inputs]\nthrotle", "stages[0].inputs.throtle", "no input"),
        ("propulsion.fuel_mass", "propulsion.fuel", "stages[0].states.propulsion.fuel", "did you mean"),
        ('"20 kg"', '"20 m"', "stages[0].states.propulsion.fuel_mass", "'m' is no unit"),
        ("mass = 5.0", "mass = -5.0", "stages[1].body", "mass"),
        ("mass = 5.0", "mas = 5.0", "stages[1].body.mas", "did you mean 'mass'"),
        ("direction = [0.0, 1.0, 0.0]", "direction = 1.0", "stages[0].forces[0].thrusters[0].direction", "3"),
        ('signal = "throttle"', 'signal = "thrust"', "events[1].signal", "no signal 'thrust'"),
        ("above = 0.9", 'above = "1 m"', "events[1].above", "plain number"),
        ('above = "20 km"', 'above = "20 kg"', "events[0].above", "'kg' is no unit of a length"),
        ('name = "far"', 'name = "upper"', "events[0].name", "stands twice"),
        ("terminal = false", "terminal = 0", "events[0].terminal", "true or false"),
    ],
)
def test_errors_name_the_key(load, old, new, key, says):
    assert FILE.count(old) >= 1
    with pytest.raises(ModelFileError) as caught:
        load(FILE.replace(old, new, 1))
    assert caught.value.key == key
    assert says in str(caught.value)


def test_the_rocket_that_comes_with_freebody_lands_where_its_track_says():
    loaded = load_model(shipped_model("two_stage_rocket"))
    run = loaded.simulate()
    assert isinstance(run, fb.StagedTrajectory)
    assert run.outcome.event == "impact"
    first, second = (loaded.tracks(stage)["com"] for stage in run.stages)
    assert np.isclose(first.altitude[-1], second.altitude[0], atol=10.0)  # other mass centres, 4 m apart
    assert 150e3 < second.altitude.max() < 250e3
    assert [event.name for event in run.events] == ["lower_grain_mass below 0.1 kg", "100 km", "impact"]
    # By the rocket equation in vacuum; air and gravity take the rest.
    ideal = 9.80665 * 220.0 * np.log(run.stages[0].mass[0] / run.stages[0].mass[-1])
    assert 0.7 * ideal < first.speed[-1] < ideal
