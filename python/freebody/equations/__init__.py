"""Scalar equations on demand: the paper's matrices multiplied with symbols in them."""

from freebody.equations.body import SymbolicBody
from freebody.equations.build import equations
from freebody.equations.result import Equations, OperationCount

__all__ = ["Equations", "OperationCount", "SymbolicBody", "equations"]
