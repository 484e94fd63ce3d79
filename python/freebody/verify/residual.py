"""One line of a verification: what was compared, how far it is off, how far it may be."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Residual:
    """The largest residual of one quantity in one case; `unit` is "relative" or the unit of both numbers."""

    case: str
    quantity: str
    residual: float
    allowed: float
    unit: str = "relative"

    @property
    def passed(self) -> bool:
        """Whether the residual is within what is allowed; NaN is not."""
        return self.residual <= self.allowed
