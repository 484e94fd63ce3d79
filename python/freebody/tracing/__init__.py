"""Laws written as Python functions, traced into programs of the core."""

# These fill the tables of what NumPy's functions do.
from freebody.tracing import functions, linalg, lookup, ufuncs  # noqa: F401
from freebody.tracing.callback import Callback, callback
from freebody.tracing.control_law import ControlLaw, control
from freebody.tracing.event_law import EventLaw, event
from freebody.tracing.force_law import ForceLaw, force
from freebody.tracing.output_law import OutputLaw, output
from freebody.tracing.situation import Situation
from freebody.tracing.wrench import Wrench, wrench

__all__ = [
    "Callback",
    "ControlLaw",
    "EventLaw",
    "ForceLaw",
    "OutputLaw",
    "Situation",
    "Wrench",
    "callback",
    "control",
    "event",
    "force",
    "output",
    "wrench",
]
