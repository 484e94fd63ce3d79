"""Atmospheres and waters: density, pressure, temperature and speed of sound by altitude."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

import numpy as np

from freebody import _check
from freebody.environment.limits import Limit, checked_word

__all__ = ["AIR_CONSTANT", "GAMMA", "Air", "Atmosphere", "UniformAtmosphere", "viscosity"]

AIR_CONSTANT = 287.05287
"""R of dry air, J/(kg K), of ISO 2533 and of NASA's check cases: it makes the air of 101 325 Pa and 288.15 K
as dense as the U.S. Standard Atmosphere 1976 prints, 1.2250 kg/m³. That standard's own R*/M0,
8314.32/28.9644, is 7e-7 more.
"""
GAMMA = 1.4
"""Ratio of specific heats of air, same source, table 2."""


class Air(NamedTuple):
    """The state of the medium at a place: kg/m³, Pa, K, m/s, Pa s."""

    density: Any
    pressure: Any
    temperature: Any
    speed_of_sound: Any
    dynamic_viscosity: Any = 1.7894e-5


class Atmosphere(ABC):
    """What forces ask of an atmosphere; numbers or traced values.

    Attributes
    ----------
    parameters
        Name: (value, unit), of what can be dispersed; every law that asks for the flow has them.
    limits
        Where it ends, and what holds there.
    """

    parameters: Mapping[str, tuple[float, str]] = {}

    @property
    def limits(self) -> tuple[Limit, ...]:
        return ()

    @abstractmethod
    def at(self, altitude: Any, p: Any = None) -> Air:
        """The air at a geometric altitude, m, for the parameters `p` of a law (None: the nominal ones)."""

    def _value(self, p: Any, name: str) -> Any:
        return self.parameters[name][0] if p is None else p[name]


class UniformAtmosphere(Atmosphere):
    """A medium of one density, air or water.

    Parameters
    ----------
    density, pressure, temperature, speed_of_sound, dynamic_viscosity
        kg/m³, Pa, K, m/s, Pa s; those of the standard atmosphere at sea level when omitted.
    density_factor
        Multiplies the density; it can be dispersed as "environment.air_density_factor".
    name
        The word before the names of its parameters.
    """

    def __init__(
        self,
        density: float = 1.225,
        pressure: float = 101325.0,
        temperature: float = 288.15,
        speed_of_sound: float = 340.294,
        dynamic_viscosity: float = 1.7894e-5,
        *,
        density_factor: float = 1.0,
        name: str = "air",
    ) -> None:
        self.air = Air(
            _check.number("density", density, positive=True),
            _check.number("pressure", pressure, positive=True),
            _check.number("temperature", temperature, positive=True),
            _check.number("speed_of_sound", speed_of_sound, positive=True),
            _check.number("dynamic_viscosity", dynamic_viscosity, positive=True),
        )
        self._factor = f"{checked_word('name', name)}_density_factor"
        factor = _check.number("density_factor", density_factor, positive=True)
        self.parameters = {self._factor: (factor, "1")}

    @classmethod
    def water(
        cls, kind: Literal["sea", "fresh"] = "sea", *, density_factor: float = 1.0
    ) -> UniformAtmosphere:
        """Water of 15 °C at one atmosphere; its parameter is "water_density_factor".

        Density and viscosity: ITTC Recommended Procedures 7.5-02-01-03, Fresh Water and Seawater Properties
        (2011), tables 1 and 3, sea water of 35.17 g/kg. Speed of sound: Mackenzie, JASA 70 (1981) 807, for
        sea water; Bilaniuk and Wong, JASA 93 (1993) 1609, for fresh water.
        """
        values = _WATERS[_check.choice("kind", kind, ("sea", "fresh"))]
        return cls(*values, density_factor=density_factor, name="water")

    def at(self, altitude: Any, p: Any = None) -> Air:
        return self.air._replace(density=self.air.density * self._value(p, self._factor))


_WATERS = {
    "sea": (1026.021, 101325.0, 288.15, 1506.7, 1.220e-3),
    "fresh": (999.1026, 101325.0, 288.15, 1465.9, 1.138e-3),
}


def viscosity(temperature: Any) -> Any:
    """Sutherland's law for air, Pa s. U.S. Standard Atmosphere 1976, (51) and table 2."""
    return 1.458e-6 * temperature * np.sqrt(temperature) / (temperature + 110.4)
