"""Added mass: the water that a body sets in motion."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.elements.seats import ORIGIN, at_least, seat
from freebody.environment import Environment, checked_environment
from freebody.errors import InputError
from freebody.tracing import ForceLaw, wrench

__all__ = ["AddedMass"]

# Symmetry of typed numbers.
_SYMMETRY = 1e-9
# Below this eccentricity the closed form of Lamb's integrals loses digits and their series needs few terms.
_ROUND = 0.3


class AddedMass(ForceLaw):
    """Added mass about a point of its own, in axes of its own, moving through water.

    The water around a body has the kinetic energy ½ V_rᵀ M_A V_r, where V_r = V − V_c is the twist of the
    body relative to the water. With Kirchhoff's equations in a frame that goes with the water the wrench on
    the body about o1 is −M_A V̇_r − Φ(V_r) M_A V_r, Φ of Konoplev (1.9), and so

        M_A V̇ stands on the left, −Φ(V_r) M_A V_r + M_A V̇_c on the right,   V̇_c = (−ω × v_c; 0)

    for a current v_c that is uniform and steady: in body axes it turns. The second term of the right is the
    Coriolis part, Munk's moment in it. Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2nd
    ed. 2021), chapters 6 (Kirchhoff's equations) and 10 (irrotational currents). On a planet that turns the
    water turns with it; its frame is taken as inertial for this force.

    The matrix is shifted to o1 once, when the element is made: `added_mass` is what the equations take.

    Parameters
    ----------
    environment
        Its wind is the current.
    matrix
        M_A (6, 6): kg, kg m, kg m²; linear part first; symmetric, no eigenvalue negative. Hydrodynamic
        derivatives are its negatives, M_A[0, 0] = −X_u̇. A diagonal (6,) will do.
    at
        The point that it is about, from o1, body axes, (3,) m.
    axes
        Its axes as columns, in body axes, (3, 3); the body axes when omitted.
    """

    def __init__(
        self,
        environment: Environment,
        matrix: ArrayLike,
        *,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> None:
        env, place = checked_environment(environment), seat(at, axes)
        shifted = place.transform.T @ _checked(matrix) @ place.transform
        shifted = 0.5 * (shifted + shifted.T)

        def added_mass(s: Any, p: Any) -> Any:
            v, w = s.velocity_body, s.angular_velocity_body
            point = s.position_world + s.world_from_body @ place.at
            body_from_world = s.world_from_body.T
            turning = body_from_world @ env.planet.angular_velocity_world
            here, through_water = v + np.cross(w, place.at), env.flow(s, p, place.at).velocity
            # Of the water that the body meets, and of the planet's turning; body axes.
            current = here - through_water
            drift = current - body_from_world @ env.planet.ground_velocity(point)
            rate = np.cross(turning, here + drift) - np.cross(w, current)
            turning_rate = np.cross(turning, w)
            relative = w - turning
            twist = np.concatenate([through_water - np.cross(relative, place.at), relative])
            # The water that meets o1 has a rate of its own where the planet turns.
            twist_rate = np.concatenate([rate - np.cross(turning_rate, place.at), turning_rate])
            momentum, carried = shifted @ twist, shifted @ twist_rate
            force = carried[:3] - np.cross(relative, momentum[:3])
            moment = carried[3:] - np.cross(relative, momentum[3:]) - np.cross(twist[:3], momentum[:3])
            return wrench(force, moment)

        super().__init__(
            added_mass, env.parameters, env.inputs, name=name, added_mass=shifted, notices=env.notices
        )

    @classmethod
    def from_derivatives(
        cls,
        environment: Environment,
        *,
        X_udot: float = 0.0,
        Y_vdot: float = 0.0,
        Z_wdot: float = 0.0,
        K_pdot: float = 0.0,
        M_qdot: float = 0.0,
        N_rdot: float = 0.0,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> AddedMass:
        """Of the hydrodynamic derivatives on its diagonal, kg and kg m², none positive: M_A = −diag."""
        given = {"X_udot": X_udot, "Y_vdot": Y_vdot, "Z_wdot": Z_wdot}
        given |= {"K_pdot": K_pdot, "M_qdot": M_qdot, "N_rdot": N_rdot}
        for key, value in given.items():
            if _check.number(key, value) > 0.0:
                raise InputError(f"{key}: got {value:g}; a derivative of added mass is not positive")
        return cls(environment, [-value for value in given.values()], at=at, axes=axes, name=name)

    @classmethod
    def spheroid(
        cls,
        environment: Environment,
        semi_major: float,
        semi_minor: float,
        *,
        roll: float = 0.0,
        density: float | None = None,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> AddedMass:
        """Of a prolate spheroid about its centre; its first axis is the long one.

        M_A = diag(k₁ m, k₂ m, k₂ m, roll, k′ I, k′ I), m and I = m (a² + b²)/5 the mass and the transverse
        moment of the displaced water. Lamb, Hydrodynamics (6th ed. 1932), articles 114 and 115; Imlay, DTMB
        report 1528 (1961); Fossen (2021), section 8.4.2.

        Parameters
        ----------
        semi_major, semi_minor
            a and b, m, a not below b.
        roll
            The added moment about the long axis, kg m²: none for a smooth spheroid, some for its fins.
        density
            Of the water, kg/m³; that of the environment at altitude 0 when omitted.
        """
        a = _check.number("semi_major", semi_major, positive=True)
        b = _check.number("semi_minor", semi_minor, positive=True)
        if b > a:
            raise InputError(
                f"semi_major, semi_minor: got {a:g} and {b:g} m; the spheroid is prolate, the first is not "
                "the smaller"
            )
        mass = 4.0 / 3.0 * math.pi * _density(environment, density) * a * b**2
        inertia = mass * (a**2 + b**2) / 5.0
        k1, k2, k3 = lamb_factors(b / a)
        diagonal = [k1 * mass, k2 * mass, k2 * mass, at_least("roll", roll), k3 * inertia, k3 * inertia]
        return cls(environment, diagonal, at=at, axes=axes, name=name)

    @classmethod
    def cylinder(
        cls,
        environment: Environment,
        length: float,
        radius: float,
        *,
        axial: float = 0.0,
        roll: float = 0.0,
        density: float | None = None,
        at: ArrayLike = ORIGIN,
        axes: ArrayLike | None = None,
        name: str | None = None,
    ) -> AddedMass:
        """Of a slender circular cylinder about its middle, by strips; its first axis is the long one.

        Each strip carries the water it displaces, ρ π r² a metre, across (Newman, Marine Hydrodynamics, 1977,
        table 4.3); along the axis `axial`, kg, and about it `roll`, kg m², are for the user to say. The flow
        around the ends is left out: for slender cylinders.
        """
        span = _check.number("length", length, positive=True)
        r = _check.number("radius", radius, positive=True)
        across = _density(environment, density) * math.pi * r**2 * span
        turning = across * span**2 / 12.0
        diagonal = [at_least("axial", axial), across, across, at_least("roll", roll), turning, turning]
        return cls(environment, diagonal, at=at, axes=axes, name=name)


def lamb_factors(ratio: float) -> tuple[float, float, float]:
    """k₁, k₂ and k′ of a prolate spheroid whose semi-axes have the ratio b/a, 0 < b/a <= 1."""
    square = (1.0 - ratio) * (1.0 + ratio)
    e = math.sqrt(square)
    if e < _ROUND:
        alpha = 2.0 * ratio**2 * sum(square**k / (2 * k + 3) for k in range(20))
    else:
        alpha = 2.0 * ratio**2 / e**3 * (math.atanh(e) - e)
    beta = 1.0 - 0.5 * alpha
    if e == 0.0:
        return 0.5, 0.5, 0.0
    spread, sum_of_squares = beta - alpha, 2.0 - square
    turning = square**2 * spread / (sum_of_squares * (2.0 * square - sum_of_squares * spread))
    return alpha / (2.0 - alpha), beta / (2.0 - beta), turning


def _density(environment: Environment, density: float | None) -> float:
    given = checked_environment(environment).atmosphere.at(0.0).density if density is None else density
    return _check.number("density", given, positive=True)


def _checked(matrix: ArrayLike) -> Array:
    given = _check.diagonal_or_full("matrix", matrix, 6)
    full = np.diag(given) if given.ndim == 1 else given
    largest = float(np.abs(full).max())
    gap = np.abs(full - full.T)
    if gap.max() > _SYMMETRY * largest:
        i, j = sorted(int(k) for k in np.unravel_index(gap.argmax(), gap.shape))
        raise InputError(
            f"matrix: not symmetric: [{i}, {j}] is {full[i, j]:g} and [{j}, {i}] is {full[j, i]:g}"
        )
    smallest = float(np.linalg.eigvalsh(0.5 * (full + full.T))[0])
    if smallest < -_SYMMETRY * largest:
        raise InputError(
            f"matrix: its smallest eigenvalue is {smallest:.6g}; the energy of the water is not negative. "
            "Hydrodynamic derivatives are the negatives of the entries"
        )
    return full
