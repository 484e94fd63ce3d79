"""Units as DAVE-ML files write them."""

import math

import pytest

from freebody.dave_ml.units import si

# Exact definitions: foot 0.3048 m, pound 0.45359237 kg, standard gravity 9.80665 m/s², nautical mile 1852 m.
LBF = 0.45359237 * 9.80665
SLUG = LBF / 0.3048
KNOWN = {
    "": (1.0, "1"),
    "nd": (1.0, "1"),
    "frac": (1.0, "1"),
    "pct": (0.01, "1"),
    "deg": (math.pi / 180, "rad"),
    "d": (math.pi / 180, "rad"),
    "rad_s": (1.0, "rad/s"),
    "deg_s": (math.pi / 180, "rad/s"),
    "_deg": (180 / math.pi, "1"),
    "_rad": (1.0, "1"),
    "deg_rad": (math.pi / 180, "1"),
    "ft": (0.3048, "m"),
    "f_s": (0.3048, "m/s"),
    "ft_s2": (0.3048, "m/s^2"),
    "ft2": (0.3048**2, "m^2"),
    "nmi_h": (1852 / 3600, "m/s"),
    "h_nmi": (3600 / 1852, "s/m"),
    "slug": (SLUG, "kg"),
    "lbm": (0.45359237, "kg"),
    "slugft2": (SLUG * 0.3048**2, "m^2 kg"),
    "slug_ft3": (SLUG / 0.3048**3, "kg/m^3"),
    "lb": (LBF, "N"),
    "ftlbf": (LBF * 0.3048, "N m"),
    "lbf_ft2": (LBF / 0.3048**2, "Pa"),
    "psf": (LBF / 0.3048**2, "Pa"),
    "dgR": (5 / 9, "K"),
    "kgm2": (1.0, "kg m^2"),
    "m3_s2": (1.0, "m^3/s^2"),
    "deg_ft": (math.pi / 180 / 0.3048, "rad/m"),
}


@pytest.mark.parametrize("units", KNOWN)
def test_units_of_the_standard(units):
    factor, _ = KNOWN[units]
    found = si(units)
    assert found is not None
    assert found.factor == pytest.approx(factor, rel=1e-15)
    assert found.unit == KNOWN[units][1] or sorted(found.unit.split()) == sorted(KNOWN[units][1].split())


@pytest.mark.parametrize(
    "units", ["nim_h", "dgF", "dgC", "fracMAC", "ft_", "ft__s", "rad_deg-1", "2ft", "m/s", "furlong"]
)
def test_other_words_are_not_guessed(units):
    assert si(units) is None
