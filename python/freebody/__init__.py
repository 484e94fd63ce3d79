"""Six-degree-of-freedom dynamics of free rigid bodies in matrix form, about any body-fixed frame."""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING

from freebody import forms
from freebody._core import __version__
from freebody.attitude import Attitude
from freebody.body import RigidBody, positive_integral_inertia, principal_inertia
from freebody.compilation import compile
from freebody.ensembles import (
    Discrete,
    Ensemble,
    Factor,
    FromFile,
    LogNormal,
    MultivariateNormal,
    Normal,
    Offset,
    Runs,
    Samples,
    TruncatedNormal,
    Uniform,
)
from freebody.equations import Equations, SymbolicBody, equations
from freebody.errors import (
    BodyError,
    FreebodyError,
    InputError,
    ModelFileError,
    NonFiniteError,
    SingularChartError,
    StoreError,
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
from freebody.simulation import ChartChange, Conserved, InputTable, Occurrence, Outcome, Trajectory
from freebody.tables import Table
from freebody.tracing import (
    ControlLaw,
    EventLaw,
    ForceLaw,
    OutputLaw,
    callback,
    control,
    event,
    force,
    output,
    wrench,
)

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
    "Discrete",
    "Ensemble",
    "Equations",
    "EventLaw",
    "Factor",
    "Force",
    "ForceLaw",
    "FreebodyError",
    "FromFile",
    "InputError",
    "InputTable",
    "InputWrench",
    "LinearDamping",
    "Linearization",
    "LogNormal",
    "Model",
    "ModelFileError",
    "MultivariateNormal",
    "NonFiniteError",
    "Normal",
    "Occurrence",
    "Offset",
    "Outcome",
    "OutputLaw",
    "PointMassGravity",
    "QuadraticDamping",
    "Quantity",
    "RigidBody",
    "Runs",
    "Samples",
    "SingularChartError",
    "StateQuantity",
    "StoreError",
    "SymbolicBody",
    "Table",
    "TabulatedWrench",
    "TraceError",
    "Trajectory",
    "TruncatedNormal",
    "Uniform",
    "UniformGravity",
    "__version__",
    "callback",
    "compile",
    "control",
    "equations",
    "event",
    "force",
    "forms",
    "load",
    "output",
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
