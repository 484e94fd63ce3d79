"""Units as DAVE-ML files write them: `ft_s`, `slugft2`, `lbf_ft2`, `_deg`; `_` is per, a digit a power.

Abbreviations of ANSI/AIAA S-119-2011, annex A, with older ones of files of DAVE-ML 1 (`f`, `d`, `lb`).
"""

from __future__ import annotations

import math
import re
from functools import cache
from typing import NamedTuple

from freebody.dave_ml.definitions import Variable
from freebody.errors import InputError
from freebody.units import DIMENSIONLESS, Dimension, dimension, text_of, times

__all__ = ["Si", "known_si", "measures", "si"]

_FOOT, _POUND = 0.3048, 0.45359237  # exact, 1959
_LBF = _POUND * 9.80665
_DEGREE = math.pi / 180.0

# Symbol: what one of it is in SI, and the unit of SI.
_SYMBOLS: dict[str, tuple[float, str]] = {
    "rad": (1.0, "rad"),
    "r": (1.0, "rad"),
    "deg": (_DEGREE, "rad"),
    "d": (_DEGREE, "rad"),
    "m": (1.0, "m"),
    "km": (1000.0, "m"),
    "cm": (0.01, "m"),
    "mm": (0.001, "m"),
    "ft": (_FOOT, "m"),
    "f": (_FOOT, "m"),
    "in": (_FOOT / 12.0, "m"),
    "nmi": (1852.0, "m"),
    "s": (1.0, "s"),
    "sec": (1.0, "s"),
    "min": (60.0, "s"),
    "h": (3600.0, "s"),
    "hr": (3600.0, "s"),
    "kg": (1.0, "kg"),
    "g": (0.001, "kg"),
    "slug": (_LBF / _FOOT, "kg"),
    "lbm": (_POUND, "kg"),
    "N": (1.0, "N"),
    "kN": (1000.0, "N"),
    "lbf": (_LBF, "N"),
    "lb": (_LBF, "N"),
    "Pa": (1.0, "Pa"),
    "kPa": (1000.0, "Pa"),
    "W": (1.0, "W"),
    "hp": (550.0 * _LBF * _FOOT, "W"),
    "J": (1.0, "J"),
    "K": (1.0, "K"),
    "dgK": (1.0, "K"),
    "dgR": (5.0 / 9.0, "K"),
    "frac": (1.0, "1"),
    "pct": (0.01, "1"),
}
_WHOLE: dict[str, tuple[float, str]] = {
    **dict.fromkeys(("", "nd", "ND", "none", "unitless", "nondimensional", "dimensionless"), (1.0, "1")),
    "psf": (_LBF / _FOOT**2, "Pa"),
    "psi": (144.0 * _LBF / _FOOT**2, "Pa"),
    "fps": (_FOOT, "m/s"),
    "kt": (1852.0 / 3600.0, "m/s"),
    "kn": (1852.0 / 3600.0, "m/s"),
    "rpm": (math.pi / 30.0, "rad/s"),
}
_TOKEN = re.compile("(" + "|".join(sorted(_SYMBOLS, key=len, reverse=True)) + r")(\d?)")


class Si(NamedTuple):
    """What a unit is in SI: one of it, the dimension of what it measures, and the power of angles in it."""

    factor: float
    dimension: Dimension
    angles: int = 0

    @property
    def unit(self) -> str:
        """The unit of SI, "N m"; "1" for numbers."""
        unit = text_of(self.dimension)
        if self.angles != 1:
            return unit
        return f"rad{unit[1:]}" if unit.startswith("1") else f"rad {unit}"


@cache
def si(units: str) -> Si | None:
    """What `units` are in SI, or None for units that are not known."""
    if units in _WHOLE:
        factor, unit = _WHOLE[units]
        return Si(factor, dimension(units, unit), int("rad" in unit))
    factor, found, angles = 1.0, DIMENSIONLESS, 0
    for i, part in enumerate(units.split("_")):
        tokens = list(_TOKEN.finditer(part))
        if "".join(token[0] for token in tokens) != part or (i > 0 and not part):
            return None
        sign = 1 if i == 0 else -1
        for symbol, digit in (token.groups() for token in tokens):
            one, unit = _SYMBOLS[symbol]
            power = sign * int(digit or 1)
            factor *= one**power
            found = times(found, dimension(symbol, unit), power)
            angles += power if unit == "rad" else 0
    return Si(factor, found, angles)


def measures(file: str, variable: Variable, unit: str) -> None:
    """Refuse a variable that does not measure what a unit of SI does."""
    if known_si(file, variable).dimension != dimension(variable.name, unit):
        raise InputError(
            f"{file}:{variable.line}: {variable.name!r} is in {variable.units!r}, which does not "
            f"measure what {unit!r} does"
        )


def known_si(file: str, variable: Variable) -> Si:
    """The units of a variable, which must be known."""
    known = si(variable.units)
    if known is None:
        raise InputError(
            f"{file}:{variable.line}: the units {variable.units!r} of {variable.name!r} are not known; "
            "write them as ANSI/AIAA S-119 does, such as 'ft_s', 'slugft2', 'lbf_ft2'"
        )
    return known
