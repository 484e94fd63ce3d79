"""Models: a body, its forces, and how the state is written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
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
from freebody.simulation import InputTable, Trajectory, notices_of, simulate
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
    notices
        What its forces and surroundings have to say when it comes to pass, with the name of who says it.
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
    notices: tuple[tuple[str, EventLaw], ...]

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
        self.notices = notices_of(given, environment)
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

    simulate = simulate

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
