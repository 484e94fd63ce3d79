"""Discrete gusts."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.environment.planet import Place
from freebody.environment.wind import NamedWind, WindHere
from freebody.errors import InputError
from freebody.forces import TabulatedWrench

__all__ = ["OneMinusCosineGust"]


class OneMinusCosineGust(NamedWind):
    """A gust that grows as (1 - cos)/2: V = Vₘ/2 (1 - cos(π x/d)) for 0 ≤ x ≤ d. MIL-F-8785C, 3.7.2.3.

    Parameters
    ----------
    velocity
        Vₘ, towards which it blows, (3,) m/s.
    start
        Where x is zero: a time, s, or a distance flown through the air, m.
    duration, length
        d, one of the two: s, for a gust in time; m, for a gust on the way, which reads the published state
        "air_path" of a `TurbulencePath`.
    axes
        "ned": north, east, down; "body": forward, right, down, the axes of the body if nothing else is said.
    body_from_aero
        Rotation (3, 3) whose columns are forward, right and down in body axes, when those are others.
    shape
        "ramp": stays at Vₘ from x = d on, as in the specification; "pulse": falls again, zero from 2 d on, as
        in airworthiness codes (CS 25.341, whose H is d).
    name
        The word before the names of its parameters: "gust_speed", "gust_start", and "gust_duration" or
        "gust_length".
    """

    def __init__(
        self,
        velocity: ArrayLike,
        start: float,
        *,
        duration: float | None = None,
        length: float | None = None,
        axes: Literal["ned", "body"] = "ned",
        shape: Literal["ramp", "pulse"] = "ramp",
        body_from_aero: ArrayLike | None = None,
        name: str = "gust",
    ) -> None:
        self.axes = _check.choice("axes", axes, ("ned", "body"))
        self.shape = _check.choice("shape", shape, ("ramp", "pulse"))
        if (duration is None) == (length is None):
            raise InputError("duration, length: give one of them: a gust in time, or one on the way")
        self._extent, unit = ("duration", "s") if length is None else ("length", "m")
        extent = _check.number(self._extent, duration if length is None else length, positive=True)  # pyright: ignore[reportArgumentType]
        whole = _check.vector("velocity", velocity, 3)
        speed = float(np.linalg.norm(whole))
        if speed == 0.0:
            raise InputError("velocity: got the zero vector; leave the gust out")
        self.direction = whole / speed
        if body_from_aero is not None and axes == "body":
            self.direction = _check.rotation("body_from_aero", body_from_aero) @ self.direction
        super().__init__(
            name,
            {
                "speed": (speed, "m/s"),
                "start": (_check.number("start", start), unit),
                self._extent: (extent, unit),
            },
        )
        self.inputs = {} if length is None else {"air_path": "m"}

    def share(self, x: Any) -> Any:
        """Of its velocity, at x/d."""
        ends = 1.0 if self.shape == "ramp" else 2.0
        return 0.5 * (1.0 - np.cos(np.pi * np.clip(x, 0.0, ends)))

    def here(self, place: Place, s: Any, p: Any) -> WindHere:
        way = s.inputs.air_path if self.inputs else s.time
        x = (way - self._value(p, "start")) / self._value(p, self._extent)
        velocity = self.direction * (self._value(p, "speed") * self.share(1.0 * x))
        if self.axes == "body":
            velocity = place.world_from_ned.T @ (s.world_from_body @ velocity)
        return WindHere(velocity, np.zeros(3))

    def marks(self) -> TabulatedWrench:
        """A force of 1e-100 N, which makes integration step onto the beginning and the end of a gust in time.

        A body that moves evenly takes long steps, which may pass a short gust.
        """
        if self.inputs:
            raise InputError(f"{self.name}: when the body meets a gust on its way is not known before")
        start, extent = self._value(None, "start"), self._value(None, self._extent)
        times = [start, start + extent] + ([start + 2.0 * extent] if self.shape == "pulse" else [])
        # A column of zeros is no table to step onto.
        return TabulatedWrench(times, force=np.full((len(times), 3), 1e-100), name=f"{self.name} marks")
