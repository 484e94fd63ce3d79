"""A two-stage launcher flies into orbit: tanks that empty, air that thins out, a stage that falls away.

The launcher is made up, of the size of the Electron (13 t, 0.2 t into a low orbit); no number is taken
from a real one. It starts at the equator of the turning Earth and follows a table of pitch angles eastwards.
World axes point to the launch site, east and north at time zero; the third body axis out of the nose.
"""

import numpy as np

import freebody as fb
from freebody.elements import Actuator, Drag, Gravity, Propulsion, Tank, Thruster
from freebody.environment import WGS84, Environment, USStandard1976

EARTH = Environment(WGS84(), USStandard1976())
RADIUS, LENGTH = 0.6, 11.0  # of the first stage, m


def tank(name: str, mass: float, bottom: float, height: float) -> Tank:
    """A cylinder whose level falls: mass centre and inertia by the mass that is left."""
    masses = np.linspace(0.0, mass, 5)
    level = height * masses / mass
    across = masses * (RADIUS**2 / 4.0 + level**2 / 12.0)
    along = masses * RADIUS**2 / 2.0
    tensors = [np.diag([a, a, b]) for a, b in zip(across, along, strict=True)]
    points = [[0.0, 0.0, bottom + h / 2.0] for h in level]
    # Polynomials of third order: cubic tables are exact.
    return Tank(name, mass, points, tensors, masses=masses, interpolation="cubic")


def shell(mass: float, bottom: float, top: float) -> fb.RigidBody:
    """Structure and engines as a thin tube."""
    across, along = mass * (RADIUS**2 / 2.0 + (top - bottom) ** 2 / 12.0), mass * RADIUS**2
    com = [0.0, 0.0, (bottom + top) / 2.0]
    return fb.RigidBody(mass, com, inertia_about_com=np.diag([across, across, along]))


TIMES = [0, 10, 25, 45, 70, 100, 126, 400]
PITCH = fb.Table(TIMES, np.deg2rad([0, 0, 10, 24, 40, 54, 76, 107]))


@fb.control(parameters={"stiffness": (0.6, "1"), "damping": (0.8, "s")})
def steering(s, p):
    """Turn the engine so that the nose follows the table: pitch is counted from the first world axis."""
    nose = s.world_from_body[:, 2]
    error = np.arctan2(nose[1], nose[0]) - PITCH(s.time)
    return {"pitch_command": p.stiffness * error + p.damping * s.angular_velocity_body[1]}


def vehicle(
    name: str, body: fb.RigidBody, engine: Thruster, tanks: list[Tank], pressure_centre: float
) -> fb.Model:
    drag = fb.Table([0.0, 0.8, 1.1, 2.0, 5.0, 50.0], [0.3, 0.35, 0.6, 0.45, 0.3, 0.3])
    forces = [
        Gravity(EARTH),
        Drag(EARTH, np.pi * RADIUS**2, drag, at=[0.0, 0.0, pressure_centre]),
        Propulsion([engine], tanks, EARTH),
        Actuator("pitch", natural_frequency=20.0, damping=0.7, limits=(-0.1, 0.1)),
    ]
    return fb.Model(body, forces, control=steering, environment=EARTH, name=name)


SWING = [("pitch", [0.0, 1.0, 0.0])]
SHARES = {"oxygen": 2.5, "kerosene": 1.0}
upper = shell(250.0, 0.0, 3.0) + shell(300.0, 3.0, 4.5)  # the second stage, and what it carries
upper_engine = Thruster([0, 0, 0], [0, 0, 1], 25.8e3, specific_impulse=343.0, tanks=SHARES, gimbal=SWING)
second = vehicle(
    "second stage",
    upper,
    upper_engine,
    [tank("oxygen", 1464.0, 0.8, 1.2), tank("kerosene", 586.0, 2.1, 0.7)],
    pressure_centre=1.0,
)

# In the first flight all of it is one body; what the second stage has in its tanks does not move.
above = [0.0, 0.0, LENGTH]
full = fb.RigidBody(2050.0, [0, 0, LENGTH + 1.6], inertia_about_com=np.diag([900.0, 900.0, 370.0]))
first = vehicle(
    "first stage",
    shell(950.0, 0.0, LENGTH) + upper.in_frame([0.0, 0.0, -LENGTH]) + full,
    Thruster(
        [0, 0, 0],
        [0, 0, 1],
        224e3,
        specific_impulse=311.0,
        tanks={"lower_oxygen": 2.5, "lower_kerosene": 1.0},
        gimbal=SWING,
        exit_area=0.336,
    ),
    [tank("lower_oxygen", 6607.0, 1.0, 5.2), tank("lower_kerosene", 2643.0, 6.5, 2.9)],
    pressure_centre=2.0,
)


@fb.event(direction="falling", inputs={"lower_oxygen_mass": "kg"})
def burnout(s):
    return s.inputs.lower_oxygen_mass - 1.0


ORBIT = 250e3


@fb.event(direction="rising")
def orbital_energy(s):
    radius = np.linalg.norm(s.position_world)
    energy = 0.5 * (s.velocity_body @ s.velocity_body) - WGS84().mu / radius
    return energy + 0.5 * WGS84().mu / (6378137.0 + ORBIT)


# Upright on the pad, turning with the Earth: the body axes point east, north and up.
upright = fb.Attitude.rotation([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
site, turning = EARTH.planet.position_world(0.0, 0.0), EARTH.planet.angular_velocity_world
start = first.state(site, upright, velocity_world=np.cross(turning, site), angular_velocity_world=turning)
stages = [fb.Stage(first, until=burnout), fb.Stage(second, origin=above, until=orbital_energy)]
run = fb.simulate_stages(stages, start, (0.0, 450.0), save_every=5.0)
print(run.outcome.message)
lower, orbiter = run.stages
burnt_out, left = lower.mass[-1], orbiter.mass[-1]
position, velocity = run.position_world[-1], run.velocity_world[-1]
height = np.linalg.norm(lower.position_world[-1]) - np.linalg.norm(site)
dropped = burnt_out - orbiter.mass[0]
print(f"separation at {lower.t[-1]:.2f} s, {height / 1e3:.1f} km; {dropped:.1f} kg fall away")
print(lower.outcome.notices[0].message)

# The ideal speed, by the rocket equation in vacuum, and what gravity, air and steering take of it.
exhaust = 9.80665 * np.array([311.0, 343.0])
ideal = exhaust @ np.log([lower.mass[0] / burnt_out, orbiter.mass[0] / left])
gained = np.linalg.norm(velocity) - np.linalg.norm(run.velocity_world[0])
print(f"ideal {ideal:.0f} m/s, gained {gained:.0f} m/s")

# The orbit after cut-off, as if the Earth were a sphere.
mu = WGS84().mu
momentum = np.cross(position, velocity)
eccentricity = np.linalg.norm(np.cross(velocity, momentum) / mu - position / np.linalg.norm(position))
low, high = (6378137.0 + ORBIT) * (1.0 + eccentricity * np.array([-1.0, 1.0])) - 6378137.0
print(f"orbit of {low / 1e3:.0f} to {high / 1e3:.0f} km, {left - 550.0:.0f} kg of propellant left")

assert run.outcome.event == "orbital_energy"
assert np.isclose(dropped, 950.0, atol=5.0)  # the first stage, and what its tanks kept
assert 1000.0 < ideal - gained < 2500.0
assert low > 180e3
