"""A run: samples of a motion with everything that can be read off them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check, _core, forms
from freebody._check import Array
from freebody.errors import InputError
from freebody.simulation.conservation import conserved
from freebody.simulation.ending import chart_changes_of, outcome_of
from freebody.simulation.outcome import ChartChange, Conserved, Outcome
from freebody.simulation.watching import Occurrence, Watched

if TYPE_CHECKING:
    import xarray

    from freebody.model import Model

__all__ = ["Trajectory"]


class Trajectory:
    """The samples of one run, n of them.

    Attributes
    ----------
    model
        What was simulated.
    t, x
        Times (n,) s and states (n, n_states), as `model.state_names` names them.
    steps, rejected_steps, evaluations
        What the integration took.
    wall_time
        s.
    """

    def __init__(
        self,
        model: Model,
        result: _core.RunResult,
        span: tuple[float, float],
        watch: Watched,
        at_start: list[float],
    ) -> None:
        self.model = model
        self.t, self.x, self.steps, self.rejected_steps, self.evaluations, self.wall_time = result.samples()
        self._told = result, span, watch, at_start

    @cached_property
    def u(self) -> Array:
        """Inputs at the samples, (n, n_inputs), as `model.input_names` names them."""
        return np.repeat(self._told[0].inputs[None], len(self), axis=0)

    @cached_property
    def outcome(self) -> Outcome:
        """How the run ended."""
        return outcome_of(self.model, *self._told)

    @cached_property
    def chart_changes(self) -> tuple[ChartChange, ...]:
        """When a run in angles went on in another chart, and when it came back."""
        return chart_changes_of(self.model, self._told[0])

    @cached_property
    def events(self) -> tuple[Occurrence, ...]:
        """The events that came to pass, in the order of their times."""
        result, _, watch, _ = self._told
        return watch.occurrences(result)

    @cached_property
    def outputs(self) -> Mapping[str, float]:
        """The outputs by name."""
        result, _, watch, _ = self._told
        return watch.values(result)

    @cached_property
    def output_units(self) -> Mapping[str, str]:
        """Units of the outputs by name."""
        return self._told[2].output_units

    @property
    def ok(self) -> bool:
        """Whether the run reached its end, or an event that ends it."""
        return self.outcome.ok

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the columns of `x`."""
        return self.model.state_names

    @property
    def state_units(self) -> tuple[str, ...]:
        """Units of the columns of `x`."""
        return self.model.state_units

    @property
    def states(self) -> Mapping[str, Array]:
        """The auxiliary states by name, (n,) each, in the units of the model."""
        return {name: self.x[:, place] for name, place in self.model.auxiliary.items()}

    @cached_property
    def commands(self) -> Mapping[str, Array]:
        """What the control law commanded, by the names of the inputs, (n,) each, in their units."""
        columns = self.model.commands(*self._at).T
        return dict(zip(self.model.command_names, columns, strict=True))

    @cached_property
    def _motion(self) -> tuple[Array, Array, Array]:
        position, quaternion, twist = self.model.motion(self.x)
        # A quaternion and its opposite are one attitude; neighbours are kept on one side.
        flips = np.where(np.sum(quaternion[1:] * quaternion[:-1], axis=1) < 0.0, -1.0, 1.0)
        quaternion[1:] *= np.cumprod(flips)[:, None]
        return position, quaternion, twist

    @property
    def position_world(self) -> Array:
        """Position of the body origin, world axes, (n, 3) m."""
        return self._motion[0]

    @property
    def quaternion(self) -> Array:
        """Attitude as unit quaternions (w, x, y, z), world from body, (n, 4); continuous in sign."""
        return self._motion[1]

    @cached_property
    def world_from_body(self) -> Array:
        """Attitude as rotation matrices, (n, 3, 3)."""
        # A run that ended before its first sample has none.
        return forms.rotation_from_quaternion(self.quaternion) if len(self) else np.empty((0, 3, 3))

    def angles(self, sequence: str | None = None) -> Array:
        """Attitude as angles of a sequence, (n, 3) rad; by default that of the model.

        In the model's own sequence these are the angles of the state, which go on through a singularity. In
        any other the second angle lies in [0, π] (proper Euler) or [-π/2, π/2] (Tait-Bryan).
        """
        own = self.model.attitude
        if sequence is None and own == "quaternion":
            raise InputError(f"sequence: give one of {', '.join(_check.SEQUENCES)}; the model has no angles")
        wanted = own if sequence is None else _check.sequence(sequence, "sequence")
        if wanted == own:
            return self.x[:, 3:6]
        return forms.angles_from_rotation(self.world_from_body, wanted) if len(self) else np.empty((0, 3))

    @property
    def velocity_body(self) -> Array:
        """Velocity of the body origin, body axes, (n, 3) m/s."""
        return self._motion[2][:, :3]

    @property
    def angular_velocity_body(self) -> Array:
        """Angular velocity, body axes, (n, 3) rad/s."""
        return self._motion[2][:, 3:]

    @cached_property
    def velocity_world(self) -> Array:
        """Velocity of the body origin, world axes, (n, 3) m/s."""
        return self._to_world(self.velocity_body)

    @cached_property
    def angular_velocity_world(self) -> Array:
        """Angular velocity, world axes, (n, 3) rad/s."""
        return self._to_world(self.angular_velocity_body)

    def point(self, point: ArrayLike) -> Array:
        """Path (n, 3) m, world axes, of the material point at `point` (3,) m, body axes from the origin."""
        return self.position_world + self.world_from_body @ _check.vector("point", point, 3)

    @cached_property
    def com_position_world(self) -> Array:
        """Position of the mass centre, world axes, (n, 3) m."""
        return self.position_world + (self.world_from_body @ self.com[:, :, None])[:, :, 0]

    @cached_property
    def com_velocity_world(self) -> Array:
        """Velocity of the material point at the mass centre, world axes, (n, 3) m/s."""
        return self._to_world(self.velocity_body + np.cross(self.angular_velocity_body, self.com))

    @cached_property
    def _inertias(self) -> Array:
        return self.model.inertias(*self._at)

    @property
    def mass(self) -> Array:
        """Of the body with what it carries, (n,) kg."""
        return self._inertias[:, 0]

    @property
    def com(self) -> Array:
        """Its mass centre from the body origin, body axes, (n, 3) m."""
        return self._inertias[:, 1:4]

    @cached_property
    def inertia_about_com(self) -> Array:
        """Its inertia about the mass centre, body axes, (n, 3, 3) kg m²."""
        return self._inertias[:, [4, 5, 6, 5, 7, 8, 6, 8, 9]].reshape(-1, 3, 3)

    @property
    def _at(self) -> tuple[Array, Array, Array]:
        return self.t, self.x, np.ascontiguousarray(self.u)

    @cached_property
    def _energies(self) -> tuple[Array, Array]:
        return self.model.energies(*self._at)

    @property
    def kinetic_energy(self) -> Array:
        """½ VᵀΘV of the body with what it carries and with its wheels, (n,) J; without a fluid's."""
        return self._energies[0]

    @property
    def potential_energy(self) -> Array:
        """Of the forces that have a potential, (n,) J."""
        return self._energies[1]

    @property
    def energy(self) -> Array:
        """Kinetic and potential energy, (n,) J."""
        return self.kinetic_energy + self.potential_energy

    @cached_property
    def momentum_world(self) -> Array:
        """Momentum Z⁰ = LΘV about the world origin, world axes, (n, 6) kg m/s and kg m²/s. Konoplev (1.5).

        Of the body with what it carries and with its wheels, without a fluid's.
        """
        return self.model.momenta(*self._at)

    @cached_property
    def singularity_distance(self) -> Array | None:
        """Distance of the second angle to its nearest singular value, (n,) rad; None without angles."""
        return self.model.singularity_distances(self.x)

    def conserved(self) -> list[Conserved]:
        """The quantities that this model keeps, with how well the run kept them."""
        return conserved(self)

    def to_xarray(self) -> xarray.Dataset:
        """The motion, what is read off it and the inputs as a labelled dataset with units (extra `data`)."""
        from freebody.results import to_dataset  # noqa: PLC0415  (an extra: only who asks needs xarray)

        return to_dataset(self)

    def _to_world(self, vectors: Array) -> Array:
        return np.einsum("nij,nj->ni", self.world_from_body, vectors)

    def __getstate__(self) -> dict[str, object]:
        # What the core keeps of the run stays in this process: it is read first.
        for name in ("u", "outcome", "chart_changes", "events", "outputs", "output_units"):
            getattr(self, name)
        return {name: value for name, value in vars(self).items() if name != "_told"}

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        return f"<Trajectory of {self.model.name!r}: {len(self)} samples, {self.outcome.status}>"
