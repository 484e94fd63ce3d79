"""Six-degree-of-freedom dynamics of free rigid bodies in matrix form, about any body-fixed frame."""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING

from freebody import dave_ml, elements, environment, forms, vehicles
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
    TrimError,
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
    Spin,
    StateQuantity,
    TabulatedWrench,
    UniformGravity,
)
from freebody.linearization import Linearization
from freebody.model import Model
from freebody.simulation import (
    ChartChange,
    Conserved,
    InputTable,
    Notice,
    Occurrence,
    Outcome,
    Separation,
    Stage,
    StagedTrajectory,
    Trajectory,
    simulate_stages,
)
from freebody.tables import Table
from freebody.tracing import (
    ContentsLaw,
    ControlLaw,
    EventLaw,
    ForceLaw,
    NoticeLaw,
    OutputLaw,
    callback,
    contents,
    control,
    event,
    force,
    mass_properties,
    notice,
    output,
    wrench,
)
from freebody.trimming import Trim, trim

if TYPE_CHECKING:
    from freebody.model_file import LoadedModel

__all__ = [
    "Attitude",
    "BodyError",
    "ChartChange",
    "Conserved",
    "ConstantWrench",
    "ContentsLaw",
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
    "Notice",
    "NoticeLaw",
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
    "Separation",
    "SingularChartError",
    "Spin",
    "Stage",
    "StagedTrajectory",
    "StateQuantity",
    "StoreError",
    "SymbolicBody",
    "Table",
    "TabulatedWrench",
    "TraceError",
    "Trajectory",
    "Trim",
    "TrimError",
    "TruncatedNormal",
    "Uniform",
    "UniformGravity",
    "__version__",
    "callback",
    "compile",
    "contents",
    "control",
    "dave_ml",
    "elements",
    "environment",
    "equations",
    "event",
    "force",
    "forms",
    "load",
    "mass_properties",
    "notice",
    "output",
    "positive_integral_inertia",
    "principal_inertia",
    "simulate_stages",
    "trim",
    "vehicles",
    "wrench",
]


def load(path: str | PathLike[str]) -> LoadedModel:
    """A model file, checked and built: what to simulate, from where, how long (extra `cli`).

    Raises `ModelFileError`, which names file, line and key, what came and what is allowed.
    """
    from freebody.model_file import load_model  # noqa: PLC0415  (an extra: only who asks needs it)

    return load_model(path)
