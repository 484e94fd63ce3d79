"""Forces computed by Python at every step: for code that cannot be traced."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from freebody import _check, _core
from freebody._check import Array
from freebody.errors import InputError, NonFiniteError
from freebody.forces import Force
from freebody.tracing.declaration import declared_inputs
from freebody.tracing.situation import LAYOUT, N_GIVEN, Names, Situation
from freebody.tracing.wrench import Wrench

__all__ = ["Callback", "callback"]


class Callback(Force):
    """A force computed by a Python function; see `callback`, which makes them."""

    def __init__(
        self, function: Callable[[Situation], Any], inputs: Mapping[str, str] | None, name: str | None
    ) -> None:
        if not callable(function):
            raise InputError(f"function: got {_check.shown(function)}; give a function of the situations s")
        super().__init__(getattr(function, "__name__", type(function).__name__) if name is None else name)
        self.function = function
        self.inputs = declared_inputs(self.name, inputs)

    def core(self) -> _core.Force:
        return _core.Force.callback(self._wrenches, len(self.inputs))

    def _wrenches(self, given: Array) -> Array:
        """Wrenches (6, n) of n situations, whose numbers stand in the columns of (23 + inputs, n)."""
        n = given.shape[1]
        returned = self.function(self._situations(np.array(given.T)))
        try:
            array = np.asarray(returned, float)
        except Exception as wrong:
            raise InputError(
                f"{self.name}: the callback returned {_check.shown(returned)}, which is no array of numbers "
                f"({wrong}); return fb.wrench(...) or an array of shape ({n}, 6)"
            ) from wrong
        if isinstance(returned, Wrench) and array.shape == (6,):
            array = np.broadcast_to(array, (n, 6))
        if array.shape != (n, 6):
            raise InputError(
                f"{self.name}: the callback returned shape {array.shape}; for {n} situations it must return "
                f"fb.wrench of arrays ({n}, 3), or an array ({n}, 6)"
            )
        wrong = np.argwhere(~np.isfinite(array))
        if wrong.size:
            i, j = (int(k) for k in wrong[0])
            raise NonFiniteError(
                f"{self.name}: the callback returned {array[i, j]} as component {j} of wrench {i}, at time "
                f"{given[0, i]} s"
            )
        return np.ascontiguousarray(array.T)

    def _situations(self, rows: Array) -> Situation:
        values: dict[str, Array] = {}
        start = 0
        for name, shape, _ in LAYOUT:
            end = start + int(np.prod(shape))
            values[name] = rows[:, start:end].reshape(len(rows), *shape)
            start = end
        rows.flags.writeable = False
        inputs = {q.name: rows[:, N_GIVEN + i] for i, q in enumerate(self.inputs)}
        return Situation(values, Names("input", inputs), Names("state", {}))


def callback(
    function: Callable[[Situation], Any], *, inputs: Mapping[str, str] | None = None, name: str | None = None
) -> Callback:
    """A force from a Python function that cannot be traced: other libraries, `if`, tables on disk.

    Slow, for Python runs at every stage of every step, once for all motions of a batch; a model with one has
    no Jacobian and no equations. Prefer `fb.force`.

    Parameters
    ----------
    function
        Takes the situations `s` of n motions, what `fb.force` has with one axis in front: `s.time` (n,),
        `s.twist` (n, 6), `s.world_from_body` (n, 3, 3), `s.inputs.rudder` (n,). Returns `fb.wrench` of
        arrays (n, 3), or the wrenches about the body origin in body axes, (n, 6).
    inputs
        Name: unit, of what it reads from u.
    name
        The function's, when omitted.

    Raises
    ------
    InputError
        While it runs: what the function returned has another shape.
    NonFiniteError
        While it runs: what the function returned is not finite.
    """
    return Callback(function, inputs, name)
