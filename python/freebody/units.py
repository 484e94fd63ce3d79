"""Units of laws. Inside a law everything is SI, so that a unit is declared in SI and its factor is one.

`dimension` reads such units itself: symbols of SI joined by spaces, `*`, `/`, with whole powers, `"N s/m"`,
`"kg m^2"`, `"1"`; `/` counts for the one symbol or bracket behind it. Values in other units are typed as
strings, `"0.3 ft^2"`, and are read with pint (extra `cli`).
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import TypeAlias

from freebody import _check
from freebody.errors import InputError

__all__ = [
    "DIMENSIONLESS",
    "Dimension",
    "agree",
    "dimension",
    "over_time",
    "scaled",
    "text_of",
    "times",
    "to_si",
]

Dimension: TypeAlias = tuple[Fraction, ...]
"""Powers of kg, m, s, A, K, mol, cd."""

_BASE = ("kg", "m", "s", "A", "K", "mol", "cd")


def _powers(*powers: int) -> Dimension:
    return tuple(Fraction(p) for p in (*powers, *(0,) * (len(_BASE) - len(powers))))


DIMENSIONLESS = _powers()
_SYMBOLS = {symbol: _powers(*(int(i == j) for j in range(7))) for i, symbol in enumerate(_BASE)} | {
    "1": DIMENSIONLESS,
    "rad": DIMENSIONLESS,
    "sr": DIMENSIONLESS,
    "N": _powers(1, 1, -2),
    "Pa": _powers(1, -1, -2),
    "J": _powers(1, 2, -2),
    "W": _powers(1, 2, -3),
    "C": _powers(0, 0, 1, 1),
    "V": _powers(1, 2, -3, -1),
    "F": _powers(-1, -2, 4, 2),
    "ohm": _powers(1, 2, -3, -2),
    "Wb": _powers(1, 2, -2, -1),
    "T": _powers(1, 0, -2, -1),
    "H": _powers(1, 2, -2, -2),
}
_NAMED = {_SYMBOLS["N"]: "N", _SYMBOLS["J"]: "N m", _SYMBOLS["Pa"]: "Pa", _SYMBOLS["W"]: "W"}
_TOKEN = re.compile(r"\s*(?:(\*\*|\^)\s*([-+]?\d+)|([A-Za-z]+|1)|([*/()·]))")
_NUMBER_AND_UNIT = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*", re.DOTALL)


def times(a: Dimension, b: Dimension, power: int = 1) -> Dimension:
    """a b^power."""
    return tuple(x + power * y for x, y in zip(a, b, strict=True))


def scaled(a: Dimension, power: Fraction) -> Dimension:
    """a^power."""
    return tuple(x * power for x in a)


def over_time(a: Dimension) -> Dimension:
    """a/s."""
    return times(a, _SYMBOLS["s"], -1)


def dimension(name: str, unit: str) -> Dimension:
    """What a unit of SI measures; `name` is how the error calls it."""
    if not isinstance(unit, str):
        raise InputError(
            f'{name}: got {_check.shown(unit)}; give its unit as a string, such as "N s/m" or "1"'
        )
    tokens, at = [], 0
    while at < len(unit.rstrip()):
        match = _TOKEN.match(unit, at)
        if match is None:
            raise _unreadable(name, unit, f"{unit[at:].strip()!r} is no symbol")
        tokens.append(match)
        at = match.end()
    found, rest = _product(name, unit, tokens)
    if rest:
        raise _unreadable(name, unit, "a bracket is closed that was not opened")
    return found


def _product(name: str, unit: str, tokens: list[re.Match[str]]) -> tuple[Dimension, list[re.Match[str]]]:
    product, sign, count = DIMENSIONLESS, 1, 0
    while tokens and tokens[0][4] != ")":
        token, *tokens = tokens
        if token[4] in ("*", "·", "/"):
            if count == 0 or not tokens or tokens[0][4] in ("*", "·", "/", ")"):
                raise _unreadable(name, unit, f"{token[4]!r} stands without a symbol beside it")
            sign = -1 if token[4] == "/" else 1
            continue
        if token[4] == "(":
            factor, tokens = _product(name, unit, tokens)
            if not tokens:
                raise _unreadable(name, unit, "a bracket is not closed")
            tokens = tokens[1:]
        elif token[3] in _SYMBOLS:
            factor = _SYMBOLS[token[3]]
        elif token[3]:
            raise _unreadable(name, unit, f"{token[3]!r} is none of its symbols here")
        else:
            raise _unreadable(name, unit, "a power stands without a symbol before it")
        power = 1
        if tokens and tokens[0][2]:
            power, tokens = int(tokens[0][2]), tokens[1:]
        product, sign, count = times(product, factor, sign * power), 1, count + 1
    if count == 0:
        raise _unreadable(name, unit, 'a number without unit has the unit "1"')
    return product, tokens


def _unreadable(name: str, unit: str, why: str) -> InputError:
    return InputError(
        f"{name}: cannot use the unit {unit!r}: {why}; inside a law everything is SI: declare the unit with "
        f'{", ".join(_SYMBOLS)} and write values in other units as strings, such as "5 deg"'
    )


def text_of(a: Dimension) -> str:
    """The unit of SI in which a dimension is measured."""
    if a in _NAMED:
        return _NAMED[a]
    above = " ".join(_symbol(s, p) for s, p in zip(_BASE, a, strict=True) if p > 0)
    below = "/".join(_symbol(s, -p) for s, p in zip(_BASE, a, strict=True) if p < 0)
    return (above or "1") + (f"/{below}" if below else "")


def _symbol(symbol: str, power: Fraction) -> str:
    if power == 1:
        return symbol
    return f"{symbol}^{power}" if power.denominator == 1 else f"{symbol}^({power})"


def agree(a: str, b: str) -> bool:
    """Whether two units measure the same; "" is a unit that is not known and agrees with all."""
    return "" in (a, b) or dimension("unit", a) == dimension("unit", b)


def to_si(name: str, value: float | str, unit: str) -> float:
    """A number in the unit of SI `unit`, or a string of a number and any unit of the same kind."""
    if not isinstance(value, str):
        return _check.number(name, value)
    match = _NUMBER_AND_UNIT.fullmatch(value)
    if match is None or not match[2]:
        raise InputError(
            f"{name}: got {value!r}; give a number, or a string of a number and a unit of {unit!r}"
        )
    number, given = float(match[1]), match[2]
    return _check.number(name, number * _factor(name, given, unit))


def _factor(name: str, given: str, unit: str) -> float:
    try:
        known = dimension(name, given)
    except InputError:
        known = None
    if known is None:
        return _factor_of_pint(name, given, unit)
    if known != dimension(name, unit):
        raise _another(name, given, unit)
    return 1.0


def _factor_of_pint(name: str, given: str, unit: str) -> float:
    try:
        import pint  # noqa: PLC0415  (an extra, and slow to load: only who types other units needs it)
    except ImportError:
        raise InputError(
            f"{name}: the unit {given!r} needs pint: pip install 'freebody[cli]'; or give {unit!r}"
        ) from None
    registry = pint.get_application_registry()
    try:
        one = registry.Quantity(1.0, registry.parse_units(given))
        base = one.to_base_units()
        zero = registry.Quantity(0.0, registry.parse_units(given)).to_base_units()
    except Exception:  # pint's parser raises what its tokenizer does
        raise InputError(f"{name}: cannot read the unit {given!r}; give {unit!r}") from None
    # Base units rather than dimensions are compared: pint counts an angle as dimensionless, so Hz would pass.
    if base.units != registry.Quantity(1.0, registry.parse_units(unit)).to_base_units().units:
        raise _another(name, given, unit)
    if zero.magnitude != 0.0:
        raise InputError(f"{name}: {given!r} has another zero than SI; give {unit!r}")
    return float(base.magnitude)


def _another(name: str, given: str, unit: str) -> InputError:
    return InputError(f"{name}: {given!r} does not measure what {unit!r} does; give {unit!r}")
