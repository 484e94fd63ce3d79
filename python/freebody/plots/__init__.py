"""Figures (extra `plot`): of one run, and of many in `freebody.plots.ensembles`."""

from .style import check_suffix, save
from .trajectory import figure

__all__ = ["check_suffix", "figure", "save"]
