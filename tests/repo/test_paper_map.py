"""docs/paper-map.toml leads from every number of the paper to its code, its tests and its page."""

import re
import tomllib
from typing import Any

import pytest

from freebody.equations import equations
from freebody.equations.forms import FORMS, MATRICES
from repo.repository import ROOT

NUMBERS = (
    [f"1.{i}" for i in range(1, 13)] + [f"2.{i}" for i in range(1, 14)] + [f"3.{i}" for i in (1, 2)] + ["4"]
)
# Screws, their transforms, momentum, what is called a coordinate, and a force are no equations of motion.
WITHOUT_EQUATIONS = {"1.1", "1.3", "1.5", "1.7", "1.10", "1.12", "2.1"}
MAP: dict[str, dict[str, Any]] = tomllib.loads((ROOT / "docs/paper-map.toml").read_text())


def section(number: str) -> str:
    """The text of the map's page from the number's anchor to the next anchor."""
    page, anchor = MAP[number]["page"].split("#")
    text = (ROOT / page).read_text()
    target = f"({anchor})=\n"
    assert target in text, f"{page} has no anchor {target.strip()}"
    return re.split(r"^\([\w-]+\)=$", text.split(target, 1)[1], flags=re.MULTILINE)[0]


def test_every_number_of_the_paper_is_listed_in_its_order():
    assert list(MAP) == NUMBERS


@pytest.mark.parametrize("number", MAP)
def test_an_entry_is_complete(number):
    entry = MAP[number]
    equations = set() if number in WITHOUT_EQUATIONS else {"equations"}
    assert set(entry) == {"title", "code", "test", "page"} | equations
    assert all(entry.values())


@pytest.mark.parametrize("number", MAP)
def test_the_code_is_where_the_map_says_and_cites_the_number(number):
    citation = "section 4" if number == "4" else f"({number})"
    cited = False
    for place in MAP[number]["code"]:
        path, item = place.split("::", 1)
        text = (ROOT / path).read_text()
        name = item.rsplit("::", 1)[-1]
        assert re.search(rf"\b(fn|struct|enum|trait|def|class) {name}\b", text), place
        cited |= citation in text
    assert cited, f"no code listed for {number} says {citation}"


def test_every_scalar_equation_belongs_to_one_number():
    listed = [(name, number) for number, entry in MAP.items() for name in entry.get("equations", ())]
    assert sorted(name for name, _ in listed) == sorted([*FORMS, *MATRICES])
    assert [number for name, number in listed if name in FORMS] == [
        name for name, _ in listed if name in FORMS
    ]


@pytest.mark.parametrize("name", [*FORMS, *MATRICES])
def test_scalar_equations_are_made_by_their_name(name):
    made = equations(name, "zyx")
    assert made.form == name
    assert f"({name})" in made.title or name in MATRICES
    assert f'`"{name}"`' in (ROOT / "docs/equations.md").read_text()


@pytest.mark.parametrize("number", MAP)
def test_a_test_is_named_by_the_number(number):
    named = f"test_{number.replace('.', '_')}"
    for place in MAP[number]["test"]:
        path, prefix = place.split("::", 1)
        assert prefix == named, f"{place} should end in ::{named}"
        assert re.search(rf"^def {named}(?!\d|_\d)", (ROOT / path).read_text(), re.MULTILINE), place


@pytest.mark.parametrize("number", MAP)
def test_the_page_names_the_code_that_carries_the_equation(number):
    text = section(number)
    for place in MAP[number]["code"]:
        name = re.split(r"::|\.", place.split("::", 1)[1])[-1]
        assert re.search(rf"\b{name}\b", text), f"{MAP[number]['page']} does not name {name}"
