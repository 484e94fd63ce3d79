"""The table of operation counts, and what docs/equations.md says of it."""

import runpy
from typing import Any

import pytest

from repo.repository import ROOT

TOOL: dict[str, Any] = runpy.run_path(str(ROOT / "tools/operation_counts.py"))
CASES = TOOL["counts"]()


def test_the_page_holds_the_table():
    """`python tools/operation_counts.py docs/equations.md` renews it."""
    assert TOOL["between_marks"]((ROOT / "docs/equations.md").read_text()) == TOOL["table"]()


@pytest.mark.parametrize("case", CASES)
def test_as_they_stand_the_matrices_of_2_10_cost_more(case):
    short, long, differentiated = (CASES[case][form, False] for form in TOOL["FORMS"])
    assert 2.0 < long[0] / short[0] < 3.0
    assert 1.5 < long[1] / short[1] < 2.0
    assert differentiated[0] < short[0]
    assert differentiated[1] < short[1]


@pytest.mark.parametrize("case", CASES)
def test_simplified_they_cost_about_the_same_when_shared(case):
    body, _ = case
    short, long, _ = (CASES[case][form, True] for form in TOOL["FORMS"])
    bounds = {"general": (2.4, 2.8), "symmetric, mass centre at the origin": (1.0, 1.3)}
    low, high = bounds.get(body, (1.0, 2.8))
    assert low < long[0] / short[0] < high
    # The product with Dᵀ: nine products and six sums of its rotation, five and three of its rate matrix.
    assert long[1] < short[1] if body.endswith("at the origin") else long[1] == short[1] + 23
