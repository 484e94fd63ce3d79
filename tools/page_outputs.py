"""What the Python blocks of a page print: `page_outputs.py PAGE ...` renews it on the pages.

The blocks of a page are one script. A block of `text`, `latex`, `c` or `{math}` that follows a Python block
directly holds what that prints.
"""

import io
import re
import sys
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np

BLOCK = re.compile(
    r"^```python\n(?P<code>.*?)^```\n"
    r"(?:\n(?P<head>```(?:text|latex|c|\{math\}\n:nowrap:\n)\n)(?P<printed>.*?)^```\n)?",
    re.DOTALL | re.MULTILINE,
)


def renewed(page: Path) -> str:
    """The text of a page whose outputs are what its blocks print now."""
    names: dict[str, Any] = {}

    def run(block: re.Match[str]) -> str:
        printed = io.StringIO()
        with redirect_stdout(printed):
            exec(compile(block["code"], str(page), "exec"), names)
        if block["head"] is None:
            return block[0]
        code = block[0][: block.start("head") - block.start()]
        return f"{code}{block['head']}{printed.getvalue().strip()}\n```\n"

    # What a page says of how arrays are printed holds for that page.
    with np.printoptions():
        return BLOCK.sub(run, page.read_text())


if __name__ == "__main__":
    for page in map(Path, sys.argv[1:]):
        page.write_text(renewed(page))
