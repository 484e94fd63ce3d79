"""From a checked model file to the library's objects."""

from __future__ import annotations

from functools import reduce
from operator import add
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody import forces as force_elements
from freebody.attitude import Attitude
from freebody.body import RigidBody, positive_integral_inertia, principal_inertia
from freebody.model import Model

from .csv_table import read_table
from .force_schema import AnyForce, TabulatedWrench
from .problems import Source
from .schema import Body, Inertia, Initial, ModelFile

__all__ = ["build_initial_state", "build_model"]

FORCES = {
    "uniform_gravity": force_elements.UniformGravity,
    "point_mass_gravity": force_elements.PointMassGravity,
    "constant_wrench": force_elements.ConstantWrench,
    "tabulated_wrench": force_elements.TabulatedWrench,
    "linear_damping": force_elements.LinearDamping,
    "quadratic_damping": force_elements.QuadraticDamping,
    "input_wrench": force_elements.InputWrench,
}


def build_model(spec: ModelFile, source: Source) -> Model:
    """The model; refusals of body or force name the key they stand at."""
    if spec.body is not None:
        body = _body(spec.body, "body", source)
    else:
        parts = [_body(part, f"parts[{i}]", source) for i, part in enumerate(spec.parts or ())]
        body = reduce(add, parts)
    forces = [_force(force, f"forces[{i}]", source) for i, force in enumerate(spec.forces)]
    with source.blame("model"):
        chart_and_form = {
            key: value for key, value in spec.simulation.given().items() if key in ("attitude", "form")
        }
        return Model(body, forces, name=spec.model.name, **chart_and_form)


def build_initial_state(initial: Initial, model: Model, source: Source) -> NDArray[np.float64]:
    """The state at the start, from the motion of the origin or of the mass centre."""
    with source.blame("initial.attitude"):
        attitude = _attitude(initial)
    with source.blame("initial"):
        motion = initial.given("point", "attitude")
        if initial.point == "com":
            motion |= _motion_of_origin(initial, attitude.as_rotation(), np.asarray(model.body.com))
        return model.state(attitude=attitude, **motion)


def _body(spec: Body, key: str, source: Source) -> RigidBody:
    values = spec.given()
    for about in ("inertia_about_com", "inertia_about_origin"):
        if about in values:
            with source.blame(f"{key}.{about}"):
                values[about] = _inertia(values[about])
    with source.blame(key):
        return RigidBody(**values)


def _inertia(spec: Inertia) -> NDArray[np.float64]:
    if spec.tensor is not None:
        return spec.tensor
    if spec.principal is not None:
        return principal_inertia(spec.principal, spec.axes)
    return positive_integral_inertia(**spec.given())


def _force(spec: AnyForce, key: str, source: Source) -> Any:
    values = spec.given("type", "csv")
    with source.blame(key):
        if isinstance(spec, TabulatedWrench) and spec.csv is not None:
            values |= read_table(spec.csv, f"{key}.csv", source)
        return FORCES[spec.type](**values)


def _attitude(initial: Initial) -> Attitude:
    table = initial.attitude
    if table is None:
        return Attitude.identity()
    if table.quaternion is not None:
        return Attitude.quaternion(table.quaternion)
    if table.rotation is not None:
        return Attitude.rotation(table.rotation)
    assert table.angles is not None
    assert table.sequence is not None
    return Attitude.angles(table.sequence, table.angles)


def _motion_of_origin(
    initial: Initial, world_from_body: NDArray[np.float64], com: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """o1 = r - C r_c, and its velocity v - ω x r_c, from those of the mass centre."""
    omega = np.zeros(3)
    if initial.angular_velocity_body is not None:
        omega = initial.angular_velocity_body
    elif initial.angular_velocity_world is not None:
        omega = world_from_body.T @ initial.angular_velocity_world
    lever = np.cross(omega, com)
    position = np.zeros(3) if initial.position is None else initial.position
    motion = {"position": position - world_from_body @ com}
    if initial.velocity_body is not None:
        motion["velocity_body"] = initial.velocity_body - lever
    else:
        velocity = np.zeros(3) if initial.velocity_world is None else initial.velocity_world
        motion["velocity_world"] = velocity - world_from_body @ lever
    return motion
