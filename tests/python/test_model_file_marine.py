"""Water, springs and contact in model files: the same elements as in Python, and errors that name the key."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import (
    AddedMass,
    Buoyancy,
    Contact,
    CrossFlowDrag,
    Fin,
    Flotation,
    HullLiftDrag,
    HydrodynamicDamping,
    RotationalSpring,
    Spring,
    Tether,
)
from freebody.environment import Environment

FRAME = """
[model]
name = "test"

[body]
mass = 12.25
com = [0.0, 0.0, 0.05]
inertia_about_com = {{ principal = [1.0, 2.0, 2.5] }}

[[forces]]
{force}

[simulation]
end = 1.0
"""
AIR = Environment()
TURN = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
SEAT: dict[str, Any] = {"at": [0.1, 0.2, 0.3], "axes": TURN}
SEATED = f'at = "[10, 20, 30] cm"\naxes = {TURN}'
# The body's own mass of the medium, 12.25 kg of 1.225 kg/m³.
NEUTRAL = 10.0
SAME: dict[str, tuple[str, Any]] = {
    "matrix": (
        f'type = "added_mass"\nmatrix = [1, 2, 3, 0.1, 0.2, 0.3]\n{SEATED}',
        AddedMass(AIR, [1, 2, 3, 0.1, 0.2, 0.3], **SEAT),
    ),
    "derivatives": (
        f'type = "added_mass"\nderivatives = {{ X_udot = "-2 lb", N_rdot = -1.0 }}\n{SEATED}',
        AddedMass.from_derivatives(AIR, X_udot=-2 * 0.45359237, N_rdot=-1.0, **SEAT),
    ),
    "spheroid": (
        'type = "added_mass"\n'
        'spheroid = { semi_major = "80 cm", semi_minor = 0.1, roll = 0.01, density = 1e3 }',
        AddedMass.spheroid(AIR, 0.8, 0.1, roll=0.01, density=1000.0),
    ),
    "cylinder": (
        'type = "added_mass"\ncylinder = { length = 2.0, radius = "4 in", axial = "1 lb" }',
        AddedMass.cylinder(AIR, 2.0, 4 * 0.0254, axial=0.45359237),
    ),
    "damping": (
        f'type = "hydrodynamic_damping"\nlinear = [1, 2, 3, 4, 5, 6]\n'
        f"quadratic = [0, 0, 0, 0, 0, 1]\n{SEATED}",
        HydrodynamicDamping(AIR, np.arange(1.0, 7.0), [0, 0, 0, 0, 0, 1], **SEAT),
    ),
    "cross flow": (
        f'type = "cross_flow_drag"\nlength = 2.0\nheight = "[10, 20] cm"\n'
        f"breadth = 0.0\nstrips = 4\n{SEATED}",
        CrossFlowDrag(AIR, 2.0, [0.1, 0.2], 0.0, strips=4, **SEAT),
    ),
    "hull": (
        f'type = "hull_lift_drag"\narea = "20 cm^2"\ndrag_coefficient = 0.1\nlift_slope = 1.2\n{SEATED}',
        HullLiftDrag(AIR, 20e-4, 0.1, lift_slope=1.2, **SEAT),
    ),
    "buoyancy": ('type = "buoyancy"', Buoyancy(AIR, NEUTRAL)),
    "buoyancy of a volume": (
        'type = "buoyancy"\nvolume = "5 l"\nat = [0.0, 0.0, 0.1]',
        Buoyancy(AIR, 5e-3, [0.0, 0.0, 0.1]),
    ),
    "flotation": (
        'type = "flotation"\ncenter = [0, 0, 0.1]\nwaterplane_area = 2.0\nmoments = [0.3, 0.4]',
        Flotation(
            AIR, NEUTRAL, [0, 0, 0.1], waterplane_area=2.0, transverse_moment=0.3, longitudinal_moment=0.4
        ),
    ),
    "metacentric heights": (
        'type = "flotation"\ncenter = [0, 0, 0.1]\n'
        'waterplane_area = 2.0\nvolume = 1.0\nmetacentric_heights = "[50, 80] cm"',
        Flotation.from_metacentric_heights(
            AIR, 1.0, [0, 0, 0.1], [0, 0, 0.05], waterplane_area=2.0, transverse=0.5, longitudinal=0.8
        ),
    ),
    "fin": (
        'type = "fin"\narea = 0.01\nat = [-1, 0, 0]\n'
        'span = [0, 0, -1]\naspect_ratio = 2\nangle = "rudder"\nstall = "15 deg"',
        Fin(AIR, 0.01, [-1, 0, 0], span=[0, 0, -1], aspect_ratio=2.0, angle="rudder", stall=np.radians(15.0)),
    ),
    "fixed fin": (
        'type = "fin"\narea = 0.01\nat = [-1, 0, 0]\nspan = [0, 0, -1]\nslope = 3\nangle = "0.1 rad"',
        Fin(AIR, 0.01, [-1, 0, 0], span=[0, 0, -1], slope=3.0, angle=0.1),
    ),
    "spring": (
        'type = "spring"\nstiffness = "2 kN/m"\nanchor = [1, 2, 3]\nlength = "10 cm"\ndamping = 3.0',
        Spring(2000.0, anchor=[1, 2, 3], length=0.1, damping=3.0),
    ),
    "tether": (
        'type = "tether"\nstiffness = 10.0\nlength = 2.0\nmoving = "tug"\nat = [0, 0, 1]\nonset = "5 cm"',
        Tether(10.0, 2.0, anchor="tug", at=[0, 0, 1], onset=0.05),
    ),
    "rotational spring": (
        f'type = "rotational_spring"\nstiffness = [1, 2, 3]\ndamping = 0.5\nattitude = {TURN}',
        RotationalSpring([1, 2, 3], TURN, 0.5),
    ),
    "contact": (
        'type = "contact"\npoints = [[0, 0, 1], [0, 1, 1]]\nstiffness = "1 kN/m"\n'
        'normal = [0, 1, -1]\nfriction = 0.5\nmoving = "deck"',
        Contact([[0, 0, 1], [0, 1, 1]], 1000.0, normal=[0, 1, -1], friction=0.5, moving="deck"),
    ),
    "ground": (
        'type = "contact"\nsurface = "ground"\npoints = [0, 0, 1]\n'
        'stiffness = 10.0\naltitude = "1 km"\ndamping = "2 s/m"',
        Contact.on_ground(AIR, [0, 0, 1], 10.0, altitude=1000.0, damping=2.0),
    ),
}


def load(force: str, folder: Path) -> fb.Model:
    path = folder / "test.toml"
    path.write_text(FRAME.format(force=force))
    return fb.load(path).model


@pytest.mark.parametrize("which", SAME)
def test_the_file_makes_the_element(which: str, tmp_path: Path) -> None:
    text, element = SAME[which]
    forces: Any = load(text, tmp_path).forces
    (force,) = forces
    assert type(force) is type(element)
    assert dict(force.parameters) == pytest.approx(dict(element.parameters), rel=1e-14)
    body = fb.RigidBody(1.0, inertia_about_com=np.eye(3))
    model, other = (fb.Model(body, [f]) for f in (force, element))
    assert model.input_names == other.input_names
    x = model.state([0.1, 0.2, 0.3], velocity_body=[1.0, 0.2, 0.3], angular_velocity_body=[0.1, 0.2, 0.3])
    u = np.full(model.n_inputs, 0.1)
    wanted = other.derivative(0.0, x, u)
    # Units round, an ulp or two.
    atol = 1e-13 * np.abs(wanted).max()
    np.testing.assert_allclose(model.derivative(0.0, x, u), wanted, rtol=0, atol=atol)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('type = "added_mass"', "needs exactly one of matrix, derivatives, spheroid, cylinder"),
        (
            'type = "added_mass"\nspheroid = { semi_major = 0.1, semi_minor = 0.2 }',
            r"forces\[0\].spheroid: .*the spheroid is prolate",
        ),
        (
            'type = "added_mass"\nspheroid = { semi_major = 0.1, semi_minro = 0.2 }',
            r"forces\[0\].spheroid.semi_minro: unknown key; did you mean 'semi_minor'",
        ),
        ('type = "hydrodynamic_damping"', r"forces\[0\]: needs linear, quadratic or both"),
        ('type = "fin"\narea = 0.1\nat = [0, 0, 0]\nspan = [1, 0, 0]\nslope = 1', "they are parallel"),
        (
            'type = "contact"\npoints = [0, 0, 1]\nstiffness = 1.0\naltitude = 3.0',
            'altitude: is not for surface = "plane"',
        ),
        (
            'type = "tether"\nstiffness = 1.0\nlength = 1.0\nanchor = [0, 0, 0]\nmoving = "tug"',
            "takes one of anchor, moving",
        ),
    ],
)
def test_errors_name_the_key(text: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(fb.ModelFileError, match=message):
        load(text, tmp_path)
