"""The variables that a form asks for, each made when it is first asked for."""

from __future__ import annotations

from functools import cached_property

from freebody import _core
from freebody.body import RigidBody
from freebody.equations.body import BodyIds, SymbolicBody, body_ids
from freebody.equations.result import Result
from freebody.equations.symbols import Group, Symbols, angle_names
from freebody.errors import InputError
from freebody.forces import Force
from freebody.model import Model
from freebody.signals import reads_inputs
from freebody.tracing import Callback

__all__ = ["Variables"]

_ORDER = (
    "t",
    "x",
    "position",
    "quaternion",
    "alpha",
    "alpha_dot",
    "q",
    "q_dot",
    "q_ddot",
    "twist",
    "twist_rate",
)
_WRENCH = ("F_x", "F_y", "F_z", "M_x", "M_y", "M_z")
_XYZ = ("x", "y", "z")
_ANY_BODY = RigidBody(1.0, inertia_about_com=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))


class Variables:
    """Expressions of the variables of a form, on one graph."""

    def __init__(
        self,
        graph: _core.Graph,
        angles: str | None,
        body: RigidBody | SymbolicBody | None,
        forces: tuple[Force, ...] | None,
        whole: Model | None,
        simplify: bool,
    ) -> None:
        self.graph, self.simplify = graph, simplify
        self.symbols = Symbols(graph)
        self._state_space = False
        self._angles, self._body, self._forces, self._whole = angles, body, forces, whole

    @property
    def angles(self) -> str:
        """The angle sequence."""
        assert self._angles is not None
        return self._angles

    @property
    def attitude(self) -> str:
        """The chart of a model."""
        return self._angles or "quaternion"

    @cached_property
    def names(self) -> list[str]:
        """Names of the angles."""
        return angle_names(self.angles)

    @cached_property
    def body(self) -> BodyIds:
        """The body's ten expressions."""
        return body_ids(self._body, self.symbols)

    @cached_property
    def q(self) -> list[int]:
        """Generalized coordinates (o; alpha). Konoplev (2.1)"""
        return self._coordinates("q", "", "", "position of the body origin, world axes, and the angles")

    @cached_property
    def q_dot(self) -> list[int]:
        """Their rates."""
        return self._coordinates("q_dot", "_dot", "/s", "rates of q")

    @cached_property
    def q_ddot(self) -> list[int]:
        """Their second rates."""
        return self._coordinates("q_ddot", "_ddot", "/s^2", "second rates of q")

    @cached_property
    def alpha(self) -> list[int]:
        """The angles alone."""
        return self.symbols.group("alpha", self.names, ["rad"] * 3, f"angles of the sequence {self.angles}")

    @cached_property
    def alpha_dot(self) -> list[int]:
        """Their rates."""
        return self.symbols.group(
            "alpha_dot", [f"{n}_dot" for n in self.names], ["rad/s"] * 3, "rates of alpha"
        )

    @cached_property
    def twist(self) -> list[int]:
        """Quasi-velocities V = (v; omega). Konoplev (1.10)"""
        names = [f"{stem}_{a}" for stem in ("v", "omega") for a in _XYZ]
        meaning = "velocity of the body origin and angular velocity, body axes"
        return self.symbols.group("twist", names, ["m/s"] * 3 + ["rad/s"] * 3, meaning)

    @cached_property
    def twist_rate(self) -> list[int]:
        """V*, the derivative of its components in the body frame."""
        names = [f"{stem}_{a}_dot" for stem in ("v", "omega") for a in _XYZ]
        meaning = "rates of the components of the twist in body axes"
        return self.symbols.group("twist_rate", names, ["m/s^2"] * 3 + ["rad/s^2"] * 3, meaning)

    @cached_property
    def position(self) -> list[int]:
        """Position of the body origin."""
        return self.symbols.group("position", _XYZ, ["m"] * 3, "of the body origin, world axes")

    @cached_property
    def time(self) -> int:
        """Time."""
        return self.symbols.group("t", ["t"], ["s"], "time", scalar=True)[0]

    def of_wrench(self) -> list[int]:
        """The wrench of a form in quasi-velocities."""
        return self._wrench(generalized=False)

    def of_generalized_wrench(self) -> list[int]:
        """The wrench of a form in generalized coordinates."""
        return self._wrench(generalized=True)

    def form(self, name: str, *arguments: list[int], angles: bool = False, body: bool = False) -> list[int]:
        """A form of the catalogue."""
        return self.graph.form(
            name, self.angles if angles else None, self.body if body else None, list(arguments)
        )

    def ordered_groups(self, results: list[Result]) -> list[Group]:
        """The groups as arguments of a function: variables, then controls, then the body.

        What only forces could have asked for, and none did, is left out, and what of the body plays no part.
        """
        used = set(self.graph.symbols_in([i for r in results for i in r.ids]))
        optional = () if self._state_space else ("t", "position", "quaternion", "alpha", "u", "states")
        groups = [g.only(used) if g.name == "body" else g for g in self.symbols.groups]
        groups = [g for g in groups if g.name not in (*optional, "body") or used & set(g.ids)]
        order = {name: i for i, name in enumerate(_ORDER)}
        last = {"body": 2}
        return sorted(groups, key=lambda g: (last.get(g.name, 0), order.get(g.name, len(_ORDER))))

    def model(self, attitude: str) -> Model:
        """The forces as a model, about whatever body; the expressions of the body replace it."""
        for force in self._forces or ():
            if isinstance(force, Callback):
                raise InputError(
                    f"forces: {force.name!r} is a callback, which is no expression; trace it with @fb.force"
                )
        if self._whole is not None:
            return self._whole
        return Model(
            self._body if isinstance(self._body, RigidBody) else _ANY_BODY, self._forces or (), attitude
        )

    def state_symbols(self, model: Model) -> list[str]:
        """Names of the state of a model as the other forms call them; all arguments of (3.2) stay."""
        self._state_space = True
        angles = [] if model.attitude == "quaternion" else angle_names(model.attitude)
        known = {f"angle_{i + 1}": n for i, n in enumerate(angles)}
        known |= {f"angle_rate_{i + 1}": f"{n}_dot" for i, n in enumerate(angles)}
        known |= {f"quaternion_{c}": f"eta_{c}" for c in "wxyz"}
        known |= {f"quaternion_rate_{c}": f"eta_{c}_dot" for c in "wxyz"}
        for a in _XYZ:
            known |= {f"position_{a}": a, f"position_rate_{a}": f"{a}_dot"}
            known |= {f"velocity_{a}": f"v_{a}", f"angular_velocity_{a}": f"omega_{a}"}
        return [known.get(n, n) for n in model.state_names]

    def inputs(self, model: Model) -> list[int]:
        """The inputs that the forces of a model read."""
        if not model.input_names:
            return []
        return self.symbols.named_by_users("u", model.input_names, model.input_units, "inputs of the forces")

    def _coordinates(self, name: str, ending: str, per: str, meaning: str) -> list[int]:
        names = [f"{n}{ending}" for n in (*_XYZ, *self.names)]
        return self.symbols.group(name, names, [f"m{per}"] * 3 + [f"rad{per}"] * 3, meaning)

    def _wrench(self, *, generalized: bool) -> list[int]:
        if self._forces is None:
            meaning = "force and moment about the body origin, body axes"
            return self.symbols.group("wrench", _WRENCH, ["N"] * 3 + ["N m"] * 3, meaning)
        if generalized:
            rotation = self.form("rotation", self.q[3:], angles=True)
            situation = [*self.q[:3], *rotation, *self.form("twist", self.q, self.q_dot, angles=True)]
        else:
            situation = [*self.position, *self.rotation, *self.twist]
        model = self.model("quaternion")
        # A model whose forces read nothing has an applied wrench of its own, which is none of these forces.
        read = reads_inputs(model.forces)
        zero = self.graph.constant(0.0)
        u = self.inputs(model) if read else [zero] * len(model.input_names)
        own = slice(13, None)  # behind the rigid body's thirteen
        names, units = model.state_names[own], model.state_units[own]
        states = self.symbols.named_by_users("states", names, units, "of the forces") if names else []
        return self.graph.wrench(model, self.body, self.time, situation, u, states)

    @cached_property
    def rotation(self) -> list[int]:
        """The rotation matrix where no form but forces ask for the orientation."""
        if self._angles in (None, "quaternion"):
            names = [f"eta_{c}" for c in "wxyz"]
            meaning = "unit quaternion, world from body"
            quaternion = self.symbols.group("quaternion", names, ["1"] * 4, meaning)
            return self.form("rotation_from_unit_quaternion", quaternion)
        return self.form("rotation", self.alpha, angles=True)
