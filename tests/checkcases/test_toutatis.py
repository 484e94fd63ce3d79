"""4179 Toutatis: the differences that another program states against the radar observations."""

from freebody.verify import toutatis


def test_differences_to_the_last_printed_digit():
    residuals = list(toutatis.cases())
    assert len(residuals) == 5
    assert [residual for residual in residuals if not residual.passed] == []


def test_nearly_all_agree_as_rounded():
    """All but two of the ninety, which are 0.56 and 0.62 units off, round to what is printed."""
    digits = [entry for row in toutatis.OBSERVATIONS for entry in row.differences.split()]
    computed = toutatis.differences().ravel()
    rounded = [
        f"{value:.{len(text.partition('.')[2])}f}" for value, text in zip(computed, digits, strict=True)
    ]
    assert sum(got != text for got, text in zip(rounded, digits, strict=True)) == 2
