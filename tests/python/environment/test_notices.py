"""What the outcome of a run has to say: tables and models that were left."""

import io
from typing import Any

import numpy as np
import pytest
from rich.console import Console

import freebody as fb
from environment_scenes import BODY, drag, model
from freebody.environment import Environment, TabulatedAtmosphere, USStandard1976, WindTable
from freebody.report import ensemble_summary, summary
from freebody.tracing import notice

TABLE = WindTable([0.0, 1000.0], [[1.0, 0.0, 0.0], [5.0, 0.0, 0.0]])
ENDS = "wind table ends at 1000 m, its last row holds"


def up(made: fb.Model, height: float, speed: float) -> np.ndarray:
    return made.state(position=[0.0, 0.0, -height], velocity_world=[0.0, 0.0, -speed])


def test_a_table_that_ends_below_the_vehicle() -> None:
    made = model(Environment(wind=TABLE))
    run = made.simulate(up(made, 900.0, 100.0), (0.0, 20.0), rtol=1e-10)
    (told,) = run.outcome.notices
    assert run.events == ()
    assert (told.law, told.message, told.from_start) == ("drag", ENDS, False)
    assert run.outcome.message == f"reached the end at t = 20 s; from {told.time:.6g} s on: {ENDS}"
    # A millimetre is allowed, so that a start on the border is inside.
    again = made.simulate(up(made, 900.0, 100.0), (0.0, told.time), rtol=1e-10)
    assert -again.com_position_world[-1][2] == pytest.approx(1000.001, abs=1e-6)
    assert run.ok


def test_outside_from_the_start() -> None:
    made = model(Environment(wind=TABLE))
    run = made.simulate(up(made, 1200.0, 0.0), (3.0, 4.0))
    assert [(n.time, n.from_start) for n in run.outcome.notices] == [(3.0, True)]
    assert run.outcome.message.endswith(f"; from the start: {ENDS}")


def test_every_time_is_kept_and_told_once() -> None:
    bounce = notice("low", lambda s: np.cos(1.0 * s.time) + 0.5)
    made = fb.Model(BODY, [fb.force(notices=[bounce])(_nothing)])
    run = made.simulate(made.state(), (0.0, 20.0), method="rk4", step=0.1)
    # cos falls through -1/2 at 2π/3, and each turn later.
    times = [n.time for n in run.outcome.notices]
    np.testing.assert_allclose(times, 2.0 * np.pi / 3.0 + 2.0 * np.pi * np.arange(3), atol=1e-9)
    assert run.outcome.message.endswith("; from 2.0944 s on: low (3 times)")


def _nothing(s: Any) -> Any:
    return fb.wrench(force=0.0 * s.com)


def test_forces_of_one_environment_say_it_once() -> None:
    env = Environment(wind=TABLE)
    made = fb.Model(BODY, [drag(env, "front"), drag(env, "back")])
    assert len(made.simulate(up(made, 1200.0, 0.0), (0.0, 1.0)).outcome.notices) == 1


def test_a_model_says_what_its_environment_has_to_say() -> None:
    made = fb.Model(BODY, [fb.UniformGravity()], environment=Environment(wind=TABLE))
    (told,) = made.simulate(up(made, 1200.0, 0.0), (0.0, 1.0)).outcome.notices
    assert told.law == "environment"


@pytest.mark.parametrize(
    ("atmosphere", "height", "words"),
    [
        (USStandard1976(), -5100.0, "begins at -5000 m, the air there holds below"),
        (USStandard1976(), 1.01e6, "ends at 1000000 m, above the pressure falls exponentially"),
        (USStandard1976(upper=False), 86500.0, "ends at 86000 m, above the pressure falls exponentially"),
        (
            TabulatedAtmosphere([0.0, 5e3], density=[1.2, 0.7], temperature=[288.0, 255.0]),
            6e3,
            "ends at 5000 m",
        ),
        (
            TabulatedAtmosphere([10.0, 5e3], density=[1.2, 0.7], temperature=[288.0, 255.0]),
            0.0,
            "begins at 10 m",
        ),
    ],
)
def test_atmospheres(atmosphere: Any, height: float, words: str) -> None:
    made = model(Environment(atmosphere=atmosphere))
    (told,) = made.simulate(up(made, height, 0.0), (0.0, 0.01)).outcome.notices
    assert words in told.message


def test_events_and_outputs_are_not_disturbed() -> None:
    made = model(Environment(wind=TABLE))

    @fb.event(terminal=False)
    def crossing(s: Any) -> Any:
        return s.position_world[2] + 950.0

    @fb.output(take="max")
    def top(s: Any) -> Any:
        return -1.0 * s.position_world[2]

    x0 = up(made, 900.0, 100.0)
    run = made.simulate(x0, (0.0, 30.0), events=[crossing], outputs=[top])
    assert {event.name for event in run.events} == {"crossing"}
    assert len(run.outcome.notices) == 1
    runs = made.ensemble(x0, {"mass": fb.Uniform(19.0, 21.0)}, n=3, events=[crossing], outputs=[top]).run(
        (0.0, 30.0)
    )
    assert set(runs.event_times) == {"crossing"}
    assert runs.chunk["event_state"].shape == (3, 1, 13)
    for r in range(3):
        alone = runs.trajectory(r)
        assert alone.outcome.notices[0].time == runs.notice_times[ENDS][r]
        assert alone.events[0].time == runs.event_times["crossing"][r]


def test_ensembles_say_from_when_on() -> None:
    made = model(Environment(wind=TABLE))
    heights = fb.Samples([[0.0, 0.0, -900.0], [0.0, 0.0, -1200.0], [0.0, 0.0, -100.0]])
    runs = made.ensemble(up(made, 900.0, 100.0), {"position": heights}, n=3).run((0.0, 5.0))
    times = runs.notice_times[ENDS]
    assert 0.5 < times[0] < 5.0
    assert times[1] == 0.0
    assert np.isnan(times[2])
    dataset = runs.to_xarray()
    assert list(dataset["notice"].values) == list(runs.notice_times)
    console = Console(width=200, record=True, file=io.StringIO())
    console.print(ensemble_summary(runs))
    console.print(summary(runs.trajectory(1)))
    text = console.export_text()
    assert f"{ENDS}: in 2 of 3 runs" in text
    assert f"from the start: {ENDS}" in text


def test_laws_with_notices_pickle_and_compare() -> None:
    import pickle  # noqa: PLC0415

    law = drag(Environment(wind=TABLE))
    again = pickle.loads(pickle.dumps(law))
    assert again == law
    assert again.notices == law.notices
    with pytest.raises(fb.InputError, match="message: got ''"):
        notice("", lambda s: s.time)
