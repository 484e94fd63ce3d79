"""Many runs of a model that differ in what is dispersed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from freebody import _check
from freebody._check import Array
from freebody.body import RigidBody
from freebody.ensembles.dispersion import Dispersion
from freebody.ensembles.draws import Draw, Draws
from freebody.ensembles.integrate import integrated, joined, rewatched
from freebody.ensembles.law_parameters import with_parameters
from freebody.ensembles.mass_properties import Bodies, bodies
from freebody.ensembles.runs import Chunk, Runs
from freebody.ensembles.sampling import Sampling, checked_n
from freebody.errors import InputError
from freebody.simulation import InputTable, Method, Settings, Trajectory, Watched, checked_settings, watched
from freebody.tracing import EventLaw, OutputLaw

if TYPE_CHECKING:
    from freebody.campaigns import StoredRuns
    from freebody.model import Model

__all__ = ["Ensemble"]


class Ensemble:
    """n runs of a model that differ in what is dispersed; made by `Model.ensemble`.

    Run r depends on the seed and on r alone: it comes out the same to the last bit alone and in company, on
    any number of threads. Ensembles pickle, without their runs.

    Parameters
    ----------
    model, x0
        What is nominal, and the state (n_states,) from which the runs depart.
    dispersions
        A distribution for each quantity by its name: of the motion ("position", "velocity_body" or "_world",
        "angular_velocity_body" or "_world", "attitude", "fin.servo"), of the body ("mass", "com", "inertia",
        "second_moments", "principal_axes", "log_cholesky"), of laws ("drag.area"), or an input. In `Offset`
        it is added to the nominal value, in `Factor` it multiplies it, else it is the value itself.
    n, seed
        How many runs, and a whole number from which their draws follow.
    sampling
        "random", "latin_hypercube", "sobol" or "saltelli", see `Design`.
    inputs
        Constant (n_inputs,), or a table, to which draws of inputs are added.
    events, outputs
        Of every run, made by `freebody.event` and `freebody.output`.

    Raises
    ------
    InputError
        A quantity that the model does not have, or a distribution of which a draw could be impossible.

    Attributes
    ----------
    base, x0
        The model and the state whose quantities are dispersed.
    n, seed, sampling
        How many runs, and which points of the unit hypercube they are.
    names, units
        Of the columns of dispersed values.
    nominal
        Their values without dispersion.
    design
        Where the runs stand in the unit hypercube.
    dispersions, events, outputs
        As they were given.
    """

    def __init__(
        self,
        model: Model,
        x0: ArrayLike,
        dispersions: Mapping[str, Dispersion],
        n: int,
        seed: int = 0,
        sampling: Sampling = "random",
        inputs: ArrayLike | InputTable | None = None,
        events: Iterable[EventLaw] = (),
        outputs: Iterable[OutputLaw] = (),
    ) -> None:
        self.base = model
        self.n, self.seed = checked_n(n, seed)
        self.sampling: Sampling = sampling
        self._watched = watched(model, events, outputs)
        self.events, self.outputs = self._watched.events, self._watched.outputs
        self._draws = draws = Draws(model, x0, dispersions, inputs, (sampling, self.seed, self.n))
        self.design, self.x0 = draws.design, draws.x0
        self.dispersions = {d.target.name: d.given for d in draws.dispersed}
        self.names = tuple(column for target in draws.targets for column in target.columns)
        self.units = tuple(unit for target in draws.targets for unit in target.units)
        self.nominal = np.concatenate([target.nominal for target in draws.targets])

    def sample(self, first: int = 0, count: int | None = None) -> Draw:
        """What the runs `first` to `first + count - 1` start from; all that follow when count is omitted."""
        count = self.n - first if count is None else count
        if not 0 <= first < first + count <= self.n:
            raise InputError(
                f"first, count: got {first} and {count}; the ensemble has runs 0 to {self.n - 1}"
            )
        return self._draws.draw(first, count)

    @property
    def notices(self) -> tuple[str, ...]:
        """What the forces of the model may have to say of a run."""
        return self._watched.messages

    @property
    def nominal_inputs(self) -> tuple[Array, InputTable | None]:
        """The inputs before what is dispersed of them: constants (n_inputs,), and a table if there is one."""
        return self._draws.constant, self._draws.table

    def model(self, r: int) -> Model:
        """The model of run r: its body, its forces, its control law."""
        values, base = self._values(r), self.base
        own: dict[int, dict[str, Array]] = {}
        for target, law, parameter in self._draws.of_laws():
            own.setdefault(law, {})[parameter.attribute] = values[target.name][0]
        body = bodies(base.body, values, 1)
        return type(base)(
            base.body if body is None else _body(body, base.body.name),
            [with_parameters(force, own.get(i, {})) for i, force in enumerate(base.forces)],
            base.attitude,
            base.form,
            control=None if base.control is None else with_parameters(base.control, own.get(-1, {})),
            name=base.name,
            environment=base.environment,
        )

    def initial_state(self, r: int) -> Array:
        """Where run r starts, (n_states,)."""
        return self._draws.states(self._values(r), 1)[0]

    def inputs(self, r: int) -> Array | InputTable:
        """The inputs of run r: (n_inputs,), or a table."""
        row, table = self._draws.input_rows(self._values(r), 1)[0], self._draws.table
        return row if table is None else InputTable(table.times, table.values + row, table.interpolation)

    def trajectory(self, r: int, t_span: tuple[float, float], **options: Any) -> Trajectory:
        """Run r alone; `options` are those of `Model.simulate`."""
        watch = self._watched_of(r)
        own = {"inputs": self.inputs(r), "events": watch.events, "outputs": watch.outputs}
        return self.model(r).simulate(self.initial_state(r), t_span, **own, **options)

    def _values(self, r: int) -> dict[str, Array]:
        if not isinstance(r, int | np.integer) or not 0 <= r < self.n:
            raise InputError(f"r: got {_check.shown(r)}; the ensemble has runs 0 to {self.n - 1}")
        return self._draws.values(int(r), 1)

    def run(
        self,
        t_span: tuple[float, float],
        *,
        method: Method = "dop853",
        rtol: float = 1e-9,
        atol: float | None = None,
        step: float | None = None,
        save_every: float | None = None,
        save_at: ArrayLike | None = None,
        max_steps: int = 10_000_000,
        threads: int | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> Runs:
        """All runs, kept in memory.

        Parameters
        ----------
        t_span, method, rtol, atol, step, max_steps
            As those of `Model.simulate`, for each run.
        save_every, save_at
            Times at which the states of every run are kept; none when both are omitted.
        threads
            How many; one for each core when omitted.
        progress
            Called now and then with the part done, 0 to 1.

        Returns
        -------
        Runs
            However the runs ended: each has its outcome.
        """
        settings = checked_settings(
            t_span, method, rtol=rtol, atol=atol, step=step, save=(save_every, save_at), max_steps=max_steps
        )
        if progress is not None and not callable(progress):
            raise InputError(f"progress: got {_check.shown(progress)}; give a function of the part done")
        told = None if progress is None else lambda done: progress(done / self.n)
        runs = Runs(self, settings, self.chunk(0, self.n, settings, threads=threads, progress=told))
        if progress is not None:
            progress(1.0)
        return runs

    def campaign(
        self,
        path: str | PathLike[str],
        t_span: tuple[float, float],
        *,
        chunk: int | None = None,
        method: Method = "dop853",
        rtol: float = 1e-9,
        atol: float | None = None,
        step: float | None = None,
        save_every: float | None = None,
        save_at: ArrayLike | None = None,
        max_steps: int = 10_000_000,
        threads: int | None = None,
        client: Any = None,
        attributes: Mapping[str, str] | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> StoredRuns:
        """All runs into a store, chunk by chunk; started again, it goes on (extra `ensemble`).

        Parameters
        ----------
        path
            A folder, or a URL that fsspec knows.
        chunk
            Runs that are in memory at a time; at most 10 000 when omitted.
        threads
            For each chunk; when omitted, one for each core, or one on a cluster.
        client
            Of a Dask cluster, whose workers do the chunks (extra `cluster`).
        attributes
            Text that is added to the store's own.

        The others are those of `run`.

        Raises
        ------
        StoreError
            The store is of another campaign, or cannot be written; what it holds is kept.
        """
        try:
            from freebody.campaigns import run_campaign  # noqa: PLC0415  (an extra: who asks needs zarr)
        except ModuleNotFoundError as error:
            raise InputError(f"campaigns need {error.name}: pip install 'freebody[ensemble]'") from None
        settings = checked_settings(
            t_span, method, rtol=rtol, atol=atol, step=step, save=(save_every, save_at), max_steps=max_steps
        )
        options = {"chunk": chunk, "threads": threads, "client": client, "attributes": attributes}
        return run_campaign(self, path, settings, progress=progress, **options)

    def chunk(
        self,
        first: int,
        count: int,
        settings: Settings,
        *,
        threads: int | None = None,
        progress: Callable[[int], object] | None = None,
    ) -> Chunk:
        """What the runs `first` to `first + count - 1` gave; `progress` is told how many are done."""
        draw, table = self.sample(first, count), self._draws.table
        workers = 0 if threads is None else _check.count("threads", threads)
        if not self._watches_dispersed:
            return integrated(self.base, draw, table, self._watched, settings, workers, progress)
        # The core has one set of events and outputs for all runs of a call.
        chunks = []
        for r in range(first, first + count):
            chunks.append(
                integrated(self.base, self.sample(r, 1), table, self._watched_of(r), settings, 1, None)
            )
            if progress is not None:
                progress(len(chunks))
        return joined(chunks)

    @property
    def _watches_dispersed(self) -> bool:
        """Whether events or outputs read what is dispersed of the environment."""
        return self._watched_of(0) is not self._watched

    def _watched_of(self, r: int) -> Watched:
        return rewatched(self.base, self._watched, self._values(r))

    def __repr__(self) -> str:
        return (
            f"<Ensemble of {self.base.name!r}: {self.n} runs, {', '.join(self.dispersions)}; {self.sampling}>"
        )


def _body(one: Bodies, name: str) -> RigidBody:
    return RigidBody(float(one.mass[0]), one.com[0], inertia_about_com=one.inertia_about_com[0], name=name)
