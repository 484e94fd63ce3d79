"""Runs that are watched: events, outputs, what is stored of them, and what is refused."""

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody import results
from freebody.errors import InputError

G = 9.80665
METHODS = [("dop853", None), ("vern8", None), ("vern9", None), ("dp54", None), ("rk4", 0.01)]


@fb.event(direction="rising")
def ground(s: Any) -> Any:
    """The third axis points down."""
    return s.position_world[2]


@fb.event(direction="falling", terminal=False)
def apex(s: Any) -> Any:
    return -(s.world_from_body @ s.velocity_body)[2]


@fb.event(terminal=False, parameters={"height": (0.0, "m")})
def gate(s: Any, p: Any) -> Any:
    return s.position_world[2] + p.height


@fb.output(unit="m", take="max")
def altitude(s: Any) -> Any:
    return -s.position_world[2]


@fb.output(unit="m")
def distance(s: Any) -> Any:
    return s.position_world[0]


def thrown(**options: Any) -> tuple[fb.Model, np.ndarray]:
    """A spinning body whose origin is its mass centre."""
    body = fb.RigidBody(2.0, inertia_about_com=np.diag([1.0, 1.4, 1.9]))
    model = fb.Model(body, [fb.UniformGravity()], **options)
    start: dict[str, Any] = {"velocity_world": [3.0, 0.0, -8.0], "angular_velocity_body": [0.5, 3.0, -0.4]}
    return model, model.state([0.0, 0.0, -1.5], **start)


@pytest.fixture(scope="module")
def run() -> fb.Trajectory:
    model, x0 = thrown()
    return model.simulate(
        x0, (0.0, 5.0), events=[ground, apex, gate(height=2.0)], outputs=[altitude, distance]
    )


@pytest.mark.parametrize(("method", "step"), METHODS)
@pytest.mark.parametrize("attitude", ["quaternion", "zyx"])
@pytest.mark.parametrize("form", ["quasi_velocity", "generalized"])
def test_a_throw_is_seen_as_it_is(method: Any, step: Any, attitude: str, form: str) -> None:
    model, x0 = thrown(attitude=attitude, form=form)
    watched = {"events": [ground, apex], "outputs": [altitude, distance]}
    run = model.simulate(x0, (0.0, 5.0), method=method, step=step, **watched)
    impact = (8.0 + np.sqrt(64.0 + 2.0 * G * 1.5)) / G
    assert (run.outcome.status, run.outcome.event, run.ok) == ("event", "ground", True)
    assert [e.name for e in run.events] == ["apex", "ground"]
    # rtol 1e-9 a step of the motion; RK4's of the spin, 0.01⁴ times 3⁵ / 120.
    np.testing.assert_allclose([e.time for e in run.events], [8.0 / G, impact], rtol=1e-7)
    np.testing.assert_allclose(run.outputs["altitude"], 1.5 + 32.0 / G, rtol=1e-7)
    np.testing.assert_allclose(run.outputs["distance"], 3.0 * impact, rtol=1e-7)
    assert run.output_units == {"altitude": "m", "distance": "m"}
    last = run.events[-1]
    assert run.t[-1] == last.time == run.outcome.time
    assert np.array_equal(run.x[-1], last.state)
    assert np.array_equal(run.outcome.state, last.state)
    assert 0.0 <= run.x[-1, 2] < 1e-12


def test_every_event_on_the_way_is_there(run: fb.Trajectory) -> None:
    assert [e.name for e in run.events] == ["gate", "apex", "gate", "ground"]
    assert "ended by the event 'ground' at t = 1.80" in run.outcome.message
    heights = [-e.state[2] for e in run.events]
    np.testing.assert_allclose(heights, [2.0, 1.5 + 32.0 / G, 2.0, 0.0], atol=1e-9)


def test_samples_end_with_the_run() -> None:
    model, x0 = thrown()
    end = model.simulate(x0, (0.0, 5.0), events=[ground]).outcome.time
    wanted = [0.0, 0.5, 1.75, 1.9, 5.0]
    run = model.simulate(x0, (0.0, 5.0), events=[ground], save_at=wanted)
    assert run.t.tolist() == wanted[:3]
    run = model.simulate(x0, (0.0, 5.0), events=[ground], save_every=0.5)
    assert run.t.tolist() == [0.0, 0.5, 1.0, 1.5, end]
    assert len(run.u) == 5
    assert np.array_equal(run.x[-1], run.outcome.state)


def test_a_bounce_goes_on_from_its_event() -> None:
    """With half of its speed each time: the pauses are halved."""
    model, x = thrown()
    times, start = [], 0.0
    for _ in range(6):
        run = model.simulate(x, (start, start + 10.0), events=[ground], rtol=1e-12)
        assert run.outcome.event == "ground"
        times.append(start := run.outcome.time)
        bounced = np.array([1.0, 1.0, -0.5]) * run.velocity_world[-1]
        x = model.state(
            run.position_world[-1],
            fb.Attitude.quaternion(run.quaternion[-1]),
            velocity_world=bounced,
            angular_velocity_body=run.angular_velocity_body[-1],
        )
    pauses = np.diff(times)
    np.testing.assert_allclose(pauses[1:] / pauses[:-1], 0.5, rtol=1e-9)


def test_inputs_and_commands_are_read() -> None:
    @fb.force(inputs={"thrust": "N", "drag": "N"})
    def engine(s: Any) -> Any:
        return fb.wrench(force=[s.inputs.thrust - s.inputs.drag, 0.0, 0.0])

    @fb.control(inputs={"pace": "m/s"})
    def governor(s: Any) -> Any:
        return {"thrust": 4.0 * (s.inputs.pace - s.velocity_body[0])}

    @fb.event(direction="falling", inputs={"thrust": "N"}, parameters={"small": (0.5, "N")})
    def settled(s: Any, p: Any) -> Any:
        return s.inputs.thrust - p.small

    @fb.output(take="max", inputs={"pace": "m/s", "thrust": "N"})
    def power(s: Any) -> Any:
        return s.inputs.pace * s.inputs.thrust

    body = fb.RigidBody(2.0, inertia_about_com=np.eye(3))
    model = fb.Model(body, [engine], control=governor)
    assert model.input_names == ("drag", "pace")
    run = model.simulate(model.state(), (0.0, 10.0), inputs=[0.0, 1.0], events=[settled], outputs=[power])
    # v' = 2 (1 - v): the thrust is 4 exp(-2 t).
    np.testing.assert_allclose(run.outcome.time, 0.5 * np.log(8.0), rtol=1e-8)
    assert (run.outputs, run.output_units) == ({"power": 4.0}, {"power": "W"})
    lost = fb.event(inputs={"thrst": "N"}, name="gone")(lambda s: s.inputs.thrst)
    with pytest.raises(InputError, match=r"event 'gone' reads the input 'thrst'.*did you mean 'thrust'"):
        model.simulate(model.state(), (0.0, 1.0), events=[lost])
    wrong = fb.output(inputs={"thrust": "m"}, name="push")(lambda s: s.inputs.thrust)
    with pytest.raises(
        InputError, match="output 'push' reads the input 'thrust' in 'm'; the model has it in"
    ):
        model.simulate(model.state(), (0.0, 1.0), outputs=[wrong])


@pytest.mark.parametrize(
    ("watched", "words"),
    [
        ({"events": ground}, "events: got .*; give a list of events made by @fb.event"),
        ({"events": [altitude]}, r"events\[0\]: got .*altitude.*made by @fb.event"),
        ({"outputs": [altitude, ground]}, r"outputs\[1\]: got .*ground.*made by @fb.output"),
        ({"outputs": "altitude"}, "outputs: got 'altitude'"),
        ({"events": [gate, gate(height=1.0)]}, r"events\[1\]: the name 'gate' stands twice.*gate\(name="),
    ],
)
def test_what_is_no_event_is_refused(watched: Any, words: str) -> None:
    model, x0 = thrown()
    with pytest.raises(InputError, match=words):
        model.simulate(x0, (0.0, 1.0), **watched)


def test_the_dataset_keeps_events_and_outputs(run: fb.Trajectory, tmp_path: Any) -> None:
    xarray = pytest.importorskip("xarray")
    dataset = run.to_xarray()
    assert dataset["event"].values.tolist() == [e.name for e in run.events]
    assert dataset["event_time"].values.tolist() == [e.time for e in run.events]
    assert np.array_equal(dataset["event_state"], [e.state for e in run.events])
    assert (dataset["output_altitude"].item(), dataset["output_altitude"].attrs["units"]) == (
        run.outputs["altitude"],
        "m",
    )
    results.save(dataset, tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc", engine="h5netcdf") as stored:
        assert stored.identical(dataset)
    results.save(dataset, tmp_path / "run.csv")  # the samples alone
    assert len((tmp_path / "run.csv").read_text().splitlines()) == len(run) + 1


@pytest.mark.parametrize(
    "law",
    [lambda s: np.log(-1.0 - s.world_from_body[0, 0] ** 2), lambda s: np.sqrt(s.position_world[2] - 3.0)],
)
def test_what_is_not_a_number_ends_nothing(law: Any) -> None:
    model, x0 = thrown()
    seen, lost = fb.output(take="max", name="seen")(law), fb.event(name="lost")(law)
    run = model.simulate(x0, (0.0, 1.0), events=[lost], outputs=[seen])
    assert (run.outcome.status, run.events) == ("reached_end", ())
    assert np.isnan(run.outputs["seen"])
