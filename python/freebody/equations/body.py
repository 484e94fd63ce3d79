"""Bodies with symbols in them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from freebody import _check, _core
from freebody.body import RigidBody
from freebody.equations.symbols import Symbols, checked_name
from freebody.errors import InputError

__all__ = ["BodyIds", "SymbolicBody", "body_ids"]

Entry = str | float
BodyIds = tuple[list[int], bool]
_UPPER = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
_FULL = (("J_xx", "J_xy", "J_xz"), ("J_xy", "J_yy", "J_yz"), ("J_xz", "J_yz", "J_zz"))


class SymbolicBody:
    """A rigid body whose numbers are symbols, or some of them.

    What is known makes shorter equations: a mass centre on an axis, `com=(0, 0, "z_c")`; principal axes,
    `inertia_about_com=("A", "B", "C")`; a symmetric body, `inertia_about_com=("A", "A", "C")`.

    Parameters
    ----------
    mass
        A name or a number, kg.
    com
        Mass centre in body axes from the origin, (3,) of names and numbers, m.
    inertia_about_com, inertia_about_origin
        The tensor (3, 3) in body axes, symmetric, or its diagonal (3,), of names and numbers, kg m²; at most
        one of the two. Without them, all six components about the origin are symbols, J_xx and so on.

    Raises
    ------
    InputError
        A name that cannot stand in code, a tensor that is not symmetric, a mass that is not positive.
    """

    def __init__(
        self,
        mass: Entry = "m",
        com: Sequence[Entry] = ("x_c", "y_c", "z_c"),
        *,
        inertia_about_com: Sequence[Entry] | Sequence[Sequence[Entry]] | None = None,
        inertia_about_origin: Sequence[Entry] | Sequence[Sequence[Entry]] | None = None,
    ) -> None:
        if inertia_about_com is not None and inertia_about_origin is not None:
            raise InputError("inertia_about_com, inertia_about_origin: both came; give one of them")
        self.mass = _entry("mass", mass)
        if not isinstance(self.mass, str) and self.mass <= 0.0:
            raise InputError(f"mass: got {self.mass}; give a name or a positive number, kg")
        self.com = tuple(_entry("com", c) for c in _three("com", com))
        self.about_origin = inertia_about_com is None
        name = "inertia_about_origin" if self.about_origin else "inertia_about_com"
        given = inertia_about_com if inertia_about_com is not None else inertia_about_origin
        self.inertia = _tensor(name, _FULL if given is None else given)

    def __repr__(self) -> str:
        about = "inertia_about_origin" if self.about_origin else "inertia_about_com"
        return f"SymbolicBody({self.mass!r}, com={self.com!r}, {about}={self.inertia!r})"


def body_ids(body: RigidBody | SymbolicBody | None, symbols: Symbols) -> BodyIds:
    """The expressions of mass, mass centre and tensor of a body; whether the tensor is about the origin."""
    if body is None:
        body = SymbolicBody()
    if isinstance(body, SymbolicBody):
        entries = [body.mass, *body.com, *(body.inertia[i][j] for i, j in _UPPER)]
        names = list(dict.fromkeys(e for e in entries if isinstance(e, str)))
        places: dict[str, str] = {}
        for entry, unit in zip(entries, ["kg", *["m"] * 3, *["kg m^2"] * 6], strict=True):
            if isinstance(entry, str) and places.setdefault(entry, unit) != unit:
                raise InputError(
                    f"body: {entry!r} stands for both {places[entry]} and {unit}; rename one of them"
                )
        about = "origin" if body.about_origin else "mass centre"
        ids = dict(
            zip(
                names,
                symbols.group(
                    "body",
                    names,
                    [places[n] for n in names],
                    f"of the body; mass centre from the origin, tensor about the {about}, in body axes",
                ),
                strict=True,
            )
            if names
            else ()
        )
        made = [ids[e] if isinstance(e, str) else symbols.graph.constant(e) for e in entries]
        return made, body.about_origin
    if not isinstance(body, _core.RigidBody):
        raise InputError(f"body: got {_check.shown(body)}; give a freebody.RigidBody or a SymbolicBody")
    tensor = body.inertia_about_com
    numbers = [body.mass, *body.com, *(tensor[place] for place in _UPPER)]
    return [symbols.graph.constant(float(x)) for x in numbers], False


def _entry(field: str, value: Entry) -> Entry:
    return checked_name(field, value) if isinstance(value, str) else _check.number(field, value)


def _three(field: str, value: object) -> list[Entry]:
    items = list(value) if isinstance(value, Iterable) and not isinstance(value, str) else []
    if len(items) != 3:
        raise InputError(f"{field}: got {_check.shown(value)}; give three names or numbers")
    return items


def _tensor(field: str, value: object) -> tuple[tuple[Entry, ...], ...]:
    rows = _three(field, value)
    if all(isinstance(row, (str, int, float)) for row in rows):
        diagonal = [_entry(field, row) for row in rows]
        return tuple(tuple(diagonal[i] if i == j else 0.0 for j in range(3)) for i in range(3))
    tensor = tuple(tuple(_entry(field, e) for e in _three(field, row)) for row in rows)
    for i, j in _UPPER:
        if tensor[i][j] != tensor[j][i]:
            raise InputError(
                f"{field}: entry ({i + 1}, {j + 1}) is {tensor[i][j]!r} and ({j + 1}, {i + 1}) is "
                f"{tensor[j][i]!r}; a tensor of inertia is symmetric"
            )
    return tensor
