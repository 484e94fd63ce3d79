"""The matrix analogue of Lagrange's second form: (2.9)-(2.12).

q, q_dot, q_ddot (..., 6) and `angles` as in `freebody.forms.generalized`.
"""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from freebody import _core
from freebody._check import Array, argument, sequence
from freebody.forms._call import checked_body, evaluate, orientation, regular


class Lagrange(NamedTuple):
    """The matrices of forms (2.9), (2.10), each (..., 6, 6), and the Christoffel sums (2.12), (..., 6)."""

    A: Array
    B: Array
    Phi_q: Array
    Phi_up_q: Array
    christoffel: Array


def lagrange(body: _core.RigidBody, q: ArrayLike, q_dot: ArrayLike, angles: str) -> Lagrange:
    """A = D^T Theta D, B, Phi_q, Phi^q = D^T Phi D^-T, and the sums {s; ij} q_dot_i q_dot_j from the symbols.

    A q_ddot + B q_dot = Q and q_ddot + Phi_q q_dot = A^-1 Q, with Q from `generalized_force`.
    SingularChartError where D has no inverse. Konoplev (2.9), (2.10), (2.12)
    """
    checked_body(body)
    coordinates, rates = argument("q", q, 6), argument("q_dot", q_dot, 6)
    regular(orientation(coordinates), sequence(angles))

    def of_motion(name: str, *item: int) -> Array:
        return evaluate(f"lagrange.{name}", item, coordinates, rates, angles=angles, body=body)

    return Lagrange(
        A=of_motion("A", 6, 6),
        B=of_motion("B", 6, 6),
        Phi_q=of_motion("Phi_q", 6, 6),
        Phi_up_q=of_motion("Phi_up_q", 6, 6),
        christoffel=of_motion("christoffel", 6),
    )


def christoffel_symbols(body: _core.RigidBody, q: ArrayLike, angles: str) -> Array:
    """The symbols of the second kind {s; ij} of the kinetic-energy matrix: (..., 6, 6, 6), indexed [s, i, j].

    SingularChartError where D has no inverse. Konoplev (2.12)
    """
    coordinates = argument("q", q, 6)
    regular(orientation(coordinates), sequence(angles))
    return evaluate("christoffel_symbols", (6, 6, 6), coordinates, angles=angles, body=checked_body(body))


def lagrange_operator(
    body: _core.RigidBody, q: ArrayLike, q_dot: ArrayLike, q_ddot: ArrayLike, angles: str
) -> Array:
    """d/dt dT/dq_dot - dT/dq = Q (..., 6) by exact differentiation of the kinetic energy. Konoplev (2.11)"""
    return evaluate(
        "lagrange_operator",
        (6,),
        argument("q", q, 6),
        argument("q_dot", q_dot, 6),
        argument("q_ddot", q_ddot, 6),
        angles=sequence(angles),
        body=checked_body(body),
    )
