"""docs/force-laws.md: what NumPy is supported, and the error that it shows."""

import re
import runpy

import pytest

from freebody import TraceError
from freebody.tracing.array import FUNCTIONS, PRODUCTS, UFUNCS
from repo.repository import ROOT, blocks

PAGE = ROOT / "docs/force-laws.md"


def test_the_page_lists_the_supported_functions():
    functions = {f"{f.__module__}.{f.__name__}".removeprefix("numpy.") for f in FUNCTIONS}
    supported = functions | {ufunc.__name__ for ufunc in (*UFUNCS, *PRODUCTS)}
    table = PAGE.read_text().partition("| family |")[2].partition("\n\n")[0]
    listed = re.findall(r"`np\.([\w.]+)`", table)
    assert sorted(listed) == sorted(supported | {"matvec", "vecmat"})  # these two in NumPy 2.2 and later


def test_the_error_is_shown_as_it_comes(tmp_path):
    (wrong,) = blocks(PAGE, "py")
    file = tmp_path / "fins.py"
    file.write_text(wrong)
    with pytest.raises(TraceError) as caught:
        runpy.run_path(str(file))
    message = str(caught.value).replace(str(file), file.name)
    assert f"{message}\n" in blocks(PAGE, "text")
