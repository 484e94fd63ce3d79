"""Six-degree-of-freedom dynamics of free rigid bodies in matrix form, about any body-fixed frame."""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING

from freebody import forms
from freebody._core import __version__
from freebody.attitude import Attitude
from freebody.body import RigidBody, positive_integral_inertia, principal_inertia
from freebody.compilation import compile
from freebody.equations import Equations, SymbolicBody, equations
from freebody.errors import (
    BodyError,
    FreebodyError,
    InputError,
    ModelFileError,
    NonFiniteError,
    SingularChartError,
    TraceError,
)
from freebody.forces import (
    ConstantWrench,
    Control,
    Force,
    InputWrench,
    LinearDamping,
    PointMassGravity,
    QuadraticDamping,
    Quantity,
    StateQuantity,
    TabulatedWrench,
    UniformGravity,
)
from freebody.linearization import Linearization
from freebody.model import Model
from freebody.simulation import ChartChange, Conserved, InputTable, Outcome, Trajectory
from freebody.tables import Table
from freebody.tracing import ControlLaw, ForceLaw, callback, control, force, wrench

if TYPE_CHECKING:
    from freebody.model_file import LoadedModel

__all__ = [
    "Attitude",
    "BodyError",
    "ChartChange",
    "Conserved",
    "ConstantWrench",
    "Control",
    "ControlLaw",
    "Equations",
    "Force",
    "ForceLaw",
    "FreebodyError",
    "InputError",
    "InputTable",
    "InputWrench",
    "LinearDamping",
    "Linearization",
    "Model",
    "ModelFileError",
    "NonFiniteError",
    "Outcome",
    "PointMassGravity",
    "QuadraticDamping",
    "Quantity",
    "RigidBody",
    "SingularChartError",
    "StateQuantity",
    "SymbolicBody",
    "Table",
    "TabulatedWrench",
    "TraceError",
    "Trajectory",
    "UniformGravity",
    "__version__",
    "callback",
    "compile",
    "control",
    "equations",
    "force",
    "forms",
    "load",
    "positive_integral_inertia",
    "principal_inertia",
    "wrench",
]


def load(path: str | PathLike[str]) -> LoadedModel:
    """A model file, checked and built: what to simulate, from where, how long (extra `cli`).

    Raises `ModelFileError`, which names file, line and key, what came and what is allowed.
    """
    from freebody.model_file import load_model  # noqa: PLC0415  (an extra: only who asks needs it)

    return load_model(path)
