"""NASA NESC check case 2."""

from freebody.verify import nesc


def test_body_rates_of_the_tumbling_brick():
    (residual,) = nesc.case_02()
    assert residual.passed, residual
