"""Aerodynamics of a DAVE-ML model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.dave_ml.model import DaveModel
from freebody.dave_ml.standard import AirData, air_data
from freebody.dave_ml.units import si
from freebody.dave_ml.wiring import Mapped, Range, Wiring, wire
from freebody.environment import Environment, checked_environment
from freebody.errors import InputError
from freebody.tracing import ForceLaw, NoticeLaw, notice
from freebody.tracing.wrench import wrench

__all__ = ["DaveAerodynamics"]

_REFERENCES = {"reference_area": "m^2", "reference_span": "m", "reference_chord": "m"}
_FORCE = tuple(f"aeroBodyForceCoefficient_{x}" for x in "XYZ")
_MOMENT = tuple(f"aeroBodyMomentCoefficient_{x}" for x in ("Roll", "Pitch", "Yaw"))
_LIFT, _DRAG = "totalCoefficientOfLift", "totalCoefficientOfDrag"
_WRENCHES = tuple(
    (tuple(f"{kind}Force_{x}" for x in "XYZ"), tuple(f"{kind}Moment_{x}" for x in ("Roll", "Pitch", "Yaw")))
    for kind in ("aeroBody", "thrustBody")
)


class DaveAerodynamics(ForceLaw):
    """The force and moment of a DAVE-ML model, about the model's own moment reference point.

    The model is fed with what it asks for under standard names, in its units, from the flow at the reference
    point; inputs with other names (controls) become inputs of the law, in SI, `elevatorDeflection` in rad.
    Of what it gives are used: coefficients of body forces, or of lift and drag, and of moments; forces and
    moments of air and thrust themselves. See docs/dave-ml.md for the names.

    Parameters
    ----------
    environment
        The medium.
    model
        From `load_dave_ml`.
    mapping
        By name or varID, what a variable is that the file calls otherwise: for an input a standard name, a
        number to hold it at (units of the file), or the name of an input of the law; for a result a
        standard name, or None to leave it out.
    reference_point
        The model's moment reference point from the body origin, body axes, (3,) m; parameters of the law.
    flow_point
        The point of the body whose motion through the medium makes airspeed and angles, (3,) m; the
        reference point when omitted.
    body_from_aero
        Rotation matrix (3, 3): the columns are the model's forward, right and down axes in body axes.
    lift_drag_axes
        "wind": drag is opposite to the velocity; "stability": to its part in the plane of symmetry. Lift is
        at a right angle to both in that plane.
    reference_area, reference_span, reference_chord
        m², m, m: where the file has none, or others. Parameters of the law.
    constants
        Constants of the file, by name or varID, that become parameters of the law, named by varID, in SI.

    Attributes
    ----------
    wiring
        What feeds the model, by varID.
    notices
        Say where a run leaves the range of the file's tables, which hold their border values there.
    """

    def __init__(
        self,
        environment: Environment,
        model: DaveModel,
        mapping: Mapping[str, Mapped] | None = None,
        reference_point: ArrayLike = (0.0, 0.0, 0.0),
        *,
        flow_point: ArrayLike | None = None,
        body_from_aero: ArrayLike | None = None,
        lift_drag_axes: str = "wind",
        reference_area: float | None = None,
        reference_span: float | None = None,
        reference_chord: float | None = None,
        constants: Iterable[str] = (),
        name: str = "dave_aerodynamics",
    ) -> None:
        checked_environment(environment)
        if not isinstance(model, DaveModel):
            raise InputError(f"model: got {_check.shown(model)}; give what load_dave_ml returns")
        axes = np.eye(3) if body_from_aero is None else _check.rotation("body_from_aero", body_from_aero)
        drag_axes = _check.choice("lift_drag_axes", lift_drag_axes, ("wind", "stability"))
        point = _check.vector("reference_point", reference_point, 3)
        met = None if flow_point is None else _check.vector("flow_point", flow_point, 3)
        adjusted = tuple(_constant(model, constant) for constant in constants)
        connected = wire(model, mapping, adjusted)
        _check_results(connected)
        references = _references(connected, (reference_area, reference_span, reference_chord))
        factors = {
            id: (known.factor, known.unit) for id in adjusted if (known := si(model.variables[id].units))
        }
        own = {f"reference_{x}": (float(r), "m") for x, r in zip("xyz", point, strict=True)}
        own |= {key: (value, _REFERENCES[key]) for key, value in references.items()}
        own |= {id: (_initial(model, id) * factor, unit) for id, (factor, unit) in factors.items()}

        def dave_aerodynamics(s: Any, p: Any) -> Any:
            at = np.stack([p.reference_x, p.reference_y, p.reference_z])
            air = air_data(environment.flow(s, p, at=at if met is None else met), axes)
            given = connected.given(air, s.inputs) | {
                id: getattr(p, id) / factor for id, (factor, _) in factors.items()
            }
            results = connected.evaluate(given)
            force, moment = _coefficients(results, air, p, drag_axes) if references else (np.zeros(3),) * 2
            for forces, moments in _WRENCHES:
                force = force + _three(results, forces)
                moment = moment + _three(results, moments)
            return wrench(axes @ force, axes @ moment, at=at)

        super().__init__(
            dave_aerodynamics,
            parameters={**own, **environment.parameters},
            inputs={**connected.law_inputs, **environment.inputs},
            name=name,
        )
        self.notices = environment.notices + tuple(
            _notice(environment, connected, axes, point if met is None else met, limits, name)
            for limits in connected.ranges()
        )
        self.wiring: Mapping[str, object] = {
            **connected.held,
            **connected.flow,
            **{id: word for id, (word, _) in connected.inputs.items()},
        }


def _notice(
    environment: Environment, wiring: Wiring, axes: Array, at: Array, limits: Range, name: str
) -> NoticeLaw:
    """What falls through zero where a variable leaves the range of its tables."""

    def inside(s: Any, p: Any) -> Any:
        given = wiring.given(air_data(environment.flow(s, p, at=at), axes), s.inputs)
        value = wiring.model.evaluate(given, [limits.variable])[limits.variable]
        ends = ((limits.low, 1.0), (limits.high, -1.0))
        return reduce(np.minimum, [sign * (value - end) for end, sign in ends if np.isfinite(end)])

    variable = wiring.model.variables[limits.variable]
    label = f"{variable.name} outside {limits.low:g} to {limits.high:g} {variable.units}"
    return notice(
        f"{label}: tables of {wiring.model.header.name or wiring.model.file} hold their border values",
        inside,
        parameters=environment.parameters,
        inputs={**wiring.law_inputs, **environment.inputs},
        name=f"{name}: {label}",
    )


def _coefficients(results: Mapping[str, Any], air: AirData, p: Any, drag_axes: str) -> tuple[Any, Any]:
    """Force and moment of the coefficients, axes of the model."""
    pressure = air.dynamic_pressure * p.reference_area
    force = _three(results, _FORCE)
    if _LIFT in results or _DRAG in results:
        sine, cosine = np.sin(air.angle_of_attack), np.cos(air.angle_of_attack)
        ahead = np.stack([cosine, 0.0, sine])
        if drag_axes == "wind":
            side, along = np.sin(air.angle_of_sideslip), np.cos(air.angle_of_sideslip)
            ahead = along * ahead + np.stack([0.0, side, 0.0])
        up = np.stack([sine, 0.0, -cosine])
        force = force + results.get(_LIFT, 0.0) * up - results.get(_DRAG, 0.0) * ahead
    moment = _three(results, _MOMENT)
    if any(name in results for name in _MOMENT):
        moment = moment * np.stack([p.reference_span, p.reference_chord, p.reference_span])
    return pressure * force, pressure * moment


def _three(results: Mapping[str, Any], names: tuple[str, ...]) -> Any:
    return np.stack([0.0 + results.get(name, 0.0) for name in names])


def _check_results(wiring: Wiring) -> None:
    """Refuse models that give no force, or the same one in two ways."""
    results, file = wiring.results.keys(), wiring.model.file
    names = {*_FORCE, *_MOMENT, _LIFT, _DRAG, *(n for pair in _WRENCHES for three in pair for n in three)}
    if not results & names:
        given = ", ".join(v.name for v in wiring.model.outputs)
        raise InputError(
            f"{file}: gives no force ({given}); say which results are aeroBodyForceCoefficient_X, "
            "totalCoefficientOfLift, thrustBodyForce_X ... with mapping={...}"
        )
    body, wind = sorted(results & {_FORCE[0], _FORCE[2]}), sorted(results & {_LIFT, _DRAG})
    if body and wind:
        raise InputError(
            f"{file}: gives {' and '.join(body)}, and {' and '.join(wind)} as well; leave one pair out, "
            f"mapping={{{', '.join(f'{wiring.results[name]!r}: None' for name in wind)}}}"
        )


def _references(wiring: Wiring, given: tuple[float | None, ...]) -> dict[str, float]:
    """Reference area and lengths that the coefficients need, SI."""
    needed: list[bool] = [bool(wiring.results.keys() & {*_FORCE, *_MOMENT, _LIFT, _DRAG})]
    needed += [
        bool(wiring.results.keys() & set(group)) for group in ((_MOMENT[0], _MOMENT[2]), (_MOMENT[1],))
    ]
    if needed[1] or needed[2]:
        needed = [True] * 3
    found: dict[str, float] = {}
    standard = ("referenceWingArea", "referenceWingSpan", "referenceWingChord")
    for key, own, value, name in zip(_REFERENCES, needed, given, standard, strict=True):
        if not own:
            continue
        number = wiring.constant(name) if value is None else value
        if number is None:
            raise InputError(f"{key}: {wiring.model.file} has no {name}; give {key} in {_REFERENCES[key]}")
        found[key] = _check.number(key, number, positive=True)
    return found


def _constant(model: DaveModel, name: str) -> str:
    variable = model.variable(name)
    if variable.role != "constant" or si(variable.units) is None or not variable.id.isidentifier():
        raise InputError(
            f"constants: {name!r} is {variable.role}, in {variable.units!r}; name constants of the file, "
            "with known units"
        )
    return variable.id


def _initial(model: DaveModel, id: str) -> float:
    initial = model.variables[id].initial
    assert initial is not None, "constants have a value"
    return initial
