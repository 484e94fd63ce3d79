"""Reads a model file."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from freebody._core import toml_parse
from freebody.ensembles import Dispersion, Ensemble, Sampling
from freebody.environment import Environment, Track
from freebody.errors import ModelFileError
from freebody.model import Model
from freebody.simulation import Stage, StagedTrajectory, Trajectory, simulate_stages

from .build import build_initial_state, build_model, build_stages
from .dispersion_schema import EnsembleTable
from .dispersions import build_dispersions
from .event_schema import build_events
from .inputs import build_inputs
from .problems import Source
from .schema import Header, ModelFile, Output

__all__ = ["LoadedModel", "load_model"]


@dataclass(frozen=True, eq=False)
class LoadedModel:
    """A model file, checked and built: a model, where it starts, how it is simulated, what is kept.

    Attributes
    ----------
    path, text
        Where the file stands and what it says.
    header
        Its name, description and sources.
    model, x0, t_span
        The arguments of the simulation, SI.
    options
        The keyword arguments of `Model.simulate` that the file gives.
    output
        The material points and tracks that are kept, and the data format.
    stages
        Those of the run, the first one with `model`; none where the file has no [[stages]].
    dispersions, plan
        How quantities differ between the runs of an ensemble; how many runs, and which.
    """

    path: Path
    text: str
    header: Header
    model: Model
    x0: NDArray[np.float64]
    t_span: tuple[float, float]
    options: dict[str, Any]
    output: Output
    dispersions: dict[str, Dispersion]
    plan: EnsembleTable
    stages: tuple[Stage, ...] = ()

    def simulate(self, *, progress: Callable[[float], None] | None = None) -> Trajectory | StagedTrajectory:
        """Runs the file's simulation, in its stages where it has some."""
        if self.stages:
            return simulate_stages(self.stages, self.x0, self.t_span, progress=progress, **self.options)
        return self.model.simulate(self.x0, self.t_span, progress=progress, **self.options)

    def ensemble(
        self,
        n: int | None = None,
        *,
        seed: int | None = None,
        sampling: Sampling | None = None,
        events: Iterable[Any] = (),
        outputs: Iterable[Any] = (),
    ) -> Ensemble:
        """The file's ensemble; what is omitted is as [ensemble] says.

        Raises `ModelFileError` where the file has stages or disperses nothing, or nobody says how many runs.
        """
        if self.stages:
            raise ModelFileError(
                "an ensemble runs one model in all its lanes; this file has stages: `freebody run` does one "
                "run, and freebody.simulate_stages in Python any number of them, one after another",
                file=str(self.path),
                key="stages",
            )
        if not self.dispersions:
            raise ModelFileError(
                "an ensemble needs dispersions, such as [dispersions.mass]",
                file=str(self.path),
                key="dispersions",
            )
        runs = self.plan.n if n is None else n
        if runs is None:
            raise ModelFileError("say how many runs, here or with -n", file=str(self.path), key="ensemble.n")
        return self.model.ensemble(
            self.x0,
            self.dispersions,
            n=runs,
            seed=self.plan.seed if seed is None else seed,
            sampling=sampling or self.plan.sampling,
            inputs=self.options.get("inputs"),
            events=(*self.options.get("events", ()), *events),
            outputs=outputs,
        )

    def tracks(self, run: Trajectory) -> dict[str, Track]:
        """The tracks of [output] by name, along a run, or along one of its stages."""
        environment = self.model.environment or Environment()
        return {name: table.track(run, environment) for name, table in self.output.tracks.items()}

    @property
    def campaign_options(self) -> dict[str, Any]:
        """The keyword arguments of `Ensemble.campaign` that the file gives."""
        single = {
            key: value
            for key, value in self.options.items()
            if not key.startswith("save_") and key not in ("inputs", "events")
        }
        return single | self.plan.given("n", "seed", "sampling")


def load_model(path: str | PathLike[str]) -> LoadedModel:
    """Reads, checks and builds the model file at `path` (docs/model-file.md).

    Raises `ModelFileError`, which names file, line and key, what came and what is allowed.
    """
    path = Path(path)
    text = _read(path)
    try:
        data, lines = toml_parse(text)
    except ValueError as error:
        message, line = error.args
        raise ModelFileError(f"not valid TOML: {message}", file=str(path), line=line) from None
    source = Source(path, data, lines)
    try:
        spec = ModelFile.model_validate(data)
    except ValidationError as error:
        raise source.errors(error) from None
    model = build_model(spec, source)
    x0 = build_initial_state(spec.initial, model, spec.simulation.start, source)
    options = spec.simulation.given("start", "end", "attitude", "form") | spec.output.given(
        "points", "tracks", "format"
    )
    stages = build_stages(spec, model, source)
    if not stages:
        inputs = build_inputs(spec.inputs, model, source)
        if inputs is not None:
            options["inputs"] = inputs
        if spec.events:
            options["events"] = build_events(spec.events, (model,), source)[0]
    t_span = (spec.simulation.start, spec.simulation.end)
    dispersions = build_dispersions(spec.dispersions, model, x0, source)
    return LoadedModel(
        path, text, spec.model, model, x0, t_span, options, spec.output, dispersions, spec.ensemble, stages
    )


def _read(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise ModelFileError(f"cannot be read: {error.strerror}", file=str(path)) from None
    except UnicodeDecodeError as error:
        raise ModelFileError(f"is not UTF-8 text: {error.reason}", file=str(path)) from None
