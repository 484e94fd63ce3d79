"""The U.S. Standard Atmosphere 1976."""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from freebody import _check
from freebody.environment.atmosphere import AIR_CONSTANT, GAMMA, Air, Atmosphere, viscosity
from freebody.environment.atmosphere_1976_upper import UPPER
from freebody.environment.limits import Limit, altitude_limits, checked_word
from freebody.tables import Table

__all__ = ["USStandard1976"]

# U.S. Standard Atmosphere, 1976, NOAA-S/T 76-1562: tables 2 and 4, equation (18).
RADIUS: Final = 6356766.0
GRAVITY: Final = 9.80665
PER_HEIGHT: Final = GRAVITY * 28.9644 / 8314.32
"""g0 M0/R*, K/m: pressure falls by this over the temperature. Density takes the constant that gives the
printed 1.2250 kg/m³ at sea level, see `AIR_CONSTANT`.
"""
LAYERS: Final = (
    (0.0, -6.5e-3),
    (11000.0, 0.0),
    (20000.0, 1.0e-3),
    (32000.0, 2.8e-3),
    (47000.0, 0.0),
    (51000.0, -2.8e-3),
    (71000.0, -2.0e-3),
)
"""Bases by geopotential altitude, m, and gradients of the molecular-scale temperature, K/m."""
LOWEST, JOINT, TOP = -5000.0, 86000.0, 1.0e6
"""Geometric altitudes, m: where it begins, where the part with one composition of air ends, its end."""


def geopotential(altitude: Any) -> Any:
    """Of a geometric altitude, m. Equation (18)."""
    return RADIUS * altitude / (RADIUS + altitude)


def _bases() -> list[tuple[float, float, float, float]]:
    """Height, gradient, temperature and logarithm of the pressure at the base of every layer."""
    temperature, log_pressure = 288.15, float(np.log(101325.0))
    found = []
    for i, (height, gradient) in enumerate(LAYERS):
        found.append((height, gradient, temperature, log_pressure))
        thickness = LAYERS[i + 1][0] - height if i + 1 < len(LAYERS) else 0.0
        end = temperature + gradient * thickness
        ratio = thickness / temperature if gradient == 0.0 else np.log(end / temperature) / gradient
        temperature, log_pressure = end, float(log_pressure - PER_HEIGHT * ratio)
    return found


BASES: Final = _bases()


def _of_layer(height: Any, column: int) -> Any:
    """A number of the layer in which a geopotential altitude lies."""
    value: Any = BASES[-1][column]
    for here, above in zip(reversed(BASES[:-1]), reversed(BASES[1:]), strict=True):
        value = np.where(height < above[0], here[column], value)
    return value


def lower(altitude: Any) -> tuple[Any, Any]:
    """Logarithm of the pressure, and molecular-scale temperature, in the layers. (23), (33a), (33b)."""
    height = geopotential(altitude)
    base, gradient, temperature, log_pressure = (_of_layer(height, i) for i in range(4))
    depth = (height - base) / temperature
    even = np.abs(gradient) < 1e-9
    # The isothermal layer is the limit of the others; both come out of one logarithm and one exponential.
    fall = np.where(even, depth, np.log1p(gradient * depth) / np.where(even, 1.0, gradient))
    return log_pressure - PER_HEIGHT * fall, temperature * (1.0 + gradient * depth)


class USStandard1976(Atmosphere):
    """The U.S. Standard Atmosphere 1976, from -5 to 1000 km geometric altitude.

    To 86 km the closed form of its seven layers; above, cubic splines through the printed figures of table I
    (logarithm of the pressure, molecular-scale temperature), which join without a jump. Below -5 km the
    air of -5 km holds, above 1000 km the pressure falls exponentially. The speed of sound is √(γ p/ρ), also
    where the standard does not give it any more. NOAA-S/T 76-1562 (NASA-TM-X-74335), Washington 1976.

    Parameters
    ----------
    temperature_offset
        Added to the temperature, K; the pressure at an altitude stays, the density changes: a day of ISA+10.
    density_factor
        Multiplies density and pressure.
    upper
        Whether there are tables above 86 km. Without them the last layer goes on at one temperature, and a
        law is a little faster.
    name
        The word before the names of its parameters, "air_temperature_offset", "air_density_factor".
    """

    def __init__(
        self,
        temperature_offset: float = 0.0,
        density_factor: float = 1.0,
        *,
        upper: bool = True,
        name: str = "air",
    ) -> None:
        word = checked_word("name", name)
        self.upper = _check.flag("upper", upper)
        self._offset, self._factor = f"{word}_temperature_offset", f"{word}_density_factor"
        self.parameters = {
            self._offset: (_check.number("temperature_offset", temperature_offset), "K"),
            self._factor: (_check.number("density_factor", density_factor, positive=True), "1"),
        }

    @property
    def limits(self) -> tuple[Limit, ...]:
        beyond = "above the pressure falls exponentially"
        top = (TOP, beyond) if self.upper else (JOINT, f"{beyond} at one temperature")
        below = "the air there holds below"
        return altitude_limits("US Standard Atmosphere 1976", LOWEST, top[0], (below, top[1]))

    def at(self, altitude: Any, p: Any = None) -> Air:
        factor, offset = self._value(p, self._factor), self._value(p, self._offset)
        altitude = np.maximum(altitude, LOWEST)
        log_pressure, scale = lower(np.minimum(altitude, JOINT))
        if self.upper:
            high = altitude > JOINT
            beyond = np.maximum(altitude - TOP, 0.0) / SCALE_HEIGHT
            log_pressure = np.where(high, LOG_PRESSURE(altitude) - beyond, log_pressure)
            scale = np.where(high, SCALE_TEMPERATURE(altitude), scale)
        else:
            beyond = geopotential(altitude) - geopotential(np.minimum(altitude, JOINT))
            log_pressure = log_pressure - PER_HEIGHT * beyond / scale
        temperature = scale * WEIGHT(altitude)
        # ISA+10 warms the air as it is: the molecular weight stays.
        warmer = 1.0 + offset / temperature
        pressure = factor * np.exp(log_pressure)
        return Air(
            pressure / (AIR_CONSTANT * scale * warmer),
            pressure,
            temperature * warmer,
            np.sqrt(GAMMA * AIR_CONSTANT * scale * warmer),
            viscosity(temperature * warmer),
        )


def _upper_tables() -> tuple[Table, Table, Table, float]:
    altitude, temperature, pressure, density = (np.array(column) for column in zip(*UPPER, strict=True))
    low = lower(JOINT)
    log_pressure, scale = np.log(pressure), pressure / (AIR_CONSTANT * density)
    log_pressure[0], scale[0] = float(low[0]), float(low[1])
    gravity = GRAVITY * (RADIUS / (RADIUS + TOP)) ** 2
    weight = temperature / scale
    weight[0] = WEIGHTS[-1]
    below = JOINT - 500.0 * np.arange(len(WEIGHTS) - 1, 0, -1)
    return (
        Table(altitude, log_pressure, "cubic"),
        Table(altitude, scale, "cubic"),
        Table(np.concatenate([below, altitude]), np.concatenate([WEIGHTS[:-1], weight])),
        float(AIR_CONSTANT * scale[-1] / gravity),
    )


# Ratio of the mean molecular weight to that at sea level, every 500 m from 80 to 86 km. Table 8.
WEIGHTS = 1.0 - 1e-6 * np.array(
    [0.0, 4.0, 11.0, 29.0, 59.0, 91.0, 130.0, 171.0, 214.0, 259.0, 306.0, 359.0, 421.0]
)
LOG_PRESSURE, SCALE_TEMPERATURE, WEIGHT, SCALE_HEIGHT = _upper_tables()
