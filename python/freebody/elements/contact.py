"""Contact of points of the body with a plane: landing legs, docking, grounding."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.planes import Plane, ground, plane
from freebody.elements.seats import ORIGIN, at_least
from freebody.elements.smooth import ramp
from freebody.environment import Environment
from freebody.errors import InputError
from freebody.tracing import ForceLaw, wrench

__all__ = ["Contact"]


class Contact(ForceLaw):
    """Points of the body that meet a plane, with friction: they go in a little, and are pushed out.

    At the depth d of a point, with its speed d' inwards and its velocity v_t along the plane,

        N = k r(d) max(0, 1 + λ d'),        friction = −μ N v_t/√(|v_t|² + v_s²)

    r grows as a parabola over the onset δ and is d − δ/2 from there. The factor of d' is Hunt and Crossley's
    damping (Coefficient of restitution interpreted as damping in vibroimpact, J. Applied Mechanics 42, 1975,
    440): no force jumps when contact begins, none pulls at its end. A mass that comes with the speed v leaves
    with e v, where λ v (1 + e) = ln((1 + λ v)/(1 − λ e v)), whatever its mass, k and δ; e ≈ 1 − ⅔ λ v for
    small λ v. Friction is Coulomb's, made smooth over the slip speed v_s: what would stick creeps, on a slope
    of the angle β with v_s tan β/√(μ² − tan² β), and what slides faster than 7 v_s has 99 % of Coulomb's
    friction.

    Times to choose steps by: a contact of the mass m lasts about π √(m/k), and friction settles within v_s
    m/(μ N). Adaptive methods find their way in and out; for long rest on the ground take an implicit one,
    "rodas5p".

    Parameters
    ----------
    points
        (3,) or (n, 3) m, from o1, body axes.
    stiffness
        k of each point, N/m.
    through, normal
        The plane: a point of it, (3,) m, and the direction out of it, towards the body, world axes. The
        default is the plane z = 0 under a third axis that points down.
    velocity
        Of the plane, constant, world axes, (3,) m/s; of a belt, or of a deck under way.
    moving
        A name, for a plane that moves along its normal: "deck" makes the inputs deck_height, m, and
        deck_speed, m/s, of the height over `through` and its rate.
    damping
        λ, s/m.
    friction
        μ.
    onset, slip_speed
        δ, m, and v_s, m/s.

    Parameters of the law: `stiffness`, `damping`, `friction`, `onset`, `slip_speed`; and `altitude` of a
    ground.
    """

    def __init__(
        self,
        points: ArrayLike,
        stiffness: float,
        *,
        through: ArrayLike = ORIGIN,
        normal: ArrayLike = (0.0, 0.0, -1.0),
        velocity: ArrayLike = ORIGIN,
        moving: str | None = None,
        damping: float = 0.0,
        friction: float = 0.0,
        onset: float = 1e-3,
        slip_speed: float = 1e-2,
        name: str | None = None,
    ) -> None:
        surface = plane(through, normal, velocity, moving)
        self._make(surface, points, stiffness, damping, friction, onset, slip_speed, name)

    @classmethod
    def on_ground(
        cls,
        environment: Environment,
        points: ArrayLike,
        stiffness: float,
        *,
        altitude: float = 0.0,
        damping: float = 0.0,
        friction: float = 0.0,
        onset: float = 1e-3,
        slip_speed: float = 1e-2,
        name: str | None = None,
    ) -> Contact:
        """With the ground of a planet at one altitude, m, level everywhere and turning with the planet."""
        contact = cls.__new__(cls)
        contact._make(
            ground(environment, altitude), points, stiffness, damping, friction, onset, slip_speed, name
        )
        return contact

    def _make(
        self,
        surface: Plane,
        points: ArrayLike,
        stiffness: float,
        damping: float,
        friction: float,
        onset: float,
        slip_speed: float,
        name: str | None,
    ) -> None:
        feet = np.atleast_2d(np.asarray(points))
        if feet.ndim != 2 or feet.shape[1] != 3 or len(feet) == 0:
            raise InputError(f"points: got shape {np.shape(points)}; allowed are (3,) and (n, 3)")
        feet = _check.vector("points", feet, *feet.shape)

        def contact(s: Any, p: Any) -> Any:
            force, moment = np.zeros(3), np.zeros(3)
            for foot in feet:
                turn = s.world_from_body
                position = s.position_world + turn @ foot
                velocity = turn @ (s.velocity_body + np.cross(s.angular_velocity_body, foot))
                depth, up, moved = surface.at(s, p, position)
                relative = velocity - moved
                rise = relative @ up
                slip = relative - rise * up
                push = p.stiffness * ramp(depth, p.onset) * np.maximum(1.0 - p.damping * rise, 0.0)
                grip = p.friction * push / np.sqrt(slip @ slip + p.slip_speed**2)
                one = turn.T @ (push * up - grip * slip)
                force, moment = force + one, moment + np.cross(foot, one)
            return wrench(force, moment)

        own = {
            "stiffness": (_check.number("stiffness", stiffness, positive=True), "N/m"),
            "damping": (at_least("damping", damping), "s/m"),
            "friction": (at_least("friction", friction), "1"),
            "onset": (_check.number("onset", onset, positive=True), "m"),
            "slip_speed": (_check.number("slip_speed", slip_speed, positive=True), "m/s"),
        }
        super().__init__(contact, {**own, **surface.parameters}, surface.inputs, name=name)
