"""What the kernel's numeric functions give for the arguments of every form, at random points."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

import freebody as fb
from freebody import forms
from freebody.verify.point_masses import Cloud, Motion

Array = NDArray[np.float64]
Values = dict[str, Array]
Results = list[Array]
Kernel = Callable[[fb.RigidBody, Values, str], Results]
"""From a body, the arguments (n, ...) and the angles to the results (n, ...), in order."""

POINTS = 100
BODIES = 5

# Both sides are the same data multiplied in another order, some hundred operations of 1e-16 each, and where
# inertia matrix and chart are inverted their conditions, up to 1e3 here, multiply that. A wrong term is of
# order one.
AGREE = 1e-12
VANISHING = 1e-2


def apply(matrix: Array, vector: Array) -> Array:
    """Matrix times vector over leading dimensions."""
    return np.einsum("...ij,...j->...i", matrix, vector)


def parameters(body: fb.RigidBody) -> Array:
    """The numbers of a general symbolic body: mass, mass centre, tensor about the origin."""
    return np.array([body.mass, *body.com, *body.inertia_about_origin[np.triu_indices(3)]])


def _of_twist(body: fb.RigidBody, g: Values, angles: str) -> Results:
    return [forms.inverse_dynamics(body, g["twist"], g["twist_rate"]), g["wrench"]]


def _twist_rate(body: fb.RigidBody, g: Values, angles: str) -> Results:
    return [forms.quasi_acceleration(body, g["twist"], g["wrench"], form="1.11")]


def _acceleration(form: str) -> Kernel:
    def kernel(body: fb.RigidBody, g: Values, angles: str) -> Results:
        motion = (g["q"], g["q_dot"], g["wrench"])
        return [forms.generalized_acceleration(body, *motion, angles, form=form)]

    return kernel


def _wrench_balance(body: fb.RigidBody, g: Values, angles: str) -> Results:
    m = forms.generalized(body, g["q"], g["q_dot"], angles)
    return [apply(m.A1, g["q_ddot"]) + apply(m.B1, g["q_dot"]), g["wrench"]]


def _force_balance(body: fb.RigidBody, g: Values, angles: str) -> Results:
    m = forms.lagrange(body, g["q"], g["q_dot"], angles)
    left = apply(m.A, g["q_ddot"]) + apply(m.B, g["q_dot"])
    return [left, forms.generalized_force(g["q"], g["wrench"], angles)]


def _operator(body: fb.RigidBody, g: Values, angles: str) -> Results:
    left = forms.lagrange_operator(body, g["q"], g["q_dot"], g["q_ddot"], angles)
    return [left, forms.generalized_force(g["q"], g["wrench"], angles)]


def _sums(body: fb.RigidBody, g: Values, angles: str) -> Results:
    return [forms.lagrange(body, g["q"], g["q_dot"], angles).christoffel]


def _rotation(body: fb.RigidBody, g: Values, angles: str) -> Results:
    motion = (g["alpha"], g["alpha_dot"], g["moment"])
    return [forms.rotation_acceleration(body.inertia_about_com, *motion, angles)]


def _phase(body: fb.RigidBody, g: Values, angles: str) -> Results:
    x = np.hstack([g["q"], g["q_dot"]])
    return [forms.phase_velocity(body, x, g["wrench"], angles)]


def _state_space(body: fb.RigidBody, g: Values, angles: str) -> Results:
    return [derivatives(fb.Model(body, attitude=angles), g)]


def derivatives(model: fb.Model, g: Mapping[str, Array]) -> Array:
    """The kernel's derivative at every point."""
    none = np.zeros((len(g["x"]), 0))
    return np.array(
        [model.derivative(*given) for given in zip(g["t"], g["x"], g.get("u", none), strict=True)]
    )


KERNELS: dict[str, Kernel] = {
    "1.8": _of_twist,
    "1.11": _twist_rate,
    **{form: _acceleration(form) for form in ("2.4", "2.7", "2.9")},
    "2.8": _wrench_balance,
    "2.10": _force_balance,
    "2.11": _operator,
    "2.12": _sums,
    "2.13": _rotation,
    "3.1": _phase,
    "3.2": _state_space,
}
CHARTS = ("quaternion", *forms.SEQUENCES)
"""The quaternion for the forms that have no angles, and for (3.2)."""


def forms_in(chart: str) -> list[str]:
    """The forms that are written in a chart."""
    without_angles = ["1.8", "1.11"]
    if chart == "quaternion":
        return [*without_angles, "3.2"]
    return [form for form in KERNELS if form not in without_angles]


def random_arguments(rng: np.random.Generator, chart: str, n: int) -> Values:
    """Values of the variables of every form at `n` motions, their angles away from the singularity."""
    motion = Motion.random(rng, "zyx" if chart == "quaternion" else chart, (n,))
    alpha = motion.q[:, 3:]
    if chart == "quaternion":
        alpha = rng.normal(size=(n, 4))
        alpha /= np.linalg.norm(alpha, axis=1, keepdims=True)
    twist, twist_rate, wrench = rng.normal(size=(3, n, 6))
    return {
        "q": motion.q,
        "q_dot": motion.q_dot,
        "q_ddot": motion.q_ddot,
        "position": motion.q[:, :3],
        "alpha": motion.q[:, 3:],
        "alpha_dot": motion.q_dot[:, 3:],
        "twist": twist,
        "twist_rate": twist_rate,
        "wrench": wrench,
        "moment": wrench[:, 3:],
        "t": rng.uniform(0.0, 10.0, n),
        "x": np.hstack([motion.q[:, :3], alpha, twist]),
        "u": wrench,
    }


def points(chart: str) -> tuple[Values, dict[str, Results]]:
    """Arguments of five bodies with twenty motions each, and what every form must give there."""
    rng = np.random.default_rng(1984)
    given: list[Values] = []
    wanted: list[dict[str, Results]] = []
    for _ in range(BODIES):
        body = Cloud.random(rng).body
        g = random_arguments(rng, chart, POINTS // BODIES)
        given.append({**g, "body": np.tile(parameters(body), (POINTS // BODIES, 1))})
        wanted.append({form: KERNELS[form](body, g, chart) for form in forms_in(chart)})
    arguments = {name: np.concatenate([g[name] for g in given]) for name in given[0]}
    results = {
        form: [np.concatenate(parts) for parts in zip(*(w[form] for w in wanted), strict=True)]
        for form in wanted[0]
    }
    return arguments, results


def blocks(size: int) -> list[slice]:
    """Entries of like units: position and angles, force and moment; a quaternion has four."""
    lengths = [3, 4, 3, 3] if size == 13 else [3] * (size // 3)
    ends = np.cumsum(lengths)
    return [slice(end - length, end) for end, length in zip(ends, lengths, strict=True)]


def disagreement(got: Array, wanted: Array) -> float:
    """The largest difference of vectors (n, size), point by point relative to the length of each block.

    A block that vanishes, as the sums of a centred body do, is what rounding left of its neighbours: it is
    held against a hundredth of the vector.
    """
    assert got.shape == wanted.shape
    whole = np.linalg.norm(wanted, axis=1)
    return max(
        float((_length(got - wanted, b) / np.maximum(_length(wanted, b), VANISHING * whole)).max())
        for b in blocks(wanted.shape[1])
    )


def _length(vectors: Array, block: slice) -> Array:
    return np.linalg.norm(vectors[:, block], axis=1)
