"""`freebody verify` on the paper: every number is there, every residual is allowed, a wrong form is seen."""

import numpy as np
import pytest

from freebody import forms
from freebody.verify import paper
from freebody.verify.residual import Residual

NUMBERS = [f"1.{k}" for k in range(1, 13)] + [f"2.{k}" for k in range(1, 14)] + ["3.1", "3.2", "4"]


def test_every_equation_holds() -> None:
    residuals = list(paper.cases(seed=7, n=2))
    assert sorted({r.case for r in residuals}) == sorted(f"paper ({number})" for number in NUMBERS)
    for residual in residuals:
        assert residual.passed, residual


def test_a_wrong_form_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    right = forms.force_cross
    monkeypatch.setattr(forms, "force_cross", lambda twist: np.swapaxes(right(twist), -1, -2))
    failed = {r.case for r in paper.cases(seed=7, n=1) if not r.passed}
    assert "paper (1.9)" in failed


def test_not_a_number_does_not_pass() -> None:
    assert Residual("case", "quantity", 1e-12, 1e-12).passed
    assert not Residual("case", "quantity", 2e-12, 1e-12).passed
    assert not Residual("case", "quantity", float("nan"), 1e-12).passed
