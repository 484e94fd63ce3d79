"""Where the commands print: results to standard output, everything else to standard error."""

import sys

from rich.console import Console

__all__ = ["errors", "output"]

# Names and messages come from files: a bracket in them is no markup.
output = Console(highlight=False, markup=False, width=None if sys.stdout.isatty() else 120)
errors = Console(stderr=True, highlight=False, markup=False)
