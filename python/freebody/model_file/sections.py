"""All kinds of force that a model file can name."""

from __future__ import annotations

from . import (
    aerodynamics_schema,
    contact_schema,
    dave_ml_schema,
    environment_schema,
    force_schema,
    gravity_schema,
    marine_schema,
    planet_schema,
    propulsion_schema,
)
from .context import ForceSection

__all__ = ["SECTIONS"]

SECTIONS: tuple[type[ForceSection], ...] = (
    *force_schema.SECTIONS,
    *planet_schema.SECTIONS,
    *gravity_schema.SECTIONS,
    *environment_schema.SECTIONS,
    *aerodynamics_schema.SECTIONS,
    *dave_ml_schema.SECTIONS,
    *propulsion_schema.SECTIONS,
    *marine_schema.SECTIONS,
    *contact_schema.SECTIONS,
)
