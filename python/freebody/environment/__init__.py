"""What surrounds a body: the planet, its air or water, and how these move."""

from freebody.environment.atmosphere import Air, Atmosphere, UniformAtmosphere
from freebody.environment.atmosphere_1976 import USStandard1976
from freebody.environment.atmosphere_table import TabulatedAtmosphere
from freebody.environment.ellipsoid import WGS84, Ellipsoid, RoundEarth
from freebody.environment.environment import Environment, Flow, checked_environment
from freebody.environment.frames import OrbitFrame, lvlh
from freebody.environment.gusts import OneMinusCosineGust
from freebody.environment.planet import FlatEarth, Place, Planet
from freebody.environment.track import Track
from freebody.environment.turbulence import DrydenTurbulence
from freebody.environment.wind import Calm, Wind, WindHere, Winds
from freebody.environment.wind_profiles import ConstantWind, LogWind, PowerLawWind, WindShear, WindTable

__all__ = [
    "WGS84",
    "Air",
    "Atmosphere",
    "Calm",
    "ConstantWind",
    "DrydenTurbulence",
    "Ellipsoid",
    "Environment",
    "FlatEarth",
    "Flow",
    "LogWind",
    "OneMinusCosineGust",
    "OrbitFrame",
    "Place",
    "Planet",
    "PowerLawWind",
    "RoundEarth",
    "TabulatedAtmosphere",
    "Track",
    "USStandard1976",
    "UniformAtmosphere",
    "Wind",
    "WindHere",
    "WindShear",
    "WindTable",
    "Winds",
    "checked_environment",
    "lvlh",
]
