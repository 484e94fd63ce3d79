"""How strong turbulence is and how long its waves are, by the height above ground. MIL-F-8785C, 3.7.3."""

from __future__ import annotations

from typing import Any, Final, Literal, NamedTuple

import numpy as np

from freebody import _check
from freebody.tables import Table

__all__ = ["SEVERITIES", "Scales", "Severity", "specified"]

Severity = Literal["light", "moderate", "severe"]
SEVERITIES: Final = ("light", "moderate", "severe")

_FT: Final = 0.3048
_KT: Final = 1852.0 / 3600.0
# Wind at 20 ft, and probability of exceedance of the intensity at altitude: 3.7.3.2 and 3.7.3.4.
_WIND_AT_20_FT: Final = {"light": 15.0 * _KT, "moderate": 30.0 * _KT, "severe": 45.0 * _KT}
# Figure 7: root mean square at altitudes in ft, ft/s, exceeded with probabilities 1e-2, 1e-3 and 1e-5.
_ALTITUDES: Final = (500, 1750, 3750, 7500, 15000, 25000, 35000, 45000, 55000, 65000, 75000, 80000)
_INTENSITIES: Final = {
    "light": (6.6, 6.9, 7.4, 6.7, 4.6, 2.7, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0),
    "moderate": (8.6, 9.6, 10.6, 10.1, 8.0, 6.6, 5.0, 4.2, 2.7, 0.0, 0.0, 0.0),
    "severe": (15.6, 17.6, 23.0, 23.6, 22.1, 20.0, 16.0, 15.1, 12.1, 7.9, 6.2, 5.1),
}
_LOW, _HIGH = 1000.0 * _FT, 2000.0 * _FT
_FREE_LENGTH: Final = 1750.0 * _FT


class Scales(NamedTuple):
    """Root mean squares of u, v, w, m/s, and their scale lengths, m: numbers or traced values, three each."""

    sigma: tuple[Any, Any, Any]
    length: tuple[Any, Any, Any]


def specified(severity: str, height: Any, wind_at_20_ft: float | None = None) -> Scales:
    """By the height above ground, m: below 1000 ft that of the surface layer, above 2000 ft that of free air.

    Between them straight lines are drawn; below 10 ft it is as at 10 ft.
    """
    _check.choice("severity", severity, SEVERITIES)
    wind = _WIND_AT_20_FT[severity] if wind_at_20_ft is None else wind_at_20_ft
    low = np.clip(height, 10.0 * _FT, _LOW)
    ratio = 0.177 + 0.000823 / _FT * low
    sigma_w = 0.1 * wind
    sigma_u, length_u = sigma_w / ratio**0.4, low / ratio**1.2
    table = Table(np.array(_ALTITUDES) * _FT, np.array(_INTENSITIES[severity]) * _FT)
    free = table(np.maximum(height, _HIGH))
    share = np.clip((height - _LOW) / (_HIGH - _LOW), 0.0, 1.0)

    def between(near_ground: Any, above: Any) -> Any:
        return near_ground + (above - near_ground) * share

    along, across = between(sigma_u, free), between(sigma_w, free)
    horizontal, vertical = between(length_u, _FREE_LENGTH), between(low, _FREE_LENGTH)
    return Scales((along, along, across), (horizontal, horizontal, vertical))
