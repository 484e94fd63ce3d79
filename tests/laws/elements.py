"""A small scene for every element, every wind, every atmosphere and every planet, told in any body frame."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np

import freebody as fb
from freebody.dave_ml import DaveAerodynamics, load_dave_ml
from freebody.elements import (
    Actuator,
    Drag,
    GyroscopicMomentum,
    HarmonicGravity,
    TurbulencePath,
)
from freebody.elements import Gravity as PlanetGravity
from freebody.environment import (
    WGS84,
    Atmosphere,
    Calm,
    ConstantWind,
    DrydenTurbulence,
    Ellipsoid,
    Environment,
    FlatEarth,
    LogWind,
    OneMinusCosineGust,
    Planet,
    PowerLawWind,
    RoundEarth,
    TabulatedAtmosphere,
    UniformAtmosphere,
    USStandard1976,
    Wind,
    WindShear,
    WindTable,
)
from python.dave_ml.files import DART

from . import airs, rockets, spinners, waters
from .rockets import Frame

MODEL = load_dave_ml(DART)
# Drag of the Mach number, at the slow speeds of these scenes.
SLOW = fb.Table([0.0, 0.004, 0.01, 0.05], [0.9, 0.5, 0.6, 1.0], "cubic")
FIELD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [-0.02, 0.01, 0.015]])
SINES = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, -0.01, 0.02]])
# World origins near the ground: a kilometre up, where every part of J2 counts.
EARTH = WGS84(center=-WGS84().position_world(0.7, 0.4, 1000.0), angle=0.3)
SPHERE = RoundEarth(center=-RoundEarth().position_world(-0.2, 3.1, 1000.0), rotation_rate=7e-5)
# Turns fast, and is so small that its ground is curved here.
SMALL = Ellipsoid(9e3, 8e8, 0.05, 0.02, 5e-3, center=(-5.0e3, 6.0e3, 4.5e3))


class Scene(NamedTuple):
    """Forces in a body frame, in calm and still medium if told so; inputs by name; how it starts, and with
    which auxiliary states.
    """

    forces: Callable[[Frame, bool], list[fb.Force]]
    inputs: Mapping[str, float] = {}
    start: Mapping[str, Any] = {}
    states: Mapping[str, float] = {}

    def model(self, there: bool = False, still: bool = False) -> fb.Model:
        return _model(self.forces, there, still)

    def state(self, model: fb.Model, frame: Frame = rockets.HERE) -> Any:
        x = frame.state(model, **self.start)
        for name, value in self.states.items():
            x[model.auxiliary[name]] = value
        return x

    def u(self, model: fb.Model) -> Any:
        return np.array([self.inputs.get(name, 0.0) for name in model.input_names])


THERE = Frame(
    np.array([0.8, -0.5, 0.6]), fb.Attitude.quaternion(np.array([0.5, -0.7, 0.1, 0.5])).as_rotation()
)


@cache
def _model(forces: Callable[[Frame, bool], list[fb.Force]], there: bool, still: bool) -> fb.Model:
    """Made once: it takes longer than what is asked of it."""
    frame = THERE if there else rockets.HERE
    return fb.Model(rockets.BODY.in_frame(*frame), forces(frame, still))


def wet(which: str) -> Scene:
    def forces(frame: Frame, still: bool) -> list[fb.Force]:
        return [waters.in_water(waters.water(None if still else waters.CURRENT), *frame)[which]]

    return Scene(forces)


# Feet in the ground, springs stretched, the hull half under.
LOW = {"position": [0.1, 0.2, 0.05], "attitude": fb.Attitude.rotation(waters.TILT.T)}


def on_ground(which: str) -> Scene:
    return Scene(lambda frame, still: [waters.on_ground(*frame)[which]], start=LOW)


def aerodynamics(axes: str) -> Scene:
    def forces(frame: Frame, still: bool) -> list[fb.Force]:
        env, at = Environment() if still else airs.WINDY, frame.point(np.array([0.4, -0.1, 0.2]))
        return [airs.element(axes, at, env, frame.turn.T)]

    return Scene(forces, {"rudder": 0.2}, {"velocity_body": [12.0, -2.0, 3.0]})


def dave(frame: Frame, still: bool) -> list[fb.Force]:
    env = Environment() if still else airs.WINDY
    at = frame.point(np.array([0.3, -0.1, 0.2]))
    return [
        DaveAerodynamics(env, MODEL, {"lag": "wake"}, reference_point=at, body_from_aero=frame.turn.T),
        # Its fin is moved by a servo, as published signals are.
        Actuator("finDeflection", natural_frequency=20.0, limits=(-0.3, 0.3), rate_limit=2.0),
    ]


def drag(
    wind: Callable[[Frame], Wind] | None = None,
    planet: Planet | None = None,
    atmosphere: Atmosphere | None = None,
    coefficient: Any = 0.7,
    **start: Any,
) -> Scene:
    """Drag off the mass centre in an environment, its planet's gravity, and the path where it is read."""

    def forces(frame: Frame, still: bool) -> list[fb.Force]:
        env = Environment(planet, atmosphere, None if still or wind is None else wind(frame))
        at = frame.point(np.array([0.3, -0.1, 0.2]))
        acting: list[fb.Force] = [Drag(env, 0.2, coefficient, at), PlanetGravity(env)]
        return [*acting, TurbulencePath(env, at)] if "air_path" in env.inputs else acting

    return Scene(forces, start=start)


def harmonics(frame: Frame, still: bool) -> list[fb.Force]:
    field = {"center": [2.0, 3.0, -8.0], "rotation_rate": 0.1, "gradient_torque": True}
    return [HarmonicGravity(500.0, 5.0, FIELD, SINES, **field)]


def propeller(i: int) -> Scene:
    def forces(frame: Frame, still: bool) -> list[fb.Force]:
        return [spinners.rotors(frame, Environment() if still else spinners.AIR)[i]]

    return Scene(forces, spinners.INPUTS)


HEIGHTS = [-50.0, 20.0, 100.0]
FAST: dict[str, Any] = {"velocity_body": [30.0, -2.0, 3.0]}

ELEMENTS: dict[str, Scene] = {
    "added mass": wet("added mass"),
    "damping": wet("damping"),
    "cross flow": wet("cross flow"),
    "hull": wet("hull"),
    "buoyancy": wet("buoyancy"),
    "fin": wet("fin"),
    "flotation": on_ground("flotation"),
    "spring": on_ground("spring"),
    "tether": on_ground("tether"),
    "rotational spring": on_ground("rotational spring"),
    "contact": on_ground("contact"),
    "ground": on_ground("ground"),
    "aerodynamics, body": aerodynamics("body"),
    "aerodynamics, stability": aerodynamics("stability"),
    "aerodynamics, wind": aerodynamics("wind"),
    "aerodynamics, DAVE-ML": Scene(
        dave, {"damped": 1.0, "wake": 0.2, "finDeflection_command": 0.1}, {"velocity_body": [32.0, -2.0, 3.0]}
    ),
    "drag by Mach number": drag(coefficient=SLOW),
    "harmonic gravity": Scene(harmonics),
    "propulsion": Scene(
        lambda frame, still: [rockets.propulsion(frame)], {"throttle": 0.9, "pitch": 0.1, "yaw": -0.2}
    ),
    "propulsion by curves": Scene(
        lambda frame, still: [rockets.propulsion(frame, interpolation="cubic")], {"throttle": 0.9}
    ),
    "propulsion running dry": Scene(
        lambda frame, still: [rockets.propulsion(frame, tail_off=0.5)],
        {"throttle": 0.9, "pitch": 0.1, "yaw": -0.2},
        states={"propulsion.fuel_mass": 0.25, "propulsion.main_level": 0.7},
    ),
    "propeller with lag": propeller(0),
    "propeller with motor": propeller(1),
    "reaction wheels": Scene(
        lambda frame, still: [spinners.wheels(frame, viscous=1e-4, coulomb=1e-3, max_speed=200.0)],
        spinners.INPUTS,
    ),
    "gyrostat": Scene(lambda frame, still: [GyroscopicMomentum(frame.vector(spinners.MOMENTUM))]),
    "actuator": Scene(
        lambda frame, still: [Actuator("flap", time_constant=0.2, rate_limit=3.0)], {"flap_command": 0.4}
    ),
}

AROUND: dict[str, Scene] = {
    "calm": drag(lambda f: Calm()),
    "constant wind": drag(lambda f: ConstantWind([2.0, -1.0, 0.5])),
    "wind table": drag(lambda f: WindTable(HEIGHTS, [[1.0, 2.0, 0.0], [4.0, -1.0, 0.5], [9.0, 0.0, 0.0]])),
    "wind shear": drag(lambda f: WindShear([0.1, -0.05, 0.0], [1.0, 2.0, 0.1])),
    "log wind": drag(lambda f: LogWind(5.0, 1.0, ground=-20.0)),
    "power law wind": drag(lambda f: PowerLawWind(5.0, 1.0, ground=-20.0, top=300.0)),
    "gust in time": drag(lambda f: OneMinusCosineGust([2.0, 3.0, 1.0], 0.1, duration=1.5)),
    "gust on the way": drag(
        lambda f: OneMinusCosineGust(
            [2.0, 3.0, 1.0], -3.0, length=20.0, axes="body", shape="pulse", body_from_aero=f.turn.T
        ),
        **FAST,
    ),
    "turbulence": drag(
        lambda f: DrydenTurbulence([1.0, 1.2, 0.8], [50.0, 40.0, 30.0], 2.0, seed=4, body_from_aero=f.turn.T),
        **FAST,
    ),
    "level turbulence": drag(
        lambda f: DrydenTurbulence.specified(
            "moderate", 2.0, seed=4, axes="level", ground=-100.0, body_from_aero=f.turn.T
        ),
        **FAST,
    ),
    "winds": drag(lambda f: ConstantWind([2.0, -1.0, 0.5]) + WindShear([0.1, 0.0, 0.0], name="shear")),
    "flat earth": drag(planet=FlatEarth(axes="enu")),
    "WGS-84": drag(planet=EARTH, wind=lambda f: ConstantWind([2.0, -1.0, 0.5])),
    "round earth": drag(planet=SPHERE, wind=lambda f: WindShear([1e-3, -2e-3, 0.0], [2.0, -1.0, 0.5])),
    "ellipsoid": drag(planet=SMALL, wind=lambda f: ConstantWind([2.0, -1.0, 0.5])),
    "US 76": drag(atmosphere=USStandard1976(5.0), planet=EARTH),
    "air table": drag(
        atmosphere=TabulatedAtmosphere(HEIGHTS, density=[1.3, 1.2, 1.1], pressure=[1.1e5, 1e5, 0.9e5])
    ),
    "uniform air": drag(atmosphere=UniformAtmosphere(1.1), coefficient=SLOW),
}

EVERY = ELEMENTS | AROUND
