"""What of a model can be dispersed: names, units, nominal values, and what they can be."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freebody._check import Array, shown
from freebody.body import RigidBody
from freebody.ensembles.law_parameters import XYZ, LawParameter, parameters, shared_name
from freebody.ensembles.mass_properties import LOG_CHOLESKY, log_cholesky, principal
from freebody.ensembles.start import Start
from freebody.errors import InputError

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Target", "check_together", "quantities", "wanted"]


@dataclass(frozen=True)
class Target:
    """A quantity of a model, k numbers.

    Attributes
    ----------
    name, components
        What it is called; its components where it has several.
    units, nominal
        k each.
    positive
        Whether it must be.
    relative
        Whether its values are in themselves changes of something else, so that zero is nominal.
    owner
        What it belongs to, as messages say it.
    places
        The laws that it belongs to, by their places among those that act, -1 for the control law; which
        parameter of each it is.
    """

    name: str
    components: tuple[str, ...]
    units: tuple[str, ...]
    nominal: Array
    positive: bool = False
    relative: bool = False
    owner: str = "the body"
    places: tuple[tuple[int, LawParameter], ...] = ()

    @property
    def size(self) -> int:
        """How many numbers it has."""
        return len(self.nominal)

    @property
    def columns(self) -> tuple[str, ...]:
        """A name for each of its numbers."""
        return tuple(f"{self.name}_{c}" for c in self.components) if self.components else (self.name,)


def quantities(model: Model, start: Start, inputs: Array | None) -> Iterator[Target]:
    """Everything of a model that can be dispersed.

    `inputs` are the nominal ones (n_inputs,); None where a table has them, to which draws are added.
    """
    yield from _motion(start)
    for name, place in model.auxiliary.items():
        law = name.partition(".")[0]
        unit, nominal = model.state_units[place], start.x0[place : place + 1]
        yield Target(name, (), (unit,), nominal, owner=f"the states of {law!r}")
    for i, (name, unit) in enumerate(zip(model.input_names, model.input_units, strict=True)):
        nominal = np.zeros(1) if inputs is None else inputs[i : i + 1]
        yield Target(name, (), (unit,), nominal, relative=inputs is None, owner="the inputs")
    yield from _body(model)
    laws = [*enumerate(model.forces), *([] if model.control is None else [(-1, model.control)])]
    shared: dict[tuple[str, str, float], list[tuple[int, LawParameter]]] = {}
    for place, law in laws:
        for p in parameters(law):
            if p.shared:
                key = (p.attribute, p.units[0], float(p.nominal[0]))
                shared.setdefault(key, []).append((place, p))
                continue
            name = f"{law.name}.{p.attribute}"
            owner = _owner(place)
            yield Target(
                name, p.components, p.units, p.nominal, p.positive, owner=owner, places=((place, p),)
            )
    for places in shared.values():
        _, p = places[0]
        owner = f"the environment of {', '.join(_owner(place) for place, _ in places)}"
        yield Target(shared_name(p.attribute), (), p.units, p.nominal, owner=owner, places=tuple(places))


def _owner(place: int) -> str:
    return "the control law" if place < 0 else f"forces[{place}]"


def _motion(start: Start) -> Iterator[Target]:
    for name, unit in (
        ("position", "m"),
        ("velocity_body", "m/s"),
        ("velocity_world", "m/s"),
        ("angular_velocity_body", "rad/s"),
        ("angular_velocity_world", "rad/s"),
    ):
        yield Target(name, XYZ, (unit,) * 3, start.nominal[name])
    yield Target("attitude", XYZ, ("rad",) * 3, np.zeros(3), relative=True)


def _body(model: Model) -> Iterator[Target]:
    body = model.body
    yield Target("mass", (), ("kg",), np.array([body.mass]), positive=True)
    yield Target("com", XYZ, ("m",) * 3, body.com)
    yield Target("inertia", (), ("1",), np.ones(1), positive=True)
    moments, _ = principal(body)
    yield Target("second_moments", XYZ, ("kg m^2",) * 3, moments, positive=True)
    yield Target("principal_axes", XYZ, ("rad",) * 3, np.zeros(3), relative=True)
    units = ("1",) * 4 + ("m",) * 6
    yield Target("log_cholesky", LOG_CHOLESKY, units, np.zeros(10), relative=True)


def wanted(name: object, known: list[Target]) -> Target:
    """The quantity of a name."""
    found = [target for target in known if target.name == name]
    if not found:
        names = sorted({target.name for target in known})
        near = difflib.get_close_matches(str(name), names, 1)
        hint = f"did you mean {near[0]!r}? " if near else ""
        raise InputError(
            f"dispersions: got {shown(name)}; {hint}this model has {', '.join(map(repr, names))}"
        )
    if len(found) > 1:
        raise InputError(
            f"dispersions[{name!r}]: it belongs to {' and to '.join(t.owner for t in found)}; give each law "
            'its own name, name="..." when it is made, and each of its quantities'
        )
    return found[0]


_APART = (
    ("velocity_body", "velocity_world"),
    ("angular_velocity_body", "angular_velocity_world"),
    *(("log_cholesky", name) for name in ("mass", "com", "inertia", "second_moments", "principal_axes")),
)


def check_together(body: RigidBody, names: Mapping[str, object]) -> None:
    """Refuse two descriptions of one thing, and one that a body does not have."""
    if "log_cholesky" in names:
        log_cholesky(body)
    for one, other in _APART:
        if one in names and other in names:
            raise InputError(f"dispersions: {one!r} and {other!r} describe the same; give one of them")
