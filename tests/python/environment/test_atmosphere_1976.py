"""The U.S. Standard Atmosphere 1976: its printed figures, and the laws that it obeys."""

from typing import Any

import mpmath
import numpy as np
import pytest

import freebody as fb
from freebody.environment import TabulatedAtmosphere, USStandard1976
from freebody.environment.atmosphere_1976_upper import UPPER

ATMOSPHERE = USStandard1976()


def integrated(altitude: float) -> Any:
    """The pressure as the standard defines it: the integral of the hydrostatic equation, by quadrature."""
    height = mpmath.mpf(6356766) * altitude / (mpmath.mpf(6356766) + altitude)
    bases = [0, 11000, 20000, 32000, 47000, 51000, 71000, 84852]
    gradients = ["-0.0065", "0", "0.001", "0.0028", "0", "-0.0028", "-0.002"]
    temperature, total = mpmath.mpf("288.15"), mpmath.mpf(0)
    for base, top, text in zip(bases, bases[1:], gradients, strict=False):
        gradient, end = mpmath.mpf(text), min(height, top) if top < 84852 else height
        if height <= base and base > 0:
            break
        start = temperature
        total += mpmath.quad(lambda h, b=base, g=gradient, t=start: 1 / (t + g * (h - b)), [base, end])
        temperature += gradient * (top - base)
    constant = mpmath.mpf("9.80665") * mpmath.mpf("28.9644") / mpmath.mpf("8314.32")
    return mpmath.mpf(101325) * mpmath.exp(-constant * total)


@pytest.mark.parametrize("altitude", [-4321.0, 3000.0, 15000.0, 27000.0, 40000.0, 49500.0, 60000.0, 84000.0])
def test_pressure_is_the_integral_of_the_hydrostatic_equation(altitude: float) -> None:
    # Six layers of a few roundings each; the exponent is up to 12, which multiplies them.
    assert float(ATMOSPHERE.at(altitude).pressure / integrated(altitude)) == pytest.approx(1.0, abs=2e-14)


@pytest.mark.parametrize("upper", [False, True])
def test_hydrostatic_balance_and_ideal_gas(upper: bool) -> None:
    atmosphere = USStandard1976(upper=upper)
    altitude = np.concatenate([np.linspace(-4900.0, 85900.0, 400), np.linspace(86100.0, 5e5, 400)])
    step = 1.0
    rise = (atmosphere.at(altitude + step).pressure - atmosphere.at(altitude - step).pressure) / (2.0 * step)
    air = atmosphere.at(altitude)
    gravity = 9.80665 * (6356766.0 / (6356766.0 + altitude)) ** 2
    balance = rise / (air.density * gravity) + 1.0
    below = altitude < 86000.0
    # Central differences: (step/H)²/6 with H = 5.4 km is 6e-9; a layer's border inside a step adds
    # step/H times half of the change of slope, below 1e-5.
    assert np.abs(balance[below]).max() < 1e-5
    # Above, splines through figures of four digits, 1.5e-4 each over layers of 5 km and more.
    assert np.abs(balance[~below]).max() < (1.5e-2 if upper else 1e-5)
    well_mixed = altitude < 80000.0
    constant = air.pressure / (air.density * air.temperature)
    np.testing.assert_allclose(constant[well_mixed], 287.05287, rtol=1e-14)


@pytest.mark.parametrize("upper", [False, True])
def test_no_jump_where_layers_meet(upper: bool) -> None:
    atmosphere = USStandard1976(upper=upper)
    heights = np.array([11e3, 20e3, 32e3, 47e3, 51e3, 71e3])
    for border in [*(6356766.0 * heights / (6356766.0 - heights)), 80e3, 86e3, -5000.0, 1e6]:
        sides = [np.array(atmosphere.at(border + side)) for side in (-1e-6, 1e-6)]
        # 2e-6 m apart: with a scale height of 5 km 4e-10 of the pressure, the rest rounding.
        np.testing.assert_allclose(sides[0], sides[1], rtol=1e-9)


def test_upper_part_is_the_printed_one() -> None:
    for altitude, temperature, pressure, density in UPPER[1:]:
        air = ATMOSPHERE.at(altitude)
        given = [air.temperature, air.pressure, air.density]
        np.testing.assert_allclose(given, [temperature, pressure, density], rtol=1e-12)


@pytest.mark.parametrize("upper", [False, True])
def test_everywhere_finite_and_falling(upper: bool) -> None:
    altitude = np.concatenate(
        [np.linspace(-7e6, -5e3, 50), np.linspace(-4999.0, 1.2e6, 5000), [1e7, 1e9, 1e12]]
    )
    air = USStandard1976(upper=upper).at(altitude)
    for values in air:
        assert np.isfinite(values).all()
        assert (values >= 0.0).all()
    assert (np.diff(air.pressure) <= 0.0).all()
    assert (np.diff(air.density) <= 0.0).all()
    assert air.density[-1] == 0.0
    assert air.density[0] == air.density[49]  # below -5 km the air of -5 km holds


def test_warm_day_and_dense_day() -> None:
    standard, warm = ATMOSPHERE.at(3000.0), USStandard1976(temperature_offset=10.0).at(3000.0)
    assert warm.temperature == pytest.approx(standard.temperature + 10.0, rel=1e-15)
    assert warm.pressure == standard.pressure
    assert warm.density * warm.temperature == pytest.approx(
        standard.density * standard.temperature, rel=1e-14
    )
    dense = USStandard1976(density_factor=1.1).at(3000.0)
    assert dense.density == pytest.approx(1.1 * standard.density, rel=1e-15)
    assert dense.temperature == standard.temperature


def test_speed_of_sound_and_viscosity_as_printed() -> None:
    # Tables III: 340.29 m/s and 1.7894e-5 Pa s at sea level, 295.15 m/s and 1.4223e-5 at 11 km.
    ground, high = ATMOSPHERE.at(0.0), ATMOSPHERE.at(11000.0)
    assert ground.speed_of_sound == pytest.approx(340.29, abs=0.005)
    assert high.speed_of_sound == pytest.approx(295.15, abs=0.005)
    assert ground.dynamic_viscosity == pytest.approx(1.7894e-5, abs=5e-10)
    assert high.dynamic_viscosity == pytest.approx(1.4223e-5, abs=5e-10)


def test_a_table_of_the_standard_comes_near_it() -> None:
    altitude = np.linspace(0.0, 30000.0, 121)
    air = ATMOSPHERE.at(altitude)
    table = TabulatedAtmosphere(altitude, pressure=air.pressure, temperature=air.temperature)
    between = np.linspace(100.0, 29900.0, 77)
    # Between rows 250 m apart the logarithm of the pressure bends by (250)²/8 of its second derivative, 4e-9:
    # 3e-5; the temperature bends where a border of layers lies inside a row: 6.5e-3·250/4 of 217 K.
    for value, wanted in zip(table.at(between), ATMOSPHERE.at(between), strict=True):
        np.testing.assert_allclose(value, wanted, rtol=2.5e-3)
    rows = table.at(altitude)
    np.testing.assert_allclose(rows.density, air.density, rtol=1e-13)
    np.testing.assert_allclose(rows.speed_of_sound, air.speed_of_sound, rtol=1e-13)
    given = {"density": air.density, "pressure": air.pressure}
    np.testing.assert_allclose(
        TabulatedAtmosphere(altitude, **given).at(altitude).temperature, air.temperature
    )
    with pytest.raises(fb.InputError, match="give two of the three"):
        TabulatedAtmosphere([0.0, 1.0], density=[1.0, 0.9])
    with pytest.raises(fb.InputError, match="density: got -1 at index 1"):
        TabulatedAtmosphere([0.0, 1.0], density=[1.0, -1.0], temperature=[280.0, 280.0])
