"""Printed code, in every language, computes what the kernel does: every form, every chart."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import pytest

import freebody as fb

from . import kernel, languages
from .kernel import AGREE, CHARTS, disagreement, forms_in

# Simplified by the known ways and identities, or the matrices multiplied as they stand.
WAYS = {"simplified": True, "literal": False}
points = cache(kernel.points)


@cache
def printed(form: str, chart: str, way: str) -> fb.Equations:
    angles = None if form in ("1.8", "1.11") else chart
    return fb.equations(form, angles, simplify=WAYS[way])


def check(form: str, chart: str, way: str, run: languages.Run) -> None:
    equations = printed(form, chart, way)
    arguments, results = points(chart)
    got = run(equations, {name: arguments[name] for name in equations.arguments})
    assert len(got) == len(results[form])
    assert max(map(disagreement, got, results[form])) < AGREE


FORMS = [pytest.param(c, f, w, id=f"{f}-{c}-{w}") for c in CHARTS for f in forms_in(c) for w in WAYS]


@pytest.mark.parametrize("language", languages.PYTHONIC)
@pytest.mark.parametrize(("chart", "form", "way"), FORMS)
def test_printed_python_computes_what_the_kernel_does(chart: str, form: str, way: str, language: str) -> None:
    check(form, chart, way, languages.PYTHONIC[language])


@pytest.mark.parametrize(("chart", "form", "way"), FORMS)
def test_the_graph_itself_computes_what_the_kernel_does(chart: str, form: str, way: str) -> None:
    check(form, chart, way, languages.run_graph)


@pytest.fixture(scope="module", autouse=True)
def libraries(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, languages.Library]]:
    """One for each chart; started before everything else, for the compiler works while others are tested."""
    made = {
        chart: languages.Library(
            tmp_path_factory.mktemp(chart),
            {c_name(f, w): printed(f, chart, w) for f in forms_in(chart) for w in WAYS},
        )
        for chart in CHARTS
    }
    yield made
    for library in made.values():
        library.close()


def c_name(form: str, way: str) -> str:
    return f"f_{form.replace('.', '_')}_{way}"


@pytest.mark.parametrize(("chart", "form", "way"), FORMS)
def test_printed_c_computes_what_the_kernel_does(
    libraries: dict[str, languages.Library], chart: str, form: str, way: str
) -> None:
    check(form, chart, way, lambda _, given: libraries[chart].run(c_name(form, way), given))
