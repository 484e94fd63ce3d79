"""Dryden turbulence: variances and spectra of the specification, seeds, flight through it."""

from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad

import freebody as fb
from environment_scenes import drag, model
from freebody.elements import TurbulencePath
from freebody.environment import ConstantWind, DrydenTurbulence, Environment
from freebody.environment.turbulence import spectrum
from freebody.environment.turbulence_scales import Scales, specified

SIGMA, LENGTH, SPAN = np.array([1.0, 1.5, 2.0]), np.array([200.0, 180.0, 150.0]), 12.0
SCALES = Scales(tuple(SIGMA), tuple(LENGTH))
FT = 0.3048


def made(seed: int = 1, **options: Any) -> DrydenTurbulence:
    return DrydenTurbulence(SIGMA, LENGTH, SPAN, seed=seed, **options)


def on_the_way(turbulence: DrydenTurbulence, way: np.ndarray) -> np.ndarray:
    """u, v, w, p, q, r (n, 6)."""
    return np.array([np.concatenate(turbulence.gusts(x)) for x in way])


def density(component: str, number: float) -> float:
    """The spectra as MIL-F-8785C, 3.7.1.2 and 3.7.5 print them."""
    if component == "q":
        return number**2 / (1.0 + (4.0 * SPAN * number / np.pi) ** 2) * density("w", number)
    if component == "r":
        return number**2 / (1.0 + (3.0 * SPAN * number / np.pi) ** 2) * density("v", number)
    return float(spectrum(component, number, SCALES, SPAN))


@pytest.mark.parametrize(("component", "sigma"), list(zip("uvw", SIGMA, strict=True)))
def test_spectra_integrate_to_the_variance(component: str, sigma: float) -> None:
    assert quad(lambda k: density(component, k), 0.0, np.inf)[0] == pytest.approx(sigma**2, rel=1e-8)


def test_longitudinal_spectrum_as_printed() -> None:
    assert density("u", 0.0) == pytest.approx(2.0 * 200.0 / np.pi)
    assert density("w", 1.0 / 150.0) == pytest.approx(4.0 * 150.0 / np.pi)  # (1 + 3)/(1 + 1)² is one
    assert density("p", 0.0) == pytest.approx(4.0 * 0.8 * (np.pi * 150.0 / 48.0) ** (1.0 / 3.0) / 150.0)


def test_mean_squares_on_a_long_way() -> None:
    """Over 3000 km the mean squares of the harmonics are those of the spectrum between its ends."""
    turbulence = made()
    gusts = on_the_way(turbulence, np.random.default_rng(0).uniform(0.0, 3e6, 10000))
    end = turbulence.edges[-1]
    for i, component in enumerate("uvwpqr"):
        variance = quad(lambda k, c=component: density(c, k), 0.0, end, limit=500)[0]
        # Samples at 10 000 places: the mean square is known to sqrt(2/10000) = 1.4 %; the spectrum at the
        # middle of 24 bands in place of its mean over each: 2 %, for the rates 5 %, of which one half
        # comes from where inside the band the wave is.
        assert np.mean(gusts[:, i] ** 2) == pytest.approx(variance, rel=0.03 if i < 4 else 0.12)


def test_power_by_bands() -> None:
    """Each band of wave numbers has the power of the spectrum, as a Fourier transform shows it."""
    step, n = 8.0, 2**14
    gusts = on_the_way(made(harmonics=60), step * np.arange(n))
    window = np.hanning(n)
    number = 2.0 * np.pi * np.fft.rfftfreq(n, step)
    for i, component in enumerate("uvw"):
        power = 2.0 * np.abs(np.fft.rfft(window * gusts[:, i])) ** 2 / (n * np.sum(window**2))
        for low, high in ((0.002, 0.01), (0.01, 0.05), (0.05, 0.3)):
            band = (number >= low) & (number < high)
            wanted = quad(lambda k, c=component: density(c, k), low, high)[0]
            # Ten to fifteen waves stand in a band, of which one at either end may be in or out.
            assert power[band].sum() == pytest.approx(wanted, rel=0.15)


def test_smooth_rates_are_the_slopes() -> None:
    """For waves much longer than the span, q is the slope of w, and r that of v; the air's own rotation."""
    turbulence = DrydenTurbulence(SIGMA, LENGTH, 0.01, seed=4, shortest=50.0)
    step, ways = 0.01, np.linspace(0.0, 5000.0, 50)
    slope = (on_the_way(turbulence, ways + step) - on_the_way(turbulence, ways - step)) / (2.0 * step)
    gusts = on_the_way(turbulence, ways)
    # Central differences: step²/6 of the third derivative, (2π/50)² ~ 2e-2: 3e-7 of the slope.
    np.testing.assert_allclose(gusts[:, 4], -slope[:, 2], atol=1e-6)
    np.testing.assert_allclose(gusts[:, 5], slope[:, 1], atol=1e-6)


def test_seeds_repeat_and_differ() -> None:
    way = np.linspace(0.0, 1000.0, 7)
    assert (on_the_way(made(7), way) == on_the_way(made(7), way)).all()
    assert np.abs(on_the_way(made(7), way) - on_the_way(made(8), way))[:, :3].max() > 0.1


def test_intensities_and_lengths_of_the_specification() -> None:
    # 3.7.3.4 at 200 ft: W20 = 30 kt; 0.177 + 0.000823 · 200 = 0.3416.
    low = specified("moderate", 200.0 * FT)
    kt = 1852.0 / 3600.0
    np.testing.assert_allclose(low.sigma, [3.0 * kt / 0.3416**0.4] * 2 + [3.0 * kt], rtol=1e-12)
    np.testing.assert_allclose(low.length, [200.0 * FT / 0.3416**1.2] * 2 + [200.0 * FT], rtol=1e-12)
    # At 1000 ft u, v and w are alike: 0.177 + 0.823 = 1.
    same = specified("light", 1000.0 * FT)
    np.testing.assert_allclose([*same.sigma, *same.length], [1.5 * kt] * 3 + [1000.0 * FT] * 3, rtol=1e-12)
    high = specified("severe", 15000.0 * FT)
    np.testing.assert_allclose([*high.sigma, *high.length], [22.1 * FT] * 3 + [1750.0 * FT] * 3, rtol=1e-12)
    between = specified("severe", 1500.0 * FT)
    assert float(between.length[2]) == pytest.approx(1375.0 * FT)


def test_held_and_followed_height_agree() -> None:
    held = DrydenTurbulence.specified("moderate", SPAN, seed=3, height=150.0)
    followed = DrydenTurbulence.specified("moderate", SPAN, seed=3, ground=40.0)
    for x in (0.0, 333.0, 9999.0):
        for a, b in zip(held.gusts(x), followed.gusts(x, 190.0), strict=True):
            np.testing.assert_allclose(a, b, rtol=1e-12)


@pytest.mark.parametrize("axes", ["body", "level"])
def test_flight_reads_the_way_through_the_air(axes: str) -> None:
    env = Environment(wind=made(2, axes=axes) + ConstantWind([5.0, 0.0, 0.0]))
    flown = model(env)
    assert "air_path" not in flown.input_names
    x0 = flown.state(position=[0.0, 0.0, -500.0], velocity_world=[60.0, 0.0, 0.0])
    run = flown.simulate(x0, (0.0, 5.0), save_every=0.5)
    air = run.velocity_world - [5.0, 0.0, 0.0]
    # Trapezoids of samples each half a second of a speed that changes by a few m/s²: 0.5²/12·5·a few.
    length = np.sum(0.5 * (np.linalg.norm(air[1:], axis=1) + np.linalg.norm(air[:-1], axis=1)) * 0.5)
    assert run.states["turbulence.air_path"][-1] == pytest.approx(length, abs=2.0)
    exact, _ = flown.jacobian(1.0, run.x[2])
    h = 1e-6 * np.maximum(np.abs(run.x[2]), 1.0)
    rows = [
        (flown.derivative(1.0, run.x[2] + h[i] * e) - flown.derivative(1.0, run.x[2] - h[i] * e))
        / (2.0 * h[i])
        for i, e in enumerate(np.eye(len(x0)))
    ]
    # Central differences: rounding of derivatives of 1e2 over 1e-6.
    np.testing.assert_allclose(exact, np.array(rows).T, atol=1e-6, rtol=1e-6)


def test_lanes_are_scalar_runs_and_shifts_are_other_air() -> None:
    env = Environment(wind=DrydenTurbulence.specified("light", SPAN, seed=5))
    flown = model(env)
    x0 = flown.state(position=[0.0, 0.0, -800.0], velocity_world=[60.0, 0.0, 0.0])
    dispersions = {
        "environment.turbulence_shift": fb.Uniform(0.0, 1e6),
        "environment.turbulence_factor": fb.Uniform(0.5, 2.0),
    }
    runs = flown.ensemble(x0, dispersions, n=5, seed=1).run((0.0, 5.0))
    for r in range(5):
        assert (runs.trajectory(r).outcome.state == runs.final[r]).all()
    assert np.ptp(runs.final[:, 1]) > 1e-3


def test_path_is_that_of_the_steady_air() -> None:
    env = Environment(wind=made() + ConstantWind([5.0, 0.0, 0.0]))
    path = TurbulencePath(env)
    assert path.publishes == ("air_path",)
    assert not path.inputs
    assert drag(env).inputs[0].name == "air_path"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"seed": -1}, "seed: got -1"),
        ({"seed": 1, "shortest": 1e5}, "shortest: got"),
        ({"seed": 1, "axes": "wind"}, "axes: got"),
        ({"seed": 1, "harmonics": 0}, "harmonics: got 0"),
    ],
)
def test_wrong_arguments(change: dict[str, Any], message: str) -> None:
    with pytest.raises(fb.InputError, match=message):
        DrydenTurbulence(SIGMA, LENGTH, SPAN, **change)
