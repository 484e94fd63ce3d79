"""Where the commands print: results to standard output, everything else to standard error."""

from rich.console import Console

__all__ = ["errors", "output"]

# Names and messages come from files: a bracket in them is no markup.
output = Console(highlight=False, markup=False)
errors = Console(stderr=True, highlight=False, markup=False)
