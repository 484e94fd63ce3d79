"""The case that every program is given, and what is right: an independent derivative and Jacobian in NumPy.

A body whose mass centre lies off the origin, with gravity, a constant wrench and linear damping; its state is
(o; quaternion; v; ω), position in world axes, twist in body axes, as freebody's quaternion chart has it.
"""

from dataclasses import dataclass

import numpy as np

GRAVITY = 9.81
FORCE, MOMENT = np.array([3.0, -1.0, 2.0]), np.array([0.4, -0.3, 0.2])
DAMPING = np.array([2.0, 3.0, 4.0, 0.5, 0.6, 0.7])
MASS = 12.5
COM = np.array([0.12, -0.05, 0.08])
INERTIA = np.array([[1.2, 0.05, -0.02], [0.05, 1.9, 0.04], [-0.02, 0.04, 2.4]])
ROLL_PITCH_YAW = np.array([0.3, -0.2, 0.5])
TWIST = np.array([5.0, 0.5, -0.3, 0.8, -1.1, 1.7])
SECONDS = 10.0

RUNS = 10_000
DISPERSION = 0.1
SEED = 4

STATES, INPUTS = 13, 6


@dataclass(frozen=True)
class Bodies:
    """Mass properties of n bodies: mass (n,), mass centre (3, n), inertia about it (3, 3, n)."""

    mass: np.ndarray
    com: np.ndarray
    inertia: np.ndarray

    def __len__(self) -> int:
        return len(self.mass)

    def part(self, which: slice) -> "Bodies":
        return Bodies(self.mass[which], self.com[:, which], self.inertia[:, :, which])

    def inverse_inertia(self) -> np.ndarray:
        """(3, 3, n), by cofactors, in the precision of the inertia."""
        rows = [np.cross(self.inertia[i - 2], self.inertia[i - 1], axis=0) for i in range(3)]
        return np.stack(rows, axis=1) / (self.inertia[0] * rows[0]).sum(0)


def quaternion(roll_pitch_yaw: np.ndarray) -> np.ndarray:
    """(4, n) from angles (3, n): yaw about z, then pitch about y, then roll about x."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(roll_pitch_yaw / 2), np.sin(roll_pitch_yaw / 2)
    return np.stack(
        [
            cr * cp * cy + sr * sp * sy,
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
        ]
    )


def nominal() -> tuple[np.ndarray, Bodies]:
    """The state (13, 1) and the body."""
    state = np.concatenate([np.zeros(3), quaternion(ROLL_PITCH_YAW), TWIST])
    return state[:, None], Bodies(np.array([MASS]), COM[:, None], INERTIA[:, :, None])


def dispersed(n: int = RUNS) -> tuple[np.ndarray, Bodies]:
    """States (13, n) and bodies: each angle, velocity, mass property by up to a tenth, uniformly."""
    rng = np.random.default_rng(SEED)
    factors = 1.0 + DISPERSION * rng.uniform(-1.0, 1.0, (19, RUNS))[:, :n]
    angles = ROLL_PITCH_YAW[:, None] * factors[:3]
    twist = TWIST[:, None] * factors[3:9]
    six = factors[[10, 13, 14, 13, 11, 15, 14, 15, 12]].reshape(3, 3, n)
    bodies = Bodies(MASS * factors[9], COM[:, None] * factors[16:19], INERTIA[:, :, None] * six)
    return np.concatenate([np.zeros((3, n)), quaternion(angles), twist]), bodies


def rotation(q: np.ndarray) -> np.ndarray:
    """world_from_body (3, 3, n)."""
    w, x, y, z = q
    return np.stack(
        [
            np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)]),
            np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)]),
            np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]),
        ]
    )


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of vectors (3, n)."""
    return a[[1, 2, 0]] * b[[2, 0, 1]] - a[[2, 0, 1]] * b[[1, 2, 0]]


def derivative(x: np.ndarray, bodies: Bodies, inverse: np.ndarray, u: np.ndarray | float = 0.0) -> np.ndarray:
    """(13, n) from states (13, n): Newton's law for the mass centre, Euler's about it.

    u is one more wrench (6, n) about the origin.
    """
    (w, *_), r = x[3:7], x[4:7]
    v, omega, c = x[7:10], x[10:13], bodies.com
    turned = rotation(x[3:7])
    wrench = np.concatenate([FORCE, MOMENT])[:, None] - DAMPING[:, None] * x[7:13] + u
    weight = bodies.mass * GRAVITY * turned[2]
    force, moment = wrench[:3] + weight, wrench[3:] - cross(c, wrench[:3])
    momentum = (bodies.inertia * omega).sum(1)
    spin = (inverse * (moment - cross(omega, momentum))).sum(1)
    centre = v + cross(omega, c)
    return np.concatenate(
        [
            (turned * v).sum(1),
            -0.5 * (r * omega).sum(0)[None],
            0.5 * (w * omega + cross(r, omega)),
            force / bodies.mass - cross(omega, centre) - cross(spin, c),
            spin,
        ]
    )


def jacobian(x: np.ndarray, bodies: Bodies) -> np.ndarray:
    """(13, 19) by states and inputs at one state (13, 1): a complex step, exact to rounding."""
    seeds = 1e-100j * np.eye(STATES + INPUTS)
    rates = derivative(x + seeds[:STATES], bodies, bodies.inverse_inertia(), seeds[STATES:])
    return np.imag(rates) / 1e-100
