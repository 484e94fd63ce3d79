"""Buoyancy: of a body under water, and of a hull that floats."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.seats import ORIGIN, at_least, seat
from freebody.environment import Environment, checked_environment
from freebody.errors import InputError
from freebody.tracing import ForceLaw, wrench

__all__ = ["Buoyancy", "Flotation"]


class Buoyancy(ForceLaw):
    """The buoyancy of a body that is under water as a whole: −ρ V g at its own centre.

    Weight is another force, at the mass centre. g is the attraction less the acceleration of the water, which
    goes with the planet. Nothing happens at the surface; see `Flotation` for what floats.

    Parameters
    ----------
    environment
        Its planet gives g, its atmosphere the density of the water.
    volume
        V of the displaced water, m³; a body of mass m hovers with V = m/ρ.
    at
        The centre of buoyancy from o1, body axes, (3,) m.

    Parameter of the law: `volume`.
    """

    def __init__(
        self, environment: Environment, volume: float, at: ArrayLike = ORIGIN, *, name: str | None = None
    ) -> None:
        env, center = checked_environment(environment), _check.vector("at", at, 3)

        def buoyancy(s: Any, p: Any) -> Any:
            flow = env.flow(s, p, center)
            lift = -(p.volume * flow.air.density) * _fall(env, s, center)
            return wrench(force=lift, at=center)

        own = {"volume": (_check.number("volume", volume, positive=True), "m^3")}
        super().__init__(buoyancy, {**own, **env.parameters}, env.inputs, name=name, notices=env.notices)


class Flotation(ForceLaw):
    """The buoyancy of a hull that floats, about its own point of flotation, for any heel and trim.

    The hull is taken as wall-sided where water comes and goes: what it displaces beyond the volume at rest
    are columns over the waterplane, cut by a water surface that is a plane. With the depth d of the point of
    flotation F below the surface and the unit vector n that points down, both in the element's axes, the
    displaced volume is V + A d/n₃ and its first moment about F is

        V r_B + (I_L n₁/n₃, I_T n₂/n₃, −½ (A d² + I_L n₁² + I_T n₂²)/n₃²),

    which gives force and moment exactly, and for small motions the stiffness ρ g A in heave, ρ g V GM_T in
    roll and ρ g V GM_L in pitch with BM = I/V. Wall-sided formula: Fossen, Handbook (2nd ed. 2021), chapter
    4; Newman, Marine Hydrodynamics (1977), chapter 6.

    It holds until the deck is wet or the bilge comes out of the water. n₃ is not taken below 0.1 (84
    degrees), so that the numbers stay finite. The sea is at altitude 0, without waves.

    Parameters
    ----------
    environment
        Planet and water.
    volume
        V, the volume displaced when the waterplane lies in the surface, m³.
    center
        B, the centre of that volume from o1, body axes, (3,) m.
    waterplane_area
        A, m².
    transverse_moment, longitudinal_moment
        I_T and I_L: the second moments of the waterplane about the axes through its centroid, those of roll
        and of pitch, m⁴.
    at
        F, the centroid of the waterplane, from o1, body axes, (3,) m.
    axes
        Its axes as columns: forward, starboard and down, normal to the waterplane; the body axes when
        omitted.

    Parameters of the law: `volume`, `waterplane_area`, `transverse_moment`, `longitudinal_moment`.
    """

    def __init__(
        self,
        environment: Environment,
        volume: float,
        center: ArrayLike,
        *,
        waterplane_area: float,
        transverse_moment: float,
        longitudinal_moment: float,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> None:
        env, place = checked_environment(environment), seat(at, axes)
        arm = place.axes.T @ (_check.vector("center", center, 3) - place.at)
        if arm[2] <= 0.0:
            raise InputError(
                f"center, at: the centre of buoyancy lies {-arm[2]:g} m above the waterplane; it lies below, "
                "and the third axis points down"
            )

        def flotation(s: Any, p: Any) -> Any:
            flow = env.flow(s, p, place.at)
            down = place.axes.T @ (s.world_from_body.T @ flow.place.world_from_ned[:, 2])
            n1, n2, n3 = down[0], down[1], np.maximum(down[2], 0.1)
            depth = -flow.place.altitude
            area, across, along = p.waterplane_area, p.transverse_moment, p.longitudinal_moment
            squares = area * depth**2 + along * n1**2 + across * n2**2
            moved = np.stack([along * n1 / n3, across * n2 / n3, -0.5 * squares / n3**2])
            # An element gone from the water altogether displaces nothing.
            displaced = np.maximum(p.volume + area * depth / n3, 0.0)
            weight = -flow.air.density * (place.axes.T @ _fall(env, s, place.at))
            moment = np.cross(np.where(displaced > 0.0, p.volume * arm + moved, 0.0), weight)
            return place.wrench(np.concatenate([displaced * weight, moment]))

        own = {
            "volume": (_check.number("volume", volume, positive=True), "m^3"),
            "waterplane_area": (_check.number("waterplane_area", waterplane_area, positive=True), "m^2"),
            "transverse_moment": (at_least("transverse_moment", transverse_moment), "m^4"),
            "longitudinal_moment": (at_least("longitudinal_moment", longitudinal_moment), "m^4"),
        }
        super().__init__(flotation, {**own, **env.parameters}, env.inputs, name=name, notices=env.notices)

    @classmethod
    def from_metacentric_heights(
        cls,
        environment: Environment,
        volume: float,
        center: ArrayLike,
        com: ArrayLike,
        *,
        waterplane_area: float,
        transverse: float,
        longitudinal: float,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> Flotation:
        """Of the metacentric heights GM_T and GM_L over the mass centre `com`, m: I = V (GM + BG)."""
        down = seat(at, axes).axes[:, 2]
        rise = float(down @ (_check.vector("center", center, 3) - _check.vector("com", com, 3)))
        size = _check.number("volume", volume, positive=True)
        heights = {"transverse": transverse, "longitudinal": longitudinal}
        moments = {key: size * (_check.number(key, height) + rise) for key, height in heights.items()}
        for key, moment in moments.items():
            if moment < 0.0:
                raise InputError(f"{key}: got {heights[key]:g} m; BM = GM + BG would be negative")
        return cls(
            environment,
            volume,
            center,
            waterplane_area=waterplane_area,
            transverse_moment=moments["transverse"],
            longitudinal_moment=moments["longitudinal"],
            at=at,
            axes=axes,
            name=name,
        )


def _fall(env: Environment, s: Any, at: Any) -> Any:
    """The acceleration with which things fall beside the water that goes with the planet, body axes."""
    point = s.position_world + s.world_from_body @ at
    turning, planet = env.planet.angular_velocity_world, env.planet
    return s.world_from_body.T @ (
        planet.gravity(point, s.time) - np.cross(turning, planet.ground_velocity(point))
    )
