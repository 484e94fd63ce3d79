"""Model files: a body, forces, a start and a time span as TOML (docs/model-file.md)."""

from .load import LoadedModel, load_model
from .shipped import shipped_model, shipped_names

__all__ = ["LoadedModel", "load_model", "shipped_model", "shipped_names"]
