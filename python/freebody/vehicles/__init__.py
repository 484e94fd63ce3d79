"""Published vehicles, complete: body, forces, surroundings."""

from freebody.vehicles import f16

__all__ = ["f16"]
