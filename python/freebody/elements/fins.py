"""Fins and rudders."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.commands import command, unit_vector
from freebody.elements.seats import at_least
from freebody.elements.smooth import TINY, saturated
from freebody.environment import Environment, checked_environment
from freebody.errors import InputError
from freebody.tracing import ForceLaw, wrench

__all__ = ["Fin", "lift_slope"]

# Oswald's efficiency of fins: between 0.85 and 0.95 for usual planforms.
_OSWALD = 0.9


class Fin(ForceLaw):
    """A fin that turns about its span: lift and drag by the flow that it meets where it is.

    α is the angle from the velocity of the fin relative to the medium, in the plane across its span, to its
    chord: the incidence of the body with what its rates add, and the angle of the fin δ, which turns the
    chord about `span` by the right-hand rule. With U the speed in that plane

        lift ½ ρ U² S C_L across the velocity,    C_L = a sat(½ sin 2α)
        drag ½ ρ U² S C_D against it,             C_D = C_D0 + C_L²/(π e A)

    ½ sin 2α is α for small angles, and sat holds what it reaches at the stall angle: lift grows to stall and
    stays there, smoothly, where that of a real fin falls; it is for angles below stall. No wake, no
    interference with the hull.

    Parameters
    ----------
    environment
        The medium.
    area
        S, planform, m².
    at
        The centre of pressure from o1, body axes, (3,) m.
    span, chord
        Directions in body axes: out along the fin, and forward, which is made perpendicular to it. With the
        chord forward and the span to starboard a positive angle lifts the leading edge; with the span up it
        turns it to port, as a rudder that turns the bow to starboard when it is astern.
    angle
        δ: the name of the input, or a number, rad.
    aspect_ratio
        A, of the fin with its mirror image in the hull; gives the slope a by `lift_slope` and the induced
        drag. Without it, there is no induced drag.
    slope
        a, 1/rad, instead of that from the aspect ratio.
    drag_coefficient
        C_D0.
    stall
        rad.

    Parameters of the law: `area`, `slope`, `drag_coefficient`, `induced_drag`, `stall`, and `angle` where it
    is a number.
    """

    def __init__(
        self,
        environment: Environment,
        area: float,
        at: ArrayLike,
        *,
        span: ArrayLike,
        chord: ArrayLike = (1.0, 0.0, 0.0),
        angle: str | float = 0.0,
        aspect_ratio: float | None = None,
        slope: float | None = None,
        drag_coefficient: float = 0.0,
        stall: float = math.radians(20.0),
        name: str | None = None,
    ) -> None:
        env, point = checked_environment(environment), _check.vector("at", at, 3)
        out, given = unit_vector("span", span), unit_vector("chord", chord)
        forward = given - (given @ out) * out
        if np.linalg.norm(forward) < 1e-6:
            raise InputError("span, chord: they are parallel; the chord points forward, across the span")
        forward = forward / np.linalg.norm(forward)
        normal = np.cross(forward, out)
        told = command("angle", angle, "rad", "angle")
        if slope is None and aspect_ratio is None:
            raise InputError("aspect_ratio, slope: neither came; give at least one of the two")
        ratio = None if aspect_ratio is None else _check.number("aspect_ratio", aspect_ratio, positive=True)
        tilt = lift_slope(ratio) if slope is None and ratio is not None else at_least("slope", slope or 0.0)
        limit = _check.number("stall", stall, positive=True)
        if limit > math.pi / 4.0:
            raise InputError(f"stall: got {limit:g} rad; fins stall before 45 degrees, 0.785 rad")

        def fin(s: Any, p: Any) -> Any:
            flow = env.flow(s, p, point)
            u, w = flow.velocity @ forward, flow.velocity @ normal
            delta = told.value(s, p)
            square = u * u + w * w + TINY
            speed = np.sqrt(square)
            along = u * np.cos(delta) - w * np.sin(delta)
            across = u * np.sin(delta) + w * np.cos(delta)
            lift = p.slope * saturated(along * across / square, 0.5 * np.sin(2.0 * p.stall))
            drag = p.drag_coefficient + p.induced_drag * lift * lift
            pressure = 0.5 * flow.air.density * p.area * speed
            return wrench(
                pressure * ((lift * w - drag * u) * forward - (lift * u + drag * w) * normal), at=point
            )

        own = {
            "area": (_check.number("area", area, positive=True), "m^2"),
            "slope": (tilt, "1"),
            "drag_coefficient": (at_least("drag_coefficient", drag_coefficient), "1"),
            "induced_drag": (0.0 if ratio is None else 1.0 / (math.pi * _OSWALD * ratio), "1"),
            "stall": (limit, "rad"),
        }
        super().__init__(
            fin,
            {**own, **told.parameters, **env.parameters},
            {**told.inputs, **env.inputs},
            name=name,
            notices=env.notices,
        )


def lift_slope(aspect_ratio: float) -> float:
    """The slope of lift over incidence of a low aspect ratio, 1/rad: π A/(1 + √(1 + (A/2)²)).

    Beard and McLain, Small Unmanned Aircraft (2012), section 4.2; Fossen, Handbook (2nd ed. 2021), chapter 8.
    """
    ratio = _check.number("aspect_ratio", aspect_ratio, positive=True)
    return math.pi * ratio / (1.0 + math.sqrt(1.0 + 0.25 * ratio**2))
