"""The model files that come with the package."""

from __future__ import annotations

from pathlib import Path

from freebody.errors import InputError

from .fields import did_you_mean

__all__ = ["shipped_model", "shipped_names"]

_FOLDER = Path(__file__).parent.parent / "models"


def shipped_names() -> list[str]:
    """Their names, such as "toutatis"."""
    return sorted(path.stem for path in _FOLDER.glob("*.toml"))


def shipped_model(name: str) -> Path:
    """The path of one of them. Raises `InputError` for another name."""
    if name not in shipped_names():
        raise InputError(f"no model {name!r} comes with freebody{did_you_mean(name, shipped_names())}")
    return _FOLDER / f"{name}.toml"
