"""Springs, dampers and tethers between the body and the world."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.anchors import anchored
from freebody.elements.seats import ORIGIN, at_least
from freebody.elements.smooth import TINY, ramp, ramp_slope
from freebody.errors import InputError
from freebody.tracing import ForceLaw, wrench

__all__ = ["RotationalSpring", "Spring", "Tether"]


class Spring(ForceLaw):
    """A spring and a damper in line, between a point of the body and a point of the world.

    The tension k (l − l₀) + c l' acts along the line; it pushes when the spring is shorter than its free
    length. Where both ends meet a spring of free length zero is smooth; another has no direction there.

    Parameters
    ----------
    stiffness
        k, N/m.
    at
        On the body, from o1, body axes, (3,) m.
    anchor
        In the world, world axes, (3,) m. Or a name, for a point that moves: "buoy" makes the inputs buoy_x,
        buoy_y, buoy_z, m, and buoy_velocity_x, …, m/s, world axes.
    length
        l₀, m, zero by default.
    damping
        c, N s/m.

    Parameters of the law: `stiffness`, `length`, `damping`.
    """

    def __init__(
        self,
        stiffness: float,
        *,
        at: ArrayLike = ORIGIN,
        anchor: ArrayLike | str = ORIGIN,
        length: float = 0.0,
        damping: float = 0.0,
        name: str | None = None,
    ) -> None:
        point, end = _check.vector("at", at, 3), anchored("anchor", anchor)

        def spring(s: Any, p: Any) -> Any:
            line, rate = end.line(s, point)
            stretched = np.sqrt(line @ line + TINY)
            along = line / stretched
            tension = p.stiffness * (stretched - p.length) + p.damping * (along @ rate)
            return wrench(s.world_from_body.T @ (-tension * along), at=point)

        own = {
            "stiffness": (at_least("stiffness", stiffness), "N/m"),
            "length": (at_least("length", length), "m"),
            "damping": (at_least("damping", damping), "N s/m"),
        }
        super().__init__(spring, own, end.inputs, name=name)


class Tether(ForceLaw):
    """A line that pulls and never pushes: towing, mooring, a tethered satellite.

    Slack up to its length; beyond it the tension is k r(l − l₀) + c r'(l − l₀) l', and not below zero. r
    grows as a parabola over the onset δ and is l − l₀ − δ/2 from there, so that stiffness and damping set in
    smoothly and adaptive methods step through. The line has no mass and no drag.

    Parameters
    ----------
    stiffness, length
        k, N/m, and l₀, m.
    at, anchor
        As of `Spring`.
    damping
        c, N s/m.
    onset
        δ, m; a hundredth of the length when omitted.

    Parameters of the law: `stiffness`, `length`, `damping`, `onset`.
    """

    def __init__(
        self,
        stiffness: float,
        length: float,
        *,
        at: ArrayLike = ORIGIN,
        anchor: ArrayLike | str = ORIGIN,
        damping: float = 0.0,
        onset: float | None = None,
        name: str | None = None,
    ) -> None:
        point, end = _check.vector("at", at, 3), anchored("anchor", anchor)
        free = _check.number("length", length, positive=True)

        def tether(s: Any, p: Any) -> Any:
            line, rate = end.line(s, point)
            distance = np.sqrt(line @ line + TINY)
            along = line / distance
            beyond = distance - p.length
            elastic = p.stiffness * ramp(beyond, p.onset)
            friction = p.damping * ramp_slope(beyond, p.onset) * (along @ rate)
            tension = np.maximum(elastic + friction, 0.0)
            return wrench(s.world_from_body.T @ (-tension * along), at=point)

        own = {
            "stiffness": (at_least("stiffness", stiffness), "N/m"),
            "length": (free, "m"),
            "damping": (at_least("damping", damping), "N s/m"),
            "onset": (_check.number("onset", 0.01 * free if onset is None else onset, positive=True), "m"),
        }
        super().__init__(tether, own, end.inputs, name=name)


class RotationalSpring(ForceLaw):
    """A spring and a damper against turning away from an attitude.

    The moment of the energy U = tr(G (1 − E)), E = C₀ᵀ C, with G = ½ tr(K) 1 − K: K θ for small angles θ, k
    sin θ about a principal axis, smooth for every attitude; and −C_d ω, ω of the body in the world. Bullo and
    Lewis, Geometric Control of Mechanical Systems (2005).

    Parameters
    ----------
    stiffness
        K, N m/rad, in the body axes: a number, (3,) or (3, 3).
    attitude
        C₀, world from body, at rest, (3, 3); the unit matrix when omitted.
    damping
        C_d, N m s/rad: a number, (3,) or (3, 3).

    Parameters of the law: `scale` and `damping_scale`, factors of both, 1.
    """

    def __init__(
        self,
        stiffness: ArrayLike,
        attitude: ArrayLike | None = None,
        damping: ArrayLike = 0.0,
        *,
        name: str | None = None,
    ) -> None:
        K, resistance = _tensor("stiffness", stiffness), _tensor("damping", damping)
        half = 0.5 * np.trace(K) * np.eye(3) - K
        rest = np.eye(3) if attitude is None else _check.rotation("attitude", attitude)

        def rotational_spring(s: Any, p: Any) -> Any:
            turned = half @ (rest.T @ s.world_from_body)
            skew = turned - turned.T
            back = np.stack([skew[2, 1], skew[0, 2], skew[1, 0]])
            return wrench(moment=-p.scale * back - p.damping_scale * (resistance @ s.angular_velocity_body))

        super().__init__(rotational_spring, {"scale": (1.0, "1"), "damping_scale": (1.0, "1")}, name=name)


def _tensor(name: str, given: ArrayLike) -> Any:
    """A number, three, or a symmetric (3, 3), without negative eigenvalues."""
    array = np.asarray(given)
    if array.ndim == 0:
        return at_least(name, given) * np.eye(3)  # type: ignore[arg-type]
    tensor = _check.diagonal_or_full(name, given, 3)
    tensor = np.diag(tensor) if tensor.ndim == 1 else tensor
    largest = np.abs(tensor).max()
    if np.abs(tensor - tensor.T).max() > 1e-9 * largest:
        raise InputError(f"{name}: not symmetric")
    smallest = float(np.linalg.eigvalsh(tensor)[0])
    if smallest < -1e-9 * largest:
        raise InputError(f"{name}: its smallest eigenvalue is {smallest:.6g}; it must not be negative")
    return tensor
