"""Aerodynamic forces from coefficients, about any point of the body."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody.elements.air_data import VARIABLES, AirData, Station
from freebody.elements.coefficients import Coefficient, read_coefficients
from freebody.elements.lookup import Lookup
from freebody.environment import Environment, checked_environment
from freebody.errors import InputError
from freebody.forces import ORIGIN
from freebody.tables import Table
from freebody.tracing import ForceLaw, wrench
from freebody.tracing.situation import did_you_mean

__all__ = ["Aerodynamics", "Drag"]

AerodynamicAxes: TypeAlias = Literal["body", "stability", "wind"]
AllCoefficients: TypeAlias = Callable[[AirData], Mapping[str, Any]]

_FORCES = {"body": ("CX", "CY", "CZ"), "stability": ("CD", "CY", "CL"), "wind": ("CD", "CY", "CL")}
_MOMENTS = ("Cl", "Cm", "Cn")


class Aerodynamics(ForceLaw):
    """Forces q̄ S (CX, CY, CZ) and moments q̄ S (b Cl, c Cm, b Cn) at a reference point of the body.

    They are told in axes forward, to the right and down, which are the body axes if nothing else is said.

    Parameters
    ----------
    environment
        Its air, and how that moves.
    reference_area, span, chord
        S in m², b and c in m. Whoever has one reference length gives it twice.
    coefficients
        By name, of those that are not zero: "CX", "CY", "CZ" in body axes, "CD", "CY", "CL" in the others,
        and "Cl", "Cm", "Cn", always about body axes. A coefficient is a slope, or a mapping from products
        of variables to slopes, {"0": 0.2, "alpha": 5.1, "alpha^2": 0.7, "q_hat": slope, "elevator": 0.4}. A
        slope is a number, a `Lookup`, a function of the `AirData`, or a list of such: their sum. Or all in
        one: a function of the `AirData` that returns them by name.
        Variables are "alpha", "beta" in rad, "mach", "altitude" in m, "airspeed" in m/s, "p_hat" = p b/2V,
        "q_hat" = q c/2V, "r_hat" = r b/2V, and the controls.
    reference_point
        Where force and moment are given, body axes from the origin, (3,) m.
    flow_point
        The point of the body whose velocity makes the angles and q̄; the reference point when omitted.
    axes
        Of the force coefficients. "stability": drag CD against, lift CL up from the flow in the plane of
        symmetry, CY along body y. "wind": the same, turned by β besides: CD straight against the flow, CY to
        the right of it.
    body_from_aero
        Rotation (3, 3) whose columns are forward, right and down in body axes, when those are others.
    controls
        Name: unit, of the inputs that are variables, {"elevator": "rad"}.

    Every coefficient has the parameters `CD_factor` and `CD_offset`, factor × C + offset, and every number
    among the slopes is one: `Cm_alpha`, `Cm_alpha2`, `Cm_0`; so are `reference_area`, `span`, `chord` and
    `reference_x`, `reference_y`, `reference_z`. Where a run leaves the range of a table is said by its
    `notices`. At zero airspeed all is zero.

    Source: Stevens and Lewis, Aircraft Control and Simulation, 2nd ed., sections 2.3 and 3.5.
    """

    def __init__(
        self,
        environment: Environment,
        reference_area: float,
        span: float,
        chord: float,
        coefficients: Mapping[str, Coefficient] | AllCoefficients,
        reference_point: ArrayLike = ORIGIN,
        *,
        flow_point: ArrayLike | None = None,
        body_from_aero: ArrayLike | None = None,
        axes: AerodynamicAxes = "body",
        controls: Mapping[str, str] | None = None,
        name: str | None = None,
    ) -> None:
        _check.choice("axes", axes, ("body", "stability", "wind"))
        names = (*_FORCES[axes], *_MOMENTS)
        point = _point("reference_point", reference_point)
        station = Station(
            checked_environment(environment),
            point if flow_point is None else _point("flow_point", flow_point),
            _check.number("span", span, positive=True),
            _check.number("chord", chord, positive=True),
            _controls(controls),
            None if body_from_aero is None else _check.rotation("body_from_aero", body_from_aero),
        )
        variables = (*VARIABLES, *station.controls)
        if isinstance(coefficients, Mapping):
            read = read_coefficients(coefficients, names, variables)
            given = tuple(read.terms)
        elif callable(coefficients):
            read, given = read_coefficients({}, names, variables), names
        else:
            raise InputError(
                f"coefficients: got {_check.shown(coefficients)}; give them by name, or a function of the "
                "air data"
            )

        def aerodynamics(s: Any, p: Any) -> Any:
            at = np.stack([p.reference_x, p.reference_y, p.reference_z])
            _, a = station.meet(s, p, at if flow_point is None else None)
            bare = (
                {name: read.value(name, a, p) for name in given}
                if isinstance(coefficients, Mapping)
                else _returned(coefficients(a), names)
            )
            c = {n: p[f"{n}_factor"] * bare[n] + p[f"{n}_offset"] if n in bare else 0.0 for n in names}
            scale = a.dynamic_pressure * p.reference_area
            force = _in_body_axes([c[n] for n in _FORCES[axes]], axes, a)
            lengths = np.stack([p.span, p.chord, p.span])
            moment = scale * lengths * np.stack([c[n] for n in _MOMENTS])
            return wrench(station.in_body_axes(scale * force), station.in_body_axes(moment), at=at)

        super().__init__(
            aerodynamics,
            parameters={
                "reference_area": (_check.number("reference_area", reference_area, positive=True), "m^2"),
                "span": (station.span, "m"),
                "chord": (station.chord, "m"),
                **{f"reference_{axis}": (place, "m") for axis, place in zip("xyz", point, strict=True)},
                **{label: (value, "1") for label, value in read.numbers.items()},
                **{f"{n}_factor": (1.0, "1") for n in given},
                **{f"{n}_offset": (0.0, "1") for n in given},
                **station.parameters,
            },
            inputs=station.inputs,
            name=name,
        )
        self.notices = environment.notices + tuple(
            station.notice(variable, low, high, ", ".join(whose), beyond)
            for (variable, low, high, beyond), whose in read.ranges().items()
        )


class Drag(ForceLaw):
    """Drag ½ ρ V² A C_D against the velocity relative to the medium, at a point of the body.

    Parameters
    ----------
    area
        A, m².
    coefficient
        C_D: a number, or a `Table` of the Mach number.
    at
        Where it acts and where the velocity is taken, body axes from the origin, (3,) m.

    Parameters of the law are `area` and `coefficient`; with a table, `coefficient` is a factor of it.
    """

    def __init__(
        self,
        environment: Environment,
        area: float,
        coefficient: float | Table,
        at: ArrayLike = ORIGIN,
        *,
        name: str | None = None,
    ) -> None:
        point = _point("at", at)
        station = Station(checked_environment(environment), point, 1.0, 1.0, {})
        table = Lookup(coefficient, "mach") if isinstance(coefficient, Table) else None
        number = 1.0 if isinstance(coefficient, Table) else _check.number("coefficient", coefficient)

        def drag(s: Any, p: Any) -> Any:
            flow, a = station.meet(s, p)
            size = 0.5 * flow.air.density * p.area * p.coefficient * a.airspeed
            return wrench(-size * (1.0 if table is None else table(a)) * flow.velocity, at=point)

        super().__init__(
            drag,
            parameters={
                "area": (_check.number("area", area, positive=True), "m^2"),
                "coefficient": (number, "1"),
                **station.parameters,
            },
            inputs=station.inputs,
            name=name,
        )
        self.notices = environment.notices + tuple(
            station.notice("mach", *table.ranges["mach"], "drag", table.beyond)
            for table in (() if table is None else (table,))
        )


def _in_body_axes(c: list[Any], axes: AerodynamicAxes, a: AirData) -> Any:
    """Force coefficients (3,) in body axes."""
    if axes == "body":
        return np.stack(c)
    drag, side, lift = c
    ca, sa = np.cos(a.alpha), np.sin(a.alpha)
    if axes == "wind":
        cb, sb = np.cos(a.beta), np.sin(a.beta)
        drag, side = drag * cb + side * sb, side * cb - drag * sb
    return np.stack([lift * sa - drag * ca, side, -lift * ca - drag * sa])


def _returned(values: Any, names: tuple[str, ...]) -> Mapping[str, Any]:
    if not isinstance(values, Mapping):
        raise InputError(f"coefficients: the function returned {_check.shown(values)}; return them by name")
    for name in values:
        if name not in names:
            raise InputError(
                f"coefficients: {name!r} is none in these axes; {did_you_mean(str(name), names)}"
            )
    return values


def _point(name: str, value: ArrayLike) -> tuple[float, float, float]:
    x, y, z = _check.vector(name, value, 3).tolist()
    return x, y, z


def _controls(given: object) -> dict[str, str]:
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise InputError(f'controls: got {_check.shown(given)}; give units by name, {{"elevator": "rad"}}')
    for name in given:
        if name in (*VARIABLES, "factor", "offset"):
            raise InputError(f"controls: {name!r} means something else here; give the control another name")
    return dict(given)
