"""Trajectories: one run of a model, and what can be read off it."""

from freebody.simulation.inputs import InputTable
from freebody.simulation.outcome import GOOD_ENDS, OUTCOMES, ChartChange, Conserved, Notice, Outcome
from freebody.simulation.settings import Method, Settings, checked_settings
from freebody.simulation.simulate import simulate
from freebody.simulation.staged import Separation, StagedTrajectory, stages_of
from freebody.simulation.stages import Stage, simulate_stages
from freebody.simulation.trajectory import Trajectory
from freebody.simulation.watching import Occurrence, Watched, notices_of, watched

__all__ = [
    "GOOD_ENDS",
    "OUTCOMES",
    "ChartChange",
    "Conserved",
    "InputTable",
    "Method",
    "Notice",
    "Occurrence",
    "Outcome",
    "Separation",
    "Settings",
    "Stage",
    "StagedTrajectory",
    "Trajectory",
    "Watched",
    "checked_settings",
    "notices_of",
    "simulate",
    "simulate_stages",
    "stages_of",
    "watched",
]
