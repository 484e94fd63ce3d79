"""Laws written as Python functions, traced into programs of the core."""

# These fill the tables of what NumPy's functions do.
from freebody.tracing import functions, linalg, lookup, ufuncs  # noqa: F401
from freebody.tracing.callback import Callback, callback
from freebody.tracing.contents_law import ContentsLaw, contents, mass_properties
from freebody.tracing.control_law import ControlLaw, control
from freebody.tracing.event_law import EventLaw, event
from freebody.tracing.force_law import ForceLaw, force
from freebody.tracing.notice_law import NoticeLaw, notice
from freebody.tracing.output_law import OutputLaw, output
from freebody.tracing.situation import Situation
from freebody.tracing.wrench import Wrench, wrench

__all__ = [
    "Callback",
    "ContentsLaw",
    "ControlLaw",
    "EventLaw",
    "ForceLaw",
    "NoticeLaw",
    "OutputLaw",
    "Situation",
    "Wrench",
    "callback",
    "contents",
    "control",
    "event",
    "force",
    "mass_properties",
    "notice",
    "output",
    "wrench",
]
