"""The U.S. Standard Atmosphere 1976 against its printed tables."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.environment import USStandard1976

from .printed import off_by
from .residual import Residual

__all__ = ["PRINTED", "cases"]

# Table I, geometric altitude, NOAA-S/T 76-1562, pages 51 to 68: m, K, mb, kg/m³, as printed.
PRINTED = """
-5000  320.676  1.7776e3   1.9311
0      288.150  1.01325e3  1.2250
5000   255.676  5.4048e2   7.3643e-1
11000  216.774  2.2699e2   3.6480e-1
20000  216.650  5.5293e1   8.8910e-2
32000  228.490  8.8906     1.3555e-2
47000  269.684  1.1585     1.4965e-3
51000  270.650  7.0458e-1  9.0690e-4
71000  216.846  4.4795e-2  7.1966e-5
80000  198.639  1.0524e-2  1.8458e-5
86000  186.87   3.7338e-3  6.958e-6
"""

# Printed pressures are cut off, not rounded: 226.9996 mb at 11 km stands as 2.2699e2. The density of 71 km
# stands 0.8 of a digit above the formula that it comes from.
ALLOWED = {"temperature": 0.501, "pressure": 1.0, "density": 0.9}


def cases() -> Iterator[Residual]:
    """Temperature, pressure and density at each altitude of `PRINTED`."""
    atmosphere, found = USStandard1976(), []
    for row in PRINTED.strip().splitlines():
        altitude, printed = row.split(maxsplit=1)
        air = atmosphere.at(float(altitude))
        found.append(off_by([air.temperature, air.pressure / 100.0, air.density], printed))
    for (quantity, allowed), worst in zip(ALLOWED.items(), np.max(found, axis=0), strict=True):
        yield Residual("US-76", f"{quantity}, -5 to 86 km", float(worst), allowed, "last digit")
