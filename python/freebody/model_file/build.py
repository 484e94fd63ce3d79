"""From a checked model file to the library's objects."""

from __future__ import annotations

from functools import reduce
from operator import add
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.attitude import Attitude
from freebody.body import RigidBody, positive_integral_inertia, principal_inertia
from freebody.environment import Environment
from freebody.model import Model
from freebody.simulation import Stage
from freebody.tracing import EventLaw

from .context import Context
from .dave_ml_schema import DaveBody
from .environment_schema import build as build_environment
from .event_schema import Crossing, build_event, build_events
from .fields import did_you_mean
from .inputs import build_inputs
from .planet_schema import start_on_planet
from .problems import Source
from .schema import Initial, ModelFile
from .stage_schema import StageTable
from .units import FieldError, to_si
from .vehicle_schema import Body, Inertia, Vehicle

__all__ = ["build_initial_state", "build_model", "build_stages"]

_SEPARATION = ("origin", "velocity_increment", "angular_velocity_increment")


def build_model(spec: ModelFile, source: Source) -> Model:
    """The model, of the first stage; refusals of body or force name the key they stand at."""
    own = None if spec.body is None else spec.body.name
    return _vehicle(spec, spec, (own or "first stage") if spec.stages else spec.model.name, "", source)


def build_stages(spec: ModelFile, first: Model, source: Source) -> tuple[Stage, ...]:
    """All stages, the first model's included; none where the file has no [[stages]]."""
    if not spec.stages:
        return ()
    models = [first]
    for i, table in enumerate(spec.stages):
        models.append(_vehicle(spec, table, table.name, f"stages[{i}].", source))
    events = build_events(spec.events, tuple(models), source)
    stages = []
    for i, model in enumerate(models):
        table = None if i == 0 else spec.stages[i - 1]
        key = "" if table is None else f"stages[{i - 1}]."
        inputs = build_inputs((table or spec).inputs, model, source, f"{key}inputs")
        own = {} if table is None else _separation(table, model, key, source)
        with source.blame(key.rstrip(".")):
            stages.append(
                Stage(model, _until(spec, i, model, source), inputs=inputs, events=events[i], **own)
            )
    return tuple(stages)


def _until(spec: ModelFile, i: int, model: Model, source: Source) -> EventLaw | float | None:
    """The end of a stage is where the next one begins."""
    if i == len(spec.stages):
        return None
    after = spec.stages[i]
    if isinstance(after.begins, Crossing):
        return build_event(after.begins, None, model, source, f"stages[{i}].begins")
    return after.begins


def _separation(table: StageTable, model: Model, key: str, source: Source) -> dict[str, Any]:
    values = {name: value for name, value in table.given().items() if name in _SEPARATION}
    if table.rotation is not None:
        with source.blame(f"{key}rotation"):
            values["rotation"] = table.rotation.attitude().as_rotation()
    states = {
        name: _state(name, value, model, source, f"{key}states") for name, value in table.states.items()
    }
    return values | {"states": states}


def _vehicle(spec: ModelFile, own: Vehicle, name: str, key: str, source: Source) -> Model:
    """The model of a stage; its keys begin with `key`."""
    if own.body is not None:
        body = _body(own.body, f"{key}body", source)
    else:
        parts = [_body(part, f"{key}parts[{i}]", source) for i, part in enumerate(own.parts or ())]
        body = reduce(add, parts)
    environment = build_environment(spec.environment, source)
    forces = []
    for i, section in enumerate(own.forces):
        place = f"{key}forces[{i}]"
        with source.blame(place):
            forces.append(section.element(Context(body, environment, source, place)))
    with source.blame(key.rstrip(".") or "model"):
        chart_and_form = {
            key: value for key, value in spec.simulation.given().items() if key in ("attitude", "form")
        }
        known = environment if "environment" in spec.model_fields_set else None
        return Model(body, forces, environment=known, name=name, **chart_and_form)


def build_initial_state(initial: Initial, model: Model, start: float, source: Source) -> NDArray[np.float64]:
    """The state at the time `start`, from the motion of the origin or of the mass centre."""
    with source.blame("initial.attitude"):
        attitude = Attitude.identity() if initial.attitude is None else initial.attitude.attitude()
    states = {
        name: _state(name, value, model, source, "initial.states") for name, value in initial.states.items()
    }
    with source.blame("initial"):
        com = np.asarray(model.body.com)
        if any(force.contents for force in model.forces):
            x = model.state(attitude=attitude, states=states)
            com = model.inertias(np.array([start]), x[None], np.zeros((1, model.n_inputs)))[0, 1:4]
        if initial.speaks_of_planet:
            planet = (model.environment or Environment()).planet
            point = com if initial.point == "com" else np.zeros(3)
            motion = start_on_planet(initial, planet, attitude, point, start)
            return model.state(**motion, states=states)
        motion = initial.given("point", "attitude", "states")
        if initial.point == "com":
            motion |= _motion_of_origin(initial, attitude.as_rotation(), com)
        return model.state(attitude=attitude, **motion, states=states)


def _state(name: str, value: Any, model: Model, source: Source, key: str) -> float:
    """An auxiliary state in its unit."""
    if name not in model.auxiliary:
        hint = did_you_mean(name, model.auxiliary) if model.auxiliary else "; no law of it has any"
        raise source.error(f"{key}.{name}", f"the model has no state {name!r}{hint}")
    unit = model.state_units[model.auxiliary[name]]
    try:
        return float(to_si(value, "" if unit == "1" else unit, ()))
    except FieldError as error:
        raise source.error(f"{key}.{name}", str(error)) from None


def _body(spec: Body | DaveBody, key: str, source: Source) -> RigidBody:
    if isinstance(spec, DaveBody):
        return spec.body(source, key)
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
