"""When have enough runs been made? A rule that looks at the first runs alone.

It is asked at run counts that are fixed beforehand, of the runs up to there, so that a campaign stops at the
same run whatever the number of its workers.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from freebody._check import choice, count, number, shown
from freebody.errors import InputError

from .columns import blocks, column, gather
from .design import refuse_pairs
from .intervals import Interval, fraction, mean_interval, probability_interval, quantile_interval
from .moments import Moments
from .table import ResultTable

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Precision", "Stopped", "Verdict", "checkpoints", "parse_precision", "run_until"]


@dataclass(frozen=True)
class Precision:
    """A statistic of a column, known to a half-width of its confidence interval.

    `statistic` is "mean" (Student), "quantile" of a `probability` (order statistics), or "probability"
    (Clopper and Pearson): of a value `above` or `below` a limit, or, with neither, of the column having a
    value at all, as for the time of an event. The half-width wanted is the larger of `absolute` and
    `relative` times the estimate. Raises `InputError` for what does not go together.
    """

    column: str
    statistic: Literal["mean", "quantile", "probability"] = "mean"
    probability: float | None = None
    above: float | None = None
    below: float | None = None
    confidence: float = 0.95
    absolute: float | None = None
    relative: float | None = None

    def __post_init__(self) -> None:
        choice("statistic", self.statistic, ("mean", "quantile", "probability"))
        fraction("confidence", self.confidence)
        if (self.probability is None) == (self.statistic == "quantile"):
            raise InputError("probability: goes with statistic='quantile', and only with it")
        if self.probability is not None:
            fraction("probability", self.probability)
        limits = [name for name in ("above", "below") if getattr(self, name) is not None]
        if len(limits) > (self.statistic == "probability"):
            raise InputError(
                f"{' and '.join(limits)}: give one of above, below, with statistic='probability'"
            )
        wanted = [name for name in ("absolute", "relative") if getattr(self, name) is not None]
        if not wanted:
            raise InputError("absolute, relative: give one of them: the half-width that is wanted")
        for name in limits:
            number(name, getattr(self, name))
        for name in wanted:
            number(name, getattr(self, name), positive=True)

    @property
    def description(self) -> str:
        """Statistic and column in words."""
        if self.probability is not None:
            return f"{100 * self.probability:g} % quantile of {self.column}"
        if self.statistic == "mean":
            return f"mean of {self.column}"
        if self.above is None and self.below is None:
            return f"probability that {self.column} has a value"
        return f"probability of {self.column} " + (
            f"< {self.below:g}" if self.above is None else f"> {self.above:g}"
        )

    def estimate(self, dataset: xr.Dataset) -> Interval:
        """The statistic of the runs of a dataset that ended well."""
        chosen = [column(dataset, self.column)]
        if self.statistic == "mean":
            taken = Moments(1)
            for block in blocks(dataset, chosen):
                taken.add(block)
            return mean_interval(float(taken.mean[0]), float(taken.sd[0]), taken.count, self.confidence)
        values = gather(dataset, chosen)[:, 0]
        if self.probability is not None:
            values = values[np.isfinite(values)]
            if len(values) == 0:
                return Interval(np.nan, -np.inf, np.inf, self.confidence, 0)
            return quantile_interval(values, self.probability, self.confidence)
        if len(values) == 0:
            return Interval(np.nan, 0.0, 1.0, self.confidence, 0)
        hits = int(np.count_nonzero(self._hits(values)))
        return probability_interval(hits, len(values), self.confidence)

    def judge(self, dataset: xr.Dataset) -> Verdict:
        """Whether the runs of a dataset are enough."""
        refuse_pairs(dataset)
        interval = self.estimate(dataset)
        relative = 0.0 if self.relative is None else self.relative * abs(interval.value)
        wanted = max(self.absolute or 0.0, relative)
        met = interval.count > 1 and interval.half_width <= wanted
        return Verdict(self, int(dataset.sizes["run"]), interval, wanted, met)

    def _hits(self, values: np.ndarray) -> np.ndarray:
        if self.above is not None:
            return values > self.above
        return np.isfinite(values) if self.below is None else values < self.below


@dataclass(frozen=True)
class Verdict:
    """What the first `runs` runs say: the estimate, the half-width wanted, and whether it is met."""

    precision: Precision
    runs: int
    interval: Interval
    wanted: float
    met: bool


@dataclass(frozen=True)
class Stopped:
    """How many runs were made, whether that was enough, and every verdict on the way."""

    runs: int
    met: bool
    history: tuple[Verdict, ...]

    def table(self) -> ResultTable:
        """A row a verdict."""
        rows = [
            (v.precision.description, v.runs, v.interval.value, v.interval.half_width, v.wanted,
             "yes" if v.met else "no")
            for v in self.history
        ]  # fmt: skip
        return ResultTable(
            "Runs until the precision is met" if self.met else "The precision is not met",
            ("statistic", "runs", "estimate", "half-width", "wanted", "met"),
            tuple(rows),
        )


def checkpoints(start: int, limit: int, growth: float = 1.5, multiple: int = 1) -> Iterator[int]:
    """Run counts at which to look: from `start` on, each `growth` times the one before, rounded up to a
    `multiple` (of the chunk of a store), and `limit` at last."""
    start, limit, multiple = count("start", start), count("limit", limit), count("multiple", multiple)
    if not number("growth", growth) > 1.0:
        raise InputError(f"growth: got {shown(growth)}; give a number above 1")
    runs = start
    while (rounded := -(-runs // multiple) * multiple) < limit:
        yield rounded
        runs = max(math.ceil(rounded * growth), rounded + 1)
    yield limit


def run_until(
    ensure: Callable[[int], xr.Dataset],
    precisions: Precision | Sequence[Precision],
    *,
    limit: int,
    start: int = 1000,
    growth: float = 1.5,
    multiple: int = 1,
) -> Stopped:
    """Makes runs until every precision is met, or `limit` runs are made.

    `ensure(k)` makes what is missing of the first k runs and gives a dataset that begins with them; runs
    beyond them are not looked at. Looking more than once makes the interval at the end hold the truth a
    little less often than its confidence says; a `start` that is not small keeps that little (Glynn and
    Whitt 1992).
    """
    rules = [precisions] if isinstance(precisions, Precision) else list(precisions)
    history: list[Verdict] = []
    for runs in checkpoints(start, limit, growth, multiple):
        first = ensure(runs).isel(run=slice(0, runs))
        verdicts = [rule.judge(first) for rule in rules]
        history += verdicts
        if all(verdict.met for verdict in verdicts):
            return Stopped(runs, True, tuple(history))
    return Stopped(limit, False, tuple(history))


_RULE = re.compile(
    r"(?P<column>.+):(?:(?P<mean>mean)|q(?P<quantile>[\d.]+)|p(?:(?P<side>[<>])(?P<edge>[-+.\deE]+))?)"
    r":(?P<width>[.\deE+-]+)(?P<percent>%?)"
)


def parse_precision(rule: str, confidence: float = 0.95) -> Precision:
    """A precision from a word: column, statistic and half-width, which may be in percent of the estimate.

    Such as `miss:mean:0.5`, `miss:mean:1%`, `miss:q0.99:0.5`, `miss:p>3:0.01`, `event:apogee:p:0.01`. Raises
    `InputError` for another.
    """
    found = _RULE.fullmatch(rule) if isinstance(rule, str) else None
    try:
        if found is None:
            raise ValueError
        width = float(found["width"])
        edge = {} if found["side"] is None else {_SIDES[found["side"]]: float(found["edge"])}
        quantile = None if found["quantile"] is None else float(found["quantile"])
    except ValueError:
        raise InputError(
            f"precision: got {shown(rule)}; give column:statistic:half-width with the statistic mean, q0.99, "
            "p>3, p<3 or p: miss:mean:0.5, miss:q0.99:1%, miss:p>3:0.01"
        ) from None
    return Precision(
        found["column"],
        "mean" if found["mean"] else "probability" if quantile is None else "quantile",
        probability=quantile,
        confidence=confidence,
        **edge,
        **({"relative": width / 100} if found["percent"] else {"absolute": width}),
    )


_SIDES = {">": "above", "<": "below"}
