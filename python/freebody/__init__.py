"""Six-degree-of-freedom dynamics of free rigid bodies in matrix form, about any body-fixed frame."""

from freebody import forms
from freebody._core import __version__
from freebody.attitude import Attitude
from freebody.body import RigidBody, positive_integral_inertia, principal_inertia
from freebody.errors import (
    BodyError,
    FreebodyError,
    InputError,
    ModelFileError,
    NonFiniteError,
    SingularChartError,
)
from freebody.forces import (
    ConstantWrench,
    Force,
    InputWrench,
    LinearDamping,
    PointMassGravity,
    QuadraticDamping,
    TabulatedWrench,
    UniformGravity,
)
from freebody.linearization import Linearization
from freebody.model import Model
from freebody.simulation import ChartChange, Conserved, InputTable, Outcome, Trajectory

__all__ = [
    "Attitude",
    "BodyError",
    "ChartChange",
    "Conserved",
    "ConstantWrench",
    "Force",
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
    "RigidBody",
    "SingularChartError",
    "TabulatedWrench",
    "Trajectory",
    "UniformGravity",
    "__version__",
    "forms",
    "positive_integral_inertia",
    "principal_inertia",
]
