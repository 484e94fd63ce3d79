"""Gravity by spherical harmonics."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.elements.coefficient_files import read_field
from freebody.errors import InputError
from freebody.forces import Force

__all__ = ["HarmonicGravity"]

ORIGIN = (0.0, 0.0, 0.0)


class HarmonicGravity(Force):
    """Attraction by a planet whose field is given in spherical harmonics, at the mass centre.

    The potential per mass is U = μ/r Σ (R/r)ⁿ P̄ₙₘ(sin φ) (C̄ₙₘ cos mλ + S̄ₙₘ sin mλ), with geocentric latitude
    φ and longitude λ in axes fixed in the planet, and fully normalised P̄, C̄ and S̄; what acts is m ∇U. There
    is no singularity at the poles (Montenbruck and Gill, Satellite Orbits, 1st ed., 2000, section 3.2.4).
    Inside the planet the series means nothing, and at its centre the force is not finite.

    `mu` and `center` can be dispersed. While a planet turns that has coefficients of an order above zero, the
    potential is that of the moment, and a run's energy is not conserved.

    Parameters
    ----------
    mu
        Gravitational parameter GM, m³/s².
    radius
        Reference radius R of the coefficients, m.
    C, S
        (N + 1, N + 1) fully normalised, `C[n, m]` of degree n and order m; zero for m > n. `C[0, 0]` is 1 for
        a planet of parameter mu; `C[2, 0]` is -J2/√5.
    center
        Position of the planet's centre, world axes, (3,) m.
    rotation_rate, angle
        The planet turns about the third world axis: the angle from the first world axis to its own is
        `angle + rotation_rate · t`; rad/s and rad.
    gradient_torque
        Whether the torque of the field's gradient over the body acts: of its whole gradient, of all degrees.
        For degree zero it is that of `PointMassGravity`.
    """

    def __init__(
        self,
        mu: float,
        radius: float,
        C: ArrayLike,
        S: ArrayLike,
        *,
        center: ArrayLike = ORIGIN,
        rotation_rate: float = 0.0,
        angle: float = 0.0,
        gradient_torque: bool = False,
        name: str | None = None,
    ) -> None:
        super().__init__(name)
        self.mu = _check.number("mu", mu, positive=True)
        self.radius = _check.number("radius", radius, positive=True)
        self.C = _coefficients("C", C)
        self.S = _coefficients("S", S)
        if self.C.shape != self.S.shape:
            raise InputError(f"S: got shape {self.S.shape}; allowed is that of C, {self.C.shape}")
        if self.S[:, 0].any():
            raise InputError("S: order 0 is not zero; there is no sine of it")
        self.center = _check.vector("center", center, 3)
        self.rotation_rate = _check.number("rotation_rate", rotation_rate)
        self.angle = _check.number("angle", angle)
        self.gradient_torque = _check.flag("gradient_torque", gradient_torque)

    @property
    def degree(self) -> int:
        """The highest degree."""
        return len(self.C) - 1

    @classmethod
    def from_file(
        cls,
        path: str | os.PathLike[str],
        degree: int | None = None,
        *,
        mu: float | None = None,
        radius: float | None = None,
        center: ArrayLike = ORIGIN,
        rotation_rate: float = 0.0,
        angle: float = 0.0,
        gradient_torque: bool = False,
        name: str | None = None,
    ) -> HarmonicGravity:
        """A field from a file: ICGEM's format, `.gfc`, or lines of n, m, C, S, `.csv`.

        Coefficients in a CSV file are fully normalised; a line `n,m,C,S` may stand first, and comments start
        with `#`. What a file does not name is zero, but C of degree 0, which is 1.

        Parameters
        ----------
        degree
            The highest degree to take, at most that of the file; all, when omitted.
        mu, radius
            As above; those of the file, when omitted. A CSV file has none.

        Raises
        ------
        InputError
            If the file cannot be read, is damaged or has coefficients that vary with time: with its line.
        """
        if degree is not None and degree != 0:
            degree = _check.count("degree", degree)
        field = read_field(Path(path), degree)
        said = {"mu": field.mu if mu is None else mu, "radius": field.radius if radius is None else radius}
        for key, value in said.items():
            if value is None:
                raise InputError(f"{key}: neither {path} nor the argument gives it; give {key}=")
        return cls(
            **said,  # pyright: ignore[reportArgumentType]  (none is refused above)
            C=field.C,
            S=field.S,
            center=center,
            rotation_rate=rotation_rate,
            angle=angle,
            gradient_torque=gradient_torque,
            name=name,
        )

    def core(self) -> _core.Force:
        rotation = (self.rotation_rate, self.angle)
        return _core.Force.harmonic_gravity(
            self.mu, self.center, self.radius, self.C, self.S, rotation, self.gradient_torque
        )


def _coefficients(name: str, value: ArrayLike) -> Array:
    """Check coefficients: square, zero where the order is above the degree."""
    size = np.shape(value)
    if len(size) != 2 or size[0] != size[1]:
        raise InputError(f"{name}: got shape {size}; allowed is (N + 1, N + 1), by degree and order")
    array = _check.vector(name, value, *size)
    above = np.argwhere(np.triu(array, 1))
    if len(above):
        n, m = above[0]
        raise InputError(f"{name}: got {array[n, m]} at degree {n}, order {m}; orders end at the degree")
    return array
