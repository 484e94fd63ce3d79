"""What is printed of the F-16 in Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed. (2015):
tables 3.5-2, 3.6-2 and 3.6-3 (pages 187, 193, 195), the turn of section 3.6, examples 4.4-1 and 5.3-1.
"""

from __future__ import annotations

from typing import NamedTuple

__all__ = [
    "CONDITIONS",
    "CONTROLS",
    "LEVEL",
    "LONG_A",
    "LONG_B",
    "MODES",
    "RATES",
    "SIDE_A",
    "SIDE_B",
    "STATE",
    "TURN",
]

# Table 3.5-2, mass centre at 0.4 chords: V ft/s, alpha, beta, phi, theta, psi, p, q, r, north ft, east,
# altitude, power; throttle, elevator deg, aileron, rudder.
STATE = (500.0, 0.5, -0.2, -1.0, 1.0, -1.0, 0.7, -0.8, 0.9, 1000.0, 900.0, 10000.0, 90.0)
CONTROLS = (0.9, 20.0, -15.0, -20.0)
# In the order of the states.
RATES = {
    "rates of airspeed, angle of attack, sideslip": "-75.23724 -0.8813491 -0.4759990",
    "rates of roll, pitch, yaw": "2.505734 0.3250820 2.145926",
    "angular acceleration": "12.62679 0.9649671 0.5809759",
    "velocity over ground, climb": "342.4439 -266.7707 248.1241",
    "rate of power": "-58.68999",
}

# Table 3.6-2, sea level, 0.35 chords: airspeed ft/s, throttle, angle of attack deg, elevator deg.
LEVEL = """130 0.816 45.6 20.1
140 0.736 40.3 -1.36
150 0.619 34.6 0.173
170 0.464 27.2 0.621
200 0.287 19.7 0.723
260 0.148 11.6 -0.090
300 0.122 8.49 -0.591
350 0.107 5.87 -0.539
400 0.108 4.16 -0.591
440 0.113 3.19 -0.671
500 0.137 2.14 -0.756
540 0.160 1.63 -0.798
600 0.200 1.04 -0.846
640 0.230 0.742 -0.871
700 0.282 0.382 -0.900
800 0.378 -0.045 -0.943"""


class Condition(NamedTuple):
    """A trimmed flight at 502 ft/s: mass centre in chords, what turns, rad/s, figures as printed.

    `loose` are the small lateral figures, which the book's search by a simplex leaves off by some 1e-5.
    """

    xcg: float
    turn_rate: float
    pitch_rate: float
    printed: dict[str, str]
    loose: dict[str, str]


# Table 3.6-3; deflections in degrees, angles in rad.
CONDITIONS = {
    "nominal": Condition(
        0.35, 0.0, 0.0, {"throttle": "0.1385", "elevator": "-0.7588", "alpha": "0.03691"}, {}
    ),
    "mass centre at 0.30": Condition(
        0.30, 0.0, 0.0, {"throttle": "0.1485", "elevator": "-1.931", "alpha": "0.03936"}, {}
    ),
    "mass centre at 0.38": Condition(
        0.38, 0.0, 0.0, {"throttle": "0.1325", "elevator": "-0.05590", "alpha": "0.03544"}, {}
    ),
    "turn of 0.3 rad/s": Condition(
        0.30,
        0.3,
        0.0,
        {
            "throttle": "0.8499",
            "elevator": "-6.256",
            "rudder": "-0.4218",
            "alpha": "0.2485",
            "beta": "0.00048",
            "roll": "1.367",
            "pitch": "0.05185",
            "p": "-0.01555",
            "q": "0.2934",
            "r": "0.06071",
        },
        {"aileron": "0.09891"},
    ),
    "pull-up of 0.3 rad/s": Condition(
        0.30,
        0.0,
        0.3,
        {"throttle": "1.023", "elevator": "-7.082", "alpha": "0.3006", "beta": "0.000041", "pitch": "0.3006"},
        {"aileron": "-0.00062", "rudder": "0.01655"},
    ),
}

# Section 3.6, a turn with the mass centre at 0.35 chords, as the book's minimum has it.
TURN = {
    "throttle": 0.8349601,
    "elevator": -1.481766,
    "aileron": 0.09553108,
    "rudder": -0.4118124,
    "alpha": 0.2392628,
    "beta": 5.061803e-4,
    "roll": 1.366289,
    "pitch": 0.05000808,
    "p": -1.499617e-2,
    "q": 0.2933811,
    "r": 6.084932e-2,
    "power": 64.12363,
}

# Example 4.4-1: (V ft/s, alpha, theta, q) and elevator in degrees; example 5.3-1: (beta, phi, p, r), aileron
# and rudder. The term of r in phi' is printed as 0.0037, ten times too small: it is tan(theta) = 0.0369.
LONG_A = [
    [-1.9311e-2, 8.8157, -32.170, -5.7499e-1],
    [-2.5389e-4, -1.0189, 0.0, 9.0506e-1],
    [0.0, 0.0, 0.0, 1.0],
    [2.9465e-12, 8.2225e-1, 0.0, -1.0774],
]
LONG_B = [[1.7370e-1], [-2.1499e-3], [0.0], [-1.7555e-1]]
SIDE_A = [
    [-0.3220, 0.0640, 0.0364, -0.9917],
    [0.0, 0.0, 1.0, 0.0369],
    [-30.6492, 0.0, -3.6784, 0.6646],
    [8.5395, 0.0, -0.0254, -0.4764],
]
SIDE_B = [[0.0003, 0.0008], [0.0, 0.0], [-0.7333, 0.1315], [-0.0319, -0.0620]]
# Example 4.4-1: (s - 0.09755)(s + 1.912)(s + 0.1507 ± 0.1153 i).
MODES = (-1.912, -0.1507 - 0.1153j, -0.1507 + 0.1153j, 0.09755)
