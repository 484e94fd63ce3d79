"""What a section of a model file is built with."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

from freebody.body import RigidBody
from freebody.environment import Environment
from freebody.forces import Force

from .fields import Section
from .problems import Source

__all__ = ["Context", "ForceSection"]


@dataclass(frozen=True)
class Context:
    """The rest of the file, as an element sees it.

    Attributes
    ----------
    body, environment
        Of the model.
    source
        The file, for messages and for paths beside it.
    key
        Where the section stands, "forces[2]".
    """

    body: RigidBody
    environment: Environment
    source: Source
    key: str


class ForceSection(Section):
    """One of [[forces]]."""

    @abstractmethod
    def element(self, context: Context) -> Force:
        """The force element."""
