"""Laws that shipped vehicles keep whatever they do: a gyrostat's momentum, a quadrotor's hover, the rocket
equation.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody._check import Array
from freebody.elements import GyroscopicMomentum, Propulsion, ReactionWheels
from freebody.model import Model
from freebody.model_file import load_model, shipped_model
from freebody.simulation import Trajectory

from .printed import digits
from .residual import Residual

__all__ = ["gyrostat", "quadrotor", "rocket"]

# Of the stages, s; and a place where the model's air has ended, m from the centre of the Earth.
SPECIFIC_IMPULSES = (220.0, 235.0)
FAR = 1e8

# What the integrator's tolerance, 1e-11, leaves after some hundred steps.
KEPT = 1e-9


def gyrostat() -> Iterator[Residual]:
    """Momentum of body, momentum wheel and reaction wheels: as the file flies it, and tumbling freely."""
    file, case = load_model(shipped_model("gyrostat")), "Gyrostat"
    (constant,) = (f for f in file.model.forces if isinstance(f, GyroscopicMomentum))
    (wheels,) = (f for f in file.model.forces if isinstance(f, ReactionWheels))
    run = file.model.simulate(file.x0, file.t_span, **file.options)
    yield _kept(case, "total momentum, driven", _momentum(run, constant, wheels))
    moved = np.linalg.norm(run.com_position_world - run.com_position_world[0], axis=1)
    yield Residual(case, "way of the mass centre, driven", float(moved.max()), 1e-9, "m")
    # Without friction and torque each wheel keeps its momentum about its axis, and the whole its energy.
    axes = [spin.axis for spin in wheels.spins]
    inertias = [spin.inertia for spin in wheels.spins]
    free = ReactionWheels(axes, inertias, torques=[0.0] * len(axes))
    model = Model(file.model.body, [constant, free])
    states = {
        f"{free.name}.{spin.state}": speed for spin, speed in zip(free.spins, (10.0, -6.0, 3.0), strict=True)
    }
    x0 = model.state(angular_velocity_body=[0.02, -0.05, 0.03], states=states)
    run = model.simulate(x0, (0.0, 1000.0), rtol=1e-12, save_every=10.0)
    omega, speeds = run.angular_velocity_body, _speeds(run, free)
    yield _kept(case, "total momentum, tumbling freely", _momentum(run, constant, free))
    own = np.array(inertias) * (speeds + omega @ np.array(axes).T)
    yield _kept(case, "spin of each wheel, tumbling freely", own)
    yield _kept(case, "kinetic energy, tumbling freely", _energy(run, free)[:, None])


def _speeds(run: Trajectory, wheels: ReactionWheels) -> Array:
    return np.column_stack([run.states[f"{wheels.name}.{spin.state}"] for spin in wheels.spins])


def _momentum(run: Trajectory, constant: GyroscopicMomentum, wheels: ReactionWheels) -> Array:
    """About the mass centre, world axes, (n, 3): C (J ω + h + Σ a J_s Ω)."""
    h = np.array([constant.parameters[f"momentum_{axis}"] for axis in "xyz"])
    along = np.array([np.multiply(spin.inertia, spin.axis) for spin in wheels.spins])
    own = run.angular_velocity_body @ run.model.body.inertia_about_com + h + _speeds(run, wheels) @ along
    return np.einsum("nij,nj->ni", run.world_from_body, own)


def _energy(run: Trajectory, wheels: ReactionWheels) -> Array:
    """½ ω J ω + Σ J_s (Ω a ω + ½ Ω²), (n,); what keeps the constant wheel's speed works on nothing else."""
    omega, speeds = run.angular_velocity_body, _speeds(run, wheels)
    inertias = np.array([spin.inertia for spin in wheels.spins])
    about = omega @ np.array([spin.axis for spin in wheels.spins]).T
    body = 0.5 * np.einsum("ni,ij,nj->n", omega, run.model.body.inertia_about_com, omega)
    return body + (speeds * about + 0.5 * speeds**2) @ inertias


def _kept(case: str, quantity: str, values: Array) -> Residual:
    """The largest change of rows (n, k), relative to the largest of them."""
    change = np.linalg.norm(values - values[0], axis=1).max()
    return Residual(case, quantity, float(change / np.linalg.norm(values, axis=1).max()), KEPT)


def quadrotor() -> Iterator[Residual]:
    """One rotor against thrust and torque as printed by Luis and Le Ny (2016); hover of four against 27 g."""
    file, case = load_model(shipped_model("quadrotor")), "Quadrotor"
    model, rest = file.model, {str(state.name): 0.0 for state in file.model.auxiliary_states}
    fast = 2.0 * np.pi * 10_000.0 / 60.0

    def wrench(speeds: dict[str, float]) -> Array:
        # No rotor has still to speed up: its command is its speed.
        commands = [speeds[name] for name in rest]
        return model.wrench(0.0, model.state(states=speeds), commands)

    still = wrench(rest)
    alone = wrench({**rest, next(iter(rest)): fast}) - still
    yield digits(case, "thrust of a rotor, N/rpm²", [-alone[2] / 1e8], "3.1582e-10")
    yield digits(case, "torque of a rotor, N m/rpm²", [abs(alone[5]) / 1e8], "7.9379e-12")
    # The printed figures hover 27 g at this speed.
    hover = 2.0 * np.pi / 60.0 * float(np.sqrt(0.027 * 9.80665 / (4 * 3.1582e-10)))
    left = np.abs(wrench(dict.fromkeys(rest, hover))).max() / abs(still[2])
    yield Residual(case, "hover at 14 478 rpm, share of the weight that is left", float(left), 5e-5)


def rocket() -> Iterator[Residual]:
    """Tsiolkovsky's equation for each stage, where there is neither air nor gravity."""
    file = load_model(shipped_model("two_stage_rocket"))
    for impulse, stage in zip(SPECIFIC_IMPULSES, file.stages, strict=True):
        (engine,) = (force for force in stage.model.forces if isinstance(force, Propulsion))
        model = Model(stage.model.body, [engine])
        x0, burning = model.state([FAR, 0.0, 0.0]), [float(name == "ignition") for name in model.input_names]
        run = model.simulate(x0, (0.0, 12.0), rtol=1e-12, save_every=0.5, inputs=burning)
        gained = 9.80665 * impulse * np.log(run.mass[0] / run.mass)
        off = np.abs(run.velocity_body - gained[:, None] * [1.0, 0.0, 0.0]).max() / gained[-1]
        yield Residual("Rocket", f"gain in speed of the {stage.model.name}", float(off), KEPT)
