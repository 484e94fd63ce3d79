"""From a form's number to its scalar equations."""

from __future__ import annotations

from collections.abc import Iterable

from freebody import _check, _core
from freebody.body import RigidBody
from freebody.equations.body import SymbolicBody
from freebody.equations.forms import FORMS, MATRICES
from freebody.equations.result import Equations
from freebody.equations.variables import Variables
from freebody.errors import InputError
from freebody.forces import Force, checked_forces
from freebody.model import Model

__all__ = ["equations"]


def equations(
    form: str = "2.10",
    angles: str | None = None,
    body: RigidBody | SymbolicBody | None = None,
    forces: Iterable[Force] | None = None,
    *,
    model: Model | None = None,
    simplify: bool = True,
    expand_angles: bool = False,
) -> Equations:
    """Scalar equations of one of the paper's forms, by plain multiplication of its matrices.

    Parameters
    ----------
    form
        "1.8", "1.11" in quasi-velocities; "2.4", "2.7", "2.8", "2.9", "2.10" in generalized coordinates;
        "2.11", "2.12"; "2.13" rotation about the mass centre; "3.1" phase space, "3.2" phase space in
        quasi-velocities with forces and a control. Or one matrix by the name that it has in `freebody.forms`:
        "D", "M0", "A1", "Phi1", "A", "B", "christoffel_symbols", and so on.
    angles
        One of the twelve sequences; "quaternion" where only forces or (3.2) ask for the orientation (the
        default there).
    body
        A RigidBody (numbers), a SymbolicBody (symbols and numbers), or None: all symbols.
    forces
        Force elements that make the wrench; without them it is six symbols.
    model
        A model whose attitude, body and forces stand for those that are not given; (3.2) is its f(x, u, t),
        with its kind of velocity, its auxiliary states and its control law.
    simplify
        Write equal expressions as one, and each form by the shortest way that is known: by blocks instead of
        full matrices. False multiplies the matrices as they stand.

    expand_angles
        Write sine and cosine of a sum, which forces may bring, in those of its terms.

    Raises
    ------
    InputError
        An unknown form or sequence; a force that cannot be written as an expression.
    """
    allowed = (*FORMS, *MATRICES)
    _check.choice("form", form, allowed)
    _check.flag("simplify", simplify)
    _check.flag("expand_angles", expand_angles)
    entry = FORMS.get(form) or MATRICES[form]
    given_forces = forces
    if model is not None and not isinstance(model, Model):
        raise InputError(f"model: got {_check.shown(model)}; give a freebody.Model")
    if model is not None:
        angles = model.attitude if angles is None else angles
        body = model.body if body is None else body
        whole = form == "3.2" and forces is None and angles == model.attitude
        forces = model.forces if forces is None else forces
        model = model if whole else None
    if entry.needs_angles:
        if angles is None or angles == "quaternion":
            raise InputError(
                f"angles: got {angles!r}; form {form} needs one of {', '.join(_check.SEQUENCES)}"
            )
        _check.sequence(angles)
    elif angles is not None:
        _check.choice("angles", angles, ("quaternion", *_check.SEQUENCES))
    if not entry.takes_forces and given_forces is not None:
        raise InputError(f"forces: form {form} has no wrench in it; leave them out")
    if form != "3.2":
        _refuse_left_side(form, forces)
    variables = Variables(
        _core.Graph(simplify, expand_angles),
        angles,
        body,
        None if forces is None else checked_forces(forces),
        model,
        simplify,
    )
    if form in FORMS:
        _ = variables.body  # its symbols come first, and so they stand first in products
    results, balance = entry.make(variables)
    in_angles = f", angles {angles}" if entry.needs_angles else ""
    title = f"Konoplev {entry.title}{in_angles}"
    return Equations(variables.graph, form, title, variables.ordered_groups(results), results, balance)


def _refuse_left_side(form: str, forces: Iterable[Force] | None) -> None:
    for force in forces or ():
        if isinstance(force, Force) and (force.added_mass is not None or force.spins or force.contents):
            raise InputError(
                f"form: {form} is that of a body alone, and force {force.name!r} brings added mass, wheels "
                'or contents; give the model with form="3.2", which has them'
            )
