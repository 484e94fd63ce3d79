"""Vehicles that have closed laws or single printed figures, and the standard atmosphere."""

import pytest

from freebody.verify import CASES


@pytest.mark.parametrize(
    ("name", "count"), [("us76", 3), ("gyrostat", 5), ("quadrotor", 3), ("two_stage_rocket", 2)]
)
def test_residuals(name, count):
    residuals = list(CASES[name].residuals())
    assert len(residuals) == count
    assert [residual for residual in residuals if not residual.passed] == []
