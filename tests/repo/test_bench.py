"""What the bench leaves in the repository: ratios alone, of versions that it pins, as the page shows them."""

import json
import re
import runpy

from repo.repository import ROOT

PAGE = runpy.run_path(str(ROOT / "bench/page.py"))
RESULTS = json.loads(PAGE["RESULTS"].read_text())


def test_the_page_shows_the_results():
    """`python bench/page.py` renews it."""
    assert PAGE["renewed"]() == PAGE["PAGE"].read_text()


def test_the_results_are_ratios():
    assert set(RESULTS) == {"instruction_set", "versions", "ratios"}
    for measure, by_threads in RESULTS["ratios"].items():
        assert measure[:2] in {"A ", "B ", "C ", "D ", "E "}
        assert set(by_threads) <= {"one thread", "all threads"}
        assert all(ratio > 0 for ratios in by_threads.values() for ratio in ratios.values())


def test_the_vehicles_are_ratios():
    found = json.loads(PAGE["VEHICLES"].read_text())
    assert set(found) == {"instruction_set", "operations", "ratios"}
    assert set(found["operations"]) == set(found["ratios"])
    assert all(ratio > 0 for ratios in found["ratios"].values() for ratio in ratios.values())


def test_the_peers_are_pinned():
    lines = (ROOT / "bench/constraints.txt").read_text().splitlines()
    assert [line for line in lines if not re.fullmatch(r"[\w.-]+==[\w.]+", line)] == []
    pinned = dict(line.lower().split("==") for line in lines)
    packages = {"pinocchio": "pin", "freebody": None}
    for name, version in RESULTS["versions"].items():
        package = packages.get(name.lower(), name.lower())
        assert package is None or pinned[package] == version
