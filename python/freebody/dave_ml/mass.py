"""Mass properties of a DAVE-ML model, by standard names of ANSI/AIAA S-119-2011."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.dave_ml.units import known_si, measures
from freebody.errors import InputError

if TYPE_CHECKING:
    from freebody.dave_ml.model import DaveModel

__all__ = ["MassProperties", "mass_properties"]

_MASS = "totalMass"
_CENTER = tuple(f"bodyPositionOfCmWrtMrc_{x}" for x in "XYZ")
_MOMENTS = tuple(f"bodyMomentOfInertia_{x}" for x in ("Roll", "Pitch", "Yaw"))
_PRODUCTS = tuple(f"bodyProductOfInertia_{x}" for x in ("XY", "YZ", "ZX"))
_UNITS = {
    _MASS: "kg",
    **dict.fromkeys(_CENTER, "m"),
    **dict.fromkeys((*_MOMENTS, *_PRODUCTS), "kg m^2"),
}


class MassProperties(NamedTuple):
    """Mass in kg, mass centre from the body origin (3,) in m, inertia about it (3, 3) in kg m²; body axes."""

    mass: Any
    com: Any
    inertia_about_com: Any


def mass_properties(
    model: DaveModel, values: Mapping[str, Any], reference_point: ArrayLike, body_from_model: ArrayLike | None
) -> MassProperties:
    """See `DaveModel.mass_properties`. Products of inertia are positive integrals, + ∫ x y dm."""
    point = _check.vector("reference_point", reference_point, 3)
    axes = np.eye(3) if body_from_model is None else _check.rotation("body_from_model", body_from_model)
    ids = {v.name: v.id for v in model.variables.values() if v.name in _UNITS}
    missing = [name for name in (_MASS, *_MOMENTS) if name not in ids]
    if missing:
        raise InputError(f"{model.file}: gives no {', '.join(missing)}; mass properties need them")
    for name, id in ids.items():
        measures(model.file, model.variables[id], _UNITS[name])
    found = model.evaluate(model.given(values), ids.values())

    def si(name: str) -> Any:
        if name not in ids:
            return 0.0
        return found[ids[name]] * known_si(model.file, model.variables[ids[name]]).factor

    xx, yy, zz = (si(name) for name in _MOMENTS)
    xy, yz, zx = (-si(name) for name in _PRODUCTS)
    inertia = np.stack([np.stack([xx, xy, zx]), np.stack([xy, yy, yz]), np.stack([zx, yz, zz])])
    com = np.stack([si(name) for name in _CENTER])
    return MassProperties(si(_MASS), point + axes @ com, axes @ inertia @ axes.T)
