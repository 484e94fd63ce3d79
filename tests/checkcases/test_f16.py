"""The F-16 against what is printed in Stevens, Lewis and Johnson, and laws that are not printed."""

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.trimming import trim
from freebody.vehicles import f16
from freebody.verify import f16 as printed
from freebody.verify import f16_printed as book

AIRSPEED = printed.AIRSPEED


@pytest.fixture(scope="module")
def residuals():
    return list(printed.cases())


def test_printed_figures(residuals):
    assert [residual for residual in residuals if not residual.passed] == []
    assert len(residuals) == 22


def test_every_row_of_the_tables_is_there():
    assert len(book.LEVEL.splitlines()) == 16
    assert sum(len(row.split()) for row in book.RATES.values()) == 13
    assert sum(len(condition.printed) + len(condition.loose) for condition in book.CONDITIONS.values()) == 27


def test_inertia_that_is_not_rounded_changes_angular_accelerations_in_the_fourth_digit():
    exact, rounded = (printed.book_rates(printed.aircraft(0.4, which)) for which in (False, True))
    assert np.delete(exact, [6, 7, 8]) == pytest.approx(np.delete(rounded, [6, 7, 8]), rel=1e-12)
    assert exact[6:9] == pytest.approx(rounded[6:9], rel=3e-4)


def test_level_flight_needs_no_lateral_controls():
    found = trim(printed.aircraft(), airspeed=AIRSPEED, bounds=f16.LIMITS)
    assert max(abs(found.inputs[name]) for name in ("aileron", "rudder")) < 1e-12


def test_a_trimmed_aircraft_flies_on_as_trimmed():
    """Heading, height and airspeed after 3 s of the turn; in so short a time nothing small grows."""
    model = printed.aircraft(0.3, False)
    found = trim(model, airspeed=AIRSPEED, turn_rate=0.3)
    run = model.simulate(found.x, (0.0, 3.0), rtol=1e-11, inputs=found.u)
    yaw, pitch, roll = run.angles("zyx")[-1]
    assert (yaw, pitch, roll) == pytest.approx((0.9, found.pitch, found.roll), abs=1e-6)
    assert run.com_position_world[-1, 2] == pytest.approx(0.0, abs=1e-4)
    assert np.linalg.norm(run.com_velocity_world[-1]) == pytest.approx(AIRSPEED, rel=1e-8)


def test_lanes_and_single_aircraft_agree():
    model = printed.aircraft(0.3, False)
    found = trim(model, airspeed=AIRSPEED)
    spread: dict[str, Any] = {
        "aerodynamics.Cm_factor": fb.Uniform(0.9, 1.1),
        "mass": fb.Uniform(9000.0, 9500.0),
    }
    ensemble = model.ensemble(found.x, spread, n=5, inputs=found.u)
    runs = ensemble.run((0.0, 2.0))
    for i in range(5):
        assert np.array_equal(runs.final[i], ensemble.trajectory(i, (0.0, 2.0)).x[-1])
