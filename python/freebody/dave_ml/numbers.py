"""Numbers in the text of elements and attributes."""

from __future__ import annotations

import math

import numpy as np

from freebody._check import Array
from freebody.dave_ml.xml_tree import Node

__all__ = ["number", "numbers", "optional_number"]


def number(node: Node, text: str, key: str | None = None) -> float:
    """One finite number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise node.error(f"<{node.tag}>: came {' '.join(text.split())!r}; give one finite number", key)
    return value


def optional_number(node: Node, attribute: str, key: str) -> float | None:
    """A number that an attribute holds, or None where it is missing."""
    text = node.attributes.get(attribute)
    if text is None:
        return None
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise node.error(f"{attribute}={text!r}; give one finite number", key)
    return value


def numbers(node: Node, key: str | None = None) -> Array:
    """The numbers of an element, separated by spaces or commas."""
    words = node.text.replace(",", " ").split()
    if not words:
        raise node.error(f"<{node.tag}> has no numbers", key)
    return np.array([number(node, word, key) for word in words])
