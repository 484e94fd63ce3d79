"""Rigid bodies: mass, mass centre and inertia about any body-fixed frame."""

from __future__ import annotations

from typing import NoReturn

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import BodyError, InputError

__all__ = ["RigidBody", "positive_integral_inertia", "principal_inertia"]


class RigidBody(_core.RigidBody):
    """Mass properties about a body frame whose origin o1 and axes may be anywhere.

    Parameters
    ----------
    mass
        Mass, kg.
    com
        Mass centre from o1, body axes, (3,) m.
    inertia_about_com, inertia_about_origin
        Inertia tensor about the mass centre or about o1, body axes, (3, 3) kg m²; exactly one of the two.
        `principal_inertia` and `positive_integral_inertia` make one from other descriptions.
    name
        How messages call the body.

    Raises
    ------
    BodyError
        No rigid body has these numbers; the message names body, rule, numbers and the nearest fix.

    Notes
    -----
    `spatial_inertia` is the Mises inertia matrix Θ (Konoplev (1.6)), (6, 6), linear part first, and
    `inverse_spatial_inertia` its inverse. A rule may be missed by 1e-9 of the largest entry of the tensor, so
    a rod or a disc at the edge of the triangle inequality passes.
    """

    def __new__(
        cls,
        mass: float,
        com: ArrayLike = (0.0, 0.0, 0.0),
        *,
        inertia_about_com: ArrayLike | None = None,
        inertia_about_origin: ArrayLike | None = None,
        name: str = "body",
    ) -> RigidBody:
        name = _check.label("name", name)
        if (inertia_about_com is None) == (inertia_about_origin is None):
            came = "neither" if inertia_about_com is None else "both"
            raise BodyError(
                f"body '{name}': give exactly one of inertia_about_com and inertia_about_origin, got {came}"
            )
        about = "com" if inertia_about_com is not None else "origin"
        try:
            # Whether the numbers are finite and make a body is for the core to say.
            tensor = _check.numbers(*_given(inertia_about_com, inertia_about_origin), 3, 3)
            weight, center = _check.numbers("mass", mass), _check.numbers("com", com, 3)
            return super().__new__(cls, name, float(weight), center, tensor, about)
        except BodyError:
            raise
        except InputError as fault:
            raise BodyError(f"body '{name}': {fault}") from None

    def in_frame(self, origin: ArrayLike = (0.0, 0.0, 0.0), rotation: ArrayLike | None = None) -> RigidBody:
        """The same body described in another body frame.

        Parameters
        ----------
        origin
            Origin of the new frame in the axes of the old one, (3,) m.
        rotation
            Old axes from new axes, (3, 3); the unit matrix when omitted.
        """
        turn = np.eye(3) if rotation is None else _check.rotation("rotation", rotation)
        com, tensor = self.moved(_check.vector("origin", origin, 3), turn)
        return _restore(self.name, self.mass, com, tensor)

    def __add__(self, other: RigidBody) -> RigidBody:
        """Two bodies of one frame, rigidly joined."""
        if not isinstance(other, RigidBody):
            raise InputError(f"body + other: other is {_check.shown(other)}; give a freebody.RigidBody")
        mass, com, tensor = self.joined(other)
        return _restore(f"{self.name} + {other.name}", mass, com, tensor)

    def __radd__(self, other: object) -> NoReturn:
        raise InputError(
            f"other + body: other is {_check.shown(other)}; give a freebody.RigidBody, and sum() one to "
            "start from"
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RigidBody) and self._description() == other._description()

    def __hash__(self) -> int:
        return hash(self._description())

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, self._description()

    def __repr__(self) -> str:
        return f"RigidBody({self.mass:g} kg, com={self.com.tolist()} m, name={self.name!r})"

    def _description(self) -> tuple[str, float, tuple[float, ...], tuple[tuple[float, ...], ...]]:
        tensor = tuple(tuple(row) for row in self.inertia_about_com.tolist())
        return self.name, self.mass, tuple(self.com.tolist()), tensor


def _restore(name: str, mass: float, com: ArrayLike, tensor: ArrayLike) -> RigidBody:
    """A body of numbers that were a body before: rounding since then is no reason to refuse them."""
    return _core.RigidBody.__new__(RigidBody, name, mass, com, tensor, "kept")


def _given(about_com: ArrayLike | None, about_origin: ArrayLike | None) -> tuple[str, ArrayLike]:
    if about_com is not None:
        return "inertia_about_com", about_com
    assert about_origin is not None
    return "inertia_about_origin", about_origin


def principal_inertia(moments: ArrayLike, axes: ArrayLike | None = None) -> Array:
    """The inertia tensor of principal moments.

    Parameters
    ----------
    moments
        Principal moments, (3,) kg m².
    axes
        Rotation matrix whose columns are the principal axes in body axes, (3, 3); the body axes when omitted.
    """
    diagonal = np.diag(_check.vector("moments", moments, 3))
    if axes is None:
        return diagonal
    turn = _check.rotation("axes", axes)
    return turn @ diagonal @ turn.T


def positive_integral_inertia(
    Ixx: float, Iyy: float, Izz: float, Pxy: float = 0.0, Pxz: float = 0.0, Pyz: float = 0.0
) -> Array:
    """The inertia tensor of moments and products in the positive-integral convention, kg m².

    The products are `Pxy = +∫xy dm` and so on, as many CAD programs print them; the tensor holds them with
    the minus sign, `J[0, 1] = -Pxy`.
    """
    given = {"Ixx": Ixx, "Iyy": Iyy, "Izz": Izz, "Pxy": Pxy, "Pxz": Pxz, "Pyz": Pyz}
    a, b, c, f, g, h = (_check.number(name, value) for name, value in given.items())
    return np.array([[a, -f, -g], [-f, b, -h], [-g, -h, c]])
