"""NASA's atmospheric check cases."""

import pytest

from freebody.verify import nesc


@pytest.mark.parametrize("number", nesc.MODELS)
def test_residuals(number):
    residuals = list(nesc.run(number))
    assert len(residuals) in (2, 4)
    for residual in residuals:
        assert residual.passed, residual
