"""NASA NESC check case 2: the rotation of a brick that tumbles without torques."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.model_file import load_model, shipped_model

from .residual import Residual

__all__ = ["case_02"]

# Printed to 1e-11 deg/s or better; that program and an adaptive integration of order 8 differ by 3e-10.
ALLOWED = 1e-8

# Inertial body rates, deg/s, at t = 0, 1, ... 30 s: NASA/TM-2015-218675, case 2, simulation tool 04.
RATES = (
    (10.0, 20.0, 30.0),
    (4.25884189866, 23.1199428975, 28.3798177751),
    (-1.75081532854, 23.6495577599, 28.0713200449),
    (-7.65791414981, 21.6324912928, 29.1927340225),
    (-12.9910509864, 16.9407267622, 31.296258194),
    (-16.9394851494, 9.63193937745, 33.4066280795),
    (-18.5264678196, 0.5271105109, 34.3661858748),
    (-17.2485622399, -8.68383330091, 33.5888658347),
    (-13.5164616104, -16.2511589807, 31.5523026209),
    (-8.2905704485, -21.2457762267, 29.3917315247),
    (-2.41890222177, -23.5525695195, 28.12859263),
    (3.59646036104, -23.3041341088, 28.2737002594),
    (9.39062210776, -20.4797136405, 29.7715840064),
    (14.4002872621, -14.9516514781, 32.0008795967),
    (17.7188643604, -6.95578659188, 33.8705360724),
    (18.4372543136, 2.38688029893, 34.3107056116),
    (16.320879525, 11.2510940915, 33.0489003606),
    (12.0211978851, 18.0791027714, 30.845213055),
    (6.522892621, 22.2354654431, 28.8724523764),
    (0.566438215329, 23.7447230741, 28.0147806506),
    (-5.42273467991, 22.7159305765, 28.6082817473),
    (-11.0519913164, 19.0684191313, 30.4234892344),
    (-15.6498483364, 12.7217680553, 32.6717310566),
    (-18.2466259376, 4.14601207624, 34.1927569195),
    (-18.0722661079, -5.25321665064, 34.0855954074),
    (-15.1840887012, -13.6177995003, 32.4167961985),
    (-10.4147573705, -19.6490488875, 30.162612709),
    (-4.71440329359, -22.9741985295, 28.4629107619),
    (1.28886647336, -23.6982952085, 28.0424068727),
    (7.2171754423, -21.880100559, 29.0627029461),
    (12.6183907757, -17.3974747619, 31.1195888868),
)


def case_02() -> Iterator[Residual]:
    """The largest difference of the body rates from the table over 30 s."""
    loaded = load_model(shipped_model("nesc_02_tumbling_brick"))
    times = np.arange(len(RATES), dtype=float)
    options = {**loaded.options, "save_every": None, "save_at": times}
    trajectory = loaded.model.simulate(loaded.x0, loaded.t_span, **options)
    differences = np.rad2deg(trajectory.angular_velocity_body) - RATES
    yield Residual("NESC 2", "inertial body rates", float(np.abs(differences).max()), ALLOWED, "deg/s")
