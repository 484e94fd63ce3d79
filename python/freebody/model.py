"""Models: a body, its forces, and how the state is written."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Literal

from numpy.typing import ArrayLike

from freebody import _check, _core
from freebody._check import Array
from freebody.attitude import Attitude
from freebody.body import RigidBody
from freebody.ensembles import Dispersion, Ensemble, Sampling
from freebody.environment import Environment
from freebody.errors import InputError
from freebody.forces import ORIGIN, InputWrench, checked_forces
from freebody.interfaces import Control, Force, StateQuantity
from freebody.left_side import left_side
from freebody.linearization import Linearization, linearize
from freebody.signals import Source, connect, labels, reads_inputs, rigid_state_labels
from freebody.simulation import InputTable, Method, Trajectory, simulate
from freebody.states import state_of
from freebody.tracing import EventLaw, OutputLaw

__all__ = ["Model"]

Form = Literal["quasi_velocity", "generalized"]


class Model(_core.Model):
    """A free rigid body with its forces as x' = f(x, u, t). Konoplev (3.1), (3.2).

    Parameters
    ----------
    body
        The body, about any frame.
    forces
        Force elements. When none of them reads inputs of u, u is the wrench (6,) on the body about its origin
        in body axes, added to the forces, so that B = [0; Θ⁻¹].
    attitude
        Chart of the orientation: "quaternion", or an angle sequence such as "zyx".
    form
        "quasi_velocity": the state holds (v; ω) of the origin in body axes. "generalized": the rates of the
        generalized coordinates, ȯ in world axes and those of the angles or the quaternion.
    control
        A control law: what it commands is no input of the model any more, what it reads itself is.
    name
        How messages and results call the model.
    environment
        In whose frames results are told. It does not act: what asks for it are forces.

    Attributes
    ----------
    state_names, state_units, input_names, input_units
        What the numbers of x and u are. Behind the rigid body's own states come the auxiliary states of the
        forces, then those of the control law, called "law.state"; inputs of one name are one input.
    compiled
        Whether its derivative is compiled C, see `freebody.compile`.
    command_names, command_units
        What the control law commands.
    sources
        What laws can read by name: inputs, commands, and states that forces publish.
    """

    body: RigidBody
    forces: tuple[Force, ...]
    attitude: str
    form: Form
    control: Control | None
    name: str
    environment: Environment | None
    compiled: bool
    acting_names: tuple[str, ...]
    state_names: tuple[str, ...]
    state_units: tuple[str, ...]
    input_names: tuple[str, ...]
    input_units: tuple[str, ...]
    command_names: tuple[str, ...]
    command_units: tuple[str, ...]
    auxiliary_states: tuple[StateQuantity, ...]
    sources: Mapping[str, Source]

    def __new__(
        cls,
        body: RigidBody,
        forces: Iterable[Force] = (),
        attitude: str = "quaternion",
        form: Form = "quasi_velocity",
        *,
        control: Control | None = None,
        name: str = "model",
        environment: Environment | None = None,
    ) -> Model:
        return cls._of(body, forces, attitude, form, control, name, environment, compiled=None)

    @classmethod
    def _of(
        cls,
        body: RigidBody,
        forces: Iterable[Force],
        attitude: str,
        form: Form,
        control: Control | None,
        name: str,
        environment: Environment | None,
        *,
        compiled: _core.Compiled | None,
    ) -> Model:
        if not isinstance(body, RigidBody):
            raise InputError(f"body: got {_check.shown(body)}; give a freebody.RigidBody")
        given = checked_forces(forces)
        _check.choice("attitude", attitude, ("quaternion", *_check.SEQUENCES))
        _check.choice("form", form, ("quasi_velocity", "generalized"))
        if not isinstance(control, Control | None):
            raise InputError(f"control: got {_check.shown(control)}; give a control law, made by @fb.control")
        if not isinstance(environment, Environment | None):
            raise InputError(f"environment: got {_check.shown(environment)}; give a freebody Environment")
        acting = given if reads_inputs(given) else (*given, InputWrench(name="applied wrench"))
        signals = connect(acting, control)
        names = [f.name for f in acting] + ([] if control is None else [control.name])
        self = super().__new__(
            cls,
            body,
            [f.core() for f in acting],
            names,
            None if attitude == "quaternion" else attitude,
            form == "generalized",
            signals.force_places,
            len(signals.inputs),
            None if control is None else control.core(),
            signals.control_places,
            left_side(body, acting, signals),
            compiled,
        )
        self.body, self.forces, self.attitude, self.form = body, given, attitude, form
        self.control, self.acting_names, self.compiled = control, tuple(names), compiled is not None
        self.name, self.environment = _check.label("name", name), environment
        names, units = rigid_state_labels(attitude, form == "generalized")
        self.state_names = (*names, *(s.name for s in signals.states))
        self.state_units = (*units, *(s.unit for s in signals.states))
        self.auxiliary_states, self.sources = signals.states, signals.sources
        self.input_names, self.input_units = labels(signals.inputs)
        self.command_names, self.command_units = labels(signals.commands)
        return self

    @property
    def auxiliary(self) -> Mapping[str, int]:
        """The places in x of the auxiliary states, by name."""
        first = self.n_states - len(self.auxiliary_states)
        return {state.name: first + i for i, state in enumerate(self.auxiliary_states)}

    def state(
        self,
        position: ArrayLike = ORIGIN,
        attitude: Attitude | None = None,
        *,
        velocity_body: ArrayLike | None = None,
        velocity_world: ArrayLike | None = None,
        angular_velocity_body: ArrayLike | None = None,
        angular_velocity_world: ArrayLike | None = None,
        states: Mapping[str, float] | None = None,
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
        states
            Auxiliary states by name, {"fin.servo": 0.1}; those omitted have the start values of their laws.

        Raises
        ------
        SingularChartError
            The angle rates of the generalized form do not exist at this attitude.
        """
        twist = velocity_body, velocity_world, angular_velocity_body, angular_velocity_world
        return state_of(self, position, attitude, twist, states)

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
        events: Iterable[EventLaw] = (),
        outputs: Iterable[OutputLaw] = (),
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
            "dop853", "dp54": Dormand-Prince 8(5,3) and 5(4), adaptive. "rk4": classical, fixed step. (Hairer,
            Nørsett, Wanner, Solving ODEs I, 2nd ed., II.1, II.5.) "rodas5p": for stiff forces, adaptive
            (Steinebach, BIT 63, 2023). "gauss6": fixed step, keeps the energy of free motion (Hairer, Lubich,
            Wanner, Geometric Numerical Integration, 2nd ed., IV.2).
        rtol, atol
            Error allowed to one step: of each vector of the state (position, velocity, ...) atol + rtol times
            its length, of the orientation rtol rad. atol is 1e-3 rtol when omitted, in SI units.
        step
            The fixed step of rk4 and gauss6, s; the first step of the others, which otherwise choose one.
        save_every, save_at
            Samples every so many s and at the end, or at given times (n,); every step when both are omitted.
        inputs
            Constant inputs (n_inputs,), or an `InputTable`; zero when omitted.
        max_steps
            Stop after so many steps, accepted and rejected.
        progress
            Called now and then with the part done, 0 to 1.
        events, outputs
            Made by `freebody.event` and `freebody.output`; see the trajectory's `events` and `outputs`.

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
            events=events,
            outputs=outputs,
        )

    def ensemble(
        self,
        x0: ArrayLike,
        dispersions: Mapping[str, Dispersion],
        *,
        n: int,
        seed: int = 0,
        sampling: Sampling = "random",
        inputs: ArrayLike | InputTable | None = None,
        events: Iterable[EventLaw] = (),
        outputs: Iterable[OutputLaw] = (),
    ) -> Ensemble:
        """n runs that differ in what is dispersed, {"mass": fb.Uniform(11.0, 14.0)}; see `Ensemble`."""
        return Ensemble(self, x0, dispersions, n, seed, sampling, inputs, events, outputs)

    def with_compiled(self, compiled: _core.Compiled) -> Model:
        """The same model with a derivative that `freebody.compile` made."""
        return type(self)._of(*self._content(), compiled=compiled)

    def linearize(self, run: Trajectory) -> Linearization:
        """The exact Jacobians A(t), B(t) at the samples of a run of this model. Konoplev (3.2)."""
        return linearize(self, run)

    def _content(self) -> tuple[Any, ...]:
        return self.body, self.forces, self.attitude, self.form, self.control, self.name, self.environment

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, self._content()

    def __repr__(self) -> str:
        acting = ", ".join(f.name for f in self.forces) or "none"
        if self.control is not None:
            acting += f"; control: {self.control.name}"
        return f"<Model {self.name!r}: {self.body.name!r}, forces: {acting}; {self.attitude}, {self.form}>"


def _restore(*content: Any) -> Model:
    return Model._of(*content, compiled=None)
