"""Atmospheres from tables."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.environment.atmosphere import AIR_CONSTANT, GAMMA, Air, Atmosphere, viscosity
from freebody.environment.limits import Limit, altitude_limits, checked_word
from freebody.errors import InputError
from freebody.tables import Table

__all__ = ["TabulatedAtmosphere"]


class TabulatedAtmosphere(Atmosphere):
    """An atmosphere by altitude: a sounding, or another planet's.

    Between the rows the logarithms of density and pressure, the temperature and the rest are straight lines.
    Below the first and above the last row these hold; a run in which the body is there says so.

    Parameters
    ----------
    altitude
        Rising, (n,) m.
    density, pressure, temperature
        (n,) kg/m³, Pa, K; two of the three, or all: the third follows from p = ρ R T.
    speed_of_sound, dynamic_viscosity
        (n,) m/s, Pa s; when omitted √(γ p/ρ), and Sutherland's law for air.
    gas_constant, gamma
        R, J/(kg K), and the ratio of specific heats; those of air when omitted.
    density_factor
        Multiplies density and pressure.
    name
        The word before the name of its parameter, "air_density_factor".
    """

    def __init__(
        self,
        altitude: ArrayLike,
        *,
        density: ArrayLike | None = None,
        pressure: ArrayLike | None = None,
        temperature: ArrayLike | None = None,
        speed_of_sound: ArrayLike | None = None,
        dynamic_viscosity: ArrayLike | None = None,
        gas_constant: float = AIR_CONSTANT,
        gamma: float = GAMMA,
        density_factor: float = 1.0,
        name: str = "air",
    ) -> None:
        self.altitude = _check.series("altitude", altitude)
        given = {
            "density": density,
            "pressure": pressure,
            "temperature": temperature,
            "speed_of_sound": speed_of_sound,
            "dynamic_viscosity": dynamic_viscosity,
        }
        columns = {key: self._column(key, value) for key, value in given.items() if value is not None}
        state = ("density", "pressure", "temperature")
        if sum(key in columns for key in state) < 2:
            raise InputError("density, pressure, temperature: give two of the three")
        self.gas_constant = _check.number("gas_constant", gas_constant, positive=True)
        self.gamma = _check.number("gamma", gamma, positive=True)
        logs = ("density", "pressure")
        self._tables = {
            key: Table(self.altitude, np.log(values) if key in logs else values)
            for key, values in columns.items()
        }
        self._factor = f"{checked_word('name', name)}_density_factor"
        factor = _check.number("density_factor", density_factor, positive=True)
        self.parameters = {self._factor: (factor, "1")}

    def _column(self, key: str, values: ArrayLike) -> Array:
        column = _check.vector(key, values, len(self.altitude))
        if not (column > 0.0).all():
            i = int(np.argmin(column))
            raise InputError(f"{key}: got {column[i]:g} at index {i}; allowed are positive numbers")
        return column

    @property
    def limits(self) -> tuple[Limit, ...]:
        low, high = float(self.altitude[0]), float(self.altitude[-1])
        return altitude_limits(
            "atmosphere table", low, high, ("its first row holds below", "its last row holds")
        )

    def at(self, altitude: Any, p: Any = None) -> Air:
        own = {key: table(altitude) for key, table in self._tables.items()}
        for key in ("density", "pressure"):
            if key in own:
                own[key] = np.exp(own[key])
        constant = self.gas_constant
        if "density" not in own:
            own["density"] = own["pressure"] / (constant * own["temperature"])
        elif "pressure" not in own:
            own["pressure"] = own["density"] * constant * own["temperature"]
        elif "temperature" not in own:
            own["temperature"] = own["pressure"] / (constant * own["density"])
        density, pressure, temperature = own["density"], own["pressure"], own["temperature"]
        sound, mu = own.get("speed_of_sound"), own.get("dynamic_viscosity")
        factor = self._value(p, self._factor)
        return Air(
            factor * density,
            factor * pressure,
            temperature,
            np.sqrt(self.gamma * pressure / density) if sound is None else sound,
            viscosity(temperature) if mu is None else mu,
        )
