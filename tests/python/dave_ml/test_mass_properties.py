"""Mass properties that DAVE-ML models give."""

import re

import numpy as np
import pytest

import freebody as fb
from freebody.dave_ml import load_dave_ml
from freebody.errors import InputError
from python.dave_ml.files import calculation, variable, write

SLUG, FOOT = 0.45359237 * 9.80665 / 0.3048, 0.3048


def of(name, units, value):
    return variable(name, initialValue=str(value)).replace('"nd"', f'"{units}"')


LINES = [
    variable("fuel", "<isInput/>", initialValue="1").replace('"nd"', '"slug"'),
    variable(
        "totalMass", calculation("<apply><plus/><cn>2</cn><ci>fuel</ci></apply>") + "<isOutput/>"
    ).replace('"nd"', '"slug"'),
    of("bodyMomentOfInertia_Roll", "slugft2", 4.0),
    of("bodyMomentOfInertia_Pitch", "slugft2", 5.0),
    of("bodyMomentOfInertia_Yaw", "slugft2", 6.0),
    of("bodyProductOfInertia_ZX", "slugft2", 0.5),
    of("bodyPositionOfCmWrtMrc_X", "ft", 0.25),
]


def test_products_of_inertia_are_positive_integrals_and_units_are_those_of_the_file(tmp_path):
    model = load_dave_ml(write(tmp_path, "\n".join(LINES)))
    mass, com, inertia = model.mass_properties({"fuel": 3.0})
    assert mass == pytest.approx(5.0 * SLUG)
    assert com == pytest.approx([0.25 * FOOT, 0.0, 0.0])
    wanted = [[4.0, 0.0, -0.5], [0.0, 5.0, 0.0], [-0.5, 0.0, 6.0]]
    np.testing.assert_allclose(inertia, np.array(wanted) * SLUG * FOOT**2, rtol=1e-15)


def test_a_body_in_another_frame_is_the_same_body(tmp_path):
    model = load_dave_ml(write(tmp_path, "\n".join(LINES)))
    own = model.rigid_body()
    assert (own.mass, own.name) == (pytest.approx(3.0 * SLUG), "body")
    origin, turn = np.array([0.4, -0.2, 0.7]), fb.Attitude.angles("zyx", [0.3, 0.2, -0.8]).as_rotation()
    moved = model.rigid_body(reference_point=-turn.T @ origin, body_from_model=turn.T, name="moved")
    wanted = own.in_frame(origin, turn)
    np.testing.assert_allclose(moved.spatial_inertia, wanted.spatial_inertia, rtol=1e-13, atol=1e-12)
    assert moved.name == "moved"


def test_inside_a_law_the_mass_is_part_of_its_program(tmp_path):
    model = load_dave_ml(write(tmp_path, "\n".join(LINES)))

    @fb.force(inputs={"fuel": "kg"})
    def weight(s):
        return fb.wrench(
            force=np.stack([0.0, 0.0, model.mass_properties({"fuel": s.inputs.fuel / SLUG}).mass])
        )

    body = fb.Model(fb.RigidBody(1.0, inertia_about_com=np.eye(3)), [weight])
    assert body.wrench(0.0, body.state(), [7.0])[2] == pytest.approx(2.0 * SLUG + 7.0)
    assert body.jacobian(0.0, body.state(), [7.0])[1][9, 0] == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("lines", "fault"),
    [
        (LINES[2:], "gives no totalMass; mass properties need them"),
        ([*LINES[:2], *LINES[3:]], "gives no bodyMomentOfInertia_Roll"),
        (
            [*LINES[:6], of("bodyPositionOfCmWrtMrc_X", "deg", 1)],
            "is in 'deg', which does not measure what 'm' does",
        ),
        (
            [*LINES[:6], of("bodyPositionOfCmWrtMrc_X", "yard", 1)],
            "the units 'yard' of 'bodyPositionOfCmWrtMrc_X'",
        ),
    ],
)
def test_what_gives_no_mass_properties_is_refused(lines, fault, tmp_path):
    with pytest.raises(InputError, match=re.escape(fault)):
        load_dave_ml(write(tmp_path, "\n".join(lines))).rigid_body()
