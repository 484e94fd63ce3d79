"""What each form of the paper, and each of its matrices, is made of."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from freebody.equations.result import Result
from freebody.equations.symbols import identifier, latex_of
from freebody.equations.variables import Variables

__all__ = ["FORMS", "MATRICES", "Entry"]

Made = tuple[list[Result], bool]


class Entry(NamedTuple):
    """A form: what it says, whether it needs angles, how its results are made, whether forces act in it."""

    title: str
    needs_angles: bool
    make: Callable[[Variables], Made]
    takes_forces: bool = True


def _vector(name: str, ids: list[int], labels: list[str], meaning: str) -> Result:
    return Result(name, tuple(ids), None, tuple(labels), meaning)


def _balance(left: list[int], right: list[int], needed: str) -> Made:
    labels = [""] * len(left)
    return [
        _vector("left", left, labels, f"{needed} that the motion needs"),
        _vector("right", right, labels, f"{needed} that acts"),
    ], True


def _known_ways(
    v: Variables, literal: str, blocks: str, *arguments: list[int], angles: bool = False
) -> list[int]:
    """A form as it stands; simplified, by blocks too: equal results become one, written the shorter way."""
    if not v.simplify:
        return v.form(literal, *arguments, angles=angles, body=True)
    result = v.form(blocks, *arguments, angles=angles, body=True)
    v.form(literal, *arguments, angles=angles, body=True)
    return result


def _rates(v: Variables, ending: str) -> list[str]:
    return [latex_of(f"{n}{ending}") for n in ("x", "y", "z", *v.names)]


def _inverse_dynamics(v: Variables) -> Made:
    left = v.form("inverse_dynamics", v.twist, v.twist_rate, body=True)
    return _balance(left, v.of_wrench(), "the wrench (N, N m; body axes, about the origin)")


def _quasi_coordinates(v: Variables) -> Made:
    rate = _known_ways(v, "quasi_acceleration.1.11", "quasi_acceleration.blocks", v.twist, v.of_wrench())
    labels = [latex_of(f"{stem}_{a}_dot") for stem in ("v", "omega") for a in "xyz"]
    meaning = "rates of the components of the twist in body axes, m/s^2 and rad/s^2"
    return [_vector("twist_rate", rate, labels, meaning)], False


def _acceleration(number: str) -> Callable[[Variables], Made]:
    def make(v: Variables) -> Made:
        form = "generalized_acceleration"
        motion = (v.q, v.q_dot, v.of_generalized_wrench())
        q_ddot = _known_ways(v, f"{form}.{number}", f"{form}.blocks", *motion, angles=True)
        return [_vector("q_ddot", q_ddot, _rates(v, "_ddot"), "second rates of q, m/s^2 and rad/s^2")], False

    return make


def _generalized_balance(number: str) -> Callable[[Variables], Made]:
    def make(v: Variables) -> Made:
        name = f"inverse_dynamics.{number}"
        left = _known_ways(v, name, f"{name}.blocks", v.q, v.q_dot, v.q_ddot, angles=True)
        wrench = v.of_generalized_wrench()
        if number == "2.8":
            return _balance(left, wrench, "the wrench (N, N m; body axes, about the origin)")
        right = v.form("generalized_force", v.q, wrench, angles=True)
        return _balance(left, right, "the generalized forces (N, N m)")

    return make


def _lagrange_operator(v: Variables) -> Made:
    if v.simplify:  # equal, so it is written in the shorter way
        v.form("inverse_dynamics.2.10.blocks", v.q, v.q_dot, v.q_ddot, angles=True, body=True)
    left = v.form("lagrange_operator", v.q, v.q_dot, v.q_ddot, angles=True, body=True)
    right = v.form("generalized_force", v.q, v.of_generalized_wrench(), angles=True)
    return _balance(left, right, "the generalized forces (N, N m)")


def _christoffel_sums(v: Variables) -> Made:
    sums = v.form("lagrange.christoffel", v.q, v.q_dot, angles=True, body=True)
    labels = [rf"\sum \Gamma^{{{s + 1}}}_{{ij}} \dot{{q}}_i \dot{{q}}_j" for s in range(6)]
    return [_vector("sums", sums, labels, "Christoffel sums of the second kind, m/s^2 and rad/s^2")], False


def _rotation(v: Variables) -> Made:
    ids, about_origin = v.body
    # The pole is the mass centre.
    xx, xy, xz, yy, yz, zz = v.graph.form("inertia_about_com", None, (ids, about_origin), [])
    tensor = [xx, xy, xz, xy, yy, yz, xz, yz, zz]
    alpha, alpha_dot = v.alpha, v.alpha_dot
    names = ("M_x", "M_y", "M_z")
    moment = v.symbols.group("moment", names, ["N m"] * 3, "about the mass centre, body axes")
    alpha_ddot = v.form("rotation_acceleration", tensor, alpha, alpha_dot, moment, angles=True)
    if v.simplify:  # equal, with the origin at the mass centre, so it is written in the shorter way
        zero, one = v.graph.constant(0.0), v.graph.constant(1.0)
        still, centred = [zero] * 3, ([one, zero, zero, zero, xx, xy, xz, yy, yz, zz], False)
        motion = [[*still, *alpha], [*still, *alpha_dot], [*still, *moment]]
        v.graph.form("generalized_acceleration.blocks", v.angles, centred, motion)
    labels = [latex_of(f"{n}_ddot") for n in v.names]
    return [_vector("alpha_ddot", alpha_ddot, labels, "second rates of alpha, rad/s^2")], False


def _phase(v: Variables) -> Made:
    wrench = v.of_generalized_wrench()
    form = "generalized_acceleration"
    second = _known_ways(v, f"{form}.2.7", f"{form}.blocks", v.q, v.q_dot, wrench, angles=True)
    rate = [*v.q_dot, *second]
    labels = _rates(v, "_dot") + _rates(v, "_ddot")
    return [_vector("x_dot", rate, labels, "rate of the phase point x = (q; q_dot)")], False


def _state_space(v: Variables) -> Made:
    model = v.model(v.attitude)
    t = v.time
    meaning = "state: " + ", ".join(model.state_names)
    x = v.symbols.named_by_users("x", v.state_symbols(model), model.state_units, meaning)
    names = v.symbols.groups[-1].symbols
    u = v.inputs(model)
    rate = v.graph.derivative(model, v.body, t, x, u)
    labels = [rf"\frac{{d}}{{dt}} {latex_of(n)}" for n in names]
    return [_vector("x_dot", rate, labels, "rate of the state, in its order, per second")], False


FORMS = {
    "1.8": Entry("(1.8): Theta V* + Phi Theta V = F", False, _inverse_dynamics),
    "1.11": Entry("(1.11): V* = Theta^-1 F - Phi_pi V", False, _quasi_coordinates),
    "2.4": Entry("(2.4): q_ddot = D^-1 Theta^-1 F - (Phi_qD + D^-1 D_dot) q_dot", True, _acceleration("2.4")),
    "2.7": Entry("(2.7): q_ddot = A1^-1 F - Phi1 q_dot", True, _acceleration("2.7")),
    "2.8": Entry("(2.8): A1 q_ddot + B1 q_dot = F", True, _generalized_balance("2.8")),
    "2.9": Entry("(2.9): q_ddot = A^-1 Q - Phi_q q_dot, Q = D^T F", True, _acceleration("2.9")),
    "2.10": Entry("(2.10): A q_ddot + B q_dot = Q, Q = D^T F", True, _generalized_balance("2.10")),
    "2.11": Entry("(2.11): d/dt dT/dq_dot - dT/dq = Q, Q = D^T F", True, _lagrange_operator),
    "2.12": Entry(
        "(2.12): sums of Christoffel symbols of the second kind with q_dot", True, _christoffel_sums, False
    ),
    "2.13": Entry(
        "(2.13): alpha_ddot = M1^-1 [J^-1 (M - <omega> J M1 alpha_dot) - C^T M0_dot alpha_dot]",
        True,
        _rotation,
        False,
    ),
    "3.1": Entry("(3.1): x_dot = f(x), x = (q; q_dot)", True, _phase),
    "3.2": Entry("(3.2): x_dot = f(x, u, t)", False, _state_space),
}


def _matrix(
    name: str,
    catalogue: str,
    symbol: str,
    columns: int,
    variables: tuple[str, ...],
    *,
    angles: bool = False,
    body: bool = False,
) -> Entry:
    def make(v: Variables) -> Made:
        given = [getattr(v, variable) for variable in variables]
        entries = v.form(catalogue, *given, angles=angles, body=body)
        labels = [f"({symbol})_{{{i // columns + 1}{i % columns + 1}}}" for i in range(len(entries))]
        return [Result(identifier(name), tuple(entries), columns, tuple(labels), "by rows")], False

    return Entry(f"matrix {name}", angles, make, False)


def _christoffel_symbols(v: Variables) -> Made:
    entries = v.form("christoffel_symbols", v.q, angles=True, body=True)
    labels = [rf"\Gamma^{{{k // 36 + 1}}}_{{{k // 6 % 6 + 1},{k % 6 + 1}}}" for k in range(len(entries))]
    meaning = "second kind: row 6 s + i, column j is the symbol {s; i j}, counted from zero"
    return [Result("christoffel_symbols", tuple(entries), 6, tuple(labels), meaning)], False


_Q, _MOTION, _ANGLES, _TURN = ("q",), ("q", "q_dot"), ("alpha",), ("alpha", "alpha_dot")

MATRICES = {
    "Theta": _matrix("Theta", "spatial_inertia", r"\Theta", 6, (), body=True),
    "Theta_inv": _matrix("Theta_inv", "inverse_spatial_inertia", r"\Theta^{-1}", 6, (), body=True),
    "L": _matrix("L", "wrench_transform", "L", 6, ("position", "rotation")),
    "L_inv": _matrix("L_inv", "wrench_transform_inverse", "L^{-1}", 6, ("position", "rotation")),
    "Phi": _matrix("Phi", "force_cross", r"\Phi", 6, ("twist",)),
    "Phi_pi": _matrix("Phi_pi", "quasi_velocity.Phi_pi", r"\Phi_\pi", 6, ("twist",), body=True),
    "C": _matrix("C", "rotation", "C", 3, _ANGLES, angles=True),
    "M0": _matrix("M0", "rate_matrix_world", "M_0", 3, _ANGLES, angles=True),
    "M1": _matrix("M1", "rate_matrix_body", "M_1", 3, _ANGLES, angles=True),
    "M0_inv": _matrix("M0_inv", "rate_matrix_world_inverse", r"M_0^{-1}", 3, _ANGLES, angles=True),
    "M1_inv": _matrix("M1_inv", "rate_matrix_body_inverse", r"M_1^{-1}", 3, _ANGLES, angles=True),
    "M0_dot": _matrix("M0_dot", "rate_matrix_world_dot", r"\dot{M}_0", 3, _TURN, angles=True),
    "omega_skew_world": _matrix(
        "omega_skew_world", "angular_velocity_skew_world", r"\langle\omega^0\rangle", 3, _TURN, angles=True
    ),
    "D": _matrix("D", "velocity_map", "D", 6, _Q, angles=True),
    "D_inv": _matrix("D_inv", "velocity_map_inverse", "D^{-1}", 6, _Q, angles=True),
    **{
        name: _matrix(name, f"generalized.{name}", symbol, 6, _MOTION, angles=True, body=True)
        for name, symbol in {
            "K": "K",
            "A1": "A_1",
            "B1": "B_1",
            "Phi1": r"\Phi_1",
            "Phi_qD": r"\Phi^{qD}",
            "D_inv_D_dot": r"(D^{-1}\dot{D})",
        }.items()
    },
    **{
        name: _matrix(name, f"lagrange.{name}", symbol, 6, _MOTION, angles=True, body=True)
        for name, symbol in {"A": "A", "B": "B", "Phi_q": r"\Phi_q", "Phi_up_q": r"\Phi^q"}.items()
    },
    "christoffel_symbols": Entry(
        "(2.12): Christoffel symbols of the second kind of A(q)", True, _christoffel_symbols, False
    ),
}
