"""Statistics of ensembles: what a set of runs says, and how surely.

It needs SciPy (extra `ensemble`). Datasets are those of `Runs.to_xarray` and of the stores of campaigns.
"""

from .columns import Column, all_columns, column, gather, outcomes, results
from .design import independent, is_paired
from .intervals import (
    Interval,
    ToleranceBounds,
    correlation_interval,
    mean_interval,
    probability_interval,
    quantile_interval,
    runs_needed,
    tolerance_bounds,
)
from .moments import Moments, moments
from .precision import Precision, Stopped, Verdict, checkpoints, parse_precision, run_until
from .sensitivity import Correlations, SobolIndices, correlations, sobol, sobol_indices
from .summaries import (
    correlation_table,
    covariance_table,
    endings,
    events,
    overview,
    quantiles,
    relations,
    sensitivities,
    sobol_table,
    spread,
    summary,
    tolerances,
)
from .table import ResultTable

__all__ = [
    "Column",
    "Correlations",
    "Interval",
    "Moments",
    "Precision",
    "ResultTable",
    "SobolIndices",
    "Stopped",
    "ToleranceBounds",
    "Verdict",
    "all_columns",
    "checkpoints",
    "column",
    "correlation_interval",
    "correlation_table",
    "correlations",
    "covariance_table",
    "endings",
    "events",
    "gather",
    "independent",
    "is_paired",
    "mean_interval",
    "moments",
    "outcomes",
    "overview",
    "parse_precision",
    "probability_interval",
    "quantile_interval",
    "quantiles",
    "relations",
    "results",
    "run_until",
    "runs_needed",
    "sensitivities",
    "sobol",
    "sobol_indices",
    "sobol_table",
    "spread",
    "summary",
    "tolerance_bounds",
    "tolerances",
]
