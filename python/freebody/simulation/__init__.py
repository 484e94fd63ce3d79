"""Trajectories: one run of a model, and what can be read off it."""

from freebody.simulation.inputs import InputTable
from freebody.simulation.outcome import ChartChange, Conserved, Outcome
from freebody.simulation.simulate import Method, simulate
from freebody.simulation.trajectory import Trajectory

__all__ = ["ChartChange", "Conserved", "InputTable", "Method", "Outcome", "Trajectory", "simulate"]
