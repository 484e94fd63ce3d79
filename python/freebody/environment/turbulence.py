"""Continuous turbulence."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.environment.planet import Place
from freebody.environment.turbulence_scales import SEVERITIES, Scales, Severity, specified
from freebody.environment.wind import NamedWind, WindHere
from freebody.errors import InputError

__all__ = ["DrydenTurbulence", "spectrum"]

_LONGEST = 1750.0 * 0.3048 / 0.02
"""Waves longer than this over 2π, m, are taken for one of half its wave number."""


class _Waves(NamedTuple):
    """The waves of one component: wave numbers and phases (n,), rad/m and rad."""

    number: Array
    phase: Array


class DrydenTurbulence(NamedWind):
    """Turbulence with the spectra of Dryden, frozen into the air through which the body flies.

    MIL-F-8785C, 3.7.1.2; MIL-HDBK-1797 writes the same spectra with half of the lengths across. Each of u, v,
    w and of the roll rate is a sum of harmonics of the distance flown through the air, with the power that
    the spectrum has around their wave numbers, and with phases that follow from the seed: smooth, and the
    same in every run. Pitch and yaw rate are the slopes of w and v, smoothed over the span as specified.

    The distance is read from a `TurbulencePath`, which belongs to the forces of the model.

    Parameters
    ----------
    sigma
        Root mean squares of u, v, w, (3,) m/s.
    length
        Scale lengths of u, v, w, (3,) m.
    span
        Of the wings, m: it says how the rates are smoothed.
    seed
        A whole number from which the phases follow.
    shortest
        Waves shorter than this, m, are left out; half of the span when omitted.
    harmonics
        How many to a component.
    axes
        "body": u, v, w lie along forward, right and down, the axes of the body if nothing else is said;
        "level": u lies horizontally below forward, w points down.
    body_from_aero
        Rotation (3, 3) whose columns are forward, right and down in body axes, when those are others.
    name
        The word before the names of its parameters: "turbulence_factor" multiplies it, "turbulence_shift" is
        added to the distance, m: another stretch of the same air, that runs of an ensemble may disperse.
    """

    def __init__(
        self,
        sigma: ArrayLike,
        length: ArrayLike,
        span: float,
        *,
        seed: int,
        shortest: float | None = None,
        harmonics: int = 24,
        axes: Literal["body", "level"] = "body",
        body_from_aero: ArrayLike | None = None,
        name: str = "turbulence",
    ) -> None:
        super().__init__(name, {"factor": (1.0, "1"), "shift": (0.0, "m")})
        self.sigma = _check.vector("sigma", sigma, 3)
        self.length = _check.vector("length", length, 3)
        if (self.sigma < 0.0).any() or (self.length <= 0.0).any():
            raise InputError("sigma, length: got a negative one; allowed are sigma >= 0 and length > 0")
        self.span = _check.number("span", span, positive=True)
        self.axes = _check.choice("axes", axes, ("body", "level"))
        turn = None if body_from_aero is None else _check.rotation("body_from_aero", body_from_aero)
        self.body_from_aero = turn
        self.severity: str | None = None
        self.ground, self.wind_at_20_ft = 0.0, None
        self.inputs = {"air_path": "m"}
        least = 0.5 * self.span if shortest is None else _check.number("shortest", shortest, positive=True)
        self.edges = _edges(least, _check.count("harmonics", harmonics))
        if not isinstance(seed, int | np.integer) or seed < 0:
            raise InputError(f"seed: got {_check.shown(seed)}; give a whole number, 0 or more")
        self.waves = _waves(self.edges, int(seed))

    @classmethod
    def specified(
        cls,
        severity: Severity,
        span: float,
        *,
        seed: int,
        height: float | None = None,
        ground: float = 0.0,
        wind_at_20_ft: float | None = None,
        **options: Any,
    ) -> DrydenTurbulence:
        """Light, moderate or severe turbulence of MIL-F-8785C, 3.7.3.

        Parameters
        ----------
        severity
            Wind of 15, 30 or 45 kt at 20 ft near the ground; above 2000 ft intensities of figure 7 that are
            exceeded with probabilities of 1e-2, 1e-3 or 1e-5.
        height
            Above ground, m, for which intensities and lengths hold; that of the body when omitted.
        ground
            Its altitude, m.
        wind_at_20_ft
            m/s, in place of that of the severity.
        options
            Those of the class.
        """
        _check.choice("severity", severity, SEVERITIES)
        wind = None if wind_at_20_ft is None else _check.number("wind_at_20_ft", wind_at_20_ft, positive=True)
        at = specified(severity, 0.0 if height is None else _check.number("height", height), wind)
        sigma, length = np.array([float(v) for v in at.sigma]), np.array([float(v) for v in at.length])
        self = cls(sigma, length, span, seed=seed, **options)
        if height is None:
            self.severity, self.wind_at_20_ft = severity, wind
            self.ground = _check.number("ground", ground)
        return self

    def scales(self, altitude: Any) -> Scales:
        """Intensities and lengths at an altitude, m."""
        if self.severity is None:
            return Scales(tuple(self.sigma), tuple(self.length))
        return specified(self.severity, 1.0 * (altitude - self.ground), self.wind_at_20_ft)

    def gusts(self, way: Any, altitude: Any = 0.0) -> tuple[Any, Any]:
        """Velocities u, v, w, m/s, and rates p, q, r of the air, rad/s, a distance on the way, m."""
        scales = self.scales(altitude)
        center, width = 0.5 * (self.edges[1:] + self.edges[:-1]), np.diff(self.edges)
        found = []
        for component, waves in zip("uvwp", self.waves, strict=True):
            power = spectrum(component, center, scales, self.span) * width
            angle = waves.number * way + waves.phase
            found.append((np.sqrt(2.0 * power), angle, waves.number))
        u, v, w, p = (np.sum(amplitude * np.cos(angle)) for amplitude, angle, _ in found)
        q, r = (self._slope(found[2], 4.0), -1.0 * self._slope(found[1], 3.0))
        return np.stack([u, v, w]), np.stack([p, q, r])

    def _slope(self, component: tuple[Any, Any, Array], part: float) -> Any:
        """Minus the slope of a component, smoothed over a part of the span."""
        amplitude, angle, number = component
        return np.sum(
            amplitude * (number / np.sqrt(1.0 + (part * self.span / np.pi * number) ** 2)) * np.sin(angle)
        )

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        factor, way = self._value(p, "factor"), s.inputs.air_path + self._value(p, "shift")
        velocity, rotation = self.gusts(1.0 * way, place.altitude)
        ned_from_body = place.world_from_ned.T @ s.world_from_body
        turn = self.body_from_aero
        ned_from_aero = ned_from_body if turn is None else ned_from_body @ turn
        if self.axes == "body":
            turning = rotation if turn is None else turn @ rotation
            return WindHere(factor * (ned_from_aero @ velocity), factor * turning)
        north, east = ned_from_aero[0, 0], ned_from_aero[1, 0]
        # A body that points straight up has no heading.
        length = np.sqrt(north**2 + east**2 + 1e-12)
        c, e = north / length, east / length
        level = [np.stack([c * x[0] - e * x[1], e * x[0] + c * x[1], x[2]]) for x in (velocity, rotation)]
        return WindHere(factor * level[0], factor * (ned_from_body.T @ level[1]))


def spectrum(component: str, number: Any, scales: Scales, span: float) -> Any:
    """The power of u, v, w or p at a wave number, rad/m, one-sided: its integral is the variance.

    MIL-F-8785C, 3.7.1.2 and 3.7.5.
    """
    place = "uvw".find("w" if component == "p" else component)
    sigma, length = scales.sigma[place], scales.length[place]
    x = length * number
    if component == "u":
        return sigma**2 * (2.0 / np.pi * length) / (1.0 + x**2)
    if component == "p":
        roll = 0.8 * (np.pi * length / (4.0 * span)) ** (1.0 / 3.0) / length
        return sigma**2 * roll / (1.0 + (4.0 * span / np.pi * number) ** 2)
    return sigma**2 * (length / np.pi) * (1.0 + 3.0 * x**2) / (1.0 + x**2) ** 2


def _edges(shortest: float, harmonics: int) -> Array:
    """The wave numbers between which each harmonic stands, rising by one factor; the first from zero."""
    highest, lowest = 2.0 * np.pi / shortest, 1.0 / _LONGEST
    if highest <= 10.0 * lowest:
        raise InputError(f"shortest: got {shortest:g} m; allowed is less than {_LONGEST / 5.0:.0f} m")
    return np.concatenate([[0.0], np.geomspace(lowest, highest, harmonics)])


def _waves(edges: Array, seed: int) -> tuple[_Waves, ...]:
    random = np.random.Generator(np.random.Philox(key=seed))
    found = []
    for _ in "uvwp":
        inside, turn = random.random((2, len(edges) - 1))
        found.append(_Waves(edges[:-1] + inside * np.diff(edges), 2.0 * np.pi * turn))
    return tuple(found)
