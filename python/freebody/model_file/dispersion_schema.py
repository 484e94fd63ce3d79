"""The keys of [dispersions] and [ensemble]: one section for each kind of distribution.

The unit of a dispersed quantity is known only with the model: numbers are read in dispersions.py.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from freebody.ensembles import Sampling

from .fields import Choice, Quantity, Section

__all__ = ["AnyDistribution", "EnsembleTable", "FromFile"]

_APPLIED = Field(default="value", description='the draw is the "value", an "offset" of it, or a "factor"')
Applied = Annotated[str, Choice("value", "offset", "factor")]


class Normal(Section):
    """The normal distribution."""

    kind: Literal["normal"]
    applied: Applied = _APPLIED
    mean: Any = Field(description="the mean")
    sd: Any = Field(description="the standard deviation")


class TruncatedNormal(Section):
    """The normal distribution between two bounds."""

    kind: Literal["truncated_normal"]
    applied: Applied = _APPLIED
    mean: Any = Field(description="the mean before the bounds")
    sd: Any = Field(description="the standard deviation before the bounds")
    low: Any = Field(default=None, description="the lower bound; none when omitted")
    high: Any = Field(default=None, description="the upper bound; none when omitted")


class Uniform(Section):
    """Every value between two bounds alike."""

    kind: Literal["uniform"]
    applied: Applied = _APPLIED
    low: Any = Field(description="the lower bound")
    high: Any = Field(description="the upper bound")


class LogNormal(Section):
    """Positive values whose logarithm is normal."""

    kind: Literal["log_normal"]
    applied: Applied = _APPLIED
    median: Any = Field(description="the median")
    sigma: Any = Field(description="the standard deviation of the logarithm")


class MultivariateNormal(Section):
    """Normal numbers with a covariance."""

    kind: Literal["multivariate_normal"]
    applied: Applied = _APPLIED
    mean: Any = Field(description="the means")
    covariance: Any = Field(description="the covariance, SI units")


class Discrete(Section):
    """One of several values."""

    kind: Literal["discrete"]
    applied: Applied = _APPLIED
    values: Any = Field(description="the values")
    weights: Any = Field(default=None, description="of each value, in any proportion")


class FromFile(Section):
    """Values from a CSV file: row r is that of run r."""

    kind: Literal["file"]
    applied: Applied = _APPLIED
    csv: str = Field(description="path of a table, relative to the model file")
    columns: list[str] = Field(description="the headings of its columns, with their units if not SI")


AnyDistribution = Annotated[
    Normal | TruncatedNormal | Uniform | LogNormal | MultivariateNormal | Discrete | FromFile,
    Field(discriminator="kind"),
]


class EnsembleTable(Section):
    """[ensemble]: how many runs, which, and what is kept of them."""

    n: int | None = Field(default=None, ge=1, description="the number of runs")
    seed: int = Field(default=0, ge=0, description="the same seed gives the same runs")
    sampling: Annotated[Sampling, Choice(*get_args(Sampling))] = Field(
        default="random", description="how points of the unit hypercube are chosen"
    )
    chunk: int | None = Field(default=None, ge=1, description="runs stored at a time")
    save_every: Annotated[float | None, Quantity("s", positive=True)] = Field(
        default=None, description="time between two samples of every run"
    )
    save_at: Annotated[NDArray[np.float64] | None, Quantity("s", (None,))] = Field(
        default=None, description="the sample times instead"
    )

    @model_validator(mode="after")
    def _check(self) -> EnsembleTable:
        self.at_most_one("save_every", "save_at")
        return self
