"""How long it takes to derive equations, and how long they are, beside SymPy's own derivation: `make bench`.

Every program gets the same task: the body of form (2.10), general tensor, mass centre off the origin, angles
"zyx". SymPy's derivations are timed once, for they take seconds, and print nothing; ours is the median of
many, with LaTeX and C printed.
"""

import statistics
import time
from collections.abc import Callable
from typing import Any

import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

import freebody as fb

REPEATS = 25


def ours(form: str, angles: str | None = "zyx") -> float:
    """Seconds to derive a form and to print it in LaTeX and C, on a new graph each time; the median."""
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        equations = fb.equations(form, angles)
        equations.latex()
        equations.c()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def left_alone(form: str, angles: str | None = "zyx") -> tuple[float, int]:
    """Operations of what stands left, written out and shared: without the wrench, as SymPy's are counted."""
    equations = fb.equations(form, angles)
    graph, left = equations._graph, list(equations._results[0].ids)
    counts = []
    for shared in (False, True):
        graph.settle(left, shared)
        counts.append(graph.operation_count(left)[shared])
    return counts[0], int(counts[1])


class Mechanics:
    """The body and its motion in the words of sympy.physics.mechanics."""

    def __init__(self) -> None:
        x, y, z, psi, theta, phi = self.q = dynamicsymbols("x y z psi theta phi")
        mass, xc, yc, zc = sp.symbols("m x_c y_c z_c")
        tensor = sp.symbols("J_xx J_yy J_zz J_xy J_yz J_xz")
        self.world = ReferenceFrame("W")
        self.axes = ReferenceFrame("B")
        self.axes.orient_body_fixed(self.world, (psi, theta, phi), "ZYX")
        self.fixed = Point("O")
        self.fixed.set_vel(self.world, 0)
        position = x * self.world.x + y * self.world.y + z * self.world.z
        self.origin = self.fixed.locatenew("o", position)
        arm = xc * self.axes.x + yc * self.axes.y + zc * self.axes.z
        self.centre = self.origin.locatenew("c", arm)
        about_origin = inertia(self.axes, *tensor)
        self.body = RigidBody("body", self.centre, self.axes, mass, (about_origin, self.origin))

    def lagrange(self) -> Any:
        """The left sides of Lagrange's equations."""
        self.origin.set_vel(self.world, self.origin.pos_from(self.fixed).dt(self.world))
        self.centre.v2pt_theory(self.origin, self.world, self.axes)
        energy = self.body.kinetic_energy(self.world)
        return LagrangesMethod(energy, self.q).form_lagranges_equations()

    def kane(self) -> Any:
        """Kane's equations in the components of the twist in body axes: form (1.8)."""
        u = dynamicsymbols("v_x v_y v_z omega_x omega_y omega_z")
        axes = (self.axes.x, self.axes.y, self.axes.z)
        rates = [coordinate.diff() for coordinate in self.q]
        velocity = sum((c * a for c, a in zip(rates, self.world, strict=False)), 0 * self.world.x)
        turning = self.axes.ang_vel_in(self.world)
        kinematic = [c - velocity.dot(a) for c, a in zip(u[:3], axes, strict=True)]
        kinematic += [c - turning.dot(a) for c, a in zip(u[3:], axes, strict=True)]
        self.axes.set_ang_vel(self.world, sum((c * a for c, a in zip(u[3:], axes, strict=True)), 0 * axes[0]))
        self.origin.set_vel(self.world, sum((c * a for c, a in zip(u[:3], axes, strict=True)), 0 * axes[0]))
        self.centre.v2pt_theory(self.origin, self.world, self.axes)
        method = KanesMethod(self.world, q_ind=self.q, u_ind=u, kd_eqs=kinematic)
        _, inertial = method.kanes_equations([self.body], [(self.origin, 0 * axes[0])])
        return inertial


def theirs(derive: Callable[[Mechanics], Any]) -> tuple[float, int, int]:
    """Seconds of a derivation, its operations written out and after SymPy's own sharing."""
    start = time.perf_counter()
    equations = derive(Mechanics())
    seconds = time.perf_counter() - start
    parts, rest = sp.cse(equations)
    return seconds, sp.count_ops(equations), sp.count_ops([e for _, e in parts]) + sp.count_ops(rest)


def main() -> None:
    lagrange, kane = theirs(Mechanics.lagrange), theirs(Mechanics.kane)
    print('equations of a general body, angles "zyx"; ours with LaTeX and C printed; left sides counted')
    print(f"{'':32}{'seconds':>9}{'ratio':>8}{'written out':>13}{'shared':>8}")
    ours_lagrange = ours("2.10")
    ours_kane = ours("1.8", None)
    rows = [
        ("(2.10)", ours_lagrange, ours_lagrange, *left_alone("2.10")),
        ("SymPy, LagrangesMethod", lagrange[0], ours_lagrange, *lagrange[1:]),
        ("(2.8)", ours("2.8"), ours_lagrange, *left_alone("2.8")),
        ("(1.8)", ours_kane, ours_kane, *left_alone("1.8", None)),
        ("SymPy, KanesMethod", kane[0], ours_kane, *kane[1:]),
    ]
    for name, seconds, unit, written_out, shared in rows:
        print(f"{name:32}{seconds:9.4f}{seconds / unit:8.1f}{written_out:13.0f}{shared:8d}")


if __name__ == "__main__":
    main()
