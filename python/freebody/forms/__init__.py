"""Every numbered matrix and form of the paper on NumPy arrays; leading batch dimensions broadcast.

All arguments are real and finite, in SI units and radians; all results are float64. A wrong argument raises
`freebody.InputError` with its name, angles at the singularity of their chart `freebody.SingularChartError`.
"""

from freebody._check import SEQUENCES
from freebody.forms.bodies import (
    QuasiVelocity,
    gravity_wrench,
    inertia_regressor,
    inertial_parameters,
    inverse_dynamics,
    kinetic_energy,
    momentum,
    momentum_world,
    quasi_acceleration,
    quasi_velocity,
    spatial_inertia,
)
from freebody.forms.charts import (
    angles_from_rotation,
    angular_velocity_skew_world,
    quaternion_from_rotation,
    quaternion_rate,
    rate_matrix_body,
    rate_matrix_body_inverse,
    rate_matrix_world,
    rate_matrix_world_dot,
    rate_matrix_world_inverse,
    rotation,
    rotation_from_quaternion,
    singularity_distance,
    velocity_map,
    velocity_map_inverse,
)
from freebody.forms.generalized import (
    Generalized,
    generalized,
    generalized_acceleration,
    generalized_force,
    phase_velocity,
    rotation_acceleration,
)
from freebody.forms.lagrange import Lagrange, christoffel_symbols, lagrange, lagrange_operator
from freebody.forms.screws import (
    force_cross,
    line_matrix,
    skew,
    wrench_transform,
    wrench_transform_inverse,
)

__all__ = [
    "SEQUENCES",
    "Generalized",
    "Lagrange",
    "QuasiVelocity",
    "angles_from_rotation",
    "angular_velocity_skew_world",
    "christoffel_symbols",
    "force_cross",
    "generalized",
    "generalized_acceleration",
    "generalized_force",
    "gravity_wrench",
    "inertia_regressor",
    "inertial_parameters",
    "inverse_dynamics",
    "kinetic_energy",
    "lagrange",
    "lagrange_operator",
    "line_matrix",
    "momentum",
    "momentum_world",
    "phase_velocity",
    "quasi_acceleration",
    "quasi_velocity",
    "quaternion_from_rotation",
    "quaternion_rate",
    "rate_matrix_body",
    "rate_matrix_body_inverse",
    "rate_matrix_world",
    "rate_matrix_world_dot",
    "rate_matrix_world_inverse",
    "rotation",
    "rotation_acceleration",
    "rotation_from_quaternion",
    "singularity_distance",
    "skew",
    "spatial_inertia",
    "velocity_map",
    "velocity_map_inverse",
    "wrench_transform",
    "wrench_transform_inverse",
]
