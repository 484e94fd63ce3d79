"""Models in DAVE-ML (ANSI/AIAA S-119-2011): read, checked against their own data, and flown."""

from freebody.dave_ml.check_data import CheckData, CheckRow
from freebody.dave_ml.definitions import Variable
from freebody.dave_ml.element import DaveAerodynamics
from freebody.dave_ml.mass import MassProperties
from freebody.dave_ml.model import DaveModel, load_dave_ml

__all__ = [
    "CheckData",
    "CheckRow",
    "DaveAerodynamics",
    "DaveModel",
    "MassProperties",
    "Variable",
    "load_dave_ml",
]
