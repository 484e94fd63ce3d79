"""Resistance of water to a body: damping matrices, cross-flow drag, lift and drag of a hull.

All of it depends on the velocity relative to the water, the current included, and keeps its own point and
axes: a body described in another frame moves the same.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.elements.seats import ORIGIN, at_least, seat
from freebody.elements.smooth import TINY
from freebody.environment import Environment, checked_environment
from freebody.errors import InputError
from freebody.tracing import ForceLaw

__all__ = ["CrossFlowDrag", "HullLiftDrag", "HydrodynamicDamping"]

_FORCES, _RATES = "XYZKMN", "uvwpqr"


class HydrodynamicDamping(ForceLaw):
    """Linear and quadratic damping by the velocity relative to the water: −D V_r − D_q (|V_r| V_r).

    V_r is the velocity of `at` and the angular velocity in the element's axes; |V_r| V_r goes component by
    component. Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2nd ed. 2021), chapter 6.

    Parameters
    ----------
    environment
        Its wind is the current.
    linear, quadratic
        D and D_q, (6,) or (6, 6), SI by blocks, linear part first. The symmetric part of D must not have
        negative eigenvalues, the diagonal of D_q no negative entry: water takes energy, it gives none.
    at, axes
        The point they are about, from o1, (3,) m, and their axes as columns, (3, 3).

    Every entry that is not zero is a parameter under the name of its hydrodynamic derivative, the negative of
    the entry: X_u, Y_r (linear), N_rr (quadratic; N_vv where it comes from v).
    """

    def __init__(
        self,
        environment: Environment,
        linear: ArrayLike | None = None,
        quadratic: ArrayLike | None = None,
        *,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> None:
        env, place = checked_environment(environment), seat(at, axes)
        if linear is None and quadratic is None:
            raise InputError("linear, quadratic: neither came; give at least one of the two")
        slow, fast = _matrix("linear", linear), _matrix("quadratic", quadratic)
        least = float(np.linalg.eigvalsh(0.5 * (slow + slow.T))[0])
        if least < -1e-9 * np.abs(slow).max():
            raise InputError(
                f"linear: its symmetric part has the eigenvalue {least:.6g}; it would give energy. "
                "Derivatives such as X_u are the negatives of the entries"
            )
        if fast.diagonal().min() < 0.0:
            raise InputError(
                "quadratic: a diagonal entry is negative; it would give energy. Derivatives such as X_uu are "
                "the negatives of the entries"
            )
        first, second = _derivatives(slow, 1), _derivatives(fast, 2)

        def damping(s: Any, p: Any) -> Any:
            twist = place.twist(env.flow(s, p, place.at))
            components = [0.0] * 6
            for key, (i, j, _) in first.items():
                components[i] = components[i] + p[key] * twist[j]
            for key, (i, j, _) in second.items():
                components[i] = components[i] + p[key] * (np.abs(twist[j]) * twist[j])
            return place.wrench(np.stack(components))

        own = {key: (value, _unit(i, j, 1)) for key, (i, j, value) in first.items()}
        own |= {key: (value, _unit(i, j, 2)) for key, (i, j, value) in second.items()}
        super().__init__(damping, {**own, **env.parameters}, env.inputs, name=name, notices=env.notices)


def _matrix(name: str, given: ArrayLike | None) -> Array:
    if given is None:
        return np.zeros((6, 6))
    checked = _check.diagonal_or_full(name, given, 6)
    return np.diag(checked) if checked.ndim == 1 else checked


def _derivatives(matrix: Array, power: int) -> dict[str, tuple[int, int, float]]:
    return {
        f"{_FORCES[i]}_{_RATES[j] * power}": (int(i), int(j), -float(matrix[i, j]))
        for i, j in np.argwhere(matrix)
    }


def _unit(i: int, j: int, power: int) -> str:
    """Of an entry: N or N m over (m/s or rad/s) to the power."""
    seconds = "s" if power == 1 else "s^2"
    metres = int(i >= 3) - (power if j < 3 else 0)
    return f"N {seconds}" + {1: " m", 0: "", -1: "/m", -2: "/m^2"}[metres]


class CrossFlowDrag(ForceLaw):
    """Drag across a slender body, by strips along its axis.

    A strip of length dx takes −½ ρ C_d (h v e_y + b w e_z) √(v² + w²) dx, v and w its own velocities across
    the axis relative to the water: the sway and heave of the strip, yaw and pitch rates included. Where the
    breadth b is zero, as for a ship whose bottom resists otherwise, only sway counts: −½ ρ C_d h |v| v dx.
    One drag coefficient for the whole body: Hoerner, Fluid-Dynamic Drag (1965), chapter 3; Fossen, Handbook
    (2nd ed. 2021), chapter 6. |v| v has a continuous slope; the strips lie at Gauss's points, so that the
    integral is exact for velocities that keep their sign along the body.

    Parameters
    ----------
    environment
        Water and current.
    length
        m, along the first axis, `at` in the middle.
    height, breadth
        What the strips show to sway and to heave, m; a number, or values at equal distances from the stern to
        the bow. The breadth is the height when omitted: a round body.
    drag_coefficient
        C_d: 1.1 to 1.2 for a circular cylinder below 1e5 in the Reynolds number of its diameter, 0.3 to 0.7
        above.
    strips
        How many.

    Parameter of the law: `drag_coefficient`.
    """

    def __init__(
        self,
        environment: Environment,
        length: float,
        height: ArrayLike,
        breadth: ArrayLike | None = None,
        *,
        drag_coefficient: float = 1.1,
        strips: int = 16,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> None:
        env, place = checked_environment(environment), seat(at, axes)
        span = _check.number("length", length, positive=True)
        nodes, weights = np.polynomial.legendre.leggauss(_check.count("strips", strips))
        x, dx = 0.5 * span * nodes, 0.5 * span * weights
        tall = _profile("height", height, nodes)
        wide = tall if breadth is None else _profile("breadth", breadth, nodes)
        counts = [float(tall.any()), float(wide.any())]

        def cross_flow_drag(s: Any, p: Any) -> Any:
            flow = env.flow(s, p, place.at)
            twist = place.twist(flow)
            v, w = twist[1] + x * twist[5], twist[2] - x * twist[4]
            speed = np.sqrt(counts[0] * v * v + counts[1] * w * w + TINY)
            pressure = -0.5 * p.drag_coefficient * flow.air.density * speed * dx
            side, lift = pressure * tall * v, pressure * wide * w
            parts = [0.0, np.sum(side), np.sum(lift), 0.0, -np.sum(x * lift), np.sum(x * side)]
            return place.wrench(np.stack(parts))

        own = {"drag_coefficient": (at_least("drag_coefficient", drag_coefficient), "1")}
        super().__init__(
            cross_flow_drag, {**own, **env.parameters}, env.inputs, name=name, notices=env.notices
        )


def _profile(name: str, given: ArrayLike, nodes: Array) -> Array:
    """Values at Gauss's points of values at equal distances from -1 to 1."""
    values = _check.series(name, np.atleast_1d(np.asarray(given)))
    if values.min() < 0.0:
        raise InputError(f"{name}: got {values.min():g} m; it must not be negative")
    return (
        np.interp(nodes, np.linspace(-1.0, 1.0, len(values)), values)
        if len(values) > 1
        else (np.full(len(nodes), values[0]))
    )


class HullLiftDrag(ForceLaw):
    """Lift and drag of a hull of revolution as a whole, at a point of its own.

    With the angle α between the first axis and the velocity relative to the water: drag ½ ρ U² S C_D against
    the velocity, C_D = C_D0 + k C_L², and lift ½ ρ U² S C_L across it in the plane of the two, C_L = C_Lα sin
    α cos α, which is C_Lα α for small angles and none broadside. Beard and McLain, Small Unmanned Aircraft
    (2012), section 4.2, as Fossen takes it for underwater vehicles (Handbook, 2nd ed. 2021, chapter 8).

    Parameters
    ----------
    environment
        Water and current.
    area
        S, m².
    drag_coefficient
        C_D0, of S.
    lift_slope
        C_Lα, 1/rad, zero by default.
    induced_drag
        k, zero by default: 1/(π e A) for the aspect ratio A and Oswald's efficiency e.
    at, axes
        Where the force acts, from o1, (3,) m; the first of its axes is that of the hull.

    Parameters of the law: `area`, `drag_coefficient`, `lift_slope`, `induced_drag`.
    """

    def __init__(
        self,
        environment: Environment,
        area: float,
        drag_coefficient: float,
        *,
        lift_slope: float = 0.0,
        induced_drag: float = 0.0,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> None:
        env, place = checked_environment(environment), seat(at, axes)

        def hull_lift_drag(s: Any, p: Any) -> Any:
            flow = env.flow(s, p, place.at)
            u, v, w = (place.axes.T @ flow.velocity)[:3]
            across = v * v + w * w
            square = u * u + across + TINY
            speed = np.sqrt(square)
            # sin²α cos²α; the lift coefficient itself would need the size of the velocity across.
            product = u * u * across / (square * square)
            drag = p.drag_coefficient + p.induced_drag * p.lift_slope**2 * product
            pressure = 0.5 * p.area * flow.air.density
            along = -pressure * drag * speed
            normal = -pressure * p.lift_slope * u / speed
            force = [along * u - normal * across, (along + normal * u) * v, (along + normal * u) * w]
            return place.wrench(np.stack([*force, 0.0, 0.0, 0.0]))

        own = {
            "area": (_check.number("area", area, positive=True), "m^2"),
            "drag_coefficient": (at_least("drag_coefficient", drag_coefficient), "1"),
            "lift_slope": (at_least("lift_slope", lift_slope), "1"),
            "induced_drag": (at_least("induced_drag", induced_drag), "1"),
        }
        super().__init__(
            hull_lift_drag, {**own, **env.parameters}, env.inputs, name=name, notices=env.notices
        )
