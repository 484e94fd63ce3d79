"""What of a force or a control law can be dispersed, and where the core keeps it."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple, TypeVar

import numpy as np

from freebody._check import Array
from freebody.elements.harmonics import HarmonicGravity
from freebody.forces import (
    ConstantWrench,
    Control,
    Force,
    InputWrench,
    LinearDamping,
    PointMassGravity,
    QuadraticDamping,
    TabulatedWrench,
    UniformGravity,
)
from freebody.tracing.law import Law

__all__ = ["LawParameter", "parameters", "shared_name", "with_parameters", "with_shared"]

L = TypeVar("L", Force, Control)
W = TypeVar("W", bound=Law)

XYZ = ("x", "y", "z")


class LawParameter(NamedTuple):
    """A parameter of a law: k numbers, from which the core keeps m.

    Attributes
    ----------
    attribute, components
        How the law calls it and, where it is no single number, its components.
    units, nominal
        k each.
    places
        Which of the law's numbers in the core they set, m.
    columns, weights
        Number i of the core is `weights[i]` times component `columns[i]`.
    positive
        Whether it must be.
    shared
        Whether other laws have the same.
    """

    attribute: str
    components: tuple[str, ...]
    units: tuple[str, ...]
    nominal: Array
    places: tuple[int, ...]
    columns: tuple[int, ...]
    weights: Array
    positive: bool = False
    shared: bool = False


def _numbers(
    attribute: str,
    components: tuple[str, ...],
    unit: str,
    nominal: object,
    first: int,
    positive: bool = False,
) -> LawParameter:
    """Numbers that the core keeps as they are."""
    values = np.atleast_1d(np.asarray(nominal, float)).ravel()
    k = len(values)
    places = tuple(range(first, first + k))
    return LawParameter(
        attribute, components, (unit,) * k, values, places, tuple(range(k)), np.ones(k), positive
    )


def parameters(law: Force | Control) -> Iterator[LawParameter]:
    """The parameters of a law; a callback has none."""
    if isinstance(law, Law):
        for i, (name, value) in enumerate(law.parameters.items()):
            own = _numbers(name, (), law.parameter_units[name], value, i)
            yield own._replace(shared=name in law.shared)
    elif isinstance(law, UniformGravity):
        nominal = np.array([law.acceleration])
        yield LawParameter("acceleration", (), ("m/s^2",), nominal, (0, 1, 2), (0, 0, 0), law.direction)
    elif isinstance(law, PointMassGravity | HarmonicGravity):
        yield _numbers("mu", (), "m^3/s^2", law.mu, 0, positive=True)
        yield _numbers("center", XYZ, "m", law.center, 1)
    elif isinstance(law, ConstantWrench):
        yield _numbers("force", XYZ, "N", law.force, 0)
        yield _numbers("moment", XYZ, "N m", law.moment, 3)
        yield _numbers("at", XYZ, "m", law.at, 6)
    elif isinstance(law, TabulatedWrench | InputWrench):
        yield _numbers("at", XYZ, "m", law.at, 0)
    elif isinstance(law, LinearDamping | QuadraticDamping):
        yield _coefficients(law)


def _coefficients(law: LinearDamping | QuadraticDamping) -> LawParameter:
    """Those of a damping: (6,), or (6, 6), which the core keeps by blocks of 3 x 3."""
    k = law.coefficients.size
    if k == 6:
        pairs = [(i, i) for i in range(6)]
        components, places = tuple(str(i + 1) for i in range(6)), tuple(range(6))
    else:
        pairs = [(i, j) for i in range(6) for j in range(6)]
        components = tuple(f"{i + 1}_{j + 1}" for i, j in pairs)
        places = tuple(9 * (2 * (i // 3) + j // 3) + 3 * (i % 3) + j % 3 for i, j in pairs)
    units = _LINEAR if isinstance(law, LinearDamping) else _QUADRATIC
    return LawParameter(
        "coefficients",
        components,
        tuple(units[i // 3][j // 3] for i, j in pairs),
        law.coefficients.ravel(),
        places,
        tuple(range(k)),
        np.ones(k),
    )


_LINEAR = (("N s/m", "N s"), ("N s", "N m s"))
_QUADRATIC = (("N s^2/m^2", "N s^2"), ("N s^2/m", "N m s^2"))


def shared_name(parameter: str) -> str:
    """How the quantity is called that sets a shared parameter in all laws that have it."""
    return f"environment.{parameter}"


def with_shared(law: W, values: Mapping[str, Array]) -> W:
    """The same law with the shared parameters that are among draws (1, 1) by the names of quantities."""
    own: dict[str, Any] = {
        name: float(values[q][0, 0]) for name in law.shared if (q := shared_name(name)) in values
    }
    return law(**own) if own else law


def with_parameters(law: L, values: dict[str, Array]) -> L:
    """The same law with other values (k,) of parameters."""
    if not values:
        return law
    if isinstance(law, Law):
        numbers: dict[str, Any] = {name: float(value[0]) for name, value in values.items()}
        return law(**numbers)
    new = copy.copy(law)
    for name, value in values.items():
        shape = np.shape(getattr(law, name))
        own = np.array(value).reshape(shape)
        own.flags.writeable = False
        setattr(new, name, own if shape else float(own))
    return new
