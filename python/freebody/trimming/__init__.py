"""Steady flight: the state and the inputs that hold it."""

from freebody.trimming.trim import Trim, trim

__all__ = ["Trim", "trim"]
