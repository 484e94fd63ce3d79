"""Events and outputs from a Python file."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

from freebody.errors import FreebodyError, InputError
from freebody.tracing import EventLaw, OutputLaw

__all__ = ["laws_of"]


def laws_of(path: Path) -> dict[str, list[Any]]:
    """The events and the outputs that a Python file defines, in its order; the file is executed."""
    try:
        defined = runpy.run_path(str(path)).values()
    except FreebodyError:
        raise
    except Exception as error:  # whatever the user's file raises
        raise InputError(f"--laws: {path}: {type(error).__name__}: {error}") from error
    found = {
        "events": [law for law in defined if isinstance(law, EventLaw)],
        "outputs": [law for law in defined if isinstance(law, OutputLaw)],
    }
    if not any(found.values()):
        raise InputError(
            f"--laws: {path} defines no event and no output; make some with @fb.event, @fb.output"
        )
    return found
