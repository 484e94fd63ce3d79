"""The figure of a run shows the run."""

import numpy as np
import pytest

from freebody import plots
from freebody.errors import InputError
from freebody.model_file import load_model, shipped_model


def panels(figure):
    return {axes.get_title(loc="left"): axes for axes in figure.axes}


def curves(axes):
    return {str(line.get_label()): np.asarray(line.get_ydata()) for line in axes.lines}


@pytest.fixture(scope="module")
def top():
    return load_model(shipped_model("heavy_top")).simulate()


@pytest.fixture(scope="module")
def toutatis():
    return load_model(shipped_model("toutatis")).simulate()


def test_panels_show_the_run_in_units_of_people(top):
    found = panels(plots.figure(top, title="Top"))
    assert np.array_equal(curves(found["Position of the mass centre"])["z"], top.com_position_world[:, 2])
    rates = curves(found["Angular velocity, body axes"])
    assert np.array_equal(rates["y"], np.rad2deg(top.angular_velocity_body[:, 1]))
    energy = curves(found["Energy gained since the start"])
    assert np.array_equal(energy["potential"], top.potential_energy - top.potential_energy[0])


def test_a_turn_past_180_deg_breaks_the_line(top):
    spin = curves(panels(plots.figure(top))["Attitude angles zxz"])["α3 about z"]
    # 20 rad/s for 2.5 s is eight turns; a line across the panel at each would look like motion.
    assert np.isnan(spin).sum() >= 7
    assert np.nanmax(np.abs(np.diff(spin))) < 180


def test_a_long_run_is_in_days(toutatis):
    figure = plots.figure(toutatis, points={"long_axis": [0.0, 0.0, 1.0]})
    found = panels(figure)
    rates = found["Angular velocity, body axes"]
    assert rates.get_ylabel() == "deg/day"
    # 14.51 deg/day is what the model file starts with
    np.testing.assert_allclose(curves(rates)["x"][0], 14.51, rtol=1e-12)
    assert {axes.get_xlabel() for axes in figure.axes} - {""} == {"time (day)"}
    assert np.array_equal(rates.lines[0].get_xdata(), toutatis.t / 86400.0)


def test_a_body_at_rest_shows_the_path_of_its_point(toutatis):
    found = panels(plots.figure(toutatis, points={"long_axis": [0.0, 0.0, 1.0]}))
    path = curves(found["Position of the point long_axis"])
    assert np.array_equal(path["x"], toutatis.point([0.0, 0.0, 1.0])[:, 0])


@pytest.mark.parametrize(("suffix", "magic"), [(".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<?xml")])
def test_the_suffix_says_the_format(top, tmp_path, suffix, magic):
    path = tmp_path / f"top{suffix}"
    plots.save(plots.figure(top), path)
    assert path.read_bytes().startswith(magic)
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


def test_an_unknown_suffix_is_refused(top, tmp_path):
    with pytest.raises(InputError, match=r"\.png, \.svg, \.pdf; came '\.gif'"):
        plots.save(plots.figure(top), tmp_path / "top.gif")


def test_a_planet_has_panels_of_its_own_and_what_is_kept_none_gives_room_to_inputs():
    def titles(name):
        return set(panels(plots.figure(load_model(shipped_model(name)).simulate())))

    assert {"Altitude", "Speed over the ground", "Attitude, local axes"} <= titles(
        "nesc_09_sphere_fired_east"
    )
    assert {"Altitude", "Speed", "Inputs"} <= titles("remus_100")
    assert "Largest relative drift so far" in titles("dzhanibekov")
    assert "Altitude" not in titles("dzhanibekov")


def test_rounding_is_no_motion():
    # The mass centre of the gyrostat rests: only rounding moves it, 1e-15 m.
    drawing = plots.figure(load_model(shipped_model("gyrostat")).simulate())
    low, high = drawing.axes[0].get_ylim()
    assert all(np.ptp(np.asarray(line.get_ydata())) < 1e-3 * (high - low) for line in drawing.axes[0].lines)
