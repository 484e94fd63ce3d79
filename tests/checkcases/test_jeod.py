"""NASA JEOD runs 9A to 9C and 10A, for the mass centre and for the origin of the structure frame."""

import pytest

from freebody.verify import jeod


@pytest.mark.parametrize("name", ["9A", "9B", "9C", "10A"])
def test_state_after_eight_hours(name):
    residuals = list(jeod.run(name))
    assert len(residuals) == 6
    assert [residual for residual in residuals if not residual.passed] == []
