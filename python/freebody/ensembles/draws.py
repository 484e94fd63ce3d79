"""From dispersions to what each run starts from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freebody import _check
from freebody._check import Array
from freebody.ensembles.dispersion import Dispersed, Dispersion
from freebody.ensembles.law_parameters import LawParameter
from freebody.ensembles.mass_properties import Bodies, bodies
from freebody.ensembles.quantities import Target, check_together, quantities, wanted
from freebody.ensembles.sampling import Design, Sampling
from freebody.ensembles.start import Start
from freebody.errors import InputError
from freebody.simulation import InputTable
from freebody.simulation.inputs import checked_inputs

if TYPE_CHECKING:
    from freebody.model import Model

__all__ = ["Draw", "Draws"]


class Draw(NamedTuple):
    """What some runs of an ensemble start from, as the core takes it.

    Attributes
    ----------
    x0
        (count, n_states), in the chart of the model.
    bodies
        Mass properties, where they are dispersed.
    parameters
        Places (m,) among the parameters of the laws and values (count, m), where they are dispersed.
    inputs
        Constant inputs, or what is added to their table, (count or 1, n_inputs).
    dispersed
        The dispersed values, (count, len(names)).
    """

    x0: Array
    bodies: Bodies | None
    parameters: tuple[NDArray[np.int64], Array] | None
    inputs: Array
    dispersed: Array


class Draws:
    """The draws of all runs of an ensemble, by their numbers.

    Attributes
    ----------
    targets
        What is dispersed.
    design
        Where the runs stand in the unit hypercube.
    x0
        The state from which those of the runs depart.
    constant, table
        The inputs that all runs have.
    """

    def __init__(
        self,
        model: Model,
        x0: ArrayLike,
        dispersions: Mapping[str, Dispersion],
        inputs: ArrayLike | InputTable | None,
        runs: tuple[Sampling, int, int],
    ) -> None:
        self.model = model
        self.x0 = _check.vector("x0", x0, model.n_states)
        self._start = Start(model, self.x0)
        self.constant, self.table = checked_inputs(inputs, model.n_inputs)
        self.dispersed = self._checked(dispersions)
        self.targets = [d.target for d in self.dispersed]
        ends = np.cumsum([d.dimensions for d in self.dispersed]).tolist()
        self._coordinates = [slice(e - d.dimensions, e) for e, d in zip(ends, self.dispersed, strict=True)]
        sampling, seed, n = runs
        self.design = Design(sampling, seed, n, *self._factors())
        for dispersed in self.dispersed:
            dispersed.check_sampling(sampling, n)

    def _checked(self, dispersions: Mapping[str, Dispersion]) -> list[Dispersed]:
        if not isinstance(dispersions, Mapping) or not dispersions:
            raise InputError(
                f"dispersions: got {_check.shown(dispersions)}; give a dictionary of quantities and "
                'distributions, such as {"mass": fb.Uniform(11.0, 14.0)}'
            )
        nominal = None if self.table is not None else self.constant
        known = list(quantities(self.model, self._start, nominal))
        found = [Dispersed(wanted(name, known), given) for name, given in dispersions.items()]
        check_together(self.model.body, dispersions)
        return found

    def _factors(self) -> tuple[tuple[tuple[str, ...], ...], tuple[tuple[int, ...], ...]]:
        """The names of independent factors, and their coordinates."""
        names, coordinates = [], []
        for dispersed, place in zip(self.dispersed, self._coordinates, strict=True):
            own, span = dispersed.factors, range(place.start, place.stop)
            names += own
            coordinates += [(i,) for i in span] if len(own) > 1 else [tuple(span)] * len(own)
        return tuple(names), tuple(coordinates)

    def values(self, first: int, count: int) -> dict[str, Array]:
        """The dispersed values (count, k) by the names of quantities."""
        u = self.design.points(first, count)
        pairs = zip(self.dispersed, self._coordinates, strict=True)
        return {d.target.name: d.values(u[:, place], first) for d, place in pairs}

    def of_laws(self) -> Iterator[tuple[Target, int, LawParameter]]:
        """What is dispersed of laws: the place of the law, -1 for the control law, and the parameter."""
        for target in self.targets:
            for law, parameter in target.places:
                yield target, law, parameter

    def _parameters(self, values: Mapping[str, Array]) -> tuple[NDArray[np.int64], Array] | None:
        places, entered = [], []
        laws = self.model.parameter_places()
        for target, law, parameter in self.of_laws():
            first, _ = laws[law]
            places += [first + place for place in parameter.places]
            entered.append(values[target.name][:, parameter.columns] * parameter.weights)
        return (np.array(places, np.int64), np.ascontiguousarray(np.hstack(entered))) if places else None

    def input_rows(self, values: Mapping[str, Array], count: int) -> Array:
        """The inputs (count, n_inputs) of the runs, or what is added to their table; one row if alike."""
        names = self.model.input_names
        if not values.keys() & set(names):
            return self.constant[None]
        rows = np.tile(self.constant, (count, 1))
        for i, name in enumerate(names):
            if name in values:
                rows[:, i] = values[name][:, 0]
        return rows

    def states(self, values: Mapping[str, Array], count: int) -> Array:
        """The states (count, n_states) in which the runs start."""
        return self._start.states(values, count)

    def draw(self, first: int, count: int) -> Draw:
        """What the runs from `first` on start from."""
        values = self.values(first, count)
        return Draw(
            self.states(values, count),
            bodies(self.model.body, values, count),
            self._parameters(values),
            self.input_rows(values, count),
            np.hstack(list(values.values())),
        )
