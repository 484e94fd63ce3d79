"""Forces of vehicles, written as laws: aerodynamics, propulsion, rotors, water, springs and contact."""

from freebody.elements.actuators import Actuator
from freebody.elements.added_mass import AddedMass
from freebody.elements.aerodynamics import Aerodynamics, Drag
from freebody.elements.air_data import AirData
from freebody.elements.buoyancy import Buoyancy, Flotation
from freebody.elements.contact import Contact
from freebody.elements.fins import Fin, lift_slope
from freebody.elements.gravity import Gravity
from freebody.elements.harmonics import HarmonicGravity
from freebody.elements.hydrodynamics import CrossFlowDrag, HullLiftDrag, HydrodynamicDamping
from freebody.elements.lookup import Lookup
from freebody.elements.propellers import Propeller
from freebody.elements.propulsion import Propulsion
from freebody.elements.springs import RotationalSpring, Spring, Tether
from freebody.elements.tanks import Tank
from freebody.elements.thrusters import Thruster
from freebody.elements.turbulence_path import TurbulencePath
from freebody.elements.wheels import GyroscopicMomentum, ReactionWheels

__all__ = [
    "Actuator",
    "AddedMass",
    "Aerodynamics",
    "AirData",
    "Buoyancy",
    "Contact",
    "CrossFlowDrag",
    "Drag",
    "Fin",
    "Flotation",
    "Gravity",
    "GyroscopicMomentum",
    "HarmonicGravity",
    "HullLiftDrag",
    "HydrodynamicDamping",
    "Lookup",
    "Propeller",
    "Propulsion",
    "ReactionWheels",
    "RotationalSpring",
    "Spring",
    "Tank",
    "Tether",
    "Thruster",
    "TurbulencePath",
    "lift_slope",
]
