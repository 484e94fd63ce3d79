"""[environment] of a model file: what it says is what Python says."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError

import freebody as fb
from freebody import _core
from freebody.elements import TurbulencePath
from freebody.environment import (
    ConstantWind,
    DrydenTurbulence,
    Environment,
    LogWind,
    OneMinusCosineGust,
    PowerLawWind,
    TabulatedAtmosphere,
    UniformAtmosphere,
    USStandard1976,
    WindShear,
    WindTable,
)
from freebody.model_file.context import Context
from freebody.model_file.environment_schema import EnvironmentTable, TurbulencePathSection, build
from freebody.model_file.fields import Section
from freebody.model_file.problems import Source


class File(Section):
    """A model file of which nothing else is read."""

    environment: EnvironmentTable


KT, FT, DEG = 1852.0 / 3600.0, 0.3048, np.pi / 180.0

# A body whose axes are to the right, forward and up.
RIGHT_FRONT_UP = [[0, 1, 0], [1, 0, 0], [0, 0, -1]]


def read(text: str, folder: Path = Path()) -> Environment:
    data, lines = _core.toml_parse(text)
    source = Source(folder / "model.toml", data, lines)
    try:
        section = File.model_validate(data).environment
    except ValidationError as error:
        raise source.errors(error) from None
    return build(section, source)


def same(one: Environment, other: Environment) -> None:
    """Both environments act alike, in a law."""

    def law(env: Environment) -> Any:
        @fb.force(parameters=env.parameters, inputs=env.inputs)
        def felt(s: Any, p: Any) -> Any:
            flow = env.flow(s, p)
            air = flow.air
            numbers = 1.0 * air.pressure + 1.0 * air.temperature + 1.0 * air.speed_of_sound
            return fb.wrench(
                force=1.0 * air.density * (1.0 * flow.velocity),
                moment=numbers * flow.angular_velocity / (1.0 * air.dynamic_viscosity),
            )

        return felt

    a, b = law(one), law(other)
    assert dict(a.parameters) == pytest.approx(dict(b.parameters), rel=1e-14)
    assert a.inputs == b.inputs
    given = np.random.default_rng(0).uniform(0.5, 2.0, (4, a.program.given_count))
    given[:, 3] *= -700.0
    values = [law.program.run(list(law.parameters.values()), given) for law in (a, b)]
    # Units are converted to the last digits only.
    np.testing.assert_allclose(*values, rtol=1e-11)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ('atmosphere = "us76"', Environment(atmosphere=USStandard1976())),
        (
            'atmosphere = { type = "us76", temperature_offset = "10 K", '
            "density_factor = 0.97, upper = false }",
            Environment(atmosphere=USStandard1976(10.0, 0.97, upper=False)),
        ),
        ('atmosphere = "water"', Environment(atmosphere=UniformAtmosphere.water())),
        (
            'atmosphere = { type = "water", kind = "fresh" }',
            Environment(atmosphere=UniformAtmosphere.water("fresh")),
        ),
        (
            'atmosphere = { type = "uniform", density = "0.0023769 slug/ft^3", '
            'speed_of_sound = "1116.45 ft/s" }',
            Environment(
                atmosphere=UniformAtmosphere(
                    0.0023769 * 14.59390293720636 / FT**3, speed_of_sound=1116.45 * FT
                )
            ),
        ),
        (
            'atmosphere = { type = "table", altitude = "[0, 10] km", pressure = "[1000, 260] mbar", '
            "temperature = [290, 225] }",
            Environment(
                atmosphere=TabulatedAtmosphere([0.0, 1e4], pressure=[1e5, 2.6e4], temperature=[290.0, 225.0])
            ),
        ),
        (
            'wind = { type = "constant", blowing_from = "270 deg", speed = "20 kt" }',
            Environment(wind=ConstantWind.blowing_from(270.0 * DEG, 20.0 * KT)),
        ),
        (
            'wind = { type = "constant", velocity = "[3, 4, 0] ft/s" }',
            Environment(wind=ConstantWind([3 * FT, 4 * FT, 0])),
        ),
        (
            'wind = { type = "constant", velocity = [0.2, 0.0, 0.0], name = "current" }',
            Environment(wind=ConstantWind([0.2, 0.0, 0.0], name="current")),
        ),
        (
            'wind = { type = "table", altitude = "[0, 5000] ft", velocity = [[1, 2, 0], [3, 4, 0]] }',
            Environment(wind=WindTable([0.0, 5000.0 * FT], [[1.0, 2, 0], [3.0, 4, 0]])),
        ),
        (
            'wind = { type = "table", altitude = [0, 2000], blowing_from = "[180, 270] deg", '
            'speed = "[5, 30] kt" }',
            Environment(
                wind=WindTable.blowing_from([0.0, 2000.0], [np.pi, 270.0 * DEG], [5.0 * KT, 30.0 * KT])
            ),
        ),
        (
            'wind = { type = "shear", gradient = "[0, 6, 0] kt/km", altitude = "100 m" }',
            Environment(wind=WindShear([0.0, 6e-3 * KT, 0.0], altitude=100.0)),
        ),
        (
            'wind = { type = "log", speed = 8, blowing_from = "90 deg", height = "20 ft", '
            'roughness = "2 ft", top = 300 }',
            Environment(wind=LogWind(8.0, 1.5 * np.pi, height=20 * FT, roughness=2 * FT, top=300.0)),
        ),
        (
            'wind = { type = "power_law", speed = 8, towards = "90 deg", exponent = 0.2, ground = 50 }',
            Environment(wind=PowerLawWind(8.0, 0.5 * np.pi, exponent=0.2, ground=50.0)),
        ),
        (
            'wind = { type = "gust", velocity = [0, 0, -9], start_time = 1, duration = 2, shape = "pulse" }',
            Environment(wind=OneMinusCosineGust([0.0, 0, -9], 1.0, duration=2.0, shape="pulse")),
        ),
        (
            'wind = { type = "gust", velocity = [0, 0, -9], start_distance = 0, '
            'length = "350 ft", axes = "body", body_from_aero = [[0, 1, 0], [1, 0, 0], [0, 0, -1]] }',
            Environment(
                wind=OneMinusCosineGust(
                    [0.0, 0, -9], 0.0, length=350.0 * FT, axes="body", body_from_aero=RIGHT_FRONT_UP
                )
            ),
        ),
        (
            'wind = { type = "dryden", severity = "moderate", seed = 4, span = "30 ft", axes = "level", '
            "body_from_aero = [[0, 1, 0], [1, 0, 0], [0, 0, -1]] }",
            Environment(
                wind=DrydenTurbulence.specified(
                    "moderate", 30.0 * FT, seed=4, axes="level", body_from_aero=RIGHT_FRONT_UP
                )
            ),
        ),
        (
            'wind = { type = "dryden", sigma = [1, 1, 2], length = [200, 200, 100], '
            "seed = 4, span = 10, harmonics = 9 }",
            Environment(wind=DrydenTurbulence([1.0, 1, 2], [200.0, 200, 100], 10.0, seed=4, harmonics=9)),
        ),
        (
            'wind = [{ type = "constant", velocity = [1, 0, 0] }, { type = "shear", '
            'name = "jet", gradient = [0, 1e-3, 0] }]',
            Environment(wind=ConstantWind([1.0, 0, 0]) + WindShear([0.0, 1e-3, 0.0], name="jet")),
        ),
    ],
    ids=lambda value: value[:40] if isinstance(value, str) else "",
)
def test_it_says_what_python_says(text: str, wanted: Environment) -> None:
    same(read(f"[environment]\n{text}\n"), wanted)


def test_tables_from_files(tmp_path: Path) -> None:
    (tmp_path / "wind.csv").write_text("altitude [ft],blowing_from [deg],speed [kt]\n0,180,5\n9000,270,30\n")
    (tmp_path / "parts.csv").write_text("altitude,north,east\n0,1,2\n1000,3,4\n")
    (tmp_path / "air.csv").write_text("altitude [km],density,temperature\n0,1.2,290\n10,0.4,225\n")
    sounding = read('[environment]\nwind = { type = "table", csv = "wind.csv" }', tmp_path)
    same(
        sounding,
        Environment(wind=WindTable.blowing_from([0, 9000 * FT], [np.pi, 270 * DEG], [5 * KT, 30 * KT])),
    )
    parts = read('[environment]\nwind = { type = "table", csv = "parts.csv" }', tmp_path)
    same(parts, Environment(wind=WindTable([0.0, 1000.0], [[1.0, 2, 0], [3.0, 4, 0]])))
    air = read('[environment]\natmosphere = { type = "table", csv = "air.csv" }', tmp_path)
    wanted = TabulatedAtmosphere([0.0, 1e4], density=[1.2, 0.4], temperature=[290.0, 225.0])
    same(air, Environment(atmosphere=wanted))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('atmosphere = "us77"', r"environment.atmosphere: unknown atmosphere 'us77'; did you mean 'us76'\?"),
        ('atmosphere = "US76"', r"unknown atmosphere 'US76'; did you mean 'us76'\?"),
        ("atmosphere = { density = 1 }", "environment.atmosphere: the key type is missing"),
        (
            'atmosphere = { type = "us76", density_factor = -1 }',
            r"environment.atmosphere: density_factor: got -1",
        ),
        ('atmosphere = { type = "us76", offset = 1 }', r"environment.atmosphere.offset: unknown key"),
        ('wind = { type = "constant" }', "exactly one of velocity, blowing_from"),
        ('wind = { type = "constant", blowing_from = "270 m", speed = 1 }', "no unit of an angle"),
        (
            'wind = { type = "gust", velocity = [0, 0, 1], start_time = 1, length = 3 }',
            "start_time and duration go",
        ),
        (
            'wind = [{ type = "constant", velocity = [1, 0] }]',
            r"environment.wind\[0\].velocity: needs 3 numbers",
        ),
        (
            'wind = [{ type = "constant", velocity = [1, 0, 0] }, { type = "constant", '
            "velocity = [1, 0, 0] }]",
            "two have the parameter 'wind_speed'",
        ),
        ('wind = { type = "table", csv = "none.csv" }', "environment.wind.csv: cannot read"),
        (
            'wind = { type = "dryden", span = 3, severity = "light" }',
            "environment.wind.seed: this key is missing",
        ),
    ],
)
def test_faults_name_their_key(text: str, message: str) -> None:
    with pytest.raises(fb.ModelFileError, match=message):
        read(f"[environment]\n{text}\n")


def test_turbulence_path_section() -> None:
    env = Environment(wind=DrydenTurbulence.specified("light", 10.0, seed=1))
    body = fb.RigidBody(1.0, inertia_about_com=np.eye(3))
    section = TurbulencePathSection.model_validate({"type": "turbulence_path", "at": [1.0, 0.0, 0.0]})
    element = section.element(Context(body, env, Source(Path("x.toml"), {}, {}), "forces[0]"))
    assert element == TurbulencePath(env, [1.0, 0.0, 0.0])
