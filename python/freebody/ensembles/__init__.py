"""Ensembles: many runs of a model that differ in initial state, body, parameters and inputs."""

from freebody.ensembles.dispersion import Dispersion, Factor, Offset
from freebody.ensembles.distributions import Distribution, LogNormal, Normal, TruncatedNormal, Uniform
from freebody.ensembles.draws import Draw
from freebody.ensembles.ensemble import Ensemble
from freebody.ensembles.joint import Discrete, FromFile, MultivariateNormal, Samples
from freebody.ensembles.runs import Chunk, Runs
from freebody.ensembles.sampling import Design, Sampling

__all__ = [
    "Chunk",
    "Design",
    "Discrete",
    "Dispersion",
    "Distribution",
    "Draw",
    "Ensemble",
    "Factor",
    "FromFile",
    "LogNormal",
    "MultivariateNormal",
    "Normal",
    "Offset",
    "Runs",
    "Samples",
    "Sampling",
    "TruncatedNormal",
    "Uniform",
]
