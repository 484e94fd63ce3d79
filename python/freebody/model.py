"""Models: a body, its forces, and how the state is written."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.body import RigidBody
from freebody.errors import InputError
from freebody.forces import ORIGIN, Force, InputWrench
from freebody.linearization import Linearization, linearize
from freebody.simulation import InputTable, Method, Trajectory, simulate

__all__ = ["Model"]

Form = Literal["quasi_velocity", "generalized"]

WRENCH_NAMES = ("force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z")
WRENCH_UNITS = ("N",) * 3 + ("N m",) * 3


class Model(_core.Model):
    """A free rigid body with its forces as x' = f(x, u, t). Konoplev (3.1), (3.2).

    Parameters
    ----------
    body
        The body, about any frame.
    forces
        Force elements. When none of them reads inputs, u is the wrench (6,) on the body about its origin in
        body axes, added to the forces, so that B = [0; Θ⁻¹].
    attitude
        Chart of the orientation: "quaternion", or an angle sequence such as "zyx".
    form
        "quasi_velocity": the state holds (v; ω) of the origin in body axes. "generalized": the rates of the
        generalized coordinates, ȯ in world axes and those of the angles or the quaternion.
    name
        How messages and results call the model.

    Attributes
    ----------
    state_names, state_units, input_names, input_units
        What the numbers of x and u are.
    """

    body: RigidBody
    forces: tuple[Force, ...]
    attitude: str
    form: Form
    name: str
    acting_names: tuple[str, ...]
    state_names: tuple[str, ...]
    state_units: tuple[str, ...]
    input_names: tuple[str, ...]
    input_units: tuple[str, ...]

    def __new__(
        cls,
        body: RigidBody,
        forces: Iterable[Force] = (),
        attitude: str = "quaternion",
        form: Form = "quasi_velocity",
        *,
        name: str = "model",
    ) -> Model:
        if not isinstance(body, RigidBody):
            raise InputError(f"body: got {_check.shown(body)}; give a freebody.RigidBody")
        given = _checked_forces(forces)
        _check.choice("attitude", attitude, ("quaternion", *_check.SEQUENCES))
        _check.choice("form", form, ("quasi_velocity", "generalized"))
        acting = given
        if not any(isinstance(f, InputWrench) for f in given):
            acting = (*given, InputWrench(name="applied wrench"))
        sequence = None if attitude == "quaternion" else attitude
        names = [f.name for f in acting]
        self = super().__new__(cls, body, [f.core() for f in acting], names, sequence, form == "generalized")
        self.body, self.forces, self.attitude, self.form = body, given, attitude, form
        self.acting_names = tuple(names)
        self.name = _check.label("name", name)
        self.state_names, self.state_units = _state_labels(attitude, form)
        self.input_names, self.input_units = _input_labels(acting)
        return self

    def state(
        self,
        position: ArrayLike = ORIGIN,
        attitude: Attitude | None = None,
        *,
        velocity_body: ArrayLike | None = None,
        velocity_world: ArrayLike | None = None,
        angular_velocity_body: ArrayLike | None = None,
        angular_velocity_world: ArrayLike | None = None,
    ) -> Array:
        """The state x of a motion, (n_states,).

        Parameters
        ----------
        position
            Of the body origin, world axes, (3,) m.
        attitude
            The identity when omitted.
        velocity_body, velocity_world
            Of the body origin, in body or world axes, (3,) m/s; zero when both are omitted.
        angular_velocity_body, angular_velocity_world
            In body or world axes, (3,) rad/s; zero when both are omitted.

        Raises
        ------
        SingularChartError
            The angle rates of the generalized form do not exist at this attitude.
        """
        attitude = Attitude.identity() if attitude is None else attitude
        if not isinstance(attitude, Attitude):
            raise InputError(f"attitude: got {_check.shown(attitude)}; make one with Attitude.angles(...)")
        body_from_world = attitude.as_rotation().T
        velocity = _either("velocity", velocity_body, velocity_world, body_from_world)
        turn = _either("angular_velocity", angular_velocity_body, angular_velocity_world, body_from_world)
        angles = np.zeros(3) if self.attitude == "quaternion" else attitude.as_angles(self.attitude)
        x = self.state_of(
            _check.vector("position", position, 3),
            attitude.as_quaternion(),
            np.concatenate([velocity, turn]),
            angles,
        )
        if self.attitude != "quaternion":
            x[3:6] = angles
        return x

    def simulate(
        self,
        x0: ArrayLike,
        t_span: tuple[float, float],
        *,
        method: Method = "dop853",
        rtol: float = 1e-9,
        atol: float | None = None,
        step: float | None = None,
        save_every: float | None = None,
        save_at: ArrayLike | None = None,
        inputs: ArrayLike | InputTable | None = None,
        max_steps: int = 10_000_000,
        progress: Callable[[float], object] | None = None,
    ) -> Trajectory:
        """Simulate from a state.

        A run in angles that comes near their singularity goes on in quaternions and comes back; its samples
        stay in the angles asked for.

        Parameters
        ----------
        x0
            State at the start, (n_states,); see `state`.
        t_span
            Start and end, s.
        method
            "dop853": Dormand-Prince 8(5,3), adaptive. "dp54": Dormand-Prince 5(4), adaptive. "rk4": classical
            Runge-Kutta, fixed step (Hairer, Nørsett, Wanner, Solving ODEs I, 2nd ed., II.1 and II.5).
        rtol, atol
            Error allowed to one step: of each vector of the state (position, velocity, ...) atol + rtol times
            its length, of the orientation rtol rad. atol is 1e-3 rtol when omitted, in SI units.
        step
            The fixed step of rk4, s; the first step of the others, which choose one when it is omitted.
        save_every, save_at
            Samples every so many s and at the end, or at given times (n,); every step when both are omitted.
        inputs
            Constant inputs (n_inputs,), or an `InputTable`; zero when omitted.
        max_steps
            Stop after so many steps, accepted and rejected.
        progress
            Called now and then with the part done, 0 to 1.

        Returns
        -------
        Trajectory
            Whatever happens: how the run ended is its `outcome`.
        """
        return simulate(
            self,
            x0,
            t_span,
            method=method,
            rtol=rtol,
            atol=atol,
            step=step,
            save_every=save_every,
            save_at=save_at,
            inputs=inputs,
            max_steps=max_steps,
            progress=progress,
        )

    def linearize(self, run: Trajectory) -> Linearization:
        """The exact Jacobians A(t), B(t) at the samples of a run of this model. Konoplev (3.2)."""
        return linearize(self, run)

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (self.body, self.forces, self.attitude, self.form, self.name)

    def __repr__(self) -> str:
        acting = ", ".join(f.name for f in self.forces) or "none"
        return f"<Model {self.name!r}: {self.body.name!r}, forces: {acting}; {self.attitude}, {self.form}>"


def _restore(body: RigidBody, forces: tuple[Force, ...], attitude: str, form: Form, name: str) -> Model:
    return Model(body, forces, attitude, form, name=name)


def _checked_forces(forces: Iterable[Force]) -> tuple[Force, ...]:
    try:
        given = tuple(forces)
    except TypeError:
        raise InputError(f"forces: got {_check.shown(forces)}; give a list of force elements") from None
    for i, force in enumerate(given):
        if not isinstance(force, Force):
            raise InputError(f"forces[{i}]: got {_check.shown(force)}; give a force element")
        if isinstance(force, InputWrench) and any(
            isinstance(f, InputWrench) and f.name == force.name for f in given[:i]
        ):
            raise InputError(
                f"forces[{i}]: a second InputWrench called {force.name!r}; give each its own name=, which "
                "its inputs bear"
            )
    return given


def _either(name: str, body: ArrayLike | None, world: ArrayLike | None, body_from_world: Array) -> Array:
    """A vector in body axes, given in body or world axes."""
    if body is not None and world is not None:
        raise InputError(f"{name}_body, {name}_world: both came; give one of them")
    if body is not None:
        return _check.vector(f"{name}_body", body, 3)
    if world is not None:
        with np.errstate(over="ignore", invalid="ignore"):  # beyond doubles: the core refuses the state
            return body_from_world @ _check.vector(f"{name}_world", world, 3)
    return np.zeros(3)


def _xyz(stem: str) -> tuple[str, ...]:
    return tuple(f"{stem}_{axis}" for axis in "xyz")


def _state_labels(attitude: str, form: Form) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the state."""
    turning, unit = ("angle_1", "angle_2", "angle_3"), "rad"
    if attitude == "quaternion":
        turning, unit = tuple(f"quaternion_{c}" for c in "wxyz"), "1"
    names, units = [*_xyz("position"), *turning], ["m"] * 3 + [unit] * len(turning)
    if form == "quasi_velocity":
        names += [*_xyz("velocity"), *_xyz("angular_velocity")]
        units += ["m/s"] * 3 + ["rad/s"] * 3
    else:
        names += [*_xyz("position_rate"), *(name.replace("_", "_rate_") for name in turning)]
        units += ["m/s"] * 3 + ["rad/s" if unit == "rad" else "1/s"] * len(turning)
    return tuple(names), tuple(units)


def _input_labels(forces: Iterable[Force]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the inputs; with several input elements each name starts with its element's."""
    readers = [f for f in forces if isinstance(f, InputWrench)]
    many = len(readers) > 1
    names = [f"{f.name}.{n}" if many else n for f in readers for n in WRENCH_NAMES]
    return tuple(names), WRENCH_UNITS * len(readers)
