"""Coefficient files of gravity fields: what is read, and what is refused with its line."""

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.elements import HarmonicGravity
from freebody.environment import Environment
from freebody.errors import InputError, ModelFileError
from freebody.model_file.context import Context
from freebody.model_file.gravity_schema import SECTIONS
from freebody.model_file.problems import Source

# The first coefficients of EGM2008 as ICGEM gives them; Fortran's exponents are as good as others.
GFC = """product_type             gravity_field
modelname                EGM2008
earth_gravity_constant   3.986004415D+14
radius                   6378136.3
max_degree               3
norm                     fully_normalized
tide_system              tide_free

key    L    M         C                   S            sigma C    sigma S
end_of_head =====================================================================
gfc    0    0  1.000000000000E+00  0.000000000000E+00 0.0000E+00 0.0000E+00
gfc    2    0 -4.841651437908150E-04  0.000000000000E+00 7.4815E-11 0.0000E+00
gfc    2    1 -2.066155090741760D-10  1.384413891379790d-09 7.0630E-11 7.1667E-11
gfc    2    2  2.439383573283130E-06 -1.400273703859340E-06 7.2306E-11 7.3020E-11
gfc    3    0  9.571611709283530E-07  0.000000000000E+00 5.7314E-11 0.0000E+00
"""
CSV = "# EGM2008\nn,m,C,S\n2,0,-4.841651437908150E-04,0\n2,2,2.439383573283130E-06,-1.400273703859340E-06\n"


@pytest.fixture
def write(tmp_path: Path) -> Any:
    def written(name: str, text: str) -> Path:
        path = tmp_path / name
        path.write_text(text)
        return path

    return written


def test_icgem_files(write: Any) -> None:
    force = HarmonicGravity.from_file(
        write("a.gfc", GFC), rotation_rate=1.0, gradient_torque=True, name="Earth"
    )
    assert (force.mu, force.radius, force.degree, force.name) == (3.986004415e14, 6378136.3, 3, "Earth")
    assert (force.rotation_rate, force.gradient_torque) == (1.0, True)
    assert force.C[2, 1] == -2.066155090741760e-10
    assert force.S[2, 1] == 1.384413891379790e-09
    assert force.C[3, 0] == 9.571611709283530e-07
    assert force.C[0, 0] == 1.0
    assert not force.C[1].any()
    short = HarmonicGravity.from_file(write("a.gfc", GFC), 2, mu=1.0)
    assert (short.degree, short.mu) == (2, 1.0)
    np.testing.assert_array_equal(short.C, force.C[:3, :3])
    assert HarmonicGravity.from_file(write("a.gfc", GFC), 0).degree == 0


def test_coefficients_that_are_not_normalised_are(write: Any) -> None:
    """J2 and C22 of the Earth, plain: Montenbruck and Gill (2000), (3.13), has the factors."""
    plain = GFC.replace("fully_normalized", "unnormalized").split("gfc ")[0]
    plain += "gfc 2 0 -1.08262668e-3 0\ngfc 2 2 1.57442e-6 -9.03759e-7\n"
    force = HarmonicGravity.from_file(write("a.gfc", plain))
    assert force.C[2, 0] == pytest.approx(-1.08262668e-3 / np.sqrt(5.0), rel=1e-14)
    assert force.S[2, 2] == pytest.approx(-9.03759e-7 / np.sqrt(2.0 * 5.0 / 24.0), rel=1e-14)


def test_tables(write: Any) -> None:
    for text in (CSV, CSV.replace("n,m,C,S\n", "").replace(",", " , ")):
        force = HarmonicGravity.from_file(write("a.csv", text), mu=3.986e14, radius=6.378e6)
        assert force.C[2, 2] == 2.439383573283130e-06
        assert force.C[0, 0] == 1.0
        assert force.degree == 2


def test_what_has_no_sine_has_none(write: Any) -> None:
    force = HarmonicGravity.from_file(write("a.csv", "2,0,-4.8e-4,-1.4e-10\n"), mu=1.0, radius=1.0)
    assert not force.S.any()


def test_elements_pickle(write: Any) -> None:
    force = HarmonicGravity.from_file(write("a.gfc", GFC), center=(1.0, 2.0, 3.0), angle=0.2)
    again = pickle.loads(pickle.dumps(force))
    assert vars(again).keys() == vars(force).keys()
    for name, value in vars(force).items():
        np.testing.assert_array_equal(getattr(again, name), value)


WRONG: list[tuple[str, str, str]] = [
    ("a.txt", CSV, r"path: got .*a\.txt; give an ICGEM file \(\.gfc\) or a table"),
    ("a.gfc", CSV, r"has no end_of_head"),
    ("a.gfc", GFC.split("gfc ", maxsplit=1)[0], r"holds no coefficients"),
    ("a.gfc", GFC.replace("fully_", "half_"), r"a\.gfc, line 6: norm is 'half_normalized'; known are"),
    ("a.gfc", GFC.replace("3.986004415D+14", "GM"), r"a\.gfc, line 3: got 'GM'; a finite number is wanted"),
    ("a.gfc", GFC.replace("gfc    2    0", "gfct   2    0"), r"line 12: got 'gfct'; known is gfc"),
    (
        "a.gfc",
        GFC.replace("gfc    2    1", "gfc    1    2"),
        r"line 13: got degree 1, order 2; whole numbers",
    ),
    ("a.gfc", GFC.replace("gfc    2    1", "gfc    2    2"), r"line 14: degree 2, order 2 comes twice"),
    ("a.gfc", GFC + "gfc 3 1 1e-6\n", r"line 16: degree, order, C and S are wanted"),
    ("a.csv", CSV, r"mu: neither .*a\.csv nor the argument gives it; give mu="),
    ("a.csv", CSV + "3,0,1e-6,nan\n", r"a\.csv, line 5: got 'nan'; a finite number is wanted"),
    ("a.csv", CSV + "3,-1,1e-6,0\n", r"a\.csv, line 5: got degree 3, order -1"),
    ("a.csv", "", r"holds no coefficients"),
]


@pytest.mark.parametrize(("name", "text", "message"), WRONG)
def test_files_that_cannot_be_used_are_refused(write: Any, name: str, text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        HarmonicGravity.from_file(write(name, text), radius=1.0)


def test_other_refusals(write: Any, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"degree: got 4; .*a\.gfc ends at 3"):
        HarmonicGravity.from_file(write("a.gfc", GFC), 4)
    with pytest.raises(InputError, match=r"degree: got -1; give a whole number"):
        HarmonicGravity.from_file(write("a.gfc", GFC), -1)
    with pytest.raises(InputError, match=r"path: cannot read .*none\.gfc"):
        HarmonicGravity.from_file(tmp_path / "none.gfc")
    one, two = [[1.0]], np.zeros((2, 2))
    for arguments, message in (
        ((0.0, 1.0, one, one), "mu: got 0.0; give one finite positive number"),
        ((1.0, -1.0, one, one), "radius: got -1.0; give one finite positive number"),
        ((1.0, 1.0, [1.0], one), r"C: got shape \(1,\); allowed is \(N \+ 1, N \+ 1\)"),
        ((1.0, 1.0, one, two), r"S: got shape \(2, 2\); allowed is that of C, \(1, 1\)"),
        ((1.0, 1.0, two + 1.0, two), "C: got 1.0 at degree 0, order 1; orders end at the degree"),
        ((1.0, 1.0, one, one), "S: order 0 is not zero"),
    ):
        with pytest.raises(InputError, match=message):
            HarmonicGravity(*arguments)


def section(folder: Path, **table: Any) -> HarmonicGravity:
    (kind,) = SECTIONS
    source = Source(folder / "model.toml", {}, {"forces": 4, "forces[0]": 5, "forces[0].file": 6})
    body = fb.RigidBody(1.0, inertia_about_com=np.eye(3))
    spec = kind.model_validate({"type": "harmonic_gravity", **table})
    element = spec.element(Context(body, Environment(), source, "forces[0]"))
    assert isinstance(element, HarmonicGravity)
    return element


def test_every_key_of_a_model_file_reaches_the_element(write: Any) -> None:
    path = write("a.gfc", GFC)
    keys = {
        "name": "Earth",
        "degree": 2,
        "mu": "4e5 km^3/s^2",
        "radius": "6400 km",
        "center": [1.0, 2.0, 3.0],
        "rotation_rate": "0.5 deg/s",
        "angle": "90 deg",
        "gradient_torque": True,
    }
    element = section(path.parent, file="a.gfc", **keys)
    assert (element.name, element.degree, element.gradient_torque) == ("Earth", 2, True)
    # Units are converted by factors that are rounded.
    got = [element.mu, element.radius, element.rotation_rate, element.angle, *element.center]
    np.testing.assert_allclose(got, [4e14, 6.4e6, np.deg2rad(0.5), np.pi / 2.0, 1.0, 2.0, 3.0], rtol=1e-14)
    assert section(path.parent, file="a.gfc").mu == 3.986004415e14
    write("b.gfc", GFC.replace("gfc    2    1", "gfc    1    2"))
    with pytest.raises(ModelFileError, match=r"model\.toml:6: forces\[0\]\.file: .*line 13: got degree 1"):
        section(path.parent, file="b.gfc")
