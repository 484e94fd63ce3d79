"""Every example runs to its last assert."""

import runpy

import pytest

from repo.repository import ROOT

EXAMPLES = sorted((ROOT / "examples").glob("*.py"))


def test_there_are_examples():
    assert EXAMPLES


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example(path):
    assert "\nassert " in path.read_text()
    runpy.run_path(str(path))
